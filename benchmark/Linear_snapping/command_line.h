// The command lines of the benchmarks, and the files that they name.

#ifndef SEAMLESS_SNAPPING_BENCHMARK_COMMAND_LINE_H
#define SEAMLESS_SNAPPING_BENCHMARK_COMMAND_LINE_H

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

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

// The named files, and of named folders all files with such a suffix that are in them or below.
inline std::vector<std::string> files_of(const std::vector<std::string>& names,
                                         const std::vector<std::string>& suffixes = {".obj"})
{
  std::vector<std::string> result;
  for(const std::string& name : names) {
    if(!std::filesystem::is_directory(name)) {
      result.push_back(name);
      continue;
    }
    const auto first = result.size();
    for(const auto& entry : std::filesystem::recursive_directory_iterator(name))
      if(std::find(suffixes.begin(), suffixes.end(), entry.path().extension()) != suffixes.end())
        result.push_back(entry.path().string());
    std::sort(result.begin() + std::ptrdiff_t(first), result.end());
  }
  return result;
}

// What programs on meshes without coordinates read.
inline std::vector<std::string> mesh_files_of(const std::vector<std::string>& names)
{
  return files_of(names, {".obj", ".off", ".ply", ".stl"});
}

} // namespace benchmark

#endif // SEAMLESS_SNAPPING_BENCHMARK_COMMAND_LINE_H
