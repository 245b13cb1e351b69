// seamless snap and seamless check for tetrahedral meshes: files in the HEXEX format.

#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "commands.h"
#include "files.h"
#include "json_report.h"
#include "formats/HEXEX_rewriter.h"
#include "words.h"

#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;
namespace Snapping = CGAL::Seamless_snapping;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

namespace {

// Whether the input is the standard input, which begins with a number, as no surface does.
bool is_volume_on_standard_input(const Arguments& arguments)
{
  for(std::size_t i = 0; i < arguments.size(); ++i) {
    if(const std::string suffix = suffix_of(arguments[i]); suffix == "obj" || suffix == "ply")
      return false;
    const std::string option = i > 0 ? arguments[i - 1] : "";
    if(arguments[i] == "-" && option != "--report" && option != "--picture" && option != "--svg") {
      const Progress progress("reading -"); // the first character may take long to come
      return std::isdigit((std::cin >> std::ws).peek()) != 0;
    }
  }
  return false;
}

} // namespace

bool is_volume(const Arguments& arguments)
{
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return suffix_of(argument) == "hexex";
  }) || is_volume_on_standard_input(arguments);
}

namespace {

// Reads a text where it is: it is large.
struct Text_buffer : public std::streambuf
{
  explicit Text_buffer(std::string& text) { setg(&text[0], &text[0], &text[0] + text.size()); }
};

// The coordinates of corners as points.
struct Uvw_map
{
  using key_type = std::size_t;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::read_write_property_map_tag;

  std::vector<std::array<double, 3> >* uvw;

  friend Point_3 get(const Uvw_map& map, const std::size_t i)
  {
    const std::array<double, 3>& u = (*map.uvw)[i];
    return Point_3(u[0], u[1], u[2]);
  }
  friend void put(const Uvw_map& map, const std::size_t i, const Point_3& p)
  { (*map.uvw)[i] = {{p.x(), p.y(), p.z()}}; }
};

struct Volume
{
  std::string filename, text; // which is kept only if the file can't be read again
  fs::file_time_type time;
  Snapping::IO::HEXEX_mesh mesh;

  explicit Volume(const std::string& name)
    : filename(name)
  {
    if(is_special_file(filename))
      text = read_file(filename);
    else
      time = time_of_file();
    read_from([&](std::istream& is) {
      if(const auto status = Snapping::IO::read_HEXEX(is, mesh); !status)
        throw Failure(UNREADABLE, filename + ": " + in_words_of_user(status.message));
    });
    if(mesh.number_of_rounded_coordinates > 0)
      std::cerr << "note: " << filename << ": "
                << counted(mesh.number_of_rounded_coordinates, "fraction")
                << " that no double holds, rounded to the nearest\n";
    if(mesh.unknown_line > 0)
      std::cerr << "note: the part of " << filename << " from line " << mesh.unknown_line
                << " holds neither walls nor features, and was not read\n";
  }

  Uvw_map uvw_map() { return {&mesh.uvw}; }

  // The file with the coordinates as they are now.
  void write(const std::string& output)
  {
    if(text.empty() && time_of_file() != time)
      throw Failure(UNREADABLE, filename + ": the file has changed since it was read");
    write_file(output, [&](std::ostream& os) {
      read_from([&](std::istream& is) {
        if(const auto status = formats::rewrite_HEXEX(is, os, mesh.uvw); !status)
          throw Failure(UNWRITABLE, output + ": " + in_words_of_user(status.message));
      });
    });
  }

private:
  fs::file_time_type time_of_file() const
  {
    std::error_code error; // of a file that is not there
    return fs::last_write_time(filename, error);
  }

  template <typename F>
  void read_from(const F& f)
  {
    if(!text.empty()) {
      Text_buffer buffer(text);
      std::istream is(&buffer);
      f(is);
    } else {
      std::ifstream is = open_file(filename);
      f(is);
    }
  }
};

struct Volume_options
{
  bool free_boundary = false, ignore_features = false, integer_grid = false;
  double tolerance = 1e-4;

  void add_to(Options& options)
  {
    options.add("free-boundary", free_boundary,
                "the boundary need not lie in planes of constant coordinates");
    options.add("ignore-features", ignore_features,
                "features of the file need not lie in such planes");
    options.add("integer-grid", integer_grid,
                "translations, singular edges, the boundary, and features must be integers");
  }

  auto parameters(const Snapping::IO::HEXEX_mesh& mesh) const
  {
    using Facets = std::vector<std::array<std::int32_t, 3> >;
    using Edges = std::vector<std::array<std::int32_t, 2> >;
    return Snapping::parameters::align_boundary(!free_boundary)
      .feature_facets(ignore_features ? Facets() : mesh.feature_facets)
      .feature_edges(ignore_features ? Edges() : mesh.feature_edges)
      .tolerance(tolerance);
  }
};

Snapping::Volume_seamlessness measure(Volume& volume, const Volume_options& options)
{
  return Snapping::measure_volume_seamlessness(volume.mesh.tetrahedra, volume.uvw_map(),
                                               options.parameters(volume.mesh));
}

// Of the walls of the file, how many lie in no plane of a constant coordinate.
std::size_t number_of_walls_off_planes(Volume& volume)
{
  if(volume.mesh.walls.empty())
    return 0;
  try {
    return Snapping::measure_volume_seamlessness(
      volume.mesh.tetrahedra, volume.uvw_map(),
      Snapping::parameters::align_boundary(false)
        .feature_facets(std::cref(volume.mesh.walls))).number_of_misalignments;
  } catch(const std::invalid_argument&) { // some are no facets
    return volume.mesh.walls.size();
  }
}

Snapping::Volume_integer_grid_measure measure_grid(Volume& volume, const Volume_options& options)
{
  return Snapping::measure_volume_integer_grid(volume.mesh.tetrahedra, volume.uvw_map(),
                                               options.parameters(volume.mesh));
}

// Hexahedra are whole if the boundary is aligned.
void write(std::ostream& os, const Snapping::Volume_integer_grid_measure& m,
           const Snapping::Volume_seamlessness& cells, const Volume_options& options)
{
  os << m.number_of_noninteger_cuts << " translations, "
     << m.number_of_noninteger_facets + m.number_of_noninteger_edges << " aligned facets and edges, "
     << m.number_of_noninteger_singular_edges << " of " << m.number_of_singular_edges
     << " singular edges and " << m.number_of_noninteger_nodes << " of " << m.number_of_nodes
     << " nodes off the integers\n";
  if(!m || options.free_boundary)
    return;
  os << std::fixed << std::setprecision(0) << m.volume << " hexahedra"
     << (cells.number_of_flipped_cells + cells.number_of_degenerate_cells > 0
           ? ", to tell by the volume; flipped or degenerate cells may keep programs from extracting "
             "them" : "") << "\n" << std::defaultfloat << std::setprecision(6);
}

// The note that a map takes no cell to one with a volume; or none.
void write_note_on_volume(std::ostream& os, const Snapping::Volume_seamlessness& s)
{
  if(s.number_of_degenerate_cells == s.number_of_cells)
    os << "note: no cell has a volume in the domain: this is no map\n";
}

std::ostream& operator<<(std::ostream& os, const Snapping::Volume_seamlessness& s)
{
  os << s.number_of_cells << " cells, " << s.number_of_mismatched_facets << " of "
     << s.number_of_interior_facets << " interior facets are cuts or inexact\n"
     << s.number_of_inexact_facets << " inexact facets, largest violation "
     << (s.extent > 0 ? s.violation / s.extent : 0.) << " of the extent\n"
     << s.number_of_misalignments << " of " << s.number_of_aligned_facets << " facets and "
     << s.number_of_aligned_edges << " edges not aligned, by up to "
     << (s.extent > 0 ? s.misalignment / s.extent : 0.) << " of the extent\n";
  if(s.number_of_flipped_cells + s.number_of_degenerate_cells > 0)
    os << s.number_of_flipped_cells << " flipped and " << s.number_of_degenerate_cells
       << " degenerate cells\n";
  return os;
}

nlohmann::json json_of(const Snapping::Volume_seamlessness& s)
{
  return {{"cells", s.number_of_cells},
          {"interior_facets", s.number_of_interior_facets},
          {"inexact_facets", s.number_of_inexact_facets},
          {"violation", s.violation},
          {"extent", s.extent},
          {"aligned_facets", s.number_of_aligned_facets},
          {"aligned_edges", s.number_of_aligned_edges},
          {"misalignments", s.number_of_misalignments},
          {"misalignment", s.misalignment},
          {"flipped_cells", s.number_of_flipped_cells},
          {"degenerate_cells", s.number_of_degenerate_cells}};
}

nlohmann::json json_of(const Snapping::Volume_integer_grid_measure& m)
{
  return {{"noninteger_cuts", m.number_of_noninteger_cuts},
          {"noninteger_facets", m.number_of_noninteger_facets},
          {"noninteger_edges", m.number_of_noninteger_edges},
          {"noninteger_singular_edges", m.number_of_noninteger_singular_edges},
          {"noninteger_nodes", m.number_of_noninteger_nodes},
          {"singular_edges", m.number_of_singular_edges},
          {"nodes", m.number_of_nodes},
          {"volume", m.volume}};
}

// With the number of hexahedra, if they are whole.
nlohmann::json json_of(const Snapping::Volume_integer_grid_measure& m, const Volume_options& options)
{
  nlohmann::json result = json_of(m);
  constexpr double largest_integer = 0x1p53;
  if(m && !options.free_boundary && std::abs(m.volume) < largest_integer)
    result["hexahedra"] = std::llround(m.volume);
  return result;
}

nlohmann::json json_of(const Snapping::Snapping_report& r)
{
  return {{"status", to_string(r.status)},
          {"cut_facets", r.run.number_of_cut_edges},
          {"unknowns", r.linear_solver.number_of_unknowns},
          {"violation_before", r.violation_before},
          {"largest_change", r.largest_change},
          {"largest_rounding", r.largest_rounding},
          {"lost_cells", r.lost_faces.size()},
          {"repaired_flips", r.run.number_of_repaired_flips},
          {"steps", json_of_steps(r.step_times)}};
}

// Scales the map such that its volume is about the wanted number of hexahedra. If cells are flipped then
// or parts have collapsed, finer grids are tried.
// \param scale receives the factor
template <typename Snap>
Snapping::Snapping_report snap_to_number(Volume& volume, const Volume_options& options,
                                         const double hexahedra, double& scale, const Snap& snap)
{
  constexpr int largest_number_of_tries = 7; // up to 4 times the number
  const double size = measure_grid(volume, options).volume;
  if(!(size > 0))
    throw Failure(NOT_SOLVED, volume.filename + ": the map has no volume that hexahedra could fill");
  const std::vector<std::array<double, 3> > input = volume.mesh.uvw;
  for(int i = 0; ; ++i) {
    scale = std::cbrt(hexahedra / size) * std::pow(4., i / (3. * (largest_number_of_tries - 1)));
    const Snapping::Snapping_report report = snap();
    if((report.status != Snapping::Outcome::FLIPS_REMAIN &&
        report.status != Snapping::Outcome::NOT_INTEGER) || i + 1 == largest_number_of_tries)
      return report;
    volume.mesh.uvw = input;
  }
}

} // namespace

void check_volume(const Arguments& arguments)
{
  Options options("check IN.hexex",
                  "Tells whether the coordinates of a tetrahedral mesh are exactly seamless: whether,\n"
                  "across each facet, the coordinates on both sides differ by a rotation of the cube\n"
                  "and a translation, and boundary and features lie in planes of constant coordinates.\n");
  std::string input, report;
  Volume_options volume_options;
  options.add_file("input", input);
  volume_options.add_to(options);
  options.add("report", "R.json", report, "write all measurements to a file, as JSON");
  if(!options.parse(arguments))
    return;
  check_outputs({input}, {report});
  Volume volume = read_or_tell(report, "exact", [&] { return Volume(input); });
  std::ostream& os = summary_stream({report});
  nlohmann::json json;
  const auto work = [&] {
    Snapping::Volume_seamlessness result;
    try {
      result = measure(volume, volume_options);
    } catch(const Snapping::Invalid_input& error) { // what is wrong with cells or features
      throw Failure(NOT_SOLVED, input + ": " + in_words_of_user(error.message));
    }
    os << result;
    json["measured"] = json_of(result);
    bool is_grid = true;
    if(volume_options.integer_grid) {
      const Snapping::Volume_integer_grid_measure grid = measure_grid(volume, volume_options);
      write(os, grid, result, volume_options);
      json["integer_grid"] = json_of(grid, volume_options);
      is_grid = bool(grid);
    }
    write_note_on_volume(os, result);
    if(!result.is_exact())
      throw Failure(NOT_SOLVED, input + ": not exactly seamless");
    if(!is_grid)
      throw Failure(NOT_SOLVED, input + ": no integer-grid map");
    os << "exactly seamless" << std::endl;
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    json["exact"] = status == SUCCESS;
    json["message"] = message;
    if(!report.empty())
      write_json(report, json);
  });
}

void snap_volume(const Arguments& arguments)
{
  Options options("snap IN.hexex OUT.hexex",
                  "Moves the coordinates of a tetrahedral mesh, by about the size of their errors,\n"
                  "so that they are exactly seamless: across each facet, the coordinates\n"
                  "on both sides differ by a rotation of the cube and a translation, and boundary and\n"
                  "features lie in planes of constant coordinates. All else in the file stays as it is.\n");
  std::string input, output, report_file;
  bool overwrite = false, repair_flips = false;
  int untangling_iterations = 400;
  double scale = 1, rounding = 0.01, hexahedra = 0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Volume_options volume_options;
  options.add_file("input", input);
  options.add_file("output", output);
  volume_options.add_to(options);
  options.add("tolerance", "T", volume_options.tolerance, {0, 1, true},
              "gaps up to T count as noise, relative to the extent of the coordinates (default: 1e-4)");
  options.add("grid-scale", "K", scale, {0, infinity, true},
              "multiply the coordinates by K first (default: 1)");
  options.add("rounding", "D", rounding, {0, infinity},
              "with --integer-grid: the largest distance from integers at which translations and "
              "levels are rounded (default: 0.01)");
  options.add("hexahedra", "N", hexahedra, {1, 1e12},
              "make an integer grid of about N hexahedra, with roundings of any size; if cells are "
              "flipped, try more hexahedra, up to 4 N");
  options.add("repair-flips", repair_flips, "repair cells that are flipped in the domain, by "
              "changing the coordinates around them if necessary");
  options.add("untangling-iterations", "N", untangling_iterations, {0, 1e9},
              "the largest number of passes over the cells around flipped cells (default: 400)");
  options.add("overwrite", overwrite, "let OUT replace IN");
  options.add("report", "R.json", report_file, "write all measurements to a file, as JSON");
  options.exclude({"hexahedra", "grid-scale"});
  options.exclude({"hexahedra", "rounding"});
  if(!options.parse(arguments))
    return;
  if(hexahedra > 0) {
    volume_options.integer_grid = repair_flips = true;
    rounding = infinity;
  }
  for(const std::string& file : {input, output})
    if(suffix_of(file) != "hexex" && !is_special_file(file))
      throw Failure(USAGE, file + ": a tetrahedral mesh is read and written as .hexex only");
  if(options.is_given("rounding") && !volume_options.integer_grid)
    throw Failure(USAGE, "--rounding is for --integer-grid; give that, too");
  if(options.is_given("untangling-iterations") && !repair_flips && !volume_options.integer_grid)
    throw Failure(USAGE, "--untangling-iterations is for --repair-flips or --integer-grid; give one "
                         "of these, too");
  check_outputs({input}, {output, report_file},
                overwrite ? Overwriting::ASKED_FOR : Overwriting::NOT_ASKED_FOR);
  Volume volume = read_or_tell(report_file, "exact", [&] { return Volume(input); });
  nlohmann::json json;
  const auto work = [&] {
    Snapping::Volume_seamlessness before;
    try {
      before = measure(volume, volume_options);
      json["before"] = json_of(before);
    } catch(const std::invalid_argument&) { // snapping tells the reason
    }
    const std::size_t walls_before = number_of_walls_off_planes(volume);
    const Progress progress("snapping " + counted(volume.mesh.tetrahedra.size(), "cell"));
    const auto snap = [&] {
      return Snapping::snap_volume_to_seamless(
        volume.mesh.tetrahedra, volume.uvw_map(),
        volume_options.parameters(volume.mesh)
          .integer_grid(volume_options.integer_grid)
          .grid_scale(scale)
          .rounding_tolerance(rounding)
          .repair_flips(repair_flips ? Snapping::Flip_repair::UNTANGLE
                                     : Snapping::Flip_repair::NONE)
          .number_of_untangling_iterations(untangling_iterations));
    };
    const Snapping::Snapping_report report =
      hexahedra > 0 ? snap_to_number(volume, volume_options, hexahedra, scale, snap) : snap();
    json["snapping"] = json_of(report);
    json["grid_scale"] = scale;
    if(!report)
      throw Failure(NOT_SOLVED, input + ": " + in_words_of_user(report.message));
    const Snapping::Volume_seamlessness after = measure(volume, volume_options);
    json["after"] = json_of(after);
    Snapping::Volume_integer_grid_measure grid;
    if(volume_options.integer_grid) {
      grid = measure_grid(volume, volume_options);
      json["integer_grid"] = json_of(grid, volume_options);
    }
    if(!after.is_exact() || (volume_options.integer_grid && !grid))
      throw Failure(NOT_SOLVED, input + ": the result is not exact; please report this");
    const std::size_t walls_after = number_of_walls_off_planes(volume);
    json["walls"] = {{"number", volume.mesh.walls.size()}, {"off_planes_before", walls_before},
                     {"off_planes", walls_after}};
    volume.write(output);
    std::ostream& os = summary_stream({output, report_file});
    os << report.status << ": " << counted(report.run.number_of_cut_edges, "cut facet");
    if(report.status != Snapping::Outcome::ALREADY_EXACT) // else there was no need to find these
      os << " in " << counted(report.run.number_of_cut_branches, "sheet") << ", "
         << counted(report.linear_solver.number_of_unknowns, "unknown");
    os << "\nlargest violation before " << report.violation_before << ", largest change "
       << report.largest_change << " (lengths in the domain), orientation of "
       << counted(report.lost_faces.size(), "cell") << " lost\n";
    if(before.number_of_flipped_cells + before.number_of_degenerate_cells > 0)
      os << before.number_of_flipped_cells << " flipped and " << before.number_of_degenerate_cells
         << " degenerate cells before, " << after.number_of_flipped_cells << " and "
         << after.number_of_degenerate_cells << " now\n";
    if(volume_options.integer_grid) {
      os << "largest rounding " << report.largest_rounding << ", of coordinates times " << scale
         << "\n";
      write(os, grid, after, volume_options);
    }
    if(walls_after > walls_before)
      os << "note: walls that have left their planes of a constant coordinate: "
         << walls_after - walls_before << " of " << volume.mesh.walls.size()
         << "; the list of walls in the file is as before\n";
    write_note_on_volume(os, after);
    if(report.run.number_of_repaired_flips > 0)
      os << report.run.number_of_repaired_flips << " flipped or degenerate cells repaired\n";
    if(report.status == Snapping::Outcome::SNAPPED && !report.message.empty())
      os << "note: " << in_words_of_user(report.message) << "\n";
    if(report.status == Snapping::Outcome::FLIPS_REMAIN)
      throw Failure(STILL_FLIPPED, input + ": " + in_words_of_user(report.message));
  };
  run_and_tell(work, [&](const Exit status, const std::string& message) {
    json["exact"] = is_written(status);
    json["message"] = message;
    if(!report_file.empty())
      write_json(report_file, json);
  });
}
