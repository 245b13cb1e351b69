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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_CUT_COMPLEX_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_CUT_COMPLEX_H

#include <CGAL/license/Seamless_snapping.h>

// The part of a parametrization with constraints: the sectors at cuts and aligned edges, and their
// links ([MC19] Sec. 5.3). It knows no mesh and no uv map: a reader fills it, and rows, exact
// coordinates, and the verification are functions of it.

#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Seamless_snapping/internal/packages_below.h>
#include <CGAL/Seamless_snapping/internal/transitions/Rotation_group.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

using Sector_index = std::int32_t;
// the index of a vertex of the complex, which has no vertices without constraints
using Vertex_index = std::int32_t;
using Branch_index = std::int32_t;

// Invariants: the sectors of a vertex are consecutive. The pairs of a branch, and the sectors of a
// chain, are in order; the first and the last are at nodes, all others are not, and those are in no
// other pair or chain. Coordinates are finite.
template <typename Group>
struct Cut_complex
{
  static_assert(Group::dimension == 2, "a volume has sheets and places, see internal/volume");

  using Vector = std::array<double, Group::dimension>;
  using Element = typename Group::Element;

  // The sectors on both sides of a cut, at one vertex: u(minus) = g u(plus) + t, with the g and t
  // of the branch.
  struct Pair
  {
    Sector_index plus, minus;
  };

  // A sector whose corners differ in the input, along edges that are no cuts.
  struct Mixed_sector
  {
    Sector_index sector;
    Vector deviation;  // from the first corner to the mean of the corners
    double distance;   // root mean square, of the corners from their mean
    double largest;    // absolute value of a coordinate of its corners
  };

  // A path crosses a branch: along, from plus to minus, or back.
  struct Crossing
  {
    Branch_index branch;
    bool is_along;
  };

  // [MC19] Eq. (6): with g the transitions of the crossings, composed, and f' = act(g, functional),
  // f'(g(u(a))) and f'(u(b)) are to be equal. A cycle has a = b.
  struct Path
  {
    Sector_index a, b;
    int functional;
    std::vector<Crossing> crossings;
  };

  // The sum of coordinates times coefficients is to be equal to the right-hand side.
  struct Equation
  {
    struct Term
    {
      Sector_index sector;
      int coordinate;
      Exact_rational coefficient;
    };

    std::vector<Term> terms;
    Exact_rational right_hand_side;
  };

  // Sectors
  std::vector<Vector> coordinates;          // in the input; first corner of mixed sectors
  std::vector<Mixed_sector> mixed_sectors;  // by sector
  std::vector<Sector_index> first_sector;   // per vertex, and the number of sectors
  std::vector<char> is_node;                // per vertex

  // Cut branches
  std::vector<Element> element;             // per branch: g
  Lists<Pair> pairs;                        // per branch

  // Chains of aligned edges, along which a functional is constant: f(u) = a
  std::vector<int> functional;              // per chain
  Lists<Sector_index> links;                // per chain: sectors

  // Further constraints, between sectors of nodes
  std::vector<Path> paths;
  std::vector<Equation> equations;

  std::size_t number_of_sectors() const { return coordinates.size(); }
  std::size_t number_of_vertices() const { return is_node.size(); }
  std::size_t number_of_branches() const { return element.size(); }
  std::size_t number_of_chains() const { return functional.size(); }

  // Null for sectors whose corners are the same.
  const Mixed_sector* find_mixed_sector(const Sector_index s) const
  {
    const auto found = std::lower_bound(
      mixed_sectors.begin(), mixed_sectors.end(), s,
      [](const Mixed_sector& m, const Sector_index t) { return m.sector < t; });
    return found != mixed_sectors.end() && found->sector == s ? &*found : nullptr;
  }

  // The pairs between the pairs, or links, at the nodes.
  typename Lists<Pair>::List inner_pairs(const std::size_t b) const
  { return pairs[b].advance_begin(1).advance_end(-1); }
  Lists<Sector_index>::List inner_links(const std::size_t c) const
  { return links[c].advance_begin(1).advance_end(-1); }
};

// Which sectors the pairs of a complex link, and which functionals its chains fix, seen from each
// sector.

template <typename Group>
class Sector_links
{
public:
  // u(sector) = element u(here) + t, for some translation.
  struct Link
  {
    Sector_index sector;
    typename Group::Element element;
  };

  explicit Sector_links(const Cut_complex<Group>& complex)
    : m_links(complex.number_of_sectors(), [&](const auto& add) {
        for(std::size_t b = 0; b < complex.number_of_branches(); ++b)
          for(const auto& pair : complex.pairs[b]) {
            add(pair.plus, Link{pair.minus, complex.element[b]});
            add(pair.minus, Link{pair.plus, Group::inverse(complex.element[b])});
          }
      }),
      m_functionals(complex.number_of_sectors(), [&](const auto& add) {
        for(std::size_t c = 0; c < complex.number_of_chains(); ++c)
          for(const Sector_index s : complex.links[c])
            add(s, complex.functional[c]);
      })
  {
    for(const auto& path : complex.paths) {
      m_pinned.push_back(path.a);
      m_pinned.push_back(path.b);
    }
    for(const auto& equation : complex.equations)
      for(const auto& term : equation.terms)
        m_pinned.push_back(term.sector);
    std::sort(m_pinned.begin(), m_pinned.end());
  }

  typename Lists<Link>::List links(const Sector_index s) const { return m_links[s]; }
  Lists<int>::List functionals(const Sector_index s) const { return m_functionals[s]; }

  // Whether the sector is in a further constraint.
  bool is_pinned(const Sector_index s) const
  { return std::binary_search(m_pinned.begin(), m_pinned.end(), s); }

private:
  Lists<Link> m_links;
  Lists<int> m_functionals;
  std::vector<Sector_index> m_pinned;
};

// The complex of a mesh, and the way back.
// Invariant: the corners of a sector are consecutive, clockwise. Sectors are made for the ends of
// all cut, merged, and aligned edges, and for the vertices of further constraints.
template <typename Group, typename Halfedge>
struct Surface_cuts
{
  Cut_complex<Group> complex;
  Lists<Halfedge> corners;         // per sector
  std::vector<std::array<Halfedge, 2> > branch_ends, chain_ends; // the first and the last edge
  // One sector of each vertex that is to be a point of an integer grid; ascending.
  std::vector<Sector_index> grid_points;
  std::size_t number_of_singular_vertices = 0;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_COMPLEX_CUT_COMPLEX_H
