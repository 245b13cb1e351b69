// Large complexes like those of surfaces: a net of cuts along the edges of a triangle mesh.

#ifndef SEAMLESS_SNAPPING_TEST_NET_OF_CUTS_H
#define SEAMLESS_SNAPPING_TEST_NET_OF_CUTS_H

#include "hexagonal_maps.h"

#include <CGAL/Seamless_snapping/internal/complex/Cut_complex.h>

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <random>
#include <vector>

namespace random_complexes {

template <int N>
using Complex = internal::Cut_complex<internal::Group_of_order<N> >;

// A sector per corner of a closed mesh, and a cut along each edge, with three inner vertices. Each
// face has a chart that is turned at random; cones are at the ends of one edge in eight. The
// coordinates are drawn at random, and are no solution.
template <int N>
Complex<N> net_of_cuts(const hexagonal_maps::Mesh& mesh, const unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Complex<N> complex;
  const auto add_sector = [&]() {
    complex.coordinates.push_back({{uniform(random), uniform(random)}});
    return internal::Sector_index(complex.coordinates.size()) - 1;
  };
  const auto add_vertex = [&](const bool is_node) {
    complex.first_sector.push_back(internal::Sector_index(complex.coordinates.size()));
    complex.is_node.push_back(is_node);
  };
  std::vector<internal::Sector_index> sector(2 * mesh.number_of_edges());
  for(const hexagonal_maps::Vertex v : mesh.vertices()) {
    add_vertex(true);
    for(const hexagonal_maps::Halfedge h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
      sector[std::size_t(h)] = add_sector();
  }
  std::vector<int> turns;
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    turns.push_back(int(random() % 12));
  for(const auto e : mesh.edges()) {
    const hexagonal_maps::Halfedge h = mesh.halfedge(e), o = mesh.opposite(h);
    const int cone = random() % 8 == 0 ? int(random() % 12) : 0;
    complex.element.push_back(internal::Group_of_order<N>::element(
      turns[std::size_t(mesh.face(o))] - turns[std::size_t(mesh.face(h))] + cone, N));
    complex.pairs.push_back({sector[std::size_t(mesh.prev(h))], sector[std::size_t(o)]});
    for(int i = 0; i < 3; ++i) {
      add_vertex(false);
      const internal::Sector_index plus = add_sector();
      complex.pairs.push_back({plus, add_sector()});
    }
    complex.pairs.push_back({sector[std::size_t(h)], sector[std::size_t(mesh.prev(o))]});
    complex.pairs.end_list();
  }
  complex.first_sector.push_back(internal::Sector_index(complex.coordinates.size()));
  return complex;
}

} // namespace random_complexes

#endif // SEAMLESS_SNAPPING_TEST_NET_OF_CUTS_H
