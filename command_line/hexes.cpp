// seamless hexes IN OUT: makes a mesh of hexahedra of a tetrahedral mesh with a seamless map.

#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "words.h"
#include "pictures/hexahedra_picture.h"

#include <CGAL/Hexahedral_meshing/IO/hexahedra.h>
#include <CGAL/Hexahedral_meshing/hexahedral_mesh.h>
#include <CGAL/Seamless_snapping/IO/HEXEX.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace HM = CGAL::Hexahedral_meshing;

struct Hexahedra_options
{
  std::string input, output, picture, report;
  double number = 0, most = 0, tolerance = 1e-4;
  int rounds = 20;
  bool ignore_features = false;

  bool parse(const Arguments& arguments)
  {
    constexpr double largest_number = 1 << 28;
    Options options("hexes IN.hexex OUT",
                    "Makes the coordinates of a tetrahedral mesh an exact integer-grid map, and\n"
                    "extracts the mesh of hexahedra that it describes. OUT is a .mesh file (MEDIT,\n"
                    "also for Gmsh), a .vtk or an .ovm file, or - for the standard output, in the\n"
                    "MEDIT format.\n");
    options.add_file("input", input);
    options.add_file("output", output);
    options.add("number", "N", number, whole_numbers(1, largest_number),
                "make about N hexahedra, or more if cells collapse (default: do not scale the map, whose "
                "singular edges and translations must be near integers)");
    options.add("maximum-number", "M", most, whole_numbers(1, largest_number),
                "the number of hexahedra above which to give up (default: 64 times N)");
    options.add("tolerance", "T", tolerance, {0, 1, true},
                "gaps up to T count as noise, relative to the extent of the coordinates (default: 1e-4)");
    options.add("ignore-features", ignore_features,
                "features of the file need not lie on the grid");
    options.add("moving-rounds", "R", rounds, whole_numbers(0, 1e6),
                "the largest number of rounds in which vertices move, to make hexahedra positive "
                "(default: 20)");
    options.add("picture", "FILE", picture, "write a picture of the mesh, cut open, as .svg");
    options.add("report", "R.json", report, "write all measurements to a file, as JSON");
    options.add_alias("svg", "picture");
    if(!options.parse(arguments))
      return false;
    if(suffix_of(input) != "hexex" && !is_special_file(input))
      throw Failure(USAGE, "'" + input + "': a tetrahedral mesh with a map is a .hexex file");
    const std::string suffix = suffix_of(output);
    if(suffix != "mesh" && suffix != "vtk" && suffix != "ovm" && !is_special_file(output))
      throw Failure(USAGE, "'" + output + "': hexahedra are written as .mesh, .vtk, or .ovm");
    if(most > 0)
      check_number_of_faces("number", number, "hexahedra", "; --maximum-number allows more", most);
    check_picture(picture);
    check_outputs({input}, {output, picture, report});
    return true;
  }
};

HM::IO::HEXEX_mesh read(const std::string& filename)
{
  HM::IO::HEXEX_mesh mesh;
  std::istringstream is(read_file(filename));
  if(const auto status = HM::IO::read_HEXEX(is, mesh); !status)
    throw Failure(UNREADABLE, filename + ": " + in_words_of_user(status.message));
  return mesh;
}

HM::Hexahedral_meshing_report make_hexahedra(const Hexahedra_options& options,
                                             const HM::IO::HEXEX_mesh& input,
                                             HM::Hexahedral_mesh& mesh)
{
  using Facets = std::vector<std::array<std::int32_t, 3> >;
  using Edges = std::vector<std::array<std::int32_t, 2> >;
  std::vector<CGAL::Simple_cartesian<double>::Point_3> uvw;
  for(const auto& u : input.uvw)
    uvw.emplace_back(u[0], u[1], u[2]);
  const auto np = HM::parameters::tolerance(options.tolerance)
                    .number_of_iterations(std::size_t(options.rounds))
                    .feature_facets(options.ignore_features ? Facets() : input.feature_facets)
                    .feature_edges(options.ignore_features ? Edges() : input.feature_edges);
  const Progress progress("meshing " + counted(input.tetrahedra.size(), "cell"));
  const auto number = std::size_t(options.number), most = std::size_t(options.most);
  const auto uvw_map = CGAL::make_property_map(uvw);
  if(most == 0)
    return HM::hexahedral_mesh(input.points, input.tetrahedra, uvw_map, mesh,
                               np.target_number_of_hexahedra(number));
  return HM::hexahedral_mesh(input.points, input.tetrahedra, uvw_map, mesh,
                             np.target_number_of_hexahedra(number).maximum_number(most));
}

void write_mesh(const std::string& output, const HM::Hexahedral_mesh& mesh)
{
  std::ostringstream os;
  const std::string suffix = suffix_of(output);
  const auto status = is_special_file(output) || suffix == "mesh" ? HM::IO::write_MEDIT(os, mesh)
                      : suffix == "vtk" ? HM::IO::write_VTK(os, mesh)
                                        : HM::IO::write_OVM(os, mesh);
  if(!status)
    throw Failure(UNWRITABLE, output + ": " + in_words_of_user(status.message));
  write_file(output, os.str());
}

nlohmann::json json_of(const HM::Hexahedron_shapes& shapes)
{
  return {{"least_scaled_jacobian", shapes.least_scaled_jacobian},
          {"mean_scaled_jacobian", shapes.mean_scaled_jacobian},
          {"number_by_tenths", shapes.number_by_tenths},
          {"nonpositive_hexahedra", shapes.nonpositive_hexahedra}};
}

std::int32_t largest(const std::vector<std::int32_t>& numbers)
{
  return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
}

nlohmann::json json_of(const HM::Hexahedral_meshing_report& report,
                       const HM::Hexahedral_mesh& mesh)
{
  nlohmann::json irregular = nlohmann::json::object();
  for(const auto& [number, edges] : report.irregular_edges)
    irregular[std::to_string(number)] = edges;
  return {{"status", to_string(report.status)},
          {"hexahedra", report.number_of_hexahedra},
          {"vertices", report.number_of_vertices},
          {"edges", report.number_of_edges},
          {"quadrilaterals", report.number_of_quadrilaterals},
          {"boundary_quadrilaterals", report.number_of_boundary_quadrilaterals},
          {"double_edges", report.number_of_double_edges},
          {"irregular_edges", irregular},
          {"patches", largest(mesh.patches)},
          {"curves", largest(mesh.curves)},
          {"grid_scale", report.grid_scale},
          {"attempts", report.number_of_attempts},
          {"reason_for_more", report.reason_for_more},
          {"shapes_before", json_of(report.shapes_before)},
          {"shapes", json_of(report.shapes)}};
}

void write_summary(std::ostream& os, const HM::Hexahedral_meshing_report& report,
                   const double number)
{
  os << report.number_of_hexahedra << " hexahedra" << ", "
     << counted(report.number_of_vertices, "vertex") << ", "
     << counted(report.number_of_boundary_quadrilaterals, "quadrilateral") << " on the boundary\n";
  if(!report.reason_for_more.empty())
    os << "no fewer were found: with " << std::size_t(number) << ", "
       << in_words_of_user(report.reason_for_more) << "\n";
  os << "interior edges that are irregular:";
  for(const auto& [n, edges] : report.irregular_edges)
    os << " " << edges << " with " << n << " hexahedra;";
  os << (report.irregular_edges.empty() ? " none\n" : " all others have 4\n");
  os << "scaled Jacobian: least " << report.shapes.least_scaled_jacobian << ", mean "
     << report.shapes.mean_scaled_jacobian;
  if(!report.shapes_before.nonpositive_hexahedra.empty())
    os << "; not positive: " << report.shapes_before.nonpositive_hexahedra.size()
       << " before vertices moved, " << report.shapes.nonpositive_hexahedra.size() << " after";
  os << std::endl;
}

} // namespace

void hexes(const Arguments& arguments)
{
  Hexahedra_options options;
  if(!options.parse(arguments))
    return;
  const HM::IO::HEXEX_mesh input =
    read_or_tell(options.report, "complete", [&] { return read(options.input); });
  nlohmann::json json;
  const auto work = [&] {
    HM::Hexahedral_mesh mesh;
    const HM::Hexahedral_meshing_report report = make_hexahedra(options, input, mesh);
    json["hexahedra"] = json_of(report, mesh);
    if(!report)
      throw Failure(NOT_SOLVED, options.input + ": " + to_string(report.status) + ": " +
                                  in_words_of_user(report.message));
    write_mesh(options.output, mesh);
    if(!options.picture.empty())
      write_file(options.picture, hexahedra_picture(mesh));
    write_summary(summary_stream({options.output, options.picture, options.report}), report,
                  options.number);
    if(const auto& bad = report.shapes.nonpositive_hexahedra; !bad.empty())
      throw Failure(STILL_FLIPPED, options.input + ": " + std::to_string(bad.size()) +
                                     " hexahedra have a corner that is not positive; the first is "
                                     "hexahedron " + std::to_string(bad.front()) +
                                     "; ask for more by --number");
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    json["complete"] = is_written(status);
    json["message"] = message;
    if(!options.report.empty())
      write_json(options.report, json);
  });
}
