// The files that snap_obj.cpp writes: each appears under its name when it is complete, and not at
// all otherwise; and no file is two of them.

#ifndef SEAMLESS_SNAPPING_EXAMPLES_OUTPUT_FILE_H
#define SEAMLESS_SNAPPING_EXAMPLES_OUTPUT_FILE_H

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

struct Unwritable : public std::runtime_error
{
  explicit Unwritable(const std::string& filename, const std::string& why = "")
    : std::runtime_error("cannot write '" + filename + "'" + (why.empty() ? "" : ": " + why))
  { }
};

// The file that a name stands for, through symbolic links, even if it does not exist yet.
inline std::filesystem::path resolved(const std::string& name)
{
  constexpr int longest_chain = 40; // of links; more of them are a circle
  std::filesystem::path path = std::filesystem::absolute(name);
  std::error_code error;
  for(int i = 0; i < longest_chain && std::filesystem::is_symlink(path, error); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path);
  return std::filesystem::weakly_canonical(path);
}

// A device, a pipe, or the like: what is written to it goes through it.
inline bool is_special_file(const std::string& name)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(name, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

// Whether what is written under one name would be lost under the other.
inline bool are_same_file(const std::string& a, const std::string& b)
{
  if(a.empty() || b.empty() || is_special_file(a) || is_special_file(b))
    return false;
  std::error_code error; // of names that do not exist
  return std::filesystem::equivalent(a, b, error) || resolved(a) == resolved(b);
}

// Calls `write(os, name)` with the name under which the text can be read back, once `os` is
// flushed. It is empty for devices and pipes, which are written to directly: to rename a file to
// them would replace them.
template <typename Write>
void write_file(const std::string& filename, const Write& write)
{
  const bool is_special = is_special_file(filename);
  std::error_code error;
  std::string unfinished;
  if(!is_special) {
    const std::string place = resolved(filename).string();
    unfinished = place + ".unfinished";
    for(int i = 2; std::filesystem::exists(unfinished, error); ++i)
      unfinished = place + ".unfinished" + std::to_string(i);
  }
  try {
    std::ofstream os(is_special ? filename : unfinished, std::ios::binary);
    if(!os)
      throw Unwritable(filename);
    write(os, unfinished);
    os.close();
    if(!os)
      throw Unwritable(filename);
    if(is_special)
      return;
    std::filesystem::rename(unfinished, resolved(filename), error);
    if(error)
      throw Unwritable(filename, error.message());
  } catch(...) {
    if(!is_special)
      std::filesystem::remove(unfinished, error);
    throw;
  }
}

#endif // SEAMLESS_SNAPPING_EXAMPLES_OUTPUT_FILE_H
