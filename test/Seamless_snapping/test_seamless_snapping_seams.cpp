// Which edges are cuts, how charts are turned, and where cones are, is read right from maps with
// noise: also where triangles are smaller than the noise, where corners have noise of their own,
// and where one part of a map is exact and another is not.

#include "floating_point_traps.h"
#include "surface_checks.h"
#include "test_data.h"
#include "test_meshes.h"
#include "uv_noise.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace SS = CGAL::Seamless_snapping;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Point_2>;
using Named = test_meshes::Named_mesh<Kernel>;
using surface_checks::Bits;

// --- noise of all sizes on maps whose topology is known ------------------------------------------

void test_noise()
{
  constexpr unsigned int seeds = 20;
  std::size_t runs = 0;
  for(const Named& original : test_meshes::all_meshes<Kernel>())
    for(unsigned int seed = 1; seed <= seeds; ++seed)
      for(const auto kind : {uv_noise::Noise::per_sector, uv_noise::Noise::per_corner})
        for(const double size : {1e-12, 1e-9, 1e-6, 1e-5}) {
          Named named = original;
          const auto uv = test_meshes::uv_map(named.mesh);
          const surface_checks::Truth<Mesh, UV_map> truth(named.mesh, uv);
          const double noise = size * truth.extent;
          if(!truth.is_clear_with(noise))
            continue;
          uv_noise::perturb(named.mesh, uv, noise, seed, kind);
          const std::string context =
            named.name + ", noise " + std::to_string(size) + ", seed " + std::to_string(seed);
          // all edges are long enough to be decided by themselves, whatever the tolerance
          const auto transitions =
            SS::seam_transitions(named.mesh, uv, SS::parameters::tolerance(1.));
          surface_checks::check_transitions(named.mesh, truth, transitions, context);
          CHECK_IN(context, transitions.data().number_of_edges_decided_by_surroundings == 0);
          ++runs;
        }
  std::cout << "noise: " << runs << " runs, seeds 1 to " << seeds << std::endl;
  CHECK(runs > 1000);
}

// --- triangles smaller than the noise ------------------------------------------------------------

// A square of 2 x 36 faces whose lines are at -1, -1/2, -h, 0, h, 1/2, 1: flat, and without a cut.
Mesh graded_square(const double h)
{
  const double lines[] = {-1, -0.5, -h, 0, h, 0.5, 1};
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for(const double x : lines)
    for(const double y : lines)
      vertices.push_back(mesh.add_vertex(Kernel::Point_3(x, y, 0)));
  for(std::size_t i = 0; i + 1 < 7; ++i)
    for(std::size_t j = 0; j + 1 < 7; ++j) {
      const auto v = [&](const std::size_t k, const std::size_t l) { return vertices[7 * k + l]; };
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1));
      mesh.add_face(v(i, j), v(i + 1, j + 1), v(i, j + 1));
    }
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  for(const auto corner : mesh.halfedges())
    if(!mesh.is_border(corner)) {
      const auto& p = mesh.point(mesh.target(corner));
      uv[corner] = Point_2(p.x(), p.y());
    }
  return mesh;
}

// The inner edges whose sides another rotation than 0 brings nearest to each other.
std::size_t number_of_edges_to_turn(const Mesh& mesh, const UV_map& uv)
{
  std::size_t result = 0;
  for(const auto e : mesh.edges()) {
    if(mesh.is_border(e))
      continue;
    const auto h = mesh.halfedge(e), g = mesh.opposite(h);
    Kernel::Vector_2 side = uv[h] - uv[mesh.prev(h)];
    const Kernel::Vector_2 other = uv[mesh.prev(g)] - uv[g];
    std::array<double, 4> residual;
    for(double& r : residual) {
      r = (std::max)(std::abs(side.x() - other.x()), std::abs(side.y() - other.y()));
      side = side.perpendicular(CGAL::COUNTERCLOCKWISE);
    }
    result += *std::min_element(residual.begin(), residual.end()) < residual[0] ? 1 : 0;
  }
  return result;
}

void test_small_triangles()
{
  std::size_t number_of_turned_edges = 0;
  constexpr unsigned int seeds = 200;
  for(unsigned int seed = 1; seed <= seeds; ++seed)
    for(const double ratio : {0.2, 1., 5.}) {
      const double h = 1e-6;
      const std::string context =
        "noise " + std::to_string(ratio) + " times the spacing, seed " + std::to_string(seed);
      Mesh mesh = graded_square(h);
      const auto uv = test_meshes::uv_map(mesh);
      uv_noise::perturb(mesh, uv, ratio * h, seed, uv_noise::Noise::per_corner);
      const auto transitions = SS::seam_transitions(mesh, uv);
      CHECK_IN(context, transitions.cut_halfedges().empty());
      CHECK_IN(context, transitions.singular_vertices().empty());
      const std::size_t number = number_of_edges_to_turn(mesh, uv);
      CHECK_IN(context, transitions.data().number_of_edges_decided_by_surroundings == number);
      number_of_turned_edges += number;
      const auto report = SS::snap_to_seamless(mesh, uv);
      CHECK_IN(context, report.status == SS::Outcome::SNAPPED);
      CHECK_IN(context, report.largest_change <= 2 * ratio * h);
    }
  std::cout << "small triangles: seeds 1 to " << seeds << ", " << number_of_turned_edges
            << " edges keep another rotation than the nearest one" << std::endl;
  CHECK(number_of_turned_edges > 0);
}

// --- an exact part beside one with noise ---------------------------------------------------------

// Component 0 has noise, component 1 is 1e-4 times as large, and exact.
void test_exact_part()
{
  constexpr unsigned int seeds = 20;
  for(unsigned int seed = 1; seed <= seeds; ++seed)
    for(const bool has_cones : {false, true}) {
      const std::string context =
        std::string(has_cones ? "tetrahedra" : "tori") + ", seed " + std::to_string(seed);
      auto complex = has_cones ? test_meshes::tetrahedron() : test_meshes::torus(3, 3);
      Mesh large = test_meshes::make_mesh<Kernel>(complex, 1);
      Mesh mesh = large;
      const auto large_uv = test_meshes::uv_map(mesh);
      uv_noise::perturb(mesh, large_uv, 1e-6, seed);
      const std::size_t number = mesh.number_of_halfedges();
      mesh += large; // with its uv map
      const auto uv = test_meshes::uv_map(mesh);
      for(std::size_t i = number; i < mesh.number_of_halfedges(); ++i) {
        Point_2& p = uv[Mesh::Halfedge_index(Mesh::size_type(i))];
        p = Point_2(std::ldexp(p.x(), -13), std::ldexp(p.y(), -13)); // transitions stay exact
      }
      const Bits before = surface_checks::all_bits(mesh, uv);
      const auto report = SS::snap_to_seamless(mesh, uv);
      CHECK_IN(context, report.status == SS::Outcome::SNAPPED);
      CHECK_IN(context, SS::is_seamless(mesh, uv));
      const Bits after = surface_checks::all_bits(mesh, uv);
      bool is_kept = true;
      for(std::size_t i = 2 * number; i < before.size(); ++i)
        is_kept = is_kept && before[i] == after[i];
      CHECK_IN(context, is_kept);
    }
  std::cout << "exact parts: seeds 1 to " << seeds << std::endl;
}

// --- seams that are borders --------------------------------------------------------------------

// Two triangles that share an edge in space, but no vertex: the report says so.
void test_cut_open_mesh()
{
  using Point_3 = Kernel::Point_3;
  Mesh mesh;
  const Point_3 corners[] = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0),
                             Point_3(1, 1, 0)};
  const auto add = [&](const int i, const int j, const int k) {
    mesh.add_face(mesh.add_vertex(corners[i]), mesh.add_vertex(corners[j]),
                  mesh.add_vertex(corners[k]));
  };
  add(0, 1, 2);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", Point_2(0, 0)).first;
  CHECK(SS::snap_to_seamless(mesh, uv).message.empty());
  add(2, 1, 3);
  const auto report = SS::snap_to_seamless(mesh, uv);
  CHECK(report.status == SS::Outcome::ALREADY_EXACT);
  CHECK(report.message.find("2 border edges coincide") != std::string::npos);

  // points of the caller in place of the points of the mesh
  const auto apart = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:apart").first;
  for(const auto v : mesh.vertices())
    apart[v] = Point_3(double(v.idx()), 0, 0);
  const auto np = SS::parameters::vertex_point_map(apart);
  CHECK(SS::snap_to_seamless(mesh, uv, np).message.empty());
  CHECK(SS::is_seamless(mesh, uv, np));
}

// --- files ---------------------------------------------------------------------------------------

struct File
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;

  explicit File(const std::filesystem::path& path)
  {
    CHECK_IN(path.string(), bool(SS::IO::read_OBJ(path.string(), mesh, uv)));
  }
};

// A disk of 54 faces with 7 cut edges through one cone, with noise and without.
void test_cone(const std::filesystem::path& folder)
{
  constexpr double tolerance = 4.68e-4; // no edge is off by more
  const File clean(folder / "cone_54faces_clean.obj");
  File noisy(folder / "cone_54faces.obj");
  const auto expected = SS::seam_transitions(clean.mesh, clean.uv);
  const auto np = SS::parameters::tolerance(tolerance);
  const auto found = SS::seam_transitions(noisy.mesh, noisy.uv, np);
  CHECK(bool(found));
  CHECK_EQUAL(found.cut_halfedges().size(), 7u);
  for(const auto h : clean.mesh.halfedges())
    CHECK_EQUAL(found.rotation(h), expected.rotation(h));
  CHECK(found.singular_vertices() == expected.singular_vertices());
  const auto report = SS::snap_to_seamless(noisy.mesh, noisy.uv, np);
  CHECK(report.status == SS::Outcome::SNAPPED);
  CHECK(report.largest_change <= report.violation_before);
}

void test_corner_noise(const std::filesystem::path& folder)
{
  File file(folder / "percorner_72faces.obj");
  const auto transitions = SS::seam_transitions(file.mesh, file.uv);
  CHECK(transitions.cut_halfedges().empty());
  CHECK(transitions.singular_vertices().empty());
  const auto report =
    SS::snap_to_seamless(file.mesh, file.uv, SS::parameters::repair_flips(true));
  CHECK(report.status == SS::Outcome::SNAPPED);
  CHECK(report.remaining_flips.empty());
  CHECK(report.lost_faces.empty());
}

void test_tiny_torus(const std::filesystem::path& path)
{
  File file(path);
  const Mesh& mesh = file.mesh;
  const auto component = file.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:c", 0).first;
  const std::size_t number =
    CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  CHECK_EQUAL(number, 2u);
  CGAL::Bbox_2 box[2];
  for(const auto h : mesh.halfedges())
    box[component[mesh.face(h)]] += file.uv[h].bbox();
  const std::size_t tiny = box[0].xmax() - box[0].xmin() < box[1].xmax() - box[1].xmin() ? 0 : 1;
  const auto cuts = SS::seam_transitions(mesh, file.uv);
  const Bits before = surface_checks::all_bits(mesh, file.uv);
  CHECK(bool(SS::snap_to_seamless(mesh, file.uv)));
  CHECK(SS::is_seamless(mesh, file.uv));
  const Bits after = surface_checks::all_bits(mesh, file.uv);
  const auto cuts_after = SS::seam_transitions(mesh, file.uv);
  std::size_t i = 0;
  for(const auto h : halfedges(mesh)) {
    for(int c = 0; c < 2; ++c, ++i)
      CHECK(component[mesh.face(h)] != tiny || before[i] == after[i]);
    if(component[mesh.face(h)] == tiny)
      CHECK(cuts.is_cut(h) == cuts_after.is_cut(h));
  }
}

// Maps as solvers compute them, with noise that the shortest edge exceeds 20 times: no rotation
// changes, none is decided by surroundings, and snapping costs no face.
void test_noise_on_file(const std::filesystem::path& path, const uv_noise::Noise kind,
                        const double size, std::size_t& runs)
{
  File file(path);
  Mesh& mesh = file.mesh;
  const std::string context = path.filename().string() + ", noise " + std::to_string(size);
  const auto clean = SS::seam_transitions(mesh, file.uv);
  CHECK_IN(context, bool(clean));
  double shortest = clean.extent();
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h)) {
      const auto d = file.uv[h] - file.uv[mesh.prev(h)];
      shortest = (std::min)(shortest, std::sqrt(d.squared_length()));
    }
  const double noise = size * clean.extent();
  if(!(shortest > 20 * noise))
    return;
  std::mt19937_64 random(1);
  for(const auto v : mesh.vertices()) {
    const auto starts_sector = [&](const auto h) { return mesh.is_border(h) || clean.is_cut(h); };
    auto first = mesh.halfedge(v);
    for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
      first = starts_sector(h) ? h : first;
    Kernel::Vector_2 move(0, 0);
    for(const auto h : CGAL::halfedges_around_target(first, mesh)) {
      if(h == first || starts_sector(h) || kind == uv_noise::Noise::per_corner)
        move = noise * Kernel::Vector_2(uv_noise::symmetric_random(random),
                                        uv_noise::symmetric_random(random));
      if(!mesh.is_border(h))
        file.uv[h] = file.uv[h] + move;
    }
  }
  const auto found = SS::seam_transitions(mesh, file.uv);
  CHECK_IN(context, bool(found) && found.data().number_of_edges_decided_by_surroundings == 0);
  CHECK_IN(context, found.singular_vertices() == clean.singular_vertices());
  for(const auto h : mesh.halfedges())
    CHECK_IN(context, found.rotation(h) == clean.rotation(h));
  const auto report = SS::snap_to_seamless(mesh, file.uv);
  CHECK_IN(context, report.status == SS::Outcome::SNAPPED && report.lost_faces.empty());
  ++runs;
}

void test_noise_on_files()
{
  std::size_t runs = 0;
  const auto files = test_data::further_files("uv", ".obj");
  if(files.empty())
    return;
  for(const auto& path : files) {
    test_noise_on_file(path, uv_noise::Noise::per_sector, 1e-5, runs);
    test_noise_on_file(path, uv_noise::Noise::per_corner, 1e-6, runs);
  }
  std::cout << "noise on files: " << runs << " runs, seed 1" << std::endl;
  CHECK(runs > files.size());
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  test_noise();
  test_small_triangles();
  test_exact_part();
  test_cut_open_mesh();
  const auto folder = test_data::further_data("seams", "seams that are easily misread");
  if(!folder.empty()) {
    test_cone(folder);
    test_corner_noise(folder);
    test_tiny_torus(folder / "tiny_exact_torus_36faces.obj");
    test_tiny_torus(folder / "tiny_exact_torus_256faces_slow.obj");
  }
  test_noise_on_files();
  return report_checks();
}
