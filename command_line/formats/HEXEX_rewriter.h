// The text of a HEXEX file with other coordinates. The rest stays as it is, byte for byte: walls,
// features, and any further content. Fractions that no `double` holds become decimal numbers.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_HEXEX_REWRITER_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_HEXEX_REWRITER_H

#include "parsers_of_library.h"

#include <CGAL/Seamless_snapping/internal/IO/HEXEX_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>
#include <CGAL/Seamless_snapping/internal/IO/file_access.h>

#include <array>
#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace formats {

class HEXEX_rewriter
{
public:
  HEXEX_rewriter(const std::string& original, std::ostream& os,
                 const std::vector<std::array<double, 3> >& uvw)
    : m_original(original), m_os(os), m_uvw(uvw)
  { }

  // All refusals come from the first of two passes, before anything is written.
  void run()
  {
    pass();
    m_writes = true;
    pass();
    write_until(m_original.size());
    if(!m_os.flush())
      throw File_refusal(0, "cannot write to the stream");
  }

private:
  void pass()
  {
    Word_scanner scanner(m_original);
    skip(3 * scanner.next_integer<std::size_t>("the number of vertices"), scanner);
    const std::size_t corners = 4 * scanner.next_integer<std::size_t>("the number of cells");
    if(corners != m_uvw.size())
      throw File_refusal(0, "the original has " + std::to_string(corners) +
                         " corners, and there are coordinates for " +
                         std::to_string(m_uvw.size()));
    for(std::size_t i = 0; i < corners; ++i) {
      if(i % 4 == 0)
        skip(4, scanner);
      for(const double to : m_uvw[i])
        replace(scanner.next(), to, scanner);
    }
  }

  static void skip(const std::size_t number, Word_scanner& scanner)
  {
    for(std::size_t i = 0; i < number; ++i)
      if(scanner.next().empty())
        scanner.refuse("the file ends too early");
  }

  void replace(const std::string_view token, const double to, const Word_scanner& scanner)
  {
    bool is_rounded = false;
    if(parse_number_or_fraction(scanner, token, is_rounded) == to && !is_rounded)
      return;
    m_number.clear();
    append_number(to, m_number); // refuses numbers that are not finite
    if(!m_writes)
      return;
    write_until(std::size_t(token.data() - m_original.data()));
    m_os << m_number;
    m_copied += token.size();
  }

  void write_until(const std::size_t end)
  {
    m_os.write(m_original.data() + m_copied, static_cast<std::streamsize>(end - m_copied));
    m_copied = end;
  }

  const std::string& m_original;
  std::ostream& m_os;
  const std::vector<std::array<double, 3> >& m_uvw;
  std::string m_number;
  std::size_t m_copied = 0; // the original, up to this position
  bool m_writes = false;
};

// Copies a file with other coordinates of corners. If it fails, nothing is written.
inline File_status rewrite_HEXEX(std::istream& original, std::ostream& os,
                                 const std::vector<std::array<double, 3> >& uvw)
{
  return status_of_writing([&] {
    const std::string text = text_of(original);
    HEXEX_rewriter(text, os, uvw).run();
  });
}

} // namespace formats

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_HEXEX_REWRITER_H
