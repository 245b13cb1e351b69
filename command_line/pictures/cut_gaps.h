// The gaps along the cuts of a parametrization, computed exactly: what svg_picture.h draws.
//
// A gap at a cut vertex is the difference between its coordinates on the two sides, brought to the
// same chart by the mean transition of the branch.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_CUT_GAPS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_CUT_GAPS_H

#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

using Vector_uv = std::array<double, 2>;

template <typename HalfedgeUVMap, typename Corner>
Vector_uv uv(HalfedgeUVMap map, Corner h)
{
  const auto p = get(map, h);
  return {double(p.x()), double(p.y())};
}

// Whether the charts end at the edge of `h`.
template <typename TriangleMesh>
bool is_chart_boundary(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                       const TriangleMesh& mesh,
                       const CGAL::Seamless_snapping::Seam_transitions<TriangleMesh>& transitions)
{
  return CGAL::is_border_edge(h, mesh) || transitions.is_cut(h);
}

// A chain of cut edges: each halfedge starts where the one before it ends, and the transition from
// the faces of the halfedges to those of their opposites turns by `rotation` quarters.
template <typename TriangleMesh>
struct Cut_branch
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> halfedges;
  int rotation = 0;
};

// The branches end at singular vertices, at the border, and where other than two cut edges meet.
template <typename TriangleMesh>
std::vector<Cut_branch<TriangleMesh> >
cut_branches(const TriangleMesh& mesh,
             const CGAL::Seamless_snapping::Seam_transitions<TriangleMesh>& transitions)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Corner = typename Graph_traits::halfedge_descriptor;
  using Vertex = typename Graph_traits::vertex_descriptor;

  std::map<Vertex, std::vector<Corner> > outgoing; // cut halfedges
  for(const Corner h : transitions.cut_halfedges()) {
    outgoing[source(h, mesh)].push_back(h);
    outgoing[target(h, mesh)].push_back(opposite(h, mesh));
  }
  std::set<Vertex> nodes;
  for(const auto& [v, halfedges] : outgoing)
    if(halfedges.size() != 2 || CGAL::is_border(v, mesh))
      nodes.insert(v);
  for(const auto& singular : transitions.singular_vertices())
    nodes.insert(singular.first);

  std::vector<Cut_branch<TriangleMesh> > branches;
  std::set<Corner> is_done;
  const auto trace = [&](Corner h) {
    if(is_done.count(h) != 0)
      return;
    Cut_branch<TriangleMesh> branch;
    branch.rotation = transitions.rotation(h);
    while(is_done.insert(h).second) {
      is_done.insert(opposite(h, mesh));
      branch.halfedges.push_back(h);
      if(nodes.count(target(h, mesh)) != 0)
        break;
      const std::vector<Corner>& two = outgoing[target(h, mesh)];
      h = (two[0] == opposite(h, mesh)) ? two[1] : two[0];
    }
    branches.push_back(branch);
  };
  for(const Vertex v : nodes)
    for(const Corner h : outgoing[v])
      trace(h);
  for(const Corner h : transitions.cut_halfedges()) // closed branches without a node
    trace(h);
  return branches;
}

inline Vector_uv rotated(Vector_uv u, int quarters)
{
  for(int i = 0; i < quarters; ++i)
    u = {-u[1], u[0]};
  return u;
}

// The gaps of a branch, two per edge: at its source and at its target.
struct Branch_gaps
{
  std::vector<std::array<Vector_uv, 2> > gaps;
  Vector_uv translation = {0, 0}; // the mean one
  double largest = 0;             // 0 if and only if all gaps are exactly 0
  std::size_t edge_of_largest = 0;
};

template <typename TriangleMesh, typename HalfedgeUVMap>
Branch_gaps branch_gaps(const Cut_branch<TriangleMesh>& branch, const TriangleMesh& mesh,
                        HalfedgeUVMap uv_map)
{
  using Exact = CGAL::Exact_rational;
  using Corner = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  // the translation from one side to the other that a pair of corners asks for
  const auto translation = [&](Corner corner, Corner opposite_corner) {
    const Vector_uv p = rotated(uv(uv_map, corner), branch.rotation);
    const Vector_uv q = uv(uv_map, opposite_corner);
    const std::array<Exact, 2> t = {Exact(q[0]), Exact(q[1])};
    return std::array<Exact, 2>{Exact(t[0] - Exact(p[0])), Exact(t[1] - Exact(p[1]))};
  };
  std::vector<std::array<Exact, 2> > translations;
  for(const Corner h : branch.halfedges) {
    const Corner o = opposite(h, mesh);
    translations.push_back(translation(prev(h, mesh), o));
    translations.push_back(translation(h, prev(o, mesh)));
  }

  std::array<Exact, 2> mean = {Exact(0), Exact(0)};
  for(const auto& t : translations)
    for(std::size_t k = 0; k < 2; ++k)
      mean[k] += t[k];
  for(std::size_t k = 0; k < 2; ++k)
    mean[k] /= Exact(static_cast<double>(translations.size()));

  Branch_gaps result;
  result.translation = {CGAL::to_double(mean[0]), CGAL::to_double(mean[1])};
  result.gaps.resize(branch.halfedges.size());
  for(std::size_t i = 0; i < translations.size(); ++i) {
    Vector_uv& gap = result.gaps[i / 2][i % 2];
    for(std::size_t k = 0; k < 2; ++k) {
      const Exact difference = mean[k] - translations[i][k];
      gap[k] = CGAL::to_double(difference);
    }
    const double length = std::hypot(gap[0], gap[1]);
    if(length > result.largest) {
      result.largest = length;
      result.edge_of_largest = i / 2;
    }
  }
  return result;
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_CUT_GAPS_H
