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
              "by changing the coordinates around them if necessary");
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
  const double tolerance =
    options.has_tolerance
      ? options.tolerance * SS::measure_seamlessness(model.mesh, model.uv_map).extent
      : tolerance_of_alignment(model.mesh, model.uv_map);
  for(const Edge e : model.mesh.edges()) {
    const bool is_asked = (options.features && model.is_feature[e])
                          || (options.align_border && model.mesh.is_border(e));
    is_aligned[e] = is_asked && misalignment(model.mesh, model.uv_map, e) <= tolerance;
    number_of_aligned_edges += is_aligned[e] ? 1 : 0;
    number_of_left_out_edges += (is_asked && !is_aligned[e]) ? 1 : 0;
  }
}

SS::Seamlessness measure(const Model& model, const Alignment& alignment)
{
  return SS::measure_seamlessness(model.mesh, model.uv_map,
                                  SS::parameters::edge_is_constrained_map(alignment.is_aligned));
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
