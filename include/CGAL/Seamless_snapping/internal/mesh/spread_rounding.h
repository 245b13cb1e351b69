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

#ifndef CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SPREAD_ROUNDING_H
#define CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SPREAD_ROUNDING_H

#include <CGAL/license/Seamless_snapping.h>

// Roundings of the size of a face would turn faces beside the cuts if only the vertices of the cuts
// moved. So they are spread over the surface first: all vertices move, by the displacement whose
// Dirichlet energy in the domain is least among those that give the cuts their rounded
// translations, the cones their coordinates, and the aligned edges their levels. What follows is
// exact; this is not, and need not be.

#include <CGAL/Seamless_snapping/internal/complex/integer_rounding.h>
#include <CGAL/Seamless_snapping/internal/linear/Sparse_cholesky.h>
#include <CGAL/Seamless_snapping/internal/mesh/Surface_cuts.h>
#include <CGAL/Seamless_snapping/internal/mesh/uv_survey.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Seamless_snapping {
namespace internal {

// Invariant: the displacement of a corner is g x + c, where x is that of a vertex of the mesh.
template <typename Group, typename TriangleMesh, typename HalfedgeUVMap, typename VertexIndexMap>
class Rounding_spreader
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Cuts = Surface_cuts<Group, TriangleMesh>;
  using Vector = typename Cut_complex<Group>::Vector;
  using Element = typename Group::Element;
  static constexpr std::size_t dimension = Group::dimension;
  static constexpr std::size_t number_of_functionals = std::size_t(Group::number_of_functionals);

  struct Place
  {
    std::size_t vertex;
    Element element;
    Vector offset;
  };

  // Unknowns times their signs, and a number.
  struct Form
  {
    std::array<std::pair<std::size_t, int>, 4> terms;
    std::size_t size = 0;
    double constant = 0;

    void add(const Form& other, const int sign)
    {
      for(std::size_t i = 0; i < other.size; ++i)
        terms[size++] = {other.terms[i].first, sign * other.terms[i].second};
      constant += sign * other.constant;
    }
  };

  // u(sector) = g u(here) + t, after the rounding.
  struct Link
  {
    Sector_index sector;
    Element element;
    Vector translation;
  };

public:
  Rounding_spreader(const TriangleMesh& tmesh, const HalfedgeUVMap& uv_map,
                    const VertexIndexMap& vertex_indices, const Cuts& cuts,
                    const std::vector<Rounding<Group> >& roundings)
    : m_tmesh(tmesh), m_uv_map(uv_map), m_vertex_indices(vertex_indices), m_cuts(cuts),
      m_complex(cuts.complex), m_places(m_complex.number_of_sectors()),
      m_fixed(number_of_functionals * num_vertices(tmesh)), m_is_fixed(m_fixed.size(), false)
  {
    link_sectors(roundings);
    for(std::size_t v = 0; v < m_complex.number_of_vertices(); ++v)
      place_sectors(v);
    fix_coordinates(roundings);
    for(std::size_t s = 0; s < m_places.size(); ++s)
      for(auto h = cuts.corners_begin(Sector_index(s)); h != cuts.corners_end(Sector_index(s)); ++h)
        m_sector_of_corner[*h] = Sector_index(s);
  }

  // Returns false if the displacement can't be computed.
  bool compute()
  {
    add_energy();
    return solve();
  }

  // Of the displacement, once it is computed: by how much edge vectors change.
  double energy() const
  {
    double result = 0;
    for(const auto f : faces(m_tmesh))
      for(const Halfedge g : CGAL::halfedges_around_face(halfedge(f, m_tmesh), m_tmesh)) {
        const Halfedge a = next(g, m_tmesh), b = prev(g, m_tmesh);
        const Vector p = displacement(place(a)), q = displacement(place(b));
        const double weight = cotangent(get_uv(m_uv_map, g), get_uv(m_uv_map, a),
                                        get_uv(m_uv_map, b));
        for(int k = 0; k < Group::number_of_functionals; ++k)
          result += weight / 2 * std::pow(Group::value(k, p) - Group::value(k, q), 2);
      }
    return result;
  }

  // Computes the displacement and moves all corners by it; or returns false.
  bool run()
  {
    if(!compute())
      return false;
    using Point = typename boost::property_traits<HalfedgeUVMap>::value_type;
    using Number = typename Uv_number<HalfedgeUVMap>::type;
    std::vector<std::pair<Halfedge, Point> > moved;
    for(const auto f : faces(m_tmesh))
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_tmesh), m_tmesh)) {
        const Uv u = get_uv(m_uv_map, h);
        const Vector d = displacement(place(h));
        moved.emplace_back(h, Point(Number(u[0] + d[0]), Number(u[1] + d[1])));
      }
    for(const auto& [h, point] : moved)
      put(m_uv_map, h, point);
    return true;
  }

private:
  void link_sectors(const std::vector<Rounding<Group> >& roundings)
  {
    m_links.resize(m_complex.number_of_sectors());
    std::vector<Vector> translations(m_complex.number_of_branches());
    for(const Rounding<Group>& r : roundings)
      if(r.kind == Rounding<Group>::BRANCH)
        translations[r.index][std::size_t(r.equation.terms.front().coordinate)] = r.rounded;
    for(std::size_t b = 0; b < m_complex.number_of_branches(); ++b) {
      const Element g = m_complex.element[b], back = Group::inverse(g);
      const Vector t = translations[b], s = Group::apply(back, t);
      for(auto p = m_complex.pairs_begin(b); p != m_complex.pairs_end(b); ++p) {
        m_links[std::size_t(p->plus)].push_back({p->minus, g, t});
        m_links[std::size_t(p->minus)].push_back({p->plus, back, {-s[0], -s[1]}});
      }
    }
  }

  // All sectors of a vertex in terms of the first; or, beyond a part of the border, of another one.
  // The latter case has no variable of its own, and the part stays where it is put by chance: cuts
  // don't lead there.
  void place_sectors(const std::size_t v)
  {
    const Sector_index first = m_complex.first_sector[v], end = m_complex.first_sector[v + 1];
    const Halfedge corner = *m_cuts.corners_begin(first);
    const std::size_t vertex = std::size_t(get(m_vertex_indices, target(corner, m_tmesh)));
    std::vector<char> is_placed(std::size_t(end - first), false);
    for(Sector_index root = first; root != end; ++root) {
      if(is_placed[std::size_t(root - first)])
        continue;
      m_places[std::size_t(root)] = {vertex, Group::identity(), {}};
      is_placed[std::size_t(root - first)] = true;
      std::vector<Sector_index> sectors(1, root);
      for(std::size_t i = 0; i < sectors.size(); ++i)
        for(const Link& link : m_links[std::size_t(sectors[i])])
          if(link.sector >= first && link.sector < end &&
             !is_placed[std::size_t(link.sector - first)]) {
            is_placed[std::size_t(link.sector - first)] = true;
            place_behind(sectors[i], link);
            sectors.push_back(link.sector);
          }
    }
  }

  void place_behind(const Sector_index here, const Link& link)
  {
    const Place& p = m_places[std::size_t(here)];
    const Vector u = Group::apply(link.element, m_complex.coordinates[std::size_t(here)]);
    const Vector c = Group::apply(link.element, p.offset);
    const Vector& now = m_complex.coordinates[std::size_t(link.sector)];
    Place& q = m_places[std::size_t(link.sector)];
    q = {p.vertex, Group::compose(link.element, p.element), {}};
    for(std::size_t i = 0; i < dimension; ++i)
      q.offset[i] = c[i] + u[i] + link.translation[i] - now[i];
  }

  // Points, and the levels along whole chains.
  void fix_coordinates(const std::vector<Rounding<Group> >& roundings)
  {
    for(const Rounding<Group>& r : roundings) {
      const auto& term = r.equation.terms.front();
      if(r.kind == Rounding<Group>::POINT)
        fix(term.sector, term.coordinate, r.rounded);
      else if(r.kind == Rounding<Group>::CHAIN)
        for(auto s = m_complex.links_begin(r.index); s != m_complex.links_end(r.index); ++s)
          fix(*s, m_complex.functional[r.index], r.rounded);
    }
  }

  void fix(const Sector_index s, const int f, const double value)
  {
    const Place& p = m_places[std::size_t(s)];
    const Signed_functional of_vertex = Group::act(Group::inverse(p.element), f);
    const std::size_t i = number_of_functionals * p.vertex + std::size_t(of_vertex.index);
    m_is_fixed[i] = true;
    m_fixed[i] =
      of_vertex.sign *
      (value - Group::value(f, m_complex.coordinates[std::size_t(s)]) - Group::value(f, p.offset));
  }

  // f(g x) is a functional of x, up to the sign.
  Form form(const Place& p, const int f) const
  {
    const Signed_functional of_vertex = Group::act(Group::inverse(p.element), f);
    Form result;
    result.add(form_of_vertex(p.vertex, of_vertex.index), of_vertex.sign);
    return result;
  }

  // Where u + v is fixed, but not both, u is the unknown.
  Form form_of_vertex(const std::size_t vertex, const int f) const
  {
    const std::size_t first = number_of_functionals * vertex;
    const bool has_fixed_sum = number_of_functionals > dimension && m_is_fixed[first + dimension];
    Form result;
    if(m_is_fixed[first + std::size_t(f)]) {
      result.constant = m_fixed[first + std::size_t(f)];
    } else if(f == 2) {
      result.add(form_of_vertex(vertex, 0), 1);
      result.add(form_of_vertex(vertex, 1), 1);
    } else if(has_fixed_sum && (f == 1 || m_is_fixed[first + 1])) {
      result.constant = m_fixed[first + dimension];
      result.add(form_of_vertex(vertex, 1 - f), -1);
    } else {
      result.terms[result.size++] = {dimension * vertex + std::size_t(f), 1};
    }
    return result;
  }

  Place place(const Halfedge h) const
  {
    const auto found = m_sector_of_corner.find(h);
    if(found != m_sector_of_corner.end())
      return m_places[std::size_t(found->second)];
    return {std::size_t(get(m_vertex_indices, target(h, m_tmesh))), Group::identity(), {}};
  }

  // 1/2 cot |d - d'|^2 for each edge of each face, the cotangent taken in the domain.
  void add_energy()
  {
    m_rhs.assign(dimension * num_vertices(m_tmesh), 0);
    for(const auto f : faces(m_tmesh)) {
      const Halfedge h = halfedge(f, m_tmesh);
      for(const Halfedge g : {h, next(h, m_tmesh), prev(h, m_tmesh)}) {
        const Halfedge a = next(g, m_tmesh), b = prev(g, m_tmesh);
        const double weight = cotangent(get_uv(m_uv_map, g), get_uv(m_uv_map, a),
                                        get_uv(m_uv_map, b));
        const Place p = place(a), q = place(b);
        for(int k = 0; k < Group::number_of_functionals; ++k) {
          Form difference = form(p, k);
          difference.constant += Group::value(k, p.offset) - Group::value(k, q.offset);
          difference.add(form(q, k), -1);
          add_square(weight, difference);
        }
      }
    }
  }

  // The same for faces of either orientation; that of nearly degenerate ones is bounded.
  static double cotangent(const Uv& p, const Uv& a, const Uv& b)
  {
    const Uv u = Group::to_cartesian({a[0] - p[0], a[1] - p[1]}),
             v = Group::to_cartesian({b[0] - p[0], b[1] - p[1]});
    const double dot = u[0] * v[0] + u[1] * v[1], cross = std::abs(u[0] * v[1] - u[1] * v[0]);
    const double squares = u[0] * u[0] + u[1] * u[1] + v[0] * v[0] + v[1] * v[1];
    return squares > 0 ? dot / (std::max)(cross, 1e-9 * squares) : 0;
  }

  // weight / 2 times the square of a form
  void add_square(const double weight, const Form& form)
  {
    for(std::size_t i = 0; i < form.size; ++i) {
      const auto [v, s] = form.terms[i];
      m_rhs[v] -= weight * s * form.constant;
      for(std::size_t j = 0; j < form.size; ++j)
        m_triplets.emplace_back(int(v), int(form.terms[j].first),
                                weight * s * form.terms[j].second);
    }
  }

  bool solve()
  {
    const int n = int(m_rhs.size());
    double largest = 0;
    for(const auto& t : m_triplets)
      largest = (std::max)(largest, std::abs(t.value()));
    for(int i = 0; i < n; ++i) // the displacement of a part may be free otherwise
      m_triplets.emplace_back(i, i, 1e-12 * (std::max)(largest, 1.));
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(m_triplets.begin(), m_triplets.end());
    m_triplets.clear();
    Sparse_cholesky<Eigen::SparseMatrix<double> > solver;
    solver.compute(matrix);
    if(solver.info() != Eigen::Success)
      return false;
    m_solution = solver.solve(Eigen::Map<const Eigen::VectorXd>(m_rhs.data(), n));
    return solver.info() == Eigen::Success && m_solution.allFinite();
  }

  Vector displacement(const Place& p) const
  {
    const auto x = [&](const int f) {
      const Form form = form_of_vertex(p.vertex, f);
      double result = form.constant;
      for(std::size_t i = 0; i < form.size; ++i)
        result += form.terms[i].second * m_solution[Eigen::Index(form.terms[i].first)];
      return result;
    };
    const Vector turned = Group::apply(p.element, Vector{x(0), x(1)});
    return {turned[0] + p.offset[0], turned[1] + p.offset[1]};
  }

  const TriangleMesh& m_tmesh;
  HalfedgeUVMap m_uv_map;
  const VertexIndexMap& m_vertex_indices;
  const Cuts& m_cuts;
  const Cut_complex<Group>& m_complex;
  std::vector<std::vector<Link> > m_links; // per sector
  std::vector<Place> m_places;             // per sector
  std::vector<double> m_fixed;             // per functional of each vertex
  std::vector<char> m_is_fixed;
  std::unordered_map<Halfedge, Sector_index> m_sector_of_corner;
  std::vector<Eigen::Triplet<double> > m_triplets;
  std::vector<double> m_rhs;
  Eigen::VectorXd m_solution;
};

} // namespace internal
} // namespace Seamless_snapping
} // namespace CGAL

#endif // CGAL_SEAMLESS_SNAPPING_INTERNAL_MESH_SPREAD_ROUNDING_H
