// A picture of a parametrization before and after it was snapped, in the way of Fig. 1 of the
// paper: at the left its domain with the cuts, at the right the places with the largest gaps. These
// are far too small to be seen, and are drawn larger by a factor that the picture tells.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SVG_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SVG_PICTURE_H

#include "svg_gap_row.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <set>
#include <string>
#include <vector>

template <typename TriangleMesh, typename HalfedgeUVMap, typename OldHalfedgeUVMap>
class Svg_picture
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Face = typename Graph_traits::face_descriptor;
  using Transitions = CGAL::Seamless_snapping::Seam_transitions<TriangleMesh>;

public:
  // `old_transitions` are those of `old_uv_map`; both maps are in place already.
  Svg_picture(const TriangleMesh& mesh, OldHalfedgeUVMap old_uv_map, HalfedgeUVMap uv_map,
              const Transitions& old_transitions)
    : m_mesh(mesh), m_old_uv_map(old_uv_map), m_uv_map(uv_map), m_transitions(old_transitions),
      m_branches(cut_branches(mesh, old_transitions))
  {
    for(const auto& branch : m_branches) {
      m_old_gaps.push_back(branch_gaps(branch, mesh, old_uv_map));
      m_gaps.push_back(branch_gaps(branch, mesh, uv_map));
      m_shown.push_back(m_shown.size());
    }
    std::stable_sort(m_shown.begin(), m_shown.end(), [this](std::size_t a, std::size_t b) {
      return m_old_gaps[a].largest > m_old_gaps[b].largest;
    });
    m_shown.resize((std::min)(m_shown.size(), std::size_t(3)));
  }

  void write(std::ostream& os, const std::string& title) const
  {
    os << std::fixed << std::setprecision(1)
       << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1600 1080\" "
          "font-family=\"sans-serif\" font-size=\"21\" fill=\"#333\">\n"
          "<rect width=\"1600\" height=\"1080\" fill=\"#fff\"/>\n"
          "<text x=\"40\" y=\"52\" font-size=\"26\">" << escaped(title) << "</text>\n";
    write_domain(os);
    write_legend(os);
    os << (m_shown.empty()
             ? "<text x=\"1295\" y=\"100\" text-anchor=\"middle\">no cut, and no gap</text>\n"
             : "<text x=\"1160\" y=\"100\" text-anchor=\"middle\" fill=\"#d55e00\">before</text>\n"
               "<text x=\"1430\" y=\"100\" text-anchor=\"middle\" fill=\"#009e73\">after</text>\n");
    for(std::size_t i = 0; i < m_shown.size(); ++i)
      Svg_gap_row<TriangleMesh, HalfedgeUVMap, OldHalfedgeUVMap>(
        m_mesh, m_old_uv_map, m_uv_map, m_transitions, m_branches[m_shown[i]],
        m_old_gaps[m_shown[i]], m_gaps[m_shown[i]]).write(os, char('A' + i), 115 + 315 * double(i));
    os << "</svg>\n";
  }

private:
  // Colors that color-blind readers can tell apart, in turn with ways to dash the line.
  static std::string stroke(std::size_t branch)
  {
    static const char* const colors[] = {"#0072b2", "#d55e00", "#009e73", "#e69f00", "#cc79a7",
                                         "#56b4e9", "#444444"};
    static const char* const dashes[] = {"", "8 4", "2 4"};
    const std::string dash = dashes[branch / 7 % 3];
    return "stroke=\"" + std::string(colors[branch % 7]) + "\""
           + (dash.empty() ? "" : " stroke-dasharray=\"" + dash + "\"");
  }

  bool is_boundary(Halfedge h) const
  {
    return is_chart_boundary(h, m_mesh, m_transitions);
  }

  View domain_view() const
  {
    CGAL::Bbox_2 box;
    for(const Face f : faces(m_mesh))
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const Vector_uv u = uv(m_uv_map, h);
        box += CGAL::Bbox_2(u[0], u[1], u[0], u[1]);
      }
    const double width = box.xmax() - box.xmin();
    const double height = box.ymax() - box.ymin();
    const double scale = (std::min)(900 / (std::max)(width, 1e-300),
                                    830 / (std::max)(height, 1e-300));
    return View{{box.xmin() + width / 2, box.ymin() + height / 2}, scale, {500, 565}};
  }

  void write_domain(std::ostream& os) const
  {
    const View view = domain_view();
    write_chart_areas(os, view);
    if(faces(m_mesh).size() <= 20000)
      write_edges(os, view);

    for(std::size_t i = 0; i < m_branches.size(); ++i) {
      os << "<path fill=\"none\" stroke-width=\"2.6\" stroke-linejoin=\"round\" " << stroke(i)
         << " d=\"";
      std::vector<Vector_uv> side, other_side;
      for(const Halfedge h : m_branches[i].halfedges) {
        const Halfedge o = opposite(h, m_mesh);
        if(side.empty()) {
          side.push_back(uv(m_uv_map, prev(h, m_mesh)));
          other_side.push_back(uv(m_uv_map, o));
        }
        side.push_back(uv(m_uv_map, h));
        other_side.push_back(uv(m_uv_map, prev(o, m_mesh)));
      }
      write_points(os, side, view);
      write_points(os, other_side, view);
      os << "\"/>\n";
    }
    write_singular_vertices(os, view);
    std::vector<Vector_uv> taken;
    for(std::size_t i = 0; i < m_shown.size(); ++i)
      write_place(os, view, i, taken);
  }

  // The charts as what their boundaries enclose: a path much shorter than that of all triangles.
  void write_chart_areas(std::ostream& os, const View& view) const
  {
    os << "<path fill=\"#ececec\" stroke=\"#777\" stroke-width=\"0.8\" d=\"";
    std::set<Halfedge> is_done;
    for(const Face f : faces(m_mesh))
      for(const Halfedge start : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        if(!is_boundary(start) || is_done.count(start) != 0)
          continue;
        std::vector<Vector_uv> loop;
        for(Halfedge h = start; is_done.insert(h).second; ) {
          loop.push_back(uv(m_uv_map, h));
          for(h = next(h, m_mesh); !is_boundary(h); )
            h = next(opposite(h, m_mesh), m_mesh);
        }
        write_points(os, loop, view);
        os << 'Z';
      }
    os << "\"/>\n";
  }

  void write_edges(std::ostream& os, const View& view) const
  {
    os << "<path fill=\"none\" stroke=\"#c4c4c4\" stroke-width=\"0.5\" d=\"";
    for(const auto e : edges(m_mesh)) {
      const Halfedge h = halfedge(e, m_mesh);
      if(!is_boundary(h))
        write_points(os, {uv(m_uv_map, prev(h, m_mesh)), uv(m_uv_map, h)}, view);
    }
    os << "\"/>\n";
  }

  static std::string singular_color(int index) { return index > 0 ? "#0072b2" : "#d55e00"; }

  void write_singular_vertices(std::ostream& os, const View& view) const
  {
    for(const auto& [v, index] : m_transitions.singular_vertices()) {
      std::set<Vector_uv> copies;
      for(const Halfedge h : CGAL::halfedges_around_target(halfedge(v, m_mesh), m_mesh))
        copies.insert(uv(m_uv_map, h));
      for(const Vector_uv& copy : copies) {
        const Vector_uv p = view(copy);
        os << "<circle cx=\"" << p[0] << "\" cy=\"" << p[1] << "\" r=\"5\" stroke=\"#fff\" fill=\""
           << singular_color(index) << "\"/>\n";
      }
    }
  }

  // The letter of a row of the right half, at both sides of the cut; beside it, where another
  // letter stands there already.
  void write_place(std::ostream& os, const View& view, std::size_t row,
                   std::vector<Vector_uv>& taken) const
  {
    const std::size_t b = m_shown[row];
    const Halfedge h = m_branches[b].halfedges[m_old_gaps[b].edge_of_largest];
    for(const Halfedge corner : {h, prev(opposite(h, m_mesh), m_mesh)}) {
      const Vector_uv place = view(uv(m_uv_map, corner));
      Vector_uv p = place;
      const auto is_taken = [&](const Vector_uv& q) {
        return std::hypot(p[0] - q[0], p[1] - q[1]) < 29;
      };
      for(int i = 0; i < 32 && std::any_of(taken.begin(), taken.end(), is_taken); ++i) {
        const double angle = 0.785 * i, distance = 32 * (1 + i / 8);
        p = {place[0] + distance * std::cos(angle), place[1] - distance * std::sin(angle)};
      }
      taken.push_back(p);
      os << "<path stroke=\"#333\" d=\"M" << place[0] << ' ' << place[1] << 'L' << p[0] << ' '
         << p[1] << "\"/><circle cx=\"" << p[0] << "\" cy=\"" << p[1]
         << "\" r=\"13\" fill=\"#fff\" stroke=\"#333\"/><text x=\"" << p[0] << "\" y=\""
         << p[1] + 6.5 << "\" font-size=\"18\" text-anchor=\"middle\">" << char('A' + row)
         << "</text>\n";
    }
  }

  void write_legend(std::ostream& os) const
  {
    os << "<text x=\"40\" y=\"82\">" << faces(m_mesh).size() << " faces, "
       << m_transitions.cut_halfedges().size() << " cut edges in " << m_branches.size()
       << " branches, " << m_transitions.singular_vertices().size() << " singular vertices</text>\n"
       << "<g font-size=\"20\"><path stroke-width=\"3\" " << stroke(0)
       << " d=\"M40 1014H70\"/><path stroke-width=\"3\" " << stroke(8)
       << " d=\"M78 1014H108\"/><text x=\"120\" y=\"1021\">cut: one line style per branch, the "
          "same on both sides</text>\n<circle cx=\"55\" cy=\"1053\" r=\"6\" fill=\""
       << singular_color(1)
       << "\"/><text x=\"70\" y=\"1060\">singular vertex of positive,</text>"
          "<circle cx=\"362\" cy=\"1053\" r=\"6\" fill=\""
       << singular_color(-1) << "\"/><text x=\"377\" y=\"1060\">of negative index</text></g>\n";
  }

  const TriangleMesh& m_mesh;
  OldHalfedgeUVMap m_old_uv_map;
  HalfedgeUVMap m_uv_map;
  const Transitions& m_transitions;
  std::vector<Cut_branch<TriangleMesh> > m_branches;
  std::vector<Branch_gaps> m_old_gaps; // per branch
  std::vector<Branch_gaps> m_gaps;
  std::vector<std::size_t> m_shown;    // the branches with the largest old gaps
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SVG_PICTURE_H
