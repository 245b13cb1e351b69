// Small meshes with exactly seamless uv maps, one for each kind of cut, node, branch, border and
// alignment that the tests have to see, and noise to make the maps inexact again.
//
// A mesh has its uv map in the property "h:uv" and its feature edges in "e:feature". Coordinates
// are integers times powers of two and fit into floats too.

#ifndef SEAMLESS_SNAPPING_TEST_TEST_MESHES_H
#define SEAMLESS_SNAPPING_TEST_TEST_MESHES_H

#include "Square_complex_mesh.h"
#include "test_surfaces.h"
#include "uv_noise.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <string>
#include <vector>

namespace test_meshes {

using square_complex::feature_map;
using square_complex::uv_map;

struct Recipe
{
  std::string name;
  Square_complex complex;
  int divisions;     // of a square's side: 2 * divisions^2 faces a square
  bool align_border; // the border runs along isocurves and may be aligned
};

inline std::vector<Recipe> recipes()
{
  std::vector<Recipe> result;
  const auto add = [&](const std::string& name, const Square_complex& complex, int divisions,
                       bool align_border = false) {
    result.push_back({ name, complex, divisions, align_border });
  };

  add("disc", disc(3, 2), 1);
  add("disc with aligned border", disc(3, 2), 2, true);
  add("tetrahedron", tetrahedron(), 1);
  add("divided tetrahedron", tetrahedron(), 4);
  add("cube", box(1, 1, 1), 1);
  add("divided cube", box(1, 1, 1), 3);
  add("long box", box(3, 2, 1), 1);
  add("cylinder", cylinder(5, 2), 1);
  add("cylinder with aligned borders", cylinder(4, 2), 2, true);
  add("torus", torus(3, 3), 1);
  add("divided torus", torus(4, 3), 2);
  add("pair of pants", pair_of_pants(), 1);
  add("box with three holes", box_with_holes(), 1, true);
  add("notched cube", notched_cube(), 1);
  add("genus 2 of translations", genus_2(), 3);
  add("genus 2 with cones", double_torus(), 1);
  for(int turns = 1; turns <= 6; ++turns)
    add("ring of " + std::to_string(turns) + " quarters", cone_ring(turns), turns < 3 ? 2 : 1,
        turns % 2 == 0);

  add("closed cut around a disc, translation", island(0, { { 8, 0.5 } }, false), 1);
  add("closed cut around a disc, rotation", island(1, { { 12, 0 } }, false), 1);
  add("closed cut around a hole, translation", island(0, { { 8, 0 } }, true), 1);
  add("closed cut around a hole, half turn", island(2, { { 16, 0.25 } }, true), 1, true);
  add("closed cut of tiny translation", island(0, { { std::ldexp(1., -20), 0 } }, true), 1);
  add("two islands", two_islands(), 2);

  Square_complex complex = disc(5, 5);
  mark_all_kinds_of_features(complex);
  add("disc with features", complex, 1, true);
  complex = island(1, { { 12, 0 } }, false);
  mark_all_kinds_of_features(complex);
  add("features across and along a cut", complex, 1);
  complex = box(1, 1, 1);
  mark_creases(complex);
  add("cube with creases", complex, 2);
  complex = notched_cube();
  mark_creases(complex);
  add("notched cube with creases", complex, 1);

  complex = box(2, 1, 1);
  scatter_charts(complex);
  add("box of scattered charts", complex, 1);
  complex = torus(3, 3);
  scatter_charts(complex);
  add("torus of scattered charts", complex, 1);
  complex = pair_of_pants();
  scatter_charts(complex);
  add("pants of scattered charts", complex, 2, true);

  complex = box(1, 1, 1);
  complex.append(torus(3, 3));
  complex.append(disc(2, 2));
  add("three components", complex, 1);
  return result;
}

template <typename Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> make_mesh(const Square_complex& complex,
                                                       int divisions, double scale = 0.125)
{
  CGAL::Surface_mesh<typename Kernel::Point_3> result;
  square_complex::build_mesh(complex, divisions, scale, result);
  return result;
}

template <typename Kernel>
struct Named_mesh
{
  std::string name;
  bool align_border;
  CGAL::Surface_mesh<typename Kernel::Point_3> mesh;
};

// All of them, from 4 to some 200 faces.
template <typename Kernel>
std::vector<Named_mesh<Kernel> > all_meshes()
{
  std::vector<Named_mesh<Kernel> > result;
  for(const Recipe& recipe : recipes())
    result.push_back({ recipe.name, recipe.align_border,
                       make_mesh<Kernel>(recipe.complex, recipe.divisions) });
  return result;
}

// A closed cut around a hole whose sides differ by a translation of 2^-30 of a side: about 1e-9,
// far above the noise of 1e-17 that it is to be told from, far below what looks like a translation.
// For doubles only.
template <typename Kernel>
Named_mesh<Kernel> tiny_translation()
{
  return { "cut of translation 2^-30", false,
           make_mesh<Kernel>(island(0, { { std::ldexp(1., -30), 0 } }, true), 1, 0.25) };
}

// Warps the uv map of a test mesh (see uv_noise.h); vertices on features and, where the border may
// be aligned, on the border stay.
template <typename Kernel>
void warp(Named_mesh<Kernel>& named, unsigned int seed, double size = 0.125 / 8)
{
  auto& mesh = named.mesh;
  const auto features = feature_map(mesh);
  uv_noise::warp(mesh, uv_map(mesh), size, seed, [&](const auto& v) {
    for(const auto h : CGAL::halfedges_around_target(v, mesh)) {
      const bool is_on_border = mesh.is_border(mesh.edge(h));
      if(features[mesh.edge(h)] || (named.align_border && is_on_border))
        return true;
    }
    return false;
  });
}

} // namespace test_meshes

#endif // SEAMLESS_SNAPPING_TEST_TEST_MESHES_H
