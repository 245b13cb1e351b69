#include "Feature_options.h"

#include "Options.h"
#include "words.h"

#include <CGAL/Quad_remeshing/detect_features.h>
#include <CGAL/Quad_remeshing/remove_feature_noise.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace QR = CGAL::Quad_remeshing;

namespace {

void mark_sharp_edges(const double angle, Model& model)
{
  Edge_bool_map is_sharp = model.mesh.add_property_map<Edge, bool>("e:sharp", false).first;
  {
    const Size_near_one size(model.mesh);
    PMP::detect_sharp_edges(model.mesh, angle, is_sharp);
  }
  for(const Edge e : model.mesh.edges())
    model.is_feature[e] = model.is_feature[e] || (is_sharp[e] && !model.mesh.is_border(e));
  model.mesh.remove_property_map(is_sharp);
}

// Marks the sharp edges that are features of a part, and tells whether there are any.
void detect_features(const double length, Model& model, std::ostream& os)
{
  constexpr int angle = Feature_options::detected_angle;
  Edge_bool_map is_found = model.mesh.add_property_map<Edge, bool>("e:found", false).first;
  QR::Detected_features found;
  {
    const Size_near_one size(model.mesh);
    found = QR::detect_features(model.mesh, angle, length / size.unscaled(1), is_found);
  }
  for(const Edge e : model.mesh.edges())
    model.is_feature[e] = model.is_feature[e] || is_found[e];
  model.mesh.remove_property_map(is_found);
  const std::size_t left_out = found.number_of_sharp_edges - found.number_of_features;
  if(found.number_of_features > 0)
    os << counted(found.number_of_features, "sharp edge")
       << " kept; --feature-angle 0 keeps none\n";
  if(left_out > 0) {
    os << counted(left_out, "sharp edge") << " not kept, because most sharp edges lie ";
    if(length > 0)
      os << "in chains shorter than " << length << ", or ";
    os << "beside faces that bend, too; --feature-angle " << angle
       << " --feature-length 0 keeps them\n";
  }
}

// Notes if more than half of all features are short for the edges of the mesh, unless they are few.
void note_noise(const std::size_t number_of_features, Model& model, std::ostream& os)
{
  constexpr std::size_t few = 20;
  if(number_of_features <= few)
    return;
  Mesh& mesh = model.mesh;
  Edge_bool_map is_kept = mesh.add_property_map<Edge, bool>("e:kept", false).first;
  double sum = 0;
  for(const Edge e : mesh.edges()) {
    is_kept[e] = model.is_feature[e];
    sum += PMP::edge_length(e, mesh);
  }
  const double length = 2 * sum / double(mesh.num_edges());
  const std::size_t number = QR::remove_feature_noise(mesh, is_kept, length);
  mesh.remove_property_map(is_kept);
  if(2 * number > number_of_features)
    os << "note: " << number << " of these edges look like noise: --feature-length " << length
       << " leaves them out, and a larger --feature-angle keeps fewer\n";
}

} // namespace

void Feature_options::add_to(Options& options, const std::string& keep,
                             const std::string& default_length)
{
  options.add("feature-angle", "DEGREES", angle, {0, 180},
              keep + " edges with at least this angle between the normals of their faces: 0 for a flat "
              "surface, 90 for a cube. 0 " + keep + "s none (default: " +
              std::to_string(detected_angle) + " if most such edges lie in long chains between smooth "
              "faces, as on CAD models; else, and with --features, 0)");
  options.add("feature-length", "L", length, {0, (std::numeric_limits<double>::max)()},
              "leave out features that are noise: lines shorter than L with a free end, all lines "
              "shorter than L that hang together and have many free ends, and sides of thin triangles "
              "(default: " + default_length + ")");
}

Marked_features Feature_options::mark(const double edge_length, Model& model, std::ostream& os) const
{
  if(is_automatic())
    detect_features(edge_length, model, os);
  else if(angle > 0)
    mark_sharp_edges(angle, model);
  Marked_features result;
  result.number_left_out = QR::remove_feature_noise(model.mesh, model.is_feature, length);
  if(result.number_left_out > 0)
    os << "left out as noise, by a --feature-length of " << length << ": "
       << counted(result.number_left_out, "feature edge") << "; 0 keeps them\n";
  std::size_t number = 0;
  for(const Edge e : model.mesh.edges())
    if(model.is_feature[e] && !model.mesh.is_border(e)) {
      ++number;
      result.length += PMP::edge_length(e, model.mesh);
    }
  if(number + result.number_left_out > 0)
    os << "features: " << counted(number, "edge") << ", of length " << result.length
       << " in sum\n";
  else if(length > 0 && !(angle > 0) && !has_default_length)
    os << "note: no edge is a feature that --feature-length could leave out; see --feature-angle and "
          "--features\n";
  if(length == 0)
    note_noise(number, model, os);
  return result;
}

std::vector<Edge> release_one_of_three(const Mesh& mesh, Edge_bool_map& is_aligned)
{
  std::vector<Edge> result;
  for(const auto f : mesh.faces()) {
    const auto around = mesh.halfedges_around_face(mesh.halfedge(f));
    if(std::all_of(around.begin(), around.end(),
                   [&](Halfedge h) { return is_aligned[mesh.edge(h)]; })) {
      result.push_back(mesh.edge(mesh.halfedge(f)));
      is_aligned[result.back()] = false;
    }
  }
  return result;
}
