// Makes several numbers of quads of one surface: parametrizes, snaps, and coarsens it once. Then
// each number only takes the search for integers. Prints the time of each step.

#include <CGAL/Quad_remeshing/approximate_seamless_parametrization.h>
#include <CGAL/Quad_remeshing/quantize.h>
#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

namespace QR = CGAL::Quad_remeshing;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Seconds of the processor since the last call.
double seconds()
{
  static std::clock_t last = 0;
  const std::clock_t before = last;
  last = std::clock();
  return double(last - before) / CLOCKS_PER_SEC;
}

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : "data/genus3_features.obj";
  std::vector<std::size_t> numbers{500, 2000, 8000};
  if(argc > 2)
    numbers.clear();
  for(int i = 2; i < argc; ++i)
    numbers.push_back(std::size_t(std::atol(argv[i])));
  Mesh mesh;
  const auto uv_map = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if(!SS::IO::read_OBJ(input, mesh, uv_map, QR::parameters::edge_is_constrained_map(is_feature)))
    return EXIT_FAILURE;
  const auto features = QR::parameters::edge_is_constrained_map(is_feature);
  const auto parameters = features.align_border(true);
  seconds();
  const auto made = QR::approximate_seamless_parametrization(mesh, uv_map, parameters);
  std::cout << made << "\nparametrization: " << seconds() << " s\n";
  const auto snapped = SS::snap_to_seamless(mesh, uv_map, parameters);
  std::cout << snapped << "\nsnapping: " << seconds() << " s\n";
  if(!made || !snapped)
    return EXIT_FAILURE;

  QR::Quantization quantization;
  for(const std::size_t number : numbers) {
    quantization =
      quantization ? QR::quantize_again(quantization, mesh,
                                        QR::parameters::target_number_of_quads(number))
                   : QR::quantize(mesh, uv_map, features.target_number_of_quads(number));
    std::cout << "quantization to " << number << ": " << seconds() << " s, "
              << quantization.number_of_quads << " quads\n";
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t> > quads;
    if(!QR::extract_quad_soup(quantization, mesh, points, quads))
      return EXIT_FAILURE;
    std::cout << "extraction: " << seconds() << " s, " << quads.size() << " quads\n";
  }
  return EXIT_SUCCESS;
}
