// Writes a surface of a given genus, to try the parametrization on:
//
//   make_handle_body OUT.off [--genus G] [--sharp] [--borders 0|1|2] [--edge-length L]
//
// The file can be of any format that CGAL writes.

#include "handle_body.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/program_options.hpp>

#include <cstdlib>
#include <iostream>
#include <string>

namespace po = boost::program_options;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char** argv)
{
  Handle_body_options body;
  std::string output;
  po::options_description options("Options");
  options.add_options()
    ("genus", po::value(&body.genus), "the number of holes, at least 0 (default: 2)")
    ("sharp", po::bool_switch(&body.is_sharp), "keep the sharp edges of the box")
    ("borders", po::value(&body.number_of_borders), "0, 1 or 2 ends are cut off (default: 0)")
    ("edge-length", po::value(&body.edge_length), "of the triangles (default: 0.25)")
    ("output", po::value(&output)->required(), "the file to write");
  try {
    po::variables_map values;
    const auto files = po::positional_options_description().add("output", 1);
    po::store(po::command_line_parser(argc, argv).options(options).positional(files).run(), values);
    po::notify(values);
    if(body.genus < 0 || body.number_of_borders < 0 || body.number_of_borders > 2
       || !(body.edge_length > 0))
      throw po::error("an option is out of its range");
  } catch(const po::error& error) {
    std::cerr << error.what() << "\n" << options;
    return EXIT_FAILURE;
  }

  Mesh mesh;
  make_handle_body(body, mesh);
  if(!CGAL::IO::write_polygon_mesh(output, mesh, CGAL::parameters::stream_precision(17))) {
    std::cerr << "cannot write '" << output << "'" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << output << ": " << mesh.number_of_faces() << " faces" << std::endl;
  return EXIT_SUCCESS;
}
