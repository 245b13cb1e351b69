// The text of a PLY file with other texture coordinates. The rest stays as it is, byte for byte.
// Only the type of the coordinates can change, from `float` to `double`.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_PLY_REWRITER_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_PLY_REWRITER_H

#include "Text_copy.h"
#include "parsers_of_library.h"

#include <CGAL/Seamless_snapping/internal/IO/PLY_header.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_parser.h>
#include <CGAL/Seamless_snapping/internal/IO/decimal_numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace formats {

class PLY_rewriter
{
public:
  // `soup` is the content of `text`, perhaps welded; `uvs` are the new coordinates of its corners.
  PLY_rewriter(const std::string_view text, const Soup& soup, const std::vector<UV>& uvs)
    : m_header(PLY_header_parser(text).parse()), m_values(text, m_header), m_soup(soup),
      m_uvs(uvs), m_copy(text)
  { }

  // To be called once. Throws if a coordinate is not finite.
  std::string rewrite()
  {
    for(const PLY_element& element : m_header.elements)
      if(element.name == "face")
        change_type(element.properties[PLY_face_layout(element).uvs]);
    for(const PLY_element& element : m_header.elements) {
      const PLY_face_layout layout(element);
      const std::size_t ends[2] = {element.find({"vertex1"}), element.find({"vertex2"})};
      for(unsigned long long row = 0; !element.properties.empty() && row < element.count; ++row)
        for(std::size_t i = 0; i < element.properties.size(); ++i)
          if(element.name == "face" && i == layout.vertices)
            rewrite_vertices(element.properties[i], static_cast<std::size_t>(row));
          else if(element.name == "face" && i == layout.uvs)
            rewrite_uvs(element.properties[i], static_cast<std::size_t>(row));
          else if(element.name == "edge" && (i == ends[0] || i == ends[1]))
            rewrite_index(element.properties[i],
                          m_soup.segments[std::size_t(row)].vertices[i == ends[0] ? 0 : 1]);
          else
            m_values.skip(element.properties[i]);
    }
    return m_copy.take();
  }

private:
  static bool are_same(const UV& a, const UV& b)
  {
    return is_same_number(a[0], b[0]) && is_same_number(a[1], b[1]);
  }

  // Numbers that stay keep their type.
  void change_type(const PLY_property& uvs)
  {
    const auto is_float = [](const UV& uv) {
      return std::all_of(uv.begin(), uv.end(), [](const double x) {
        return std::abs(x) <= (std::numeric_limits<float>::max)()
               && x == static_cast<double>(static_cast<float>(x));
      });
    };
    m_uv_type = uvs.type;
    const bool changes = !std::equal(m_uvs.begin(), m_uvs.end(), m_soup.uvs.begin(), are_same);
    const bool fits = uvs.type == PLY_type::DOUBLE
                      || (uvs.type == PLY_type::FLOAT
                          && std::all_of(m_uvs.begin(), m_uvs.end(), is_float));
    if(changes && !fits) {
      m_uv_type = PLY_type::DOUBLE;
      m_copy.replace(uvs.type_name, "double");
    }
  }

  // Only welding changes vertices, to some that come earlier in the file: their type has room for
  // them.
  void rewrite_vertices(const PLY_property& property, const std::size_t triangle)
  {
    m_values.next_length(property);
    for(const std::size_t v : m_soup.triangles[triangle].vertices)
      rewrite_index(property, v);
  }

  void rewrite_index(const PLY_property& property, const std::size_t v)
  {
    const std::string_view old = m_values.next(property.type);
    if(m_values.integer(old, property.type) != static_cast<long long>(v))
      m_copy.replace(old, text_of_index(v, property.type));
  }

  void rewrite_uvs(const PLY_property& property, const std::size_t triangle)
  {
    m_values.next_length(property);
    const bool changes_all = m_header.format != PLY_format::ASCII && m_uv_type != property.type;
    for(std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
      for(std::size_t c = 0; c < 2; ++c) {
        const std::string_view old = m_values.next(property.type);
        if(changes_all || !is_same_number(m_uvs[corner][c], m_soup.uvs[corner][c]))
          m_copy.replace(old, text_of_number(m_uvs[corner][c]));
      }
  }

  std::string text_of_number(const double x) const
  {
    std::string text;
    append_number(x, text); // throws if it is not finite
    if(m_header.format == PLY_format::ASCII)
      return text;
    text.clear();
    if(m_uv_type == PLY_type::FLOAT)
      append_bytes(static_cast<float>(x), m_header.format, text);
    else
      append_bytes(x, m_header.format, text);
    return text;
  }

  std::string text_of_index(const std::size_t v, const PLY_type type) const
  {
    if(m_header.format == PLY_format::ASCII)
      return std::to_string(v);
    std::string text;
    if(size_of(type) == 1)
      append_bytes(static_cast<std::uint8_t>(v), m_header.format, text);
    else if(size_of(type) == 2)
      append_bytes(static_cast<std::uint16_t>(v), m_header.format, text);
    else
      append_bytes(static_cast<std::uint32_t>(v), m_header.format, text);
    return text;
  }

  PLY_header m_header;
  PLY_values m_values;
  const Soup& m_soup;
  const std::vector<UV>& m_uvs;
  PLY_type m_uv_type = PLY_type::DOUBLE;
  Text_copy m_copy;
};

} // namespace formats

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_PLY_REWRITER_H
