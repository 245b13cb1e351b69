// How the time and the memory of quad_remesh() grow with the number of faces: for each mesh, rounds
// of Loop subdivision, and a tenth as many quads as faces. Each size runs in a process of its own.
//
//   remeshing_growth [--subdivide N]... MESH_OR_FOLDER...
//
// The columns: faces, seconds of the processor (of the user, without reading and subdividing), the
// exponent of the number of faces by which they grow from the row before, quads, irregular
// vertices, the mean scaled Jacobian, and the largest memory of the process, in bytes per face as
// well.

#include "child_process.h"
#include "command_line.h"

#include <CGAL/Quad_remeshing/quad_remesh.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace po = benchmark::options;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace QR = CGAL::Quad_remeshing;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

double user_seconds(const rusage& usage)
{ return double(usage.ru_utime.tv_sec) + 1e-6 * double(usage.ru_utime.tv_usec); }

rusage usage_of_process()
{
  rusage result;
  getrusage(RUSAGE_SELF, &result);
  return result;
}

// The number of faces and the seconds, and then the other cells of the row.
std::string measure(const std::string& filename, const unsigned int subdivisions)
{
  Mesh mesh, quads;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
    throw std::runtime_error(filename + " is unreadable");
  PMP::triangulate_faces(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(
    mesh, CGAL::parameters::number_of_iterations(subdivisions));
  const double start = user_seconds(usage_of_process());
  const auto report = QR::quad_remesh(
    mesh, quads, QR::parameters::target_number_of_quads(mesh.number_of_faces() / 10));
  if(!report)
    throw std::runtime_error(report.message);
  const rusage usage = usage_of_process();
  std::ostringstream result;
  result << mesh.number_of_faces() << ' ' << user_seconds(usage) - start << ' ' << std::fixed
         << std::setprecision(3) << report.number_of_quads << " | "
         << report.number_of_irregular_vertices << " | " << report.mean_scaled_jacobian << " | "
         << usage.ru_maxrss / 1024 << " | "
         << 1024. * double(usage.ru_maxrss) / double(mesh.number_of_faces());
  return result.str();
}

void print_rows(const std::string& filename, const std::vector<unsigned int>& rounds)
{
  double faces_before = 0, seconds_before = 0;
  for(const unsigned int n : rounds) {
    std::string text, cells;
    std::cout << "| " << std::filesystem::path(filename).stem().string() << " | " << std::flush;
    if(benchmark::run_in_child([&] { return measure(filename, n); }, {}, text) !=
       benchmark::Child_end::FINISHED) {
      std::cout << "failed |" << std::endl;
      continue;
    }
    double faces = 0, seconds = 0;
    std::istringstream is(text);
    std::getline(is >> faces >> seconds >> std::ws, cells);
    std::cout << std::fixed << std::setprecision(0) << faces << " | " << std::setprecision(2)
              << seconds << " | ";
    if(faces_before > 0 && faces != faces_before)
      std::cout << std::log(seconds / seconds_before) / std::log(faces / faces_before);
    std::cout << " | " << cells << " |" << std::endl;
    faces_before = faces;
    seconds_before = seconds;
  }
}

int main(int argc, char** argv)
{
  std::vector<unsigned int> rounds;
  std::vector<std::string> meshes;
  po::options_description options("Options");
  options.add_options()
    ("subdivide", po::value(&rounds)->composing(),
     "rounds of Loop subdivision, one size each (default: 1 to 4)")
    ("mesh", po::value(&meshes)->required(), "meshes of any format that CGAL reads, or folders");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "remeshing_growth [options] MESH_OR_FOLDER...", options, "mesh"))
    return *exit_code;
  if(rounds.empty())
    rounds = {1, 2, 3, 4};
  std::cout << "| mesh | faces | CPU seconds | exponent | quads | irregular | mean Jacobian | MB "
               "| bytes per face |\n|---|---|---|---|---|---|---|---|---|" << std::endl;
  for(const std::string& mesh : benchmark::mesh_files_of(meshes))
    print_rows(mesh, rounds);
  return EXIT_SUCCESS;
}
