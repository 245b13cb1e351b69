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

#ifndef CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CROSS_GRAPH_H
#define CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CROSS_GRAPH_H

#include <CGAL/license/Quad_remeshing.h>

// The data of a surface for the energy of a cross field, and coarser graphs of the same kind, whose
// nodes stand for clusters of faces.

#include <CGAL/Linear_snapping/internal/support/Lists.h>
#include <CGAL/Quad_remeshing/internal/parametrization/Triangle_surface.h>
#include <CGAL/Quad_remeshing/internal/parametrization/prescribe_alignment.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_remeshing {
namespace internal {
namespace parametrization {

// Weight of an edge in the energy of a field: its length over the length of the dual edge.
inline double dual_weight(const double length, const double sum_of_areas)
{ return 1.5 * length * length / sum_of_areas; }

// The weight of an edge whose two sides may have different lengths.
inline double dual_weight(const Triangle_surface& surface, const Corner_index h)
{
  const Corner_index g = surface.opposite(h);
  return dual_weight(std::sqrt(surface.length[h] * surface.length[g]),
                     surface.area[surface.face(h)] + surface.area[surface.face(g)]);
}

// One node for each face, or for a connected cluster of faces; neighbors share an edge.
struct Cross_graph
{
  using Node = std::int32_t;

  // To a neighbor, in both directions. A cross z is `rotation * z` in the frame of the target; less
  // than 1 where the edges of the common border disagree, as curvature makes them.
  struct Arc
  {
    Node target;
    double length; // of the common border
    Complex rotation;
  };

  std::size_t size() const { return area.size(); }

  double weight(const std::size_t node, const Arc& arc) const
  { return dual_weight(arc.length, area[node] + area[arc.target]); }

  std::size_t number_of_components = 0;
  double mean_mass = 1;
  std::vector<double> area;           // per node
  std::vector<double> mass;           // area, relative to the mean face of the component
  std::vector<std::size_t> component; // per node
  Lists<Arc> arcs;                    // per node
};

inline Cross_graph cross_graph(const Triangle_surface& surface)
{
  Cross_graph graph;
  graph.number_of_components = surface.number_of_components;
  graph.area = graph.mass = surface.area;
  graph.component = surface.component;
  const std::vector<double> mean_area = component_means(surface, surface.area);
  for(Flat_face_index f = 0; f < surface.number_of_faces(); ++f) {
    graph.mass[f] /= mean_area[surface.component[f]];
    for(Corner_index h = 3 * f; h < 3 * f + 3; ++h)
      if(!surface.is_border_edge(h))
        graph.arcs.push_back({surface.face(surface.opposite(h)), surface.length[h],
                              cross_of_angle(surface.transport(h))});
    graph.arcs.end_list();
  }
  return graph;
}

// Which nodes of a graph are one node of a coarser one: a root and its neighbors, some with
// neighbors of their own. A cross z of the cluster is `transport * z` in the frame of a node.
class Clusters
{
public:
  explicit Clusters(const Cross_graph& graph)
    : m_cluster(graph.size(), none), m_transport(graph.size(), 1)
  {
    for(std::size_t root = 0; root < graph.size(); ++root) {
      bool is_free = m_cluster[root] == none;
      for(const Cross_graph::Arc& arc : graph.arcs[root])
        is_free = is_free && m_cluster[arc.target] == none;
      if(!is_free)
        continue;
      m_cluster[root] = m_size++;
      add_neighbors(graph, root);
    }
    // Each of the others has a neighbor in a cluster.
    std::vector<std::size_t> others;
    for(std::size_t node = 0; node < graph.size(); ++node)
      if(m_cluster[node] == none)
        others.push_back(node);
    for(const std::size_t node : others)
      join_strongest(graph, node);
  }

  std::size_t size() const { return m_size; }

  Cross_graph coarse_graph(const Cross_graph& graph) const
  {
    Cross_graph coarse;
    coarse.number_of_components = graph.number_of_components;
    coarse.mean_mass = graph.mean_mass * double(graph.size()) / double(m_size);
    coarse.area.resize(m_size);
    coarse.mass.resize(m_size);
    coarse.component.resize(m_size);
    for(std::size_t node = 0; node < graph.size(); ++node) {
      coarse.area[m_cluster[node]] += graph.area[node];
      coarse.mass[m_cluster[node]] += graph.mass[node];
      coarse.component[m_cluster[node]] = graph.component[node];
    }
    add_arcs(graph, coarse);
    return coarse;
  }

  // The mean of a field, each node with its mass.
  Prescribed_field restrict(const Cross_graph& graph, const Prescribed_field& field) const
  {
    Prescribed_field result(m_size);
    std::vector<double> mass(m_size);
    for(std::size_t node = 0; node < graph.size(); ++node) {
      result[m_cluster[node]] += graph.mass[node] * std::conj(m_transport[node]) * field[node];
      mass[m_cluster[node]] += graph.mass[node];
    }
    for(std::size_t c = 0; c < m_size; ++c)
      result[c] /= mass[c];
    return result;
  }

  Prescribed_field prolong(const Prescribed_field& field) const
  {
    Prescribed_field result;
    for(std::size_t node = 0; node < m_cluster.size(); ++node)
      result.push_back(m_transport[node] * field[m_cluster[node]]);
    return result;
  }

private:
  void add_neighbors(const Cross_graph& graph, const std::size_t root)
  {
    for(const Cross_graph::Arc& arc : graph.arcs[root])
      if(m_cluster[arc.target] == none) { // not the root, nor met twice
        m_cluster[arc.target] = m_cluster[root];
        m_transport[arc.target] = unit_cross(arc.rotation);
      }
  }

  void join_strongest(const Cross_graph& graph, const std::size_t node)
  {
    double strongest = -1;
    for(const Cross_graph::Arc& arc : graph.arcs[node]) {
      const double weight = graph.weight(node, arc);
      if(m_cluster[arc.target] == none || weight <= strongest)
        continue;
      strongest = weight;
      m_cluster[node] = m_cluster[arc.target];
      m_transport[node] = unit_cross(std::conj(arc.rotation) * m_transport[arc.target]);
    }
  }

  void add_arcs(const Cross_graph& graph, Cross_graph& coarse) const
  {
    const Lists<std::size_t> clusters(m_size, [&](const auto& add) {
      for(std::size_t node = 0; node < graph.size(); ++node)
        add(m_cluster[node], node);
    });
    std::vector<Cross_graph::Arc> arcs;           // from the present cluster
    std::vector<std::size_t> place(m_size, none); // of the arc to a cluster
    for(std::size_t c = 0; c < m_size; ++c) {
      arcs.clear();
      for(const std::size_t node : clusters[c])
        for(const Cross_graph::Arc& arc : graph.arcs[node]) {
          const std::size_t d = m_cluster[arc.target];
          if(d == c)
            continue;
          if(place[d] == none) {
            place[d] = arcs.size();
            arcs.push_back({Cross_graph::Node(d), 0, 0});
          }
          Cross_graph::Arc& sum = arcs[place[d]];
          sum.length += arc.length;
          sum.rotation += arc.length * std::conj(m_transport[arc.target]) * arc.rotation
                          * m_transport[node];
        }
      for(Cross_graph::Arc& arc : arcs) {
        arc.rotation /= arc.length;
        place[arc.target] = none;
      }
      coarse.arcs.append(arcs);
      coarse.arcs.end_list();
    }
  }

  std::size_t m_size = 0;
  std::vector<std::size_t> m_cluster; // per node
  std::vector<Complex> m_transport;   // per node
};

} // namespace parametrization
} // namespace internal
} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_INTERNAL_PARAMETRIZATION_CROSS_GRAPH_H
