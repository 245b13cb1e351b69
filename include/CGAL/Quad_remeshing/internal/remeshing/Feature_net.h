// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_INTERNAL_REMESHING_FEATURE_NET_H
#define CGAL_QUAD_REMESHING_INTERNAL_REMESHING_FEATURE_NET_H

#include <CGAL/license/Quad_remeshing.h>

// The feature edges of a mesh as a net, and which of them are noise.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {

// Edges between numbered vertices, from which short chains are removed.
class Feature_net
{
public:
  struct Edge
  {
    std::array<std::size_t, 2> vertices;
    double length;
    bool is_kept = true;
  };

  // \param is_on_border for each vertex
  Feature_net(std::vector<Edge> edges, std::vector<char> is_on_border)
    : m_edges(std::move(edges)), m_is_on_border(std::move(is_on_border)) { }

  const Edge& edge(const std::size_t i) const { return m_edges[i]; }

  // For each edge, the length of its chain.
  std::vector<double> chain_lengths() const
  {
    std::vector<double> result(m_edges.size(), 0);
    for(const Chain& chain : make_chains())
      for(const std::size_t e : chain.edges)
        result[e] = chain.length;
    return result;
  }

  // Removes chains that lead nowhere and are shorter. Where these were much of the net, and many of
  // the others are short, too, these are noise as well: the net of a scan has meshes. Of a few
  // chains, a part means nothing.
  void remove_noise(const double length)
  {
    constexpr std::size_t few = 20; // chains are few
    constexpr double a_fifth = 0.2; // as a part of the length of all chains
    std::vector<Chain> chains = make_chains();
    const bool may_be_noise =
      chains.size() > few &&
      part_of(chains, [](const Chain& c) { return c.leads_nowhere; }) > a_fifth;
    remove_shorter(length, true, chains);
    if(may_be_noise &&
       part_of(chains, [=](const Chain& c) { return c.length < 2 * length; }) > a_fifth)
      remove_shorter(4 * length, false, chains);
  }

private:
  // Edges from one end or branching to the next, or around a loop.
  struct Chain
  {
    std::vector<std::size_t> edges;
    double length = 0;
    bool leads_nowhere = false; // it ends inside the surface, where no other feature is
  };

  struct Vertex
  {
    std::size_t number_of_edges = 0;
    std::array<std::size_t, 2> first_edges;
  };

  std::vector<Vertex> make_vertices() const
  {
    std::vector<Vertex> result(m_is_on_border.size());
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(m_edges[e].is_kept)
        for(const std::size_t v : m_edges[e].vertices)
          if(const std::size_t i = result[v].number_of_edges++; i < 2)
            result[v].first_edges[i] = e;
    return result;
  }

  std::vector<Chain> make_chains() const
  {
    const std::vector<Vertex> vertices = make_vertices();
    boost::disjoint_sets_with_storage<> sets(m_edges.size());
    for(const Vertex& v : vertices)
      if(v.number_of_edges == 2)
        sets.union_set(v.first_edges[0], v.first_edges[1]);
    std::map<std::size_t, Chain> chains;
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(m_edges[e].is_kept) {
        Chain& chain = chains[sets.find_set(e)];
        chain.edges.push_back(e);
        chain.length += m_edges[e].length;
        for(const std::size_t v : m_edges[e].vertices)
          chain.leads_nowhere |= vertices[v].number_of_edges == 1 && !m_is_on_border[v];
      }
    std::vector<Chain> result;
    for(auto& [set, chain] : chains)
      result.push_back(std::move(chain));
    return result;
  }

  // By length.
  template <typename Predicate>
  static double part_of(const std::vector<Chain>& chains, const Predicate& is_meant)
  {
    double all = 0, meant = 0;
    for(const Chain& chain : chains) {
      all += chain.length;
      meant += is_meant(chain) ? chain.length : 0;
    }
    return all > 0 ? meant / all : 0;
  }

  // The shortest go first: where they end, two others can go on as one that is long enough.
  // \param chains the chains before the call, and after it
  void remove_shorter(const double length, const bool must_lead_nowhere,
                      std::vector<Chain>& chains)
  {
    for(const int exponent : {-5, -4, -3, -2, -1, 0}) {
      const double least = std::ldexp(length, exponent);
      while(remove_if(chains, [=](const Chain& c)
              { return c.length < least && (c.leads_nowhere || !must_lead_nowhere); }))
        chains = make_chains();
    }
  }

  // Returns whether there are such chains.
  template <typename Predicate>
  bool remove_if(const std::vector<Chain>& chains, const Predicate& is_meant)
  {
    bool result = false;
    for(const Chain& chain : chains)
      if(is_meant(chain)) {
        result = true;
        for(const std::size_t e : chain.edges)
          m_edges[e].is_kept = false;
      }
    return result;
  }

  std::vector<Edge> m_edges;
  std::vector<char> m_is_on_border;
};

// The net of the feature edges of a mesh inside.
// \param features receives the edge of the mesh for each edge of the net
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename VertexPointMap,
          typename VertexIndexMap>
Feature_net feature_net(const TriangleMesh& mesh, const EdgeIsFeatureMap& is_feature,
                        const VertexPointMap& point_map, const VertexIndexMap& index_map,
                        std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor>&
                          features)
{
  std::vector<char> is_on_border(num_vertices(mesh), false);
  std::vector<Feature_net::Edge> edges_of_net;
  for(const auto e : edges(mesh)) {
    const auto v = source(e, mesh), w = target(e, mesh);
    const std::size_t i = get(index_map, v), j = get(index_map, w);
    if(CGAL::is_border(e, mesh))
      is_on_border[i] = is_on_border[j] = true;
    else if(get(is_feature, e)) {
      features.push_back(e);
      edges_of_net.push_back({{i, j}, std::sqrt(CGAL::to_double(CGAL::squared_distance(
                                        get(point_map, v), get(point_map, w))))});
    }
  }
  return Feature_net(std::move(edges_of_net), std::move(is_on_border));
}

} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_REMESHING_FEATURE_NET_H
