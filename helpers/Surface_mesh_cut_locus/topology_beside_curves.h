// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_TOPOLOGY_BESIDE_CURVES_H
#define CGAL_CUT_LOCI_HELPERS_TOPOLOGY_BESIDE_CURVES_H

#include "Source_set.h"
#include "Union_find.h"

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace curve_measures {
namespace internal {

/*
 * The surface without its sources shrinks to the cut locus, also if some of them are curves: so both have the same number
 * of components and the same Euler characteristic. A border loop that is no source is closed by a disk, or, for the
 * graph, is a node. That of the surface is V - E + F of the mesh, plus one for each such disk, minus that of the sources.
 */
class Topology_beside_curves
{
  using Index = CGAL::Cut_loci::Index;
  using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;
  using Graph = CGAL::Cut_loci::Indexed_cut_locus;

public:
  Topology_beside_curves(const Mesh& mesh, const Graph& graph, const Source_set& set)
    : mesh_(mesh), connectivity_(mesh), is_closed_(connectivity_.number_of_border_loops, false),
      vertices_(set.vertices_of_curves(mesh))
  {
    for(const CGAL::Cut_loci::Indexed_curve& curve : set.curves)
      for(Index h : curve.halfedges)
      {
        sources_.insert(h);
        if(!mesh.is_border_edge(h))
          sources_.insert(mesh.opposite[h]);
      }
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(mesh.is_border_edge(h) && sources_.count(h) == 0)
        is_closed_[connectivity_.border_loop[mesh.source(h)]] = true;
    of_graph_ = measured(graph);
    of_surface_ = measured_surface(set);
  }

  std::string fault() const
  {
    if(of_graph_.first != of_surface_.first)
      return "the curve has " + std::to_string(of_graph_.first) + " components, and the surface without the sources " +
             std::to_string(of_surface_.first);
    if(of_graph_.second != of_surface_.second)
      return "the curve has the Euler characteristic " + std::to_string(of_graph_.second) +
             ", and the surface without the sources " + std::to_string(of_surface_.second);
    return std::string();
  }

private:
  using Measures = std::pair<std::int64_t, std::int64_t>; // components, and the Euler characteristic

  static CGAL::Cut_loci::Indexed_location rounded(CGAL::Cut_loci::Indexed_location x)
  {
    constexpr double rounding = 1e-12; // of barycentric coordinates, of whoever made the curve
    for(double& c : x.coordinates)
      c = c > rounding ? c : 0.;
    return x;
  }

  // whether an edge joins others along the border, whose loop is one node
  bool is_along_border(const Graph& graph, const Graph::Edge& e) const
  {
    using CGAL::Cut_loci::internal::vertex_of;
    const Index v = vertex_of(mesh_, rounded(graph.nodes[e.source].location));
    const Index w = vertex_of(mesh_, rounded(graph.nodes[e.target].location));
    if(v == CGAL::Cut_loci::null_index || w == CGAL::Cut_loci::null_index)
      return false;
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      if(connectivity_.ring_vertex[k] == w && mesh_.is_border_edge(connectivity_.ring_halfedge[k]))
        return true;
    return false;
  }

  // the closed loop that a node is on, or null
  Index loop_at(const Graph::Node& node) const
  {
    const CGAL::Cut_loci::Indexed_location x = rounded(node.location);
    const Index v = CGAL::Cut_loci::internal::vertex_of(mesh_, x), h = CGAL::Cut_loci::internal::edge_of(x);
    Index result = CGAL::Cut_loci::null_index;
    if(v != CGAL::Cut_loci::null_index)
      result = connectivity_.is_border(v) && vertices_.count(v) == 0 ? connectivity_.border_loop[v] : result;
    else if(h != CGAL::Cut_loci::null_index && mesh_.is_border_edge(h) && sources_.count(h) == 0)
      result = connectivity_.border_loop[mesh_.source(h)];
    return result != CGAL::Cut_loci::null_index && is_closed_[result] ? result : CGAL::Cut_loci::null_index;
  }

  // with a node for each closed loop that the graph meets
  Measures measured(const Graph& graph) const
  {
    const auto n = static_cast<Index>(graph.nodes.size());
    Union_find parts(n + is_closed_.size());
    std::set<Index> met;
    std::int64_t joints = 0, along = 0;
    for(const Graph::Edge& e : graph.edges)
    {
      parts.unite(e.source, e.target);
      along += is_along_border(graph, e);
    }
    for(Index i = 0; i < n; ++i)
      if(const Index loop = loop_at(graph.nodes[i]); loop != CGAL::Cut_loci::null_index)
      {
        parts.unite(i, n + loop);
        met.insert(loop);
        ++joints;
      }
    const auto nodes = static_cast<std::int64_t>(n + met.size());
    const auto unmet = static_cast<std::int64_t>(is_closed_.size() - met.size());
    return {static_cast<std::int64_t>(parts.number_of_parts()) - unmet,
            nodes - joints + along - static_cast<std::int64_t>(graph.edges.size())};
  }

  Measures measured_surface(const Source_set& set) const
  {
    const Index nf = mesh_.number_of_faces();
    Union_find parts(nf + is_closed_.size()); // the disks that close loops are behind the faces
    std::int64_t edges = 0;
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
    {
      edges += mesh_.is_border_edge(h) || h < mesh_.opposite[h];
      if(sources_.count(h) == 0)
        parts.unite(h / 3,
                    mesh_.is_border_edge(h) ? nf + connectivity_.border_loop[mesh_.source(h)] : mesh_.opposite[h] / 3);
    }
    const auto disks = static_cast<std::int64_t>(std::count(is_closed_.begin(), is_closed_.end(), true));
    std::int64_t characteristic = std::int64_t(mesh_.number_of_vertices()) - edges + std::int64_t(nf) + disks;
    characteristic -= static_cast<std::int64_t>(set.points.size() + vertices_.size());
    for(Index h : sources_)
      characteristic += mesh_.is_border_edge(h) || h < mesh_.opposite[h];
    const auto without = static_cast<std::int64_t>(is_closed_.size()) - disks; // places of loops that are sources
    return {static_cast<std::int64_t>(parts.number_of_parts()) - without, characteristic};
  }

  const Mesh& mesh_;
  const CGAL::Cut_loci::Mesh_connectivity connectivity_;
  std::vector<bool> is_closed_; // for each border loop
  std::set<Index> vertices_;    // of the curves
  std::set<Index> sources_;     // halfedges on the curves
  Measures of_graph_, of_surface_;
};

inline std::string topology_fault_beside_curves(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh,
                                                const CGAL::Cut_loci::Indexed_cut_locus& graph, const Source_set& set)
{
  return Topology_beside_curves(mesh, graph, set).fault();
}

} // namespace internal
} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_TOPOLOGY_BESIDE_CURVES_H
