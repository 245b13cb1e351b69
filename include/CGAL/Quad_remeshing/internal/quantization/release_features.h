// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_RELEASE_FEATURES_H
#define CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_RELEASE_FEATURES_H

#include <CGAL/license/Quad_remeshing.h>

// Features that force quads: which ones, and that they are walls no more.

#include <CGAL/Quad_remeshing/internal/quantization/coarsen.h>
#include <CGAL/Quad_remeshing/internal/quantization/quantize_surface.h>
#include <CGAL/Quad_remeshing/internal/quantization/wanted_units.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// The halfedges of a feature between two vertices where it turns, ends, or meets others.
using Feature_chain = std::vector<Corner_index>;

inline bool is_feature(const Integer_mesh& mesh, const Corner_index h)
{ return mesh.corner(h).is_wall && mesh.opposite(h) != no_index; }

// The halfedge by which a feature goes on, straight and alone, after a halfedge; or no index.
inline Corner_index next_on_feature(const Integer_mesh& mesh, const Corner_index h)
{
  Corner_index result = no_index;
  int axes = 0;
  for(Corner_index c = mesh.counterclockwise(h); c != no_index; c = mesh.counterclockwise(c)) {
    axes += axes_at_corner(mesh, c, &Integer_corner::vector);
    if(c == h)
      return axes == 4 ? result : no_index;
    if(!mesh.corner(c).is_wall)
      continue;
    if(result != no_index || axes != 2)
      return no_index;
    result = mesh.opposite(c);
  }
  return no_index; // at the border
}

// All features, each in one direction; closed ones begin anywhere.
inline std::vector<Feature_chain> feature_chains(const Integer_mesh& mesh)
{
  std::vector<Feature_chain> result;
  std::vector<char> is_visited(mesh.corners.size(), false);
  for(const bool is_closed : {false, true})
    for(Corner_index first = 0; first < mesh.number_of_halfedges(); ++first) {
      if(!is_feature(mesh, first) || is_visited[std::size_t(first)] ||
         (!is_closed && next_on_feature(mesh, mesh.opposite(first)) != no_index))
        continue;
      result.emplace_back();
      for(Corner_index h = first; h != no_index && !is_visited[std::size_t(h)];
          h = next_on_feature(mesh, h)) {
        result.back().push_back(h);
        is_visited[std::size_t(h)] = is_visited[std::size_t(mesh.opposite(h))] = true;
      }
    }
  return result;
}

// In the domain.
inline double length_in_map(const Integer_mesh& mesh, const std::vector<Feature_chain>& chains)
{
  double result = 0;
  for(const Feature_chain& chain : chains)
    for(const Corner_index h : chain)
      result +=
        mesh.steps[std::size_t(mesh.part[std::size_t(h / 3)])] * length(mesh.corner(h).vector);
  return result;
}

// The surface without some of its features.
inline Coarse_surface without_features(const Coarse_surface& surface,
                                       const std::vector<Feature_chain>& chains)
{
  Coarse_surface result;
  result.input = surface.input;
  result.steps = surface.steps;
  for(const Feature_chain& chain : chains)
    for(const Corner_index h : chain)
      for(const Corner_index side : {h, surface.input.opposite(h)})
        result.input.corners[std::size_t(side)].is_wall = false;
  result.complex = make_coarse_complex(result.input);
  return result;
}

// Triangles that are too small for integers force quads: at least one, or one along a wall. Without
// a feature, the triangles at its sides and ends would be others.
class Costly_features
{
public:
  // \param scales units per step of the input's grid, per part
  Costly_features(const Coarse_surface& surface, const std::vector<double>& scales)
    : m_surface(surface), m_scales(scales), m_chains(feature_chains(surface.input)),
      m_faces(m_chains.size()), m_is_settled(std::size_t(surface.complex.number_of_faces()), false)
  {
    for(const Feature_chain& chain : m_chains)
      m_length.push_back(length_in_map(surface.input, {chain}));
    collect_faces();
  }

  bool exist() const
  {
    for(std::size_t i = 0; i < m_chains.size(); ++i)
      if(forced_quads(i) > 0)
        return true;
    return false;
  }

  // The chains that force most for their length: at least one. The last one makes their length
  // exceed `enough`; it never exceeds `most`.
  std::vector<Feature_chain> find(const double enough, const double most)
  {
    std::vector<std::pair<double, std::size_t> > order;
    for(std::size_t i = 0; i < m_chains.size(); ++i)
      if(const double forced = forced_quads(i); forced > 0)
        order.emplace_back(-forced / m_length[i], i);
    std::sort(order.begin(), order.end());
    std::vector<Feature_chain> result;
    double sum = 0;
    for(const auto& [value, i] : order) {
      const bool is_needed = 2 * forced_quads(i) > -value * m_length[i];
      if(!is_needed || sum + m_length[i] > most)
        continue;
      result.push_back(m_chains[i]);
      sum += m_length[i];
      for(const Flat_face_index f : m_faces[i])
        m_is_settled[std::size_t(f)] = true;
      if(sum >= enough)
        break;
    }
    return result;
  }

private:
  // Per feature: the faces at the vertices of the coarse triangulation that it leads to.
  void collect_faces()
  {
    const Integer_mesh& input = m_surface.input;
    const Intrinsic_complex& complex = m_surface.complex;
    std::vector<std::size_t> chain_of(input.corners.size(), m_chains.size());
    for(std::size_t i = 0; i < m_chains.size(); ++i)
      for(const Corner_index h : m_chains[i])
        chain_of[std::size_t(h)] = chain_of[std::size_t(input.opposite(h))] = i;
    for(Corner_index h = 0; h < complex.number_of_halfedges(); ++h) {
      const Corner_index departure = complex.corner(h).departure.corner;
      const std::size_t i = chain_of[std::size_t(Integer_mesh::next(departure))];
      if(!complex.corner(h).is_wall || i == m_chains.size())
        continue;
      for_each_corner(complex, complex.source(h),
                      [&](const Corner_index c) { m_faces[i].push_back(c / 3); });
    }
    for(std::vector<Flat_face_index>& all : m_faces) {
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
    }
  }

  double forced_quads(const std::size_t chain) const
  {
    double result = 0;
    for(const Flat_face_index f : m_faces[chain])
      result += m_is_settled[std::size_t(f)] ? 0 : forced_quads_of_face(f);
    return result;
  }

  double forced_quads_of_face(const Flat_face_index f) const
  {
    const Intrinsic_complex& complex = m_surface.complex;
    const auto a = wanted_units(complex, 3 * f, m_scales);
    const auto b = wanted_units(complex, 3 * f + 1, m_scales);
    const double twice_area = a[0] * b[1] - a[1] * b[0];
    double least = 1; // twice the area, once there are integers
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h)
      if(complex.corner(h).is_wall) {
        const auto side = wanted_units(complex, h, m_scales);
        const double width = std::hypot(side[0], side[1]);
        least = (std::max)({least, width, twice_area / width});
      }
    return (std::max)(0., least - twice_area) / 2;
  }

  const Coarse_surface& m_surface;
  std::vector<double> m_scales;
  std::vector<Feature_chain> m_chains;
  std::vector<double> m_length;                       // per feature
  std::vector<std::vector<Flat_face_index> > m_faces; // per feature
  std::vector<char> m_is_settled; // per face of the coarse triangulation: a feature is released
};

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_QUANTIZATION_RELEASE_FEATURES_H
