#include "files.h"

#include "Failure.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <locale>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#if __has_include(<unistd.h>) && __has_include(<sys/stat.h>)
#include <sys/stat.h>
#include <unistd.h>
#define SEAMLESS_SNAPPING_FILES_HAVE_OWNERS
#endif

namespace fs = std::filesystem;

namespace {

const std::string standard_stream = "-";

[[noreturn]] void fail(const Exit status, const std::string& what, const std::string& filename,
                       const std::string& why)
{
  throw Failure(status, what + " '" + filename + "'" + (why.empty() ? "" : ": " + why));
}

std::string reason()
{
  return errno == 0 ? std::string() : std::generic_category().message(errno);
}

// The file that a name stands for, through symbolic links, even if it does not exist yet.
fs::path resolved(const std::string& name)
{
  constexpr int longest_chain = 40; // of links; more of them are a circle
  std::error_code error;
  fs::path path = fs::absolute(name, error);
  for(int i = 0; i < longest_chain && fs::is_symlink(path, error); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  const fs::path result = fs::weakly_canonical(path, error);
  return error ? path : result;
}

// Whether what is written under one name would be lost under the other.
bool are_same_file(const std::string& a, const std::string& b)
{
  if(a.empty() || b.empty())
    return false;
  if(a == standard_stream || b == standard_stream)
    return a == b;
  if(is_special_file(a) || is_special_file(b))
    return false;
  std::error_code error; // of names that do not exist
  return fs::equivalent(a, b, error) || resolved(a) == resolved(b);
}

// Gives `copy`, which is to replace `original`, its mode and owner. Returns whether that worked.
bool take_mode_and_owner(const fs::path& original, const fs::path& copy)
{
  std::error_code error;
#ifdef SEAMLESS_SNAPPING_FILES_HAVE_OWNERS
  struct stat old_file, new_file;
  if(stat(original.c_str(), &old_file) != 0 || stat(copy.c_str(), &new_file) != 0)
    return false;
  if((old_file.st_uid != new_file.st_uid || old_file.st_gid != new_file.st_gid)
     && chown(copy.c_str(), old_file.st_uid, old_file.st_gid) != 0)
    return false;
  if(old_file.st_nlink > 1) // other names of the file would keep the old text
    return false;
#endif
  fs::permissions(copy, fs::status(original, error).permissions(), error);
  return !error;
}

using Write = std::function<void(std::ostream&)>;

Write writing(const std::string& text)
{
  return [&text](std::ostream& os) {
    os.write(text.data(), static_cast<std::streamsize>(text.size()));
  };
}

void write_directly(const fs::path& place, const std::string& filename, const Write& write)
{
  errno = 0;
  std::ofstream os(place, std::ios::binary);
  if(!os)
    fail(UNWRITABLE, "cannot write", filename, reason());
  write(os);
  os.close();
  if(!os)
    fail(UNWRITABLE, "cannot write", filename, reason());
}

// A file that may not be written to is not replaced either.
void check_existing(const fs::path& place, const std::string& filename)
{
  errno = 0;
  if(!std::ofstream(place, std::ios::binary | std::ios::app))
    fail(UNWRITABLE, "cannot write", filename, reason());
}

fs::path unused_name(const fs::path& place)
{
  std::error_code error;
  fs::path result = place.string() + ".unfinished";
  for(int i = 2; fs::exists(result, error); ++i)
    result = place.string() + ".unfinished" + std::to_string(i);
  return result;
}

// Throws unless the file can be written, which it will be when all is computed: then would be late.
// What is there stays as it is. Pipes are not opened, as their readers would take it for the end.
void check_writable(const std::string& filename)
{
  if(filename.empty() || is_special_file(filename))
    return;
  const fs::path place = resolved(filename), unfinished = unused_name(place);
  std::error_code error;
  if(fs::exists(place, error))
    check_existing(place, filename);
  write_directly(unfinished, filename, writing(""));
  fs::remove(unfinished, error);
}

std::string text_of_file(const std::string& filename)
{
  errno = 0;
  if(filename == standard_stream) {
    std::string text(std::istreambuf_iterator<char>(std::cin), {});
    if(std::cin.bad())
      throw Failure(UNREADABLE, "cannot read the standard input");
    return text;
  }
  std::ifstream is = open_file(filename);
  std::string text;
  std::error_code error; // of files without a size
  if(const std::uintmax_t size = fs::file_size(filename, error); !error)
    text.reserve(std::size_t(size));
  std::vector<char> buffer(std::size_t(1) << 20);
  while(is.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || is.gcount() > 0)
    text.append(buffer.data(), static_cast<std::size_t>(is.gcount()));
  if(is.bad() || fs::is_directory(filename))
    fail(UNREADABLE, "cannot read", filename, reason());
  return text;
}

// Not that of what a symbolic link leads to: programs look for what belongs to a file beside its name.
fs::path folder_of(const std::string& filename)
{
  std::error_code error;
  const fs::path folder = fs::absolute(filename, error).parent_path();
  const fs::path result = fs::weakly_canonical(folder, error);
  return error ? folder : result;
}

// The name of a file, which may have blanks, or those of several. What is not there keeps its name.
std::string moved_names(const std::string& names, const fs::path& old_folder,
                        const fs::path& new_folder)
{
  const auto moved = [&](const std::string& name) {
    std::error_code error;
    const fs::path place = (old_folder / name).lexically_relative(new_folder);
    const bool is_kept =
      fs::path(name).is_absolute() || place.empty() || !fs::exists(old_folder / name, error);
    return is_kept ? name : place.generic_string();
  };
  if(const std::string result = moved(names); result != names)
    return result;
  std::string result;
  std::istringstream words(names);
  for(std::string name; words >> name; )
    result += (result.empty() ? "" : " ") + moved(name);
  return result;
}

} // namespace

std::ifstream open_file(const std::string& filename)
{
  errno = 0;
  std::ifstream result(filename, std::ios::binary);
  if(!result)
    fail(UNREADABLE, "cannot read", filename, reason());
  return result;
}

std::string read_file(const std::string& filename)
{
  std::string text = text_of_file(filename);
  if(text.find_first_not_of(" \t\r\n") == text.npos)
    throw Failure(UNREADABLE, filename + ": the file is empty");
  return text;
}

std::vector<double> read_numbers(const std::string& filename)
{
  const std::string text = read_file(filename), blanks = " \t\r\n\f\v";
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> result;
  while(!(stream >> std::ws).eof()) {
    const auto at = std::size_t(stream.tellg());
    double x = 0;
    if(!(stream >> x) || !std::isfinite(x)) {
      const std::size_t begin = text.find_last_of(blanks, at) + 1; // also of "1,5", at its comma
      const std::string word = text.substr(begin, text.find_first_of(blanks, at) - begin);
      throw Failure(UNREADABLE, filename + ": line " +
                                  std::to_string(1 + std::count(text.begin(),
                                                                text.begin() + std::ptrdiff_t(at),
                                                                '\n')) +
                                  ": '" + word + "' is no number");
    }
    result.push_back(x);
  }
  return result;
}

void write_file(const std::string& filename, const std::string& text)
{
  write_file(filename, writing(text));
}

void write_file(const std::string& filename, const Write& write)
{
  if(filename == standard_stream) {
    write(std::cout);
    if(!std::cout.flush())
      throw Failure(UNWRITABLE, "cannot write to the standard output");
    return;
  }
  if(is_special_file(filename)) // to rename a file to it would replace it
    return write_directly(filename, filename, write);

  const fs::path place = resolved(filename), unfinished = unused_name(place);
  std::error_code error;
  try {
    write_directly(unfinished, filename, writing(""));
    const bool exists = fs::exists(place, error);
    if(exists)
      check_existing(place, filename);
    const bool may_replace = !exists || take_mode_and_owner(place, unfinished);
    write_directly(unfinished, filename, write);
    if(may_replace) {
      fs::rename(unfinished, place, error);
      if(error)
        fail(UNWRITABLE, "cannot write", filename, error.message());
    } else { // the text fits on the disk
      write_directly(place, filename, [&](std::ostream& os) {
        os << std::ifstream(unfinished, std::ios::binary).rdbuf();
      });
      fs::remove(unfinished, error);
    }
  } catch(...) {
    fs::remove(unfinished, error);
    throw;
  }
}

bool is_special_file(const std::string& filename)
{
  std::error_code error;
  const fs::file_status status = fs::status(filename, error);
  return filename == standard_stream
         || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

std::string suffix_of(const std::string& filename)
{
  std::string suffix = fs::path(filename).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix.empty() ? suffix : suffix.substr(1);
}

void check_no_tetrahedra(const std::string& filename)
{
  if(suffix_of(filename) == "hexex")
    throw Failure(USAGE, "'" + filename + "': tetrahedra are for 'seamless snap', 'seamless "
                         "hexes', and 'seamless check' only");
}

void check_picture(const std::string& filename)
{
  if(!filename.empty() && suffix_of(filename) != "svg")
    throw Failure(USAGE, "'" + filename + "': pictures are written to .svg files");
}

void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                   const Overwriting overwriting)
{
  for(auto file = outputs.begin(); file != outputs.end(); ++file) {
    const auto same = std::find_if(outputs.begin(), file, [&](const std::string& other) {
      return are_same_file(*file, other);
    });
    if(same != file)
      throw Failure(USAGE, "'" + *same + "' and '" + *file + "' are the same file");
    const bool is_first = file == outputs.begin(); // the only one that may replace an input
    for(const std::string& input : inputs)
      if(*file != standard_stream && are_same_file(*file, input)
         && !(is_first && overwriting == Overwriting::ASKED_FOR))
        throw Failure(USAGE, "'" + *file + "' is the input"
                               + (is_first && overwriting == Overwriting::NOT_ASKED_FOR
                                    ? "; --overwrite replaces it" : ""));
  }
  std::for_each(outputs.begin(), outputs.end(), check_writable);
}

std::string with_libraries(std::string text, const std::string& from, const std::string& to)
{
  static const std::string keyword = "mtllib ", blanks = " \t", line_ends = "\r\n";
  if(is_special_file(from) || is_special_file(to))
    return text;
  const fs::path old_folder = folder_of(from), new_folder = folder_of(to);
  if(old_folder == new_folder)
    return text;
  for(std::size_t i = 0; (i = text.find(keyword, i)) != text.npos; ) {
    const std::size_t line = text.find_last_of(line_ends, i) + 1; // 0 in the first one
    const bool is_first = text.find_first_not_of(blanks, line) == i;
    i = (std::min)(text.find_first_not_of(blanks, i + keyword.size()), text.size());
    const std::size_t end = (std::min)(text.find_first_of("#" + line_ends, i), text.size());
    if(!is_first || i == end)
      continue;
    const std::size_t size = text.find_last_not_of(blanks, end - 1) + 1 - i;
    const std::string names = moved_names(text.substr(i, size), old_folder, new_folder);
    text.replace(i, size, names);
    i += names.size();
  }
  return text;
}

std::ostream& summary_stream(const std::vector<std::string>& outputs)
{
  return std::find(outputs.begin(), outputs.end(), standard_stream) == outputs.end() ? std::cout
                                                                                     : std::cerr;
}
