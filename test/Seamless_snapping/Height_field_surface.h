// Big closed meshes with many cones: the boundary of the voxels below a height field
// h(x,y) = f(x) + g(y), unfolded along a spanning tree of its squares. A sum of two functions of
// one variable has no saddle where two voxels touch in an edge or a vertex only, so the boundary is
// a closed 2-manifold for any f and g, a topological sphere; and every place where f and g both
// step has cones of positive and of negative curvature.

#ifndef SEAMLESS_SNAPPING_TEST_HEIGHT_FIELD_SURFACE_H
#define SEAMLESS_SNAPPING_TEST_HEIGHT_FIELD_SURFACE_H

#include "Square_complex.h"
#include "Square_complex_mesh.h"
#include "uv_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace height_field_surface {

using square_complex::Square_complex;

// The squares around size x size columns of 2 to 6 voxels.
inline Square_complex surface(int size, unsigned int seed)
{
  std::mt19937_64 random(seed);
  std::vector<int> f, g;
  for(int i = 0; i < size; ++i) {
    f.push_back(1 + int(random() % 3));
    g.push_back(1 + int(random() % 3));
  }
  Square_complex result =
    square_complex::voxel_surface({ { size, size, 6 } }, [&](int x, int y, int z) {
      return z < f[std::size_t(x)] + g[std::size_t(y)];
    });
  result.unfold();
  return result;
}

// Singular vertices and vertices with other than two cut edges: on closed surfaces, the vertices
// with cut edges whose number or whose sum of rotations is not that of a plain branch.
template <typename Mesh, typename UVMap>
std::size_t number_of_nodes(const Mesh& mesh, const UVMap& uv)
{
  const uv_noise::Cuts<Mesh, UVMap> cuts(mesh, uv);
  std::size_t result = 0;
  for(const auto v : vertices(mesh)) {
    int cut_edges = 0, rotation = 0;
    for(const auto h : CGAL::halfedges_around_target(v, mesh)) {
      if(cuts.is_passable(h))
        continue;
      ++cut_edges;
      rotation += cuts.rotation(h); // all in the same sense around the vertex
    }
    if(cut_edges != 0 && (cut_edges != 2 || rotation % 4 != 0))
      ++result;
  }
  return result;
}

// What to ask of the generator. The numbers are met within some tens of percent.
struct Wish
{
  std::size_t faces = 100000;
  std::size_t nodes = 500;
  unsigned int seed = 1;
};

// Fills an empty mesh and its uv map "h:uv", which is exactly seamless. One square has sides of
// length 1 or a little less, cut into n steps of a power of two. Returns that length.
template <typename Mesh>
double make_surface(const Wish& wish, Mesh& mesh)
{
  // Measured: size^2 columns give about 1.4 size^2 nodes, somewhat less if they are few.
  const int size = 2 + int(std::lround(std::sqrt(double(wish.nodes) / 1.4)));
  const Square_complex complex = surface(size, wish.seed);
  const double faces_per_square = double(wish.faces) / complex.number_of_squares();
  const int n = (std::max)(1, int(std::lround(std::sqrt(faces_per_square / 2))));
  const double step = std::ldexp(1., -int(std::ceil(std::log2(double(n)))));
  square_complex::build_mesh(complex, n, step, mesh);
  return n * step;
}

// Adds noise of the given size relative to the extent of the uv map: one move per sector, so that
// edges without a cut stay equal to the bit.
template <typename Mesh>
void perturb(Mesh& mesh, double relative_size, unsigned int seed)
{
  const auto uv = square_complex::uv_map(mesh);
  double extent = 0;
  for(const auto h : halfedges(mesh))
    extent = (std::max)({ extent, std::abs(double(uv[h].x())), std::abs(double(uv[h].y())) });
  uv_noise::perturb(mesh, uv, relative_size * extent, seed);
}

} // namespace height_field_surface

#endif // SEAMLESS_SNAPPING_TEST_HEIGHT_FIELD_SURFACE_H
