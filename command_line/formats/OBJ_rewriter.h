// The text of an OBJ file with other texture coordinates. The rest stays as it is, byte for byte.
//
// A `vt` statement keeps its place, and its digits if its numbers stay. If corners that share a
// statement get different coordinates, further statements follow it; later statements then have
// higher indices.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_OBJ_REWRITER_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_OBJ_REWRITER_H

#include "Text_copy.h"
#include "parsers_of_library.h"

#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Seamless_snapping/internal/IO/Distinct_uvs.h>
#include <CGAL/Seamless_snapping/internal/IO/OBJ_scanner.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace formats {

// The places of the coordinates: each old `vt` statement becomes one or more.
class OBJ_uv_layout
{
public:
  // `uvs` are the new coordinates of all corners.
  OBJ_uv_layout(const Soup& soup, const std::vector<UV>& uvs)
    : m_first(1, 0)
  {
    const std::size_t n = soup.uvs.size(); // old statements
    Distinct_uvs distinct(n);
    std::vector<std::size_t> old_index; // per distinct pair
    if(n + 3 * soup.triangles.size() > largest_soup_index)
      throw File_refusal(0, "the file is too large; nothing is written");
    m_index.reserve(3 * soup.triangles.size());
    for(std::size_t c = 0; c < uvs.size(); ++c) {
      const std::size_t old = soup.triangles[c / 3].uvs[c % 3], i = distinct.insert(old, uvs[c]);
      m_index.push_back(Soup_index(i));
      if(i == old_index.size())
        old_index.push_back(old);
    }

    const Lists<std::size_t> by_statement(n, [&](const auto& add) {
      for(std::size_t i = 0; i < old_index.size(); ++i)
        add(old_index[i], i);
    });
    std::vector<std::size_t> place(old_index.size());
    for(std::size_t k = 0; k < n; ++k) {
      for(const std::size_t i : by_statement[k]) {
        place[i] = m_uvs.size();
        m_uvs.push_back(distinct.uvs()[i]);
      }
      m_is_used.resize(m_uvs.size(), true);
      if(by_statement[k].empty()) // one that no corner uses stays
        m_uvs.emplace_back();
      m_is_used.resize(m_uvs.size(), false);
      m_first.push_back(m_uvs.size());
    }
    for(Soup_index& i : m_index)
      i = Soup_index(place[i]);
  }

  std::size_t index_of_corner(std::size_t c) const { return m_index[c]; }

  // The new indices that old statement `k` has become: from `first(k)` to before `first(k + 1)`.
  std::size_t first(std::size_t k) const { return m_first[k]; }
  bool keeps_indices() const { return m_uvs.size() + 1 == m_first.size(); }
  bool is_used(std::size_t i) const { return m_is_used[i]; }
  const UV& uv(std::size_t i) const { return m_uvs[i]; }

private:
  std::vector<std::size_t> m_first;
  std::vector<Soup_index> m_index;  // per corner
  std::vector<UV> m_uvs;            // per new statement
  std::vector<bool> m_is_used;
};

class OBJ_rewriter
{
public:
  // `soup` is the content of `text`, perhaps welded; `uvs` are the new coordinates of its corners.
  OBJ_rewriter(const std::string_view text, const Soup& soup, const std::vector<UV>& uvs)
    : m_soup(soup), m_layout(soup, uvs), m_scanner(text), m_copy(text)
  { }

  // To be called once. Throws if a coordinate is not finite.
  // \param is_welded whether vertices of the soup are no longer all vertices of the text
  std::string rewrite(const bool is_welded)
  {
    const bool keeps_indices = m_layout.keeps_indices() && !is_welded;
    for(std::string_view keyword = m_scanner.next_statement();
        !keyword.empty() && !(keeps_indices && m_number_of_uvs == m_soup.uvs.size());
        keyword = m_scanner.next_statement()) {
      if(keyword == "v")
        ++m_number_of_points;
      else if(keyword == "vt")
        rewrite_uv();
      else if(keyword == "f")
        rewrite_face();
      else if(keyword == "l")
        rewrite_polyline();
    }
    return m_copy.take();
  }

private:
  void rewrite_uv()
  {
    const std::size_t k = m_number_of_uvs++;
    std::string further_numbers;
    std::size_t place = 0;
    for(std::string_view token; !(token = m_scanner.next_token()).empty(); ++place)
      if(place >= 2)
        further_numbers += " " + std::string(token);
      else if(m_layout.is_used(m_layout.first(k)))
        rewrite_number(token, m_soup.uvs[k][place], m_layout.uv(m_layout.first(k))[place]);
    if(m_layout.first(k) + 1 == m_layout.first(k + 1))
      return;

    const std::string_view end = m_scanner.finish_statement();
    std::string statements(end);
    for(std::size_t i = m_layout.first(k) + 1; i < m_layout.first(k + 1); ++i) {
      if(end.empty()) // at the end of the text
        statements += '\n';
      statements += "vt ";
      append_number(m_layout.uv(i)[0], statements);
      statements += ' ';
      append_number(m_layout.uv(i)[1], statements);
      statements.append(further_numbers).append(end);
    }
    m_copy.replace(end, statements);
  }

  void rewrite_number(const std::string_view token, const double old_number, const double number)
  {
    if(is_same_number(old_number, number))
      return;
    std::string decimal;
    append_number(number, decimal);
    m_copy.replace(token, decimal);
  }

  void rewrite_face()
  {
    const Soup::Triangle& triangle = m_soup.triangles[m_number_of_triangles];
    for(std::size_t i = 0; i < 3; ++i) {
      const std::string_view token = m_scanner.next_token();
      const std::size_t first = token.find('/'), second = token.find('/', first + 1);
      rewrite_index(token.substr(0, first), triangle.vertices[i], m_number_of_points);
      rewrite_index(token.substr(first + 1, second - first - 1),
                    m_layout.index_of_corner(3 * m_number_of_triangles + i),
                    m_layout.first(m_number_of_uvs));
    }
    ++m_number_of_triangles;
  }

  void rewrite_polyline()
  {
    bool is_first = true;
    for(std::string_view token; !(token = m_scanner.next_token()).empty();) {
      const std::size_t slash = token.find('/');
      // the first two vertices are of one segment
      const std::size_t end = is_first ? 0 : 1;
      rewrite_index(token.substr(0, slash), m_soup.segments[m_number_of_segments].vertices[end],
                    m_number_of_points);
      m_number_of_segments += end;
      is_first = false;
      if(slash != token.npos)
        rewrite_uv_of_polyline(token.substr(slash + 1));
    }
  }

  // A `vt` that exists becomes the first of the statements that have taken its place.
  void rewrite_uv_of_polyline(const std::string_view token)
  {
    const long long index = parse_index(token);
    const long long k = index > 0 ? index - 1 : index + static_cast<long long>(m_number_of_uvs);
    if(k >= 0 && k < static_cast<long long>(m_soup.uvs.size()))
      rewrite_index(token, m_layout.first(static_cast<std::size_t>(k)),
                    m_layout.first(m_number_of_uvs));
  }

  static long long parse_index(const std::string_view token)
  {
    long long index = 0;
    std::from_chars(token.data(), token.data() + token.size(), index);
    return index;
  }

  // A negative index counts back from the number of elements so far.
  void rewrite_index(const std::string_view token, const std::size_t index,
                     const std::size_t number_so_far)
  {
    const long long old = parse_index(token);
    long long written = static_cast<long long>(index) + 1;
    if(old < 0)
      written -= static_cast<long long>(number_so_far) + 1;
    if(written != old)
      m_copy.replace(token, std::to_string(written));
  }

  const Soup& m_soup;
  OBJ_uv_layout m_layout;
  OBJ_scanner m_scanner;
  Text_copy m_copy;
  std::size_t m_number_of_points = 0, m_number_of_uvs = 0, m_number_of_triangles = 0,
              m_number_of_segments = 0; // so far
};

} // namespace formats

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_OBJ_REWRITER_H
