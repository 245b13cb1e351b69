// The command line: makes the parametrization in an OBJ file exactly seamless.
//
//   snap_obj IN.obj OUT.obj [--align-border] [--features] [--tolerance T]
//                           [--report R.json] [--svg PICTURE.svg] [--verbose]

#include "output_file.h"
#include "snap_obj_summary.h"
#include "svg_picture.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace po = boost::program_options;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Uv_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
using Edge_bool_map = Mesh::Property_map<Edge, bool>;

// The exit status. Only `EXACT` says that there is an output, and that it is exact.
enum Exit { EXACT = 0, NOT_SNAPPED = 1, USAGE = 2, UNREADABLE = 3, UNWRITABLE = 4 };

struct Failure : public std::runtime_error
{
  Failure(Exit exit, const std::string& message) : std::runtime_error(message), status(exit) { }
  Exit status;
};

struct Options
{
  std::string input, output, report, svg;
  bool align_border = false;
  bool features = false;
  bool verbose = false;
  bool help = false;
  double tolerance = 1e-4;
  bool has_tolerance = false; // given on the command line
};

// The command line as the library wants it: the values go to `options`.
po::options_description description_of(Options& options)
{
  po::options_description description("Options");
  description.add_options()
    ("align-border", po::bool_switch(&options.align_border), "keep border edges on isocurves")
    ("features", po::bool_switch(&options.features), "keep the edges of 'l' elements on isocurves")
    ("tolerance", po::value(&options.tolerance)->value_name("T"),
     "the largest deviation that counts as inaccuracy, relative to the extent of the coordinates "
     "(default: 1e-4; where alignment is concerned, 100 times the inaccuracy of the seams, from "
     "1e-9 to 1e-4)")
    ("report", po::value(&options.report)->value_name("R.json"), "write all figures to a file")
    ("svg", po::value(&options.svg)->value_name("PICTURE.svg"),
     "draw the domain, and the largest gaps before and after")
    ("verbose", po::bool_switch(&options.verbose), "tell of each step on the error stream")
    ("help", po::bool_switch(&options.help), "show this text");
  return description;
}

// Each file is written after the one before, so that two with one name leave the last of them.
void check_files(const Options& options)
{
  const std::vector<std::string> files = {options.input, options.output, options.report,
                                          options.svg};
  for(std::size_t i = 0; i < files.size(); ++i)
    for(std::size_t j = (std::max)(i + 1, std::size_t(2)); j < files.size(); ++j) // IN may be OUT
      if(are_same_file(files[i], files[j]))
        throw Failure(USAGE, "'" + files[i] + "' and '" + files[j] + "' are the same file");
}

Options parse_command_line(int argc, char** argv)
{
  Options options;
  po::options_description all = description_of(options);
  all.add_options()("input", po::value(&options.input))("output", po::value(&options.output));
  const auto files = po::positional_options_description().add("input", 1).add("output", 1);
  po::variables_map values;
  try {
    po::store(po::command_line_parser(argc, argv).options(all).positional(files).run(), values);
    po::notify(values);
  } catch(const po::error& error) {
    throw Failure(USAGE, std::string(error.what()) + "; see snap_obj --help");
  }
  options.has_tolerance = values.count("tolerance") != 0;
  if(!options.help && (options.input.empty() || options.output.empty()))
    throw Failure(USAGE, "an input and an output file are needed; see snap_obj --help");
  if(!(options.tolerance > 0 && options.tolerance < 1))
    throw Failure(USAGE, "the tolerance must be between 0 and 1");
  if(!options.help)
    check_files(options);
  return options;
}

void print_help()
{
  Options ignored;
  std::cout
    << "Usage: snap_obj IN.obj OUT.obj [options]\n\n"
       "Moves the texture coordinates of a triangle mesh, by about as much as they are\n"
       "inaccurate, so that they are exactly seamless: across each edge, the coordinates on\n"
       "both sides differ by a rotation by a multiple of 90 degrees and a translation.\n\n"
    << description_of(ignored)
    << "\nExit status: 0 the output is exact; 1 no exact solution was found;\n"
       "2 wrong usage; 3 unreadable input; 4 a file cannot be written.\n";
}

// All that the program works on.
struct Model
{
  Mesh mesh;
  Uv_map uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  Edge_bool_map is_feature = mesh.add_property_map<Edge, bool>("e:feature", false).first;
  Edge_bool_map is_aligned = mesh.add_property_map<Edge, bool>("e:aligned", false).first;

  void read(const std::string& filename, Summary& summary)
  {
    const SS::IO::OBJ_status status =
      SS::IO::read_OBJ(filename, mesh, uv_map, SS::parameters::edge_is_constrained_map(is_feature));
    if(!status)
      throw Failure(UNREADABLE, filename + ": " + status.message);
    summary.split_vertices = status.number_of_split_vertices;
    summary.vertices = mesh.number_of_vertices();
    summary.faces = mesh.number_of_faces();
    for(const Edge e : mesh.edges()) {
      summary.border_edges += mesh.is_border(e) ? 1 : 0;
      summary.features += is_feature[e] ? 1 : 0;
    }
  }

  // The lesser change of a coordinate along an edge, on the side where that is larger.
  double misalignment(Edge e) const
  {
    double result = 0;
    for(const Halfedge h : {mesh.halfedge(e), mesh.opposite(mesh.halfedge(e))})
      if(!mesh.is_border(h)) {
        const Kernel::Vector_2 change = uv_map[h] - uv_map[mesh.prev(h)];
        result = (std::max)(result, (std::min)(std::abs(change.x()), std::abs(change.y())));
      }
    return result;
  }

  // Marks the edges that are asked to be aligned and lie on an isocurve now.
  void choose_aligned_edges(const Options& options, double extent, double violation,
                            Summary& summary)
  {
    const double tolerance =
      options.has_tolerance ? options.tolerance * extent
                            : (std::min)((std::max)(100 * violation, 1e-9 * extent), 1e-4 * extent);
    for(const Edge e : mesh.edges()) {
      const bool is_asked = (options.features && is_feature[e])
                            || (options.align_border && mesh.is_border(e));
      is_aligned[e] = is_asked && misalignment(e) <= tolerance;
      summary.aligned_edges += is_aligned[e] ? 1 : 0;
      summary.left_out_edges += (is_asked && !is_aligned[e]) ? 1 : 0;
    }
  }

  SS::Seamlessness measure() const
  {
    return SS::measure_seamlessness(mesh, uv_map,
                                    SS::parameters::edge_is_constrained_map(is_aligned));
  }

  // What counts is the file: it is read back and compared before it gets its name.
  void write(const std::string& filename) const
  {
    write_file(filename, [&](std::ostream& os, const std::string& unfinished) {
      const SS::IO::OBJ_status status =
        SS::IO::write_OBJ(os, mesh, uv_map, "exactly seamless",
                          SS::parameters::edge_is_constrained_map(is_feature));
      if(!status)
        throw Failure(UNWRITABLE, filename + ": " + status.message);
      if(unfinished.empty()) // a device or a pipe
        return;
      Model written;
      Summary ignored;
      written.read(unfinished, ignored);
      if(!is_same(written))
        throw Failure(UNWRITABLE, filename + ": does not read back as it was written; removed");
    });
  }

  // Whether points, faces, coordinates, and features are the same, to the bit, in the same order.
  bool is_same(const Model& other) const
  {
    if(mesh.number_of_vertices() != other.mesh.number_of_vertices() ||
       mesh.number_of_faces() != other.mesh.number_of_faces())
      return false;
    const auto are_same_points = [&](const auto v) {
      const Kernel::Point_3 &p = mesh.point(v), &q = other.mesh.point(v);
      return is_same_number(p.x(), q.x()) && is_same_number(p.y(), q.y()) &&
             is_same_number(p.z(), q.z());
    };
    return std::all_of(mesh.vertices_begin(), mesh.vertices_end(), are_same_points) &&
           std::all_of(mesh.faces_begin(), mesh.faces_end(),
                       [&](const auto f) { return is_same_face(other, f); });
  }

private:
  static bool is_same_number(double x, double y)
  {
    return x == y && std::signbit(x) == std::signbit(y);
  }

  // Elements that were read from files have the same indices, as none is removed.
  bool is_same_face(const Model& other, Mesh::Face_index f) const
  {
    Halfedge g = other.mesh.halfedge(f);
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Kernel::Point_2 &p = uv_map[h], &q = other.uv_map[g];
      if(mesh.target(h) != other.mesh.target(g) ||
         !is_same_number(p.x(), q.x()) || !is_same_number(p.y(), q.y()) ||
         is_feature[mesh.edge(h)] != other.is_feature[other.mesh.edge(g)])
        return false;
      g = other.mesh.next(g);
    }
    return true;
  }
};

void draw(const Options& options, const Model& model, const Uv_map& old_uv_map)
{
  const SS::Seam_transitions<Mesh> transitions =
    SS::seam_transitions(model.mesh, old_uv_map, SS::parameters::tolerance(options.tolerance));
  const Svg_picture<Mesh, Uv_map, Uv_map> picture(model.mesh, old_uv_map, model.uv_map,
                                                  transitions);
  write_file(options.svg, [&](std::ostream& os, const std::string&) {
    picture.write(os, std::filesystem::path(options.input).filename().string());
  });
}

void run(const Options& options, Summary& summary)
{
  CGAL::Real_timer timer;
  timer.start();
  Model model;
  model.read(options.input, summary);
  summary.reading_time = timer.time();
  const bool verbose = options.verbose || summary.faces > 500000;
  if(verbose)
    std::cerr << options.input << ": " << summary.faces << " faces" << std::endl;

  const SS::Seamlessness survey = model.measure();
  model.choose_aligned_edges(options, survey.extent, survey.violation, summary);
  summary.before = model.measure();
  const Uv_map old_uv_map =
    model.mesh.add_property_map<Halfedge, Kernel::Point_2>("h:old_uv").first;
  for(const Halfedge h : model.mesh.halfedges())
    put(old_uv_map, h, model.uv_map[h]);

  timer.reset();
  summary.report =
    SS::snap_to_seamless(model.mesh, model.uv_map,
                         SS::parameters::edge_is_constrained_map(model.is_aligned)
                                        .tolerance(options.tolerance)
                                        .verbose(verbose));
  summary.has_report = true;
  summary.snapping_time = timer.time();
  if(!summary.report)
    throw Failure(NOT_SNAPPED, options.input + ": " + to_text(summary.report));
  summary.after = model.measure();
  if(!summary.after.is_exact())
    throw Failure(NOT_SNAPPED, options.input + ": the result is not exact; please report this");

  timer.reset();
  model.write(options.output);
  summary.writing_time = timer.time();
  if(!options.svg.empty())
    draw(options, model, old_uv_map);
}

int main(int argc, char** argv)
{
  Options options;
  Summary summary;
  Exit status = EXACT;
  std::string message;
  try {
    options = parse_command_line(argc, argv);
    if(options.help) {
      print_help();
      return EXACT;
    }
    run(options, summary);
    std::cout << summary;
  } catch(const Failure& failure) {
    status = failure.status;
    message = failure.what();
    std::cerr << message << std::endl;
  } catch(const Unwritable& failure) {
    status = UNWRITABLE;
    message = failure.what();
    std::cerr << message << std::endl;
  } catch(const std::exception& error) { // no memory, and the like
    status = NOT_SNAPPED;
    message = error.what();
    std::cerr << "snap_obj: " << message << std::endl;
  }

  try {
    if(!options.report.empty())
      write_file(options.report, [&](std::ostream& os, const std::string&) {
        os << to_text(to_json(summary, status == EXACT, message)) << '\n';
      });
  } catch(const std::exception& error) {
    std::cerr << error.what() << std::endl;
    status = (status == EXACT) ? UNWRITABLE : status;
  }
  return status;
}
