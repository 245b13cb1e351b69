// What quad_remesh() makes of the given meshes, and of all meshes in given folders, at several
// sizes, and what QuadriFlow does where Blender is installed: tables of quads, irregular vertices,
// topology, inverted quads, scaled Jacobians, Hausdorff distances from the input, and CPU times.
// Edges with an angle of more than that of --feature-angle are features, but for noise; without,
// none. With --results, the quads are kept in a folder.
//
//   quad_comparison [--quads N]... [--feature-angle DEGREES] [--blender PROGRAM]
//                   [--results FOLDER] MESH_OR_FOLDER...

#include "Quad_measures.h"
#include "Quadriflow.h"
#include "command_line.h"

#include <CGAL/Quad_remeshing/quad_remesh.h>
#include <CGAL/Quad_remeshing/remove_feature_noise.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace po = benchmark::options;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace QR = CGAL::Quad_remeshing;

using Kernel = benchmark::Kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A new folder for files, which goes with its content unless it has a name.
class Folder
{
public:
  explicit Folder(const std::string& name)
    : m_path(name), m_is_temporary(name.empty())
  {
    if(m_is_temporary)
      m_path = fs::temp_directory_path() /
               ("quad_comparison_" + std::to_string(std::random_device{}()));
    fs::create_directories(m_path);
  }

  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  ~Folder()
  {
    std::error_code ignored;
    if(m_is_temporary)
      fs::remove_all(m_path, ignored);
  }

  const fs::path& path() const { return m_path; }

private:
  fs::path m_path;
  bool m_is_temporary;
};

// Of one program, over all meshes and sizes.
class Totals
{
public:
  explicit Totals(std::string program) : m_program(std::move(program)) { }

  const std::string& program() const { return m_program; }

  void add_failure() { ++m_tried; }

  void add(const bool is_kept, const benchmark::Shape_of_quads& shape, const double distance,
           const double seconds)
  {
    ++m_tried;
    m_kept += is_kept ? 1 : 0;
    m_without_inverted += is_kept && shape.number_of_inverted_quads == 0 ? 1 : 0;
    m_jacobians.push_back(shape.mean_jacobian);
    m_distances.push_back(distance);
    m_seconds.push_back(seconds);
  }

  void print() const
  {
    std::cout << m_program << ": " << m_jacobians.size() << " of " << m_tried
              << " with a result, " << m_kept << " with the topology kept, "
              << m_without_inverted << " of these without inverted quads";
    if(!m_jacobians.empty())
      std::cout << "; medians: mean Jacobian " << std::setprecision(3) << median(m_jacobians)
                << ", distance " << std::setprecision(2) << median(m_distances) << " %, "
                << median(m_seconds) << " s";
    std::cout << std::endl;
  }

private:
  static double median(std::vector<double> values)
  {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  std::string m_program;
  std::size_t m_tried = 0, m_kept = 0, m_without_inverted = 0;
  std::vector<double> m_jacobians, m_distances, m_seconds;
};

// A mesh, and what its quads are compared with.
struct Input
{
  std::string name;
  Mesh mesh;
  bool has_features; // the sharp edges
  Mesh::Property_map<Mesh::Edge_index, bool> is_sharp;
  benchmark::Triangles triangles;
  double diagonal;
  std::ptrdiff_t euler_characteristic;
};

// \param feature_angle in degrees; 0: no features
// Returns false if the file can't be read.
bool read(const std::string& filename, const double feature_angle, Input& input)
{
  input.name = fs::path(filename).stem().string();
  if(!PMP::IO::read_polygon_mesh(filename, input.mesh))
    return false;
  PMP::triangulate_faces(input.mesh);
  input.is_sharp = input.mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  input.has_features = feature_angle > 0;
  if(input.has_features)
    PMP::detect_sharp_edges(input.mesh, feature_angle, input.is_sharp);
  benchmark::Polygon_soup soup;
  PMP::polygon_mesh_to_polygon_soup(input.mesh, soup.points, soup.polygons);
  input.triangles = soup.triangles();
  input.diagonal = soup.diagonal();
  input.euler_characteristic = benchmark::Topology_of_soup(soup).euler_characteristic;
  return true;
}

// \param seconds negative if there are no quads
void print_row(const Input& input, const std::size_t number, const fs::path& quads_file,
               const double seconds, const std::string& outcome, Totals& totals)
{
  std::cout << "| " << input.name << " | " << input.mesh.number_of_faces() << " | " << number
            << " | " << totals.program() << " | ";
  benchmark::Polygon_soup quads;
  if(seconds < 0 || !CGAL::IO::read_OFF(quads_file.string(), quads.points, quads.polygons) ||
     quads.polygons.empty()) {
    std::cout << " | | | | | | | | " << outcome << " |" << std::endl;
    totals.add_failure();
    return;
  }
  const benchmark::Topology_of_soup topology(quads);
  const benchmark::Shape_of_quads shape(quads);
  const double distance = 100 / input.diagonal *
                          benchmark::distance(input.triangles, quads.triangles(),
                                              input.diagonal / 200);
  const bool has_same = topology.euler_characteristic == input.euler_characteristic;
  std::cout << quads.polygons.size() << " | " << topology.number_of_irregular_vertices << " | "
            << (!topology.is_manifold ? "not manifold" : has_same ? "kept" : "changed") << " | "
            << shape.number_of_inverted_quads << " | " << std::fixed << std::setprecision(3)
            << shape.mean_jacobian << " | " << std::setprecision(2) << shape.first_percentile
            << " | " << distance << " | " << seconds << " | " << outcome << " |" << std::endl;
  totals.add(topology.is_manifold && has_same, shape, distance, seconds);
}

void remesh(const Input& input, const std::size_t number, const fs::path& quads_file,
            Totals& totals)
{
  Mesh mesh = input.mesh, quads;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for(const auto e : mesh.edges())
    is_feature[e] = input.is_sharp[e];
  CGAL::Timer timer;
  timer.start();
  if(input.has_features)
    QR::remove_feature_noise(mesh, is_feature, std::sqrt(PMP::area(mesh) / double(number)));
  const QR::Remeshing_report report = QR::quad_remesh(
    mesh, quads,
    QR::parameters::target_number_of_quads(number).edge_is_constrained_map(is_feature));
  timer.stop();
  if(report)
    CGAL::IO::write_OFF(quads_file.string(), quads,
                        CGAL::parameters::stream_precision(17));
  std::ostringstream outcome;
  outcome << report;
  print_row(input, number, quads_file, report ? timer.time() : -1, outcome.str(), totals);
}

void remesh_by_quadriflow(const Input& input, const std::size_t number,
                          const Quadriflow& quadriflow, const fs::path& mesh_file,
                          const fs::path& quads_file, Totals& totals)
{
  const double seconds = quadriflow.remesh(mesh_file, quads_file, number, input.has_features);
  print_row(input, number, quads_file, seconds, seconds < 0 ? "no quads" : "success", totals);
}

int main(int argc, char** argv)
{
  std::vector<std::size_t> numbers;
  std::vector<std::string> names;
  double feature_angle = 0; // in degrees; 0: no features
  std::string blender, results;
  po::options_description options("Options");
  options.add_options()
    ("quads", po::value(&numbers)->composing(), "sizes (default: 300 and 5000)")
    ("feature-angle", po::value(&feature_angle),
     "edges with a larger angle are features, but for noise, degrees")
    ("blender", po::value(&blender)->default_value("blender"),
     "the program that has QuadriFlow")
    ("results", po::value(&results), "a folder in which the quads are kept")
    ("mesh", po::value(&names)->required(), "meshes of any format that CGAL reads, or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "quad_comparison [options] MESH_OR_FOLDER...", options, "mesh"))
    return *exit_code;
  if(numbers.empty())
    numbers = {300, 5000};
  const Folder results_folder(results);
  const fs::path& folder = results_folder.path();
  const Quadriflow quadriflow(blender, folder);
  std::cout << "| mesh | faces | asked | program | quads | irregular | topology | inverted "
               "| mean Jacobian | 1st percentile | distance, % of diagonal | CPU seconds "
               "| outcome |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|" << std::endl;
  Totals ours("quad_remesh()"), theirs("QuadriFlow");
  for(const std::string& filename : benchmark::mesh_files_of(names)) {
    Input input;
    if(!read(filename, feature_angle, input)) {
      std::cout << "| " << input.name << " | unreadable |" << std::endl;
      continue;
    }
    const fs::path mesh_file = folder / (input.name + ".off");
    CGAL::IO::write_OFF(mesh_file.string(), input.mesh, CGAL::parameters::stream_precision(17));
    for(const std::size_t number : numbers) {
      const std::string stem = input.name + "_" + std::to_string(number);
      remesh(input, number, folder / (stem + "_quad_remesh.off"), ours);
      if(quadriflow.is_there())
        remesh_by_quadriflow(input, number, quadriflow, mesh_file,
                             folder / (stem + "_quadriflow.off"), theirs);
    }
  }
  ours.print();
  if(quadriflow.is_there())
    theirs.print();
  else
    std::cout << "QuadriFlow is left out: the program '" << blender << "' is not there\n";
  return EXIT_SUCCESS;
}
