// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_FILE_ACCESS_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_FILE_ACCESS_H

#include <CGAL/license/Seamless_snapping.h>

// Files and streams as whole texts, and how their failures become a status.

#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/types/File_status.h>

#include <cerrno>
#include <cstddef>
#include <fstream>
#include <ios>
#include <istream>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Why the last call of the operating system failed, if it says so, to be put behind a message.
// Streams don't tell; what they call sets `errno`.
inline std::string reason_of_system()
{
  return errno == 0 ? std::string() : ": " + std::generic_category().message(errno);
}

// The number of characters up to the end of what can be searched, such as a file; else 0.
inline std::size_t remaining_size(std::streambuf& buffer)
{
  const std::streamoff begin = buffer.pubseekoff(0, std::ios_base::cur, std::ios_base::in);
  if(begin < 0)
    return 0;
  const std::streamoff end = buffer.pubseekoff(0, std::ios_base::end, std::ios_base::in);
  buffer.pubseekpos(begin, std::ios_base::in);
  return end > begin ? static_cast<std::size_t>(end - begin) : 0;
}

// Reads a stream to its end. Throws if that fails. Reads from its buffer, since members of the
// stream would take the end for a failure, for which it may have been asked to throw.
inline std::string text_of(std::istream& is)
{
  if(!is)
    throw File_refusal(0, "cannot read the stream");
  std::string text;
  std::vector<char> buffer(std::size_t(1) << 16);
  const std::streamsize size = static_cast<std::streamsize>(buffer.size());
  try {
    for(std::streamsize count = size; count == size;) {
      count = is.rdbuf()->sgetn(buffer.data(), size);
      if(text.empty() && count == size) // what has no end can't be read at all
        text.reserve(buffer.size() + remaining_size(*is.rdbuf()));
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
  } catch(const std::ios_base::failure&) { // how some libraries tell that a file cannot be read
    is.setstate(std::ios::badbit);
    throw File_refusal(0, "cannot read the stream");
  }
  if((is.exceptions() & std::ios::eofbit) == 0)
    is.setstate(std::ios::eofbit);
  return text;
}

inline std::string text_of(const std::string& filename)
{
  errno = 0;
  std::ifstream is(filename, std::ios::binary);
  if(!is)
    throw File_refusal(0, "cannot open '" + filename + "'" + reason_of_system());
  try {
    return text_of(is);
  } catch(const File_refusal&) {
    throw File_refusal(0, "cannot read '" + filename + "'" + reason_of_system());
  }
}

inline void write_text(std::ostream& os, const std::string& text)
{
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
  if(!os.flush())
    throw File_refusal(0, "cannot write to the stream");
}

inline void write_text(const std::string& filename, const std::string& text)
{
  errno = 0;
  std::ofstream os(filename, std::ios::binary);
  if(!os)
    throw File_refusal(0, "cannot open '" + filename + "' for writing" + reason_of_system());
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
  if(!os.flush() || !os.rdbuf()->close())
    throw File_refusal(0, "cannot write to '" + filename + "'" + reason_of_system());
}

// Calls `f()`, which returns what was done.
template <typename F>
IO::File_status status_of_reading(const F& f)
{
  try {
    return f();
  } catch(const File_refusal& refusal) {
    return {refusal.message(), refusal.line()};
  }
}

template <typename F>
IO::File_status status_of_writing(const F& f)
{
  return status_of_reading([&f] {
    f();
    return IO::File_status();
  });
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_FILE_ACCESS_H
