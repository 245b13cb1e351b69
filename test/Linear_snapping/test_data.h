// Where the tests find their files: those of the package in data/, next to the programs, and
// further parametrizations in a folder that the environment variable SEAMLESS_SNAPPING_DATA_DIR
// names. These are not part of the package; tests of them are skipped where there are none, and say
// so.

#ifndef SEAMLESS_SNAPPING_TEST_TEST_DATA_H
#define SEAMLESS_SNAPPING_TEST_TEST_DATA_H

#include "checking.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace test_data {

// Whether the environment asks for all tests.
inline bool are_tests_long() { return std::getenv("SEAMLESS_SNAPPING_LONG_TESTS") != nullptr; }

// How many of so many random trials a test makes: a quarter, unless the environment asks for all.
inline int trials(const int all) { return are_tests_long() ? all : (all + 3) / 4; }

// The files of a folder with the given suffix, by name.
inline std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                   const std::string& suffix)
{
  std::vector<std::filesystem::path> files;
  if(std::filesystem::is_directory(folder))
    for(const auto& entry : std::filesystem::directory_iterator(folder))
      if(entry.path().extension() == suffix)
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Where the parametrizations of the packages are, seen from the folder of a test. Within CGAL, each
// package has a root, and programs run in a copy of their folder.
inline std::filesystem::path data_folder()
{
#ifdef SEAMLESS_SNAPPING_TEST_DATA
  return SEAMLESS_SNAPPING_TEST_DATA;
#else
  return std::filesystem::is_directory("data") ? "data" : "../Seamless_snapping/data";
#endif
}

// A parametrization of the packages.
inline std::string package_file(const std::string& name)
{
  return (data_folder() / (name + ".obj")).string();
}

inline std::vector<std::filesystem::path> package_files()
{
  const auto files = files_in(data_folder(), ".obj");
  if(!CHECK(!files.empty()))
    std::cerr << "  run this program in the folder of its source" << std::endl;
  return files;
}

// A part of the further data: a path to nowhere, and `what` counted as skipped, if it is not there.
inline std::filesystem::path further_data(const std::string& part, const std::string& what)
{
  const char* const folder = std::getenv("SEAMLESS_SNAPPING_DATA_DIR");
  const auto path = std::filesystem::path(folder != nullptr ? folder : "") / part;
  if(folder != nullptr && *folder != 0 && std::filesystem::exists(path))
    return path;
  checking::skip(what + ", as SEAMLESS_SNAPPING_DATA_DIR names no folder with " + part);
  return std::filesystem::path();
}

inline std::vector<std::filesystem::path> further_files(const std::string& part,
                                                        const std::string& suffix)
{
  const auto folder = further_data(part, "files of " + part + "/");
  const auto files =
      folder.empty() ? std::vector<std::filesystem::path>() : files_in(folder, suffix);
  CHECK(folder.empty() || !files.empty());
  return files;
}

// For tests that take long: every fifth of them, unless the environment asks for all.
inline std::vector<std::filesystem::path> fifth_of_further_files(const std::string& part,
                                                                 const std::string& suffix)
{
  const auto files = further_files(part, suffix);
  if(are_tests_long())
    return files;
  std::vector<std::filesystem::path> result;
  for(std::size_t i = 0; i < files.size(); i += 5)
    result.push_back(files[i]);
  if(result.size() < files.size())
    checking::skip("four of five files of " + part +
                   ", as SEAMLESS_SNAPPING_LONG_TESTS is not set");
  return result;
}

} // namespace test_data

#endif // SEAMLESS_SNAPPING_TEST_TEST_DATA_H
