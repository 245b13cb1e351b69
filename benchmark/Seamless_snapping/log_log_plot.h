// A picture (SVG) of series of points in the plane with logarithmic axes, the decades as a square
// grid.

#ifndef SEAMLESS_SNAPPING_BENCHMARK_LOG_LOG_PLOT_H
#define SEAMLESS_SNAPPING_BENCHMARK_LOG_LOG_PLOT_H

#include "../../command_line/pictures/svg_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace benchmark {

struct Series
{
  std::string name;
  std::vector<std::pair<double, double> > points; // positive
};

class Log_log_plot
{
public:
  Log_log_plot(const std::string& x_label, const std::string& y_label,
               const std::vector<Series>& series)
    : m_x_label(x_label), m_y_label(y_label), m_series(series)
  {
    for(const Series& s : series)
      for(const auto& p : s.points) {
        extend(0, std::log10(p.first));
        extend(1, std::log10(p.second));
      }
    m_view = View{ { double(m_low[0]), double(m_low[1]) },
                   double(decade),
                   { margin, 30. + decade * (m_high[1] - m_low[1]) } };
  }

  void write(std::ostream& os) const
  {
    const double right = m_view({ double(m_high[0]), 0 })[0], bottom = m_view.middle[1];
    os << std::fixed << std::setprecision(1)
       << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << right + 200 << ' '
       << bottom + 70 << "\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#333\">\n"
       << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    write_grid(os);
    os << "<text x=\"" << (margin + right) / 2 << "\" y=\"" << bottom + 52
       << "\" text-anchor=\"middle\">" << escaped(m_x_label) << "</text>\n"
       << "<text transform=\"translate(24 " << (30 + bottom) / 2
       << ") rotate(-90)\" text-anchor=\"middle\">" << escaped(m_y_label) << "</text>\n";
    for(std::size_t i = 0; i < m_series.size(); ++i)
      write_series(os, i, right + 30);
    os << "</svg>\n";
  }

private:
  static constexpr double margin = 80;
  static constexpr int decade = 160;

  void extend(std::size_t axis, double logarithm)
  {
    const int low = int(std::floor(logarithm)), high = int(std::floor(logarithm)) + 1;
    m_low[axis] = m_is_empty[axis] ? low : (std::min)(m_low[axis], low);
    m_high[axis] = m_is_empty[axis] ? high : (std::max)(m_high[axis], high);
    m_is_empty[axis] = false;
  }

  static void write_power(std::ostream& os, const Vector_uv& p, const char* anchor, int exponent)
  {
    os << "<text x=\"" << p[0] << "\" y=\"" << p[1] << "\" text-anchor=\"" << anchor
       << "\">10<tspan dy=\"-6\" font-size=\"10\">" << exponent << "</tspan></text>\n";
  }

  void write_grid(std::ostream& os) const
  {
    os << "<path fill=\"none\" stroke=\"#ddd\" d=\"";
    for(int x = m_low[0]; x <= m_high[0]; ++x)
      write_points(os, { { double(x), double(m_low[1]) }, { double(x), double(m_high[1]) } },
                   m_view);
    for(int y = m_low[1]; y <= m_high[1]; ++y)
      write_points(os, { { double(m_low[0]), double(y) }, { double(m_high[0]), double(y) } },
                   m_view);
    os << "\"/>\n";
    for(int x = m_low[0]; x <= m_high[0]; ++x) {
      const Vector_uv p = m_view({ double(x), double(m_low[1]) });
      write_power(os, { p[0], p[1] + 24 }, "middle", x);
    }
    for(int y = m_low[1]; y <= m_high[1]; ++y) {
      const Vector_uv p = m_view({ double(m_low[0]), double(y) });
      write_power(os, { p[0] - 10, p[1] + 5 }, "end", y);
    }
  }

  void write_series(std::ostream& os, std::size_t i, double legend) const
  {
    const std::string color = "hsl(" + std::to_string(i * 67 % 360) + ",75%,42%)";
    os << "<g fill=\"" << color << "\" fill-opacity=\"0.75\">\n";
    for(const auto& point : m_series[i].points) {
      const Vector_uv p = m_view({ std::log10(point.first), std::log10(point.second) });
      os << "<circle cx=\"" << p[0] << "\" cy=\"" << p[1] << "\" r=\"3.5\"/>\n";
    }
    const double y = 40 + 24 * double(i);
    os << "<circle cx=\"" << legend << "\" cy=\"" << y << "\" r=\"5\"/></g>\n<text x=\""
       << legend + 12 << "\" y=\"" << y + 5 << "\">" << escaped(m_series[i].name) << "</text>\n";
  }

  std::string m_x_label, m_y_label;
  const std::vector<Series>& m_series;
  bool m_is_empty[2] = { true, true };
  int m_low[2] = { 0, 0 }, m_high[2] = { 1, 1 }; // exponents
  View m_view;
};

} // namespace benchmark

#endif // SEAMLESS_SNAPPING_BENCHMARK_LOG_LOG_PLOT_H
