#include "measures.h"

#include "Failure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

namespace {

// The lesser change of a coordinate along an edge, on the side where that is larger.
double misalignment(const Model& model, const Edge e)
{
  const Mesh& mesh = model.mesh;
  double result = 0;
  for(const Halfedge h : {mesh.halfedge(e), mesh.opposite(mesh.halfedge(e))})
    if(!mesh.is_border(h)) {
      const Kernel::Vector_2 change = model.uv_map[h] - model.uv_map[mesh.prev(h)];
      result = (std::max)(result, (std::min)(std::abs(change.x()), std::abs(change.y())));
    }
  return result;
}

double largest_component(const Kernel::Vector_2& v)
{
  return (std::max)(std::abs(v.x()), std::abs(v.y()));
}

// How far the sides of an edge are from each other under the rotation that fits best.
double misfit(const Kernel::Vector_2& side, Kernel::Vector_2 other)
{
  double least = largest_component(side - other);
  for(int k = 1; k < 4; ++k) {
    other = other.perpendicular(CGAL::COUNTERCLOCKWISE);
    least = (std::min)(least, largest_component(side - other));
  }
  return least;
}

} // namespace

void Seam_options::add_to(Options& options)
{
  options.add("weld", reading.weld,
              "join border edges between the same points, for meshes that were cut open along their "
              "seams");
  options.add("align-border", align_border, "keep border edges on isocurves");
  options.add("features", features, "keep the edges of 'l' elements on isocurves");
  options.add("tolerance", "T", tolerance, {0, 1, true},
              "the largest deviation that counts as inaccuracy, relative to the extent of the "
              "coordinates (default: 1e-4; for alignments, 100 times the inaccuracy of the seams, from "
              "1e-9 to 1e-4)");
  options.add("verbose", reading.verbose, "report each step on the error stream");
}

void Seam_options::add_repair_to(Options& options)
{
  options.add("repair-flips", repair_flips, "repair faces that are flipped in the domain, "
              "by changing the coordinates around them if need be");
  options.add("untangling-iterations", "N", untangling_iterations, {0, 1e9},
              "a bound on the work of repairs, in iterations over all faces (default: 400)");
}

SS::Flip_repair Seam_options::flip_repair() const
{
  return repair_flips            ? SS::Flip_repair::UNTANGLE
         : repairs_flips_near_by ? SS::Flip_repair::NEAR_BY
                                 : SS::Flip_repair::NONE;
}

void Seam_options::check(const Options& options)
{
  has_tolerance = options.is_given("tolerance");
}

void Seam_options::check_repair(const Options& options) const
{
  if(options.is_given("untangling-iterations") && !repair_flips)
    throw Failure(USAGE, "--untangling-iterations is for --repair-flips; give that, too");
}

Alignment::Alignment(Model& model, const Seam_options& options)
  : is_aligned(model.mesh.add_property_map<Edge, bool>(std::string(), false).first)
{
  if(!options.features && !options.align_border)
    return;
  const SS::Seamlessness survey = SS::measure_seamlessness(model.mesh, model.uv_map);
  const double extent = survey.extent;
  const double tolerance =
    options.has_tolerance
      ? options.tolerance * extent
      : (std::min)((std::max)(100 * survey.violation, 1e-9 * extent), 1e-4 * extent);
  for(const Edge e : model.mesh.edges()) {
    const bool is_asked = (options.features && model.is_feature[e])
                          || (options.align_border && model.mesh.is_border(e));
    is_aligned[e] = is_asked && misalignment(model, e) <= tolerance;
    number_of_aligned_edges += is_aligned[e] ? 1 : 0;
    number_of_left_out_edges += (is_asked && !is_aligned[e]) ? 1 : 0;
  }
}

SS::Seamlessness measure(const Model& model, const Alignment& alignment)
{
  return SS::measure_seamlessness(model.mesh, model.uv_map,
                                  SS::parameters::edge_is_constrained_map(alignment.is_aligned));
}

Misfits count_misfits(const Model& model, const double tolerance)
{
  const Mesh& mesh = model.mesh;
  const double largest = tolerance * SS::measure_seamlessness(mesh, model.uv_map).extent;
  Misfits result;
  for(const Edge e : mesh.edges()) {
    if(mesh.is_border(e))
      continue;
    ++result.number_of_edges;
    const Halfedge h = mesh.halfedge(e), g = mesh.opposite(h);
    const auto &a = model.uv_map[mesh.prev(h)], &b = model.uv_map[h];
    const auto &a_opposite = model.uv_map[g], &b_opposite = model.uv_map[mesh.prev(g)];
    if((std::max)(largest_component(a - a_opposite), largest_component(b - b_opposite)) <= largest)
      continue;
    ++result.number_of_cut_edges;
    const Kernel::Vector_2 side = b - a, opposite = b_opposite - a_opposite;
    const double distance = misfit(side, opposite);
    const double length = (std::max)(largest_component(side), largest_component(opposite));
    if(distance > largest) {
      ++result.number_of_misfits;
      result.number_of_gross_misfits += 8 * distance > length ? 1 : 0;
    }
  }
  return result;
}

std::string note_on_far_coordinate(const Model& model)
{
  constexpr double far = 1e6; // no map is drawn out like this, but a digit too many makes it so
  constexpr std::ptrdiff_t few = 100; // of so many, one may be wrong
  const Mesh& mesh = model.mesh;
  const auto size = [&](const Halfedge h) { return largest_component(model.uv_map[h] - CGAL::ORIGIN); };
  std::vector<Halfedge> corners;
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      corners.push_back(h);
  const auto part = corners.begin() + std::ptrdiff_t(corners.size()) / 2;
  std::nth_element(corners.begin(), part, corners.end(),
                   [&](const Halfedge h, const Halfedge g) { return size(h) < size(g); });
  if(corners.empty() || !(size(*part) > 0))
    return {};
  const double median = size(*part);
  const auto is_far = [&](const Halfedge h) { return size(h) > far * median; };
  const auto number = std::count_if(part, corners.end(), is_far);
  if(number == 0 || number > (std::max)(few, std::ptrdiff_t(corners.size())) / few * 6)
    return {};
  const Halfedge h = *std::min_element(part, corners.end(), [&](const Halfedge a, const Halfedge b) {
    return std::make_pair(!is_far(a), a) < std::make_pair(!is_far(b), b);
  });
  std::ostringstream os;
  os << ", the coordinate " << size(h) << ", while the median of all is " << median
     << "; correct it";
  return in_words_of_user(Message(Message::VERTEX, "vertex", std::size_t(mesh.target(h))) +
                            " has, in " + Message(Message::FACE, "face", std::size_t(mesh.face(h))) +
                            os.str(), model);
}
