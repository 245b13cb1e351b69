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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_PARSER_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_PARSER_H

#include <CGAL/license/Seamless_snapping.h>

// The text of a PLY file as a triangle soup, with coordinates per corner as MeshLab writes them: a
// list `texcoord` of six numbers for each face. For coordinates of type `void`, a polygon soup
// without coordinates.

#include <CGAL/Linear_snapping/internal/exact/Protect_exact_arithmetic.h>
#include <CGAL/Seamless_snapping/internal/IO/Corner_soup.h>
#include <CGAL/Seamless_snapping/internal/IO/File_refusal.h>
#include <CGAL/Seamless_snapping/internal/IO/PLY_header.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// The places of the data of faces among the properties.
struct PLY_face_layout
{
  explicit PLY_face_layout(const PLY_element& element)
    : vertices(element.find({"vertex_indices", "vertex_index"})), uvs(element.find({"texcoord"}))
  { }

  std::size_t vertices, uvs;
};

template <typename PointNumber, typename UVNumber>
class PLY_parser
{
public:
  using Soup = Corner_soup<PointNumber, UVNumber>;

  // Throws `File_refusal` if the header is wrong.
  explicit PLY_parser(const std::string_view text)
    : m_header(PLY_header_parser(text).parse()), m_values(text, m_header)
  { }

  // To be called once. Throws `File_refusal`.
  Soup parse();

private:
  static constexpr bool has_uvs = !std::is_void_v<UVNumber>;

  // Calls `read(property, its index)` for all properties of all rows.
  template <typename Read>
  void for_each_row(const PLY_element& element, const Read& read)
  {
    for(unsigned long long row = 0; row < element.count; ++row) {
      m_values.set_place(element.name, row);
      for(std::size_t i = 0; i < element.properties.size(); ++i)
        read(element.properties[i], i);
    }
  }

  // Throws unless the element has this property, which is a list or is not.
  static void need(const PLY_element& element, const std::size_t property, const bool is_list,
                   const std::string& name)
  {
    if(property == element.properties.size()
       || element.properties[property].is_list != is_list)
      throw File_refusal(0, "element " + std::string(element.name) + " has no "
                              + (is_list ? "list " : "number ") + name
                              + (name == "texcoord" ? remedy(compute_coordinates) : Message()));
  }

  void parse_vertices(const PLY_element& element)
  {
    std::array<std::size_t, 3> places;
    const std::array<const char*, 3> names = {"x", "y", "z"};
    for(std::size_t c = 0; c < 3; ++c) {
      places[c] = element.find({names[c]});
      need(element, places[c], false, names[c]);
    }
    for_each_row(element, [&](const PLY_property& property, const std::size_t i) {
      if(i == 0)
        m_soup.points.emplace_back();
      const auto place = std::find(places.begin(), places.end(), i);
      if(place == places.end())
        return m_values.skip(property);
      const std::string_view value = m_values.next(property.type);
      m_soup.points.back()[std::size_t(place - places.begin())] =
        m_values.template number<PointNumber>(value, property.type);
    });
  }

  void parse_faces(const PLY_element& element)
  {
    const PLY_face_layout layout(element);
    need(element, layout.vertices, true, "vertex_indices");
    if constexpr(has_uvs) {
      need(element, layout.uvs, true,
           "texcoord: coordinates per corner are needed, not per vertex");
      for_each_row(element, [&](const PLY_property& property, const std::size_t i) {
        if(i == 0)
          m_soup.triangles.push_back({{}, {}, 0});
        if(i == layout.vertices)
          parse_triangle(property);
        else if(i == layout.uvs)
          parse_uvs(property);
        else
          m_values.skip(property);
      });
    } else {
      for_each_row(element, [&](const PLY_property& property, const std::size_t i) {
        if(i == layout.vertices)
          parse_polygon(property, m_soup.polygons);
        else
          m_values.skip(property);
      });
    }
  }

  template <typename Polygons>
  void parse_polygon(const PLY_property& property, Polygons& polygons)
  {
    polygons.emplace_back();
    // a length that is wrong ends with the file
    for(std::size_t n = m_values.next_length(property); n > 0; --n)
      polygons.back().vertices.push_back(next_index(property));
  }

  void parse_triangle(const PLY_property& property)
  {
    const std::size_t n = m_values.next_length(property);
    if(n != 3)
      m_values.refuse("has " + std::to_string(n) + " corners"
                      + (n > 3 ? "; triangulate the mesh first" : ", but needs 3"));
    std::array<Soup_index, 3>& v = m_soup.triangles.back().vertices;
    for(Soup_index& vertex : v)
      vertex = next_index(property);
    if(v[0] == v[1] || v[0] == v[2] || v[1] == v[2])
      m_values.refuse("uses vertex " + std::to_string(v[0] == v[1] ? v[0] : v[2]) + " twice");
  }

  void parse_uvs(const PLY_property& property)
  {
    const std::size_t n = m_values.next_length(property);
    if(n != 6)
      m_values.refuse("has " + std::to_string(n) + " texture coordinates, but needs 6");
    for(Soup_index& uv : m_soup.triangles.back().uvs) {
      uv = checked(m_soup.uvs.size());
      m_soup.uvs.emplace_back();
      for(UVNumber& x : m_soup.uvs.back())
        x = m_values.template number<UVNumber>(m_values.next(property.type), property.type);
    }
  }

  void parse_edges(const PLY_element& element)
  {
    const std::size_t ends[2] = {element.find({"vertex1"}), element.find({"vertex2"})};
    need(element, ends[0], false, "vertex1");
    need(element, ends[1], false, "vertex2");
    for_each_row(element, [&](const PLY_property& property, const std::size_t i) {
      if(i == 0)
        m_soup.segments.push_back({{}, 0});
      if(i == ends[0] || i == ends[1])
        m_soup.segments.back().vertices[i == ends[0] ? 0 : 1] = next_index(property);
      else
        m_values.skip(property);
    });
  }

  Soup_index next_index(const PLY_property& property)
  {
    const long long index = m_values.integer(m_values.next(property.type), property.type);
    if(index < 0)
      m_values.refuse("vertex index " + std::to_string(index) + " is negative");
    return checked(static_cast<std::size_t>(index));
  }

  Soup_index checked(const std::size_t index) const
  {
    if(index > largest_soup_index)
      m_values.refuse("index " + std::to_string(index) + " is out of range");
    return static_cast<Soup_index>(index);
  }

  void check_indices()
  {
    const auto check = [this](const auto& elements, const char* name) {
      for(std::size_t i = 0; i < elements.size(); ++i)
        for(const std::size_t v : elements[i].vertices)
          if(v >= m_soup.points.size()) {
            m_values.set_place(name, i);
            m_values.refuse("vertex index " + std::to_string(v) + " is out of range: the file has "
                            + std::to_string(m_soup.points.size()) + " vertices");
          }
    };
    check(m_soup.faces(), "face");
    check(m_soup.segments, "edge");
  }

  PLY_header m_header;
  PLY_values m_values;
  Soup m_soup;
};

// Outside of the class, so that programs that share a library can share this, too.
template <typename PointNumber, typename UVNumber>
Corner_soup<PointNumber, UVNumber> PLY_parser<PointNumber, UVNumber>::parse()
{
  // parsing decimals may multiply in the current rounding mode
  const Protect_exact_arithmetic protect;

  for(const PLY_element& element : m_header.elements) {
    if(element.properties.empty())
      continue;
    if(element.name == "vertex")
      parse_vertices(element);
    else if(element.name == "face")
      parse_faces(element);
    else if(element.name == "edge")
      parse_edges(element);
    else
      for_each_row(element, [this](const PLY_property& p, std::size_t) { m_values.skip(p); });
  }
  if(m_soup.faces().empty())
    throw File_refusal(0, "the file has no face");
  check_indices();
  return std::move(m_soup);
}

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_IO_PLY_PARSER_H
