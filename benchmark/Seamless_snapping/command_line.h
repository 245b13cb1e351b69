// The command lines of the benchmarks.

#ifndef SEAMLESS_SNAPPING_BENCHMARK_COMMAND_LINE_H
#define SEAMLESS_SNAPPING_BENCHMARK_COMMAND_LINE_H

#include <boost/program_options.hpp>

#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

namespace benchmark {

namespace options = boost::program_options;

// Reads the options; values without the name of an option are those of `positional`. Returns the
// exit code if the program has nothing left to do: after --help, and for what is wrong or missing.
inline std::optional<int> read_command_line(int argc, char** argv, const std::string& usage,
                                            options::options_description& description,
                                            const char* positional)
{
  description.add_options()("help,h", "print this");
  try {
    options::variables_map values;
    options::positional_options_description positions;
    positions.add(positional, -1);
    options::store(
      options::command_line_parser(argc, argv).options(description).positional(positions).run(),
      values);
    if(values.count("help") != 0) {
      std::cout << "usage: " << usage << "\n" << description;
      return EXIT_SUCCESS;
    }
    options::notify(values);
  } catch(const options::error& error) {
    std::cerr << error.what() << "\nusage: " << usage << "\n" << description;
    return EXIT_FAILURE;
  }
  return std::nullopt;
}

} // namespace benchmark

#endif // SEAMLESS_SNAPPING_BENCHMARK_COMMAND_LINE_H
