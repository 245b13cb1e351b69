// What the benchmarks share: times of steps as the minimum over several runs, growth exponents, and
// the memory that a process occupies.

#ifndef SEAMLESS_SNAPPING_BENCHMARK_BENCHMARK_TOOLS_H
#define SEAMLESS_SNAPPING_BENCHMARK_BENCHMARK_TOOLS_H

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <malloc.h>

namespace benchmark {

inline double seconds_now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The steps in the order of their first appearance. A step that occurs twice in a run adds up.
using Step_times = std::vector<std::pair<std::string, double> >;

inline double& time_of(const std::string& name, Step_times& steps)
{
  for(auto& step : steps)
    if(step.first == name)
      return step.second;
  steps.emplace_back(name, 0.);
  return steps.back().second;
}

inline Step_times summed(const Step_times& steps)
{
  Step_times result;
  for(const auto& step : steps)
    time_of(step.first, result) += step.second;
  return result;
}

// The shortest time of each step, and of the whole, over several runs: what a machine that does
// other things too takes away differs from run to run and from step to step.
class Shortest_times
{
public:
  void add(const Step_times& steps, double total)
  {
    const bool is_first = m_runs++ == 0;
    m_total = is_first ? total : (std::min)(m_total, total);
    for(const auto& step : summed(steps)) {
      double& shortest = time_of(step.first, m_steps);
      shortest = is_first ? step.second : (std::min)(shortest, step.second);
    }
  }

  const Step_times& steps() const { return m_steps; }
  double total() const { return m_total; }

private:
  std::size_t m_runs = 0;
  Step_times m_steps;
  double m_total = 0;
};

// What the system says of this process: "VmRSS:" is the memory it occupies, "VmHWM:" the most that
// it has.
inline double kilobytes(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for(std::string line; std::getline(status, line);)
    if(line.compare(0, key.size(), key) == 0)
      return std::stod(line.substr(key.size() + 1));
  return 0;
}

// From here on VmHWM is the peak since now.
inline void reset_memory_peak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5" << std::flush;
}

// The slope of the line that fits log(value) over log(size) best.
inline double growth_exponent(const std::vector<std::pair<double, double> >& sizes_and_values)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for(const auto& pair : sizes_and_values) {
    const double log_size = std::log(pair.first), log_value = std::log(pair.second);
    n += 1;
    x += log_size;
    y += log_value;
    xx += log_size * log_size;
    xy += log_size * log_value;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

} // namespace benchmark

#endif // SEAMLESS_SNAPPING_BENCHMARK_BENCHMARK_TOOLS_H
