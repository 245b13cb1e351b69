// Tests of the orientation of faces on parametrizations that solvers made, where there are any: no
// face may be lost, neither at their own accuracy nor with noise, and the changes must remain those
// of the closest solution.

#ifndef SEAMLESS_SNAPPING_TEST_ORIENTATION_DATA_H
#define SEAMLESS_SNAPPING_TEST_ORIENTATION_DATA_H

#include "orientation_checks.h"
#include "test_data.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace orientation_data {

using namespace orientation_checks;

// Moves the corners at all vertices on cuts by up to `size`, those of one sector alike, or each by
// itself.
inline void perturb_at_cuts(const Mesh& mesh,
                            UV_map uv,
                            const SS::Seam_transitions<Mesh>& transitions,
                            double size,
                            uv_noise::Noise kind,
                            unsigned int seed)
{
  std::mt19937_64 random(seed);
  for(const auto v : mesh.vertices()) {
    std::vector<Mesh::Halfedge_index> corners;
    Mesh::Halfedge_index h = mesh.halfedge(v);
    do {
      corners.push_back(h);
      h = mesh.opposite(mesh.next(h));
    } while(h != mesh.halfedge(v));
    const auto begins_sector = [&](auto g) {
      return transitions.is_cut(g) || mesh.is_border(mesh.opposite(g));
    };
    const auto first = std::find_if(corners.begin(), corners.end(), begins_sector);
    if(std::none_of(corners.begin(), corners.end(), [&](auto g) { return transitions.is_cut(g); }))
      continue;
    std::rotate(corners.begin(), first, corners.end());
    square_complex::Vector_2 move = { { 0, 0 } };
    for(const auto corner : corners) {
      if(kind == uv_noise::Noise::per_corner || begins_sector(corner))
        move = {
            {size * uv_noise::symmetric_random(random), size * uv_noise::symmetric_random(random)}};
      if(!mesh.is_border(corner))
        uv[corner] = uv_noise::moved(uv[corner], move);
    }
  }
}

struct File
{
  Mesh mesh;
  UV_map uv = test_meshes::uv_map(mesh);
  Mesh::Property_map<Mesh::Edge_index, bool> features = test_meshes::feature_map(mesh);

  explicit File(const std::filesystem::path& path)
  {
    const auto np = SS::parameters::edge_is_constrained_map(features);
    CHECK_IN(path.filename().string(), bool(SS::IO::read_OBJ(path.string(), mesh, uv, np)));
    // features and border where they lie on isocurves
    const double tolerance = 1e-6 * extent(mesh, uv);
    for(const auto e : mesh.edges()) {
      auto h = mesh.halfedge(e);
      h = mesh.is_border(h) ? mesh.opposite(h) : h;
      const auto d = uv[h] - uv[mesh.prev(h)];
      features[e] = (features[e] || mesh.is_border(e))
                    && (std::min)(std::abs(d.x()), std::abs(d.y())) <= tolerance;
    }
  }
};

inline void test_file(const File& original,
                      const std::string& name,
                      double noise,
                      uv_noise::Noise kind,
                      unsigned int seed,
                      Tally& tally)
{
  const std::string context = name + ", seed " + std::to_string(seed);
  File file(original);
  file.uv = test_meshes::uv_map(file.mesh);
  file.features = test_meshes::feature_map(file.mesh);
  Mesh& mesh = file.mesh;
  // taken from the file: noise may be larger than edges and translations
  const auto transitions = SS::seam_transitions(mesh, file.uv);
  const auto edge_is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;
  const auto rotations = mesh.add_property_map<Mesh::Halfedge_index, int>("h:rotation", 0).first;
  for(const auto h : mesh.halfedges()) {
    edge_is_cut[mesh.edge(h)] = transitions.is_cut(h);
    rotations[h] = transitions.rotation(h);
  }
  perturb_at_cuts(mesh, file.uv, transitions, noise * extent(mesh, file.uv), kind, seed);
  const auto np = SS::parameters::edge_is_cut_map(edge_is_cut).halfedge_rotation_map(rotations);
  const bool with_features = seed % 2 == 0;
  const auto report =
    with_features
      ? snap(mesh, file.uv, np.edge_is_constrained_map(file.features),
             is_aligned(mesh, file.features, false), context)
      : snap(mesh, file.uv, np, exact_check::No_edge_aligned(), context);
  CHECK_IN(context, report.lost_faces.empty());
  CHECK_IN(context, report.largest_change <= 1.05 * report.run.largest_change_before_repair);
  // noise is well above the grid
  CHECK_IN(context, noise == 0 || report.rms_change <= 1.01 * report.optimal_rms_change);
  tally.add(report);
}

inline void test_files()
{
  const auto paths = test_data::fifth_of_further_files("uv", ".obj");
  const std::vector<double> noises = { 0, 1e-8, 1e-6 };
  std::vector<Tally> tallies(noises.size());
  for(const auto& path : paths) {
    const File file(path);
    for(std::size_t i = 0; i < noises.size(); ++i)
      for(unsigned int seed = 1; seed <= (i == 0 ? 2u : 4u); ++seed)
        test_file(file, path.filename().string() + ", noise " + std::to_string(noises[i]),
                  noises[i], seed <= 2 ? uv_noise::Noise::per_sector : uv_noise::Noise::per_corner,
                  seed, tallies[i]);
  }
  for(std::size_t i = 0; i < noises.size(); ++i)
    tallies[i].print("noise " + std::to_string(1e9 * noises[i]) + "e-9");
}

} // namespace orientation_data

#endif // SEAMLESS_SNAPPING_TEST_ORIENTATION_DATA_H
