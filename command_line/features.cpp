#include "features.h"

#include "Options.h"
#include "words.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

// Features from end to end, or as a loop.
struct Chain
{
  std::vector<Edge> edges;
  double length = 0;
  bool leads_nowhere = false; // it ends inside the surface, where no other feature is
};

std::vector<Chain> chains_of_features(const Mesh& mesh, const Edge_bool_map& is_feature)
{
  const auto is_inside = [&](const Edge e) { return is_feature[e] && !mesh.is_border(e); };
  boost::disjoint_sets_with_storage<> sets(mesh.num_edges());
  std::vector<char> is_dead_end(mesh.num_vertices(), false);
  for(const auto v : mesh.vertices()) {
    std::vector<Edge> at_vertex;
    for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(h != Mesh::null_halfedge() && is_inside(mesh.edge(h)))
        at_vertex.push_back(mesh.edge(h));
    if(at_vertex.size() == 2)
      sets.union_set(std::size_t(at_vertex[0]), std::size_t(at_vertex[1]));
    is_dead_end[std::size_t(v)] = at_vertex.size() == 1 && !mesh.is_border(v);
  }
  std::map<std::size_t, Chain> chains;
  for(const Edge e : mesh.edges())
    if(is_inside(e)) {
      Chain& chain = chains[sets.find_set(std::size_t(e))];
      chain.edges.push_back(e);
      chain.length += PMP::edge_length(e, mesh);
      chain.leads_nowhere = chain.leads_nowhere || is_dead_end[std::size_t(mesh.vertex(e, 0))] ||
                            is_dead_end[std::size_t(mesh.vertex(e, 1))];
    }
  std::vector<Chain> result;
  for(auto& [set, chain] : chains)
    result.push_back(std::move(chain));
  return result;
}

void mark_sharp_edges(const double angle, Model& model)
{
  const Edge_bool_map is_sharp = model.mesh.add_property_map<Edge, bool>("e:sharp", false).first;
  PMP::detect_sharp_edges(model.mesh, angle, is_sharp);
  for(const Edge e : model.mesh.edges())
    model.is_feature[e] = model.is_feature[e] || (is_sharp[e] && !model.mesh.is_border(e));
}

// Returns the number of their edges.
std::size_t leave_out_short_chains(const double length, Model& model)
{
  std::size_t count = 0;
  // The shortest first: where they end, two others can go on as one that is long enough.
  for(const double part : {0.125, 0.25, 0.5, 1.})
    for(std::size_t before = count + 1; before != count;) {
      before = count;
      for(const Chain& chain : chains_of_features(model.mesh, model.is_feature))
        if(chain.leads_nowhere && chain.length < part * length) {
          count += chain.edges.size();
          for(const Edge e : chain.edges)
            model.is_feature[e] = false;
        }
    }
  return count;
}

// That they are most of them.
void note_noise(const std::vector<Chain>& chains, std::ostream& os)
{
  constexpr std::size_t few = 20;
  std::size_t number = 0;
  double longest = 0;
  for(const Chain& chain : chains)
    if(chain.edges.size() == 1 && chain.leads_nowhere) {
      ++number;
      longest = (std::max)(longest, chain.length);
    }
  if(number > few && 2 * number > chains.size())
    os << "note: " << number << " of these chains are single edges that lead nowhere, as noise makes "
          "them, of length " << longest << " at most: --feature-length leaves out what is shorter, and "
          "a larger --feature-angle keeps fewer\n";
}

} // namespace

void Feature_options::add_to(Options& options, const std::string& keep,
                             const std::string& default_length)
{
  options.add("feature-angle", "DEGREES", angle, {0, 180},
              keep + " edges that are sharper (default: 0, which " + keep + "s none)");
  options.add("feature-length", "L", length, {0, (std::numeric_limits<double>::max)()},
              "leave out features that are shorter and lead nowhere, as noise makes them:\n"
              "lines of edges with an end where no other feature is, nor the border\n"
              "(default: " + default_length + ")");
}

Marked_features Feature_options::mark(Model& model, std::ostream& os) const
{
  if(angle > 0)
    mark_sharp_edges(angle, model);
  Marked_features result;
  result.number_left_out = length > 0 ? leave_out_short_chains(length, model) : 0;
  if(result.number_left_out > 0)
    os << "left out, as they are shorter than " << length << " and lead nowhere: "
       << counted(result.number_left_out, "feature edge") << "; --feature-length 0 keeps them\n";
  const std::vector<Chain> chains = chains_of_features(model.mesh, model.is_feature);
  if(chains.empty()) {
    if(length > 0 && angle == 0 && result.number_left_out == 0)
      os << "note: no edge is a feature that --feature-length could leave out; see --feature-angle and "
            "--features\n";
    return result;
  }
  std::size_t number_of_edges = 0;
  for(const Chain& chain : chains) {
    number_of_edges += chain.edges.size();
    result.length += chain.length;
  }
  os << "features: " << counted(number_of_edges, "edge") << " in " << counted(chains.size(), "chain")
     << ", of length " << result.length << " in sum\n";
  note_noise(chains, os);
  return result;
}

std::size_t release_one_of_three(const Mesh& mesh, Edge_bool_map& is_feature)
{
  std::size_t result = 0;
  for(const auto f : mesh.faces()) {
    const auto around = mesh.halfedges_around_face(mesh.halfedge(f));
    if(std::all_of(around.begin(), around.end(),
                   [&](Halfedge h) { return is_feature[mesh.edge(h)]; })) {
      is_feature[mesh.edge(mesh.halfedge(f))] = false;
      ++result;
    }
  }
  return result;
}
