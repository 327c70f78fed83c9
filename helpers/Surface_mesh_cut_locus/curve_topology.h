// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_CURVE_TOPOLOGY_H
#define CGAL_CUT_LOCI_HELPERS_CURVE_TOPOLOGY_H

#include "Union_find.h"

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace curve_measures {
namespace internal {

// The mesh, with lengths that give flat faces angles, as methods see it.
inline CGAL::Cut_loci::Indexed_triangle_mesh with_areas(CGAL::Cut_loci::Indexed_triangle_mesh mesh)
{
  if(CGAL::Cut_loci::internal::needs_mollification(mesh))
    mesh.lengths = CGAL::Cut_loci::internal::Mollification(mesh).lengths;
  return mesh;
}

// The topology of a curve through the faces, from the order of its edges around each node: no coordinates are rounded,
// and no faces split. A border loop is one node, and so are nodes at one point that an edge joins.
//
// If the graph is connected, has 2g cycles, and one walk along its sides meets all of them, a neighborhood of it has one
// border curve and the Euler characteristic 1 - 2g: the rest of the surface is an open disk. With 2g - 1 + k cycles and k
// walks, the rest has k border curves and the Euler characteristic k: k open disks.
class Curve_topology
{
  using Index = CGAL::Cut_loci::Index;
  using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;
  using Graph = CGAL::Cut_loci::Indexed_cut_locus;
  using Location = CGAL::Cut_loci::Indexed_location;
  using Planar = CGAL::Cut_loci::internal::Planar_vector;

public:
  Curve_topology(const Mesh& mesh, const Graph& graph)
    : mesh_(with_areas(mesh)), connectivity_(mesh), graph_(graph),
      nodes_(graph.nodes.size() + connectivity_.number_of_border_loops)
  {
    number_border();
    for(const Graph::Node& node : graph.nodes)
    {
      location_.push_back(node.location);
      for(double& c : location_.back().coordinates)
        c = c > rounding ? c : 0.;
    }
    for(Index i = 0; i < location_.size(); ++i)
    {
      const Index h = border_halfedge(location_[i]);
      if(h != null)
        nodes_.unite(i, Index(location_.size()) + connectivity_.border_loop[mesh.source(h)]);
    }
    for(Index e = 0; e < graph.edges.size(); ++e)
      add_arc(e);
  }

  // the first thing that is wrong for a complement of that many disks, or nothing
  std::string fault(std::size_t disks = 1)
  {
    Union_find parts = nodes_;
    for(Index e : arcs_)
      parts.unite(graph_.edges[e].source, graph_.edges[e].target);
    const std::int64_t components = std::int64_t(parts.number_of_parts());
    if(components != 1)
      return "the curve and the border have " + std::to_string(components) + " components";
    const std::int64_t cycles = std::int64_t(arcs_.size()) - std::int64_t(nodes_.number_of_parts()) + 1,
                       genus = connectivity_.genus(mesh_);
    if(cycles != 2 * genus - 1 + std::int64_t(disks))
      return std::to_string(cycles) + " independent cycles on a surface of genus " + std::to_string(genus);
    if(has_crossing())
      return "the curve crosses itself";
    const std::size_t walks = number_of_walks();
    if(walks == disks)
      return std::string();
    return (disks == 1 ? std::string("the complement is no disk") : "the complement is not one disk for each source") +
           ": the curve has " + std::to_string(walks) + " sides";
  }

private:
  static constexpr Index null = CGAL::Cut_loci::null_index;
  using Place = std::array<double, 3>; // in counterclockwise order around a node

  void number_border()
  {
    for(Index first = 0; first < mesh_.number_of_halfedges(); ++first)
      for(Index h = first; mesh_.is_border_edge(h) && border_position_.count(h) == 0;
          h = connectivity_.ring_halfedge[connectivity_.ring_begin[mesh_.target(h)]])
      {
        const double position = double(border_position_.size());
        border_position_[h] = position;
      }
  }

  // the halfedge on the border that a location is on, or starts at, or `null`
  Index border_halfedge(const Location& x) const
  {
    const Index v = CGAL::Cut_loci::internal::vertex_of(mesh_, x);
    const Index h =
      v != null ? connectivity_.ring_halfedge[connectivity_.ring_begin[v]] : CGAL::Cut_loci::internal::edge_of(x);
    return h != null && mesh_.is_border_edge(h) ? h : null;
  }

  // What runs along the border is part of the loop.
  bool is_along_border(const std::array<double, 3>& a, const std::array<double, 3>& b, Index f) const
  {
    for(Index i = 0; i < 3; ++i)
      if(mesh_.is_border_edge(3 * f + i) && a[(i + 2) % 3] == 0. && b[(i + 2) % 3] == 0.)
        return true;
    return false;
  }

  void add_arc(Index e)
  {
    const Index i = graph_.edges[e].source, j = graph_.edges[e].target;
    Index face = null;
    if(const Index h = graph_.edges[e].halfedge; h != null) // one of several edges that may join two vertices
      face = h / 3;
    else
      CGAL::Cut_loci::internal::for_each_common_face(mesh_, connectivity_, location_[i], location_[j],
                                                     [&](Index f) { face = f; });
    if(face == null)
      return; // its ends are joined by no segment: they stay apart
    const auto a = CGAL::Cut_loci::internal::in_face(mesh_, location_[i], face).coordinates,
               b = CGAL::Cut_loci::internal::in_face(mesh_, location_[j], face).coordinates;
    if(is_along_border(a, b, face))
      return;
    const auto difference = [](double x, double y) { return std::abs(x - y) < 1e-15; };
    if(std::equal(a.begin(), a.end(), b.begin(), difference) && nodes_.find(i) != nodes_.find(j))
    {
      nodes_.unite(i, j);
      return;
    }
    arcs_.push_back(e);
    faces_.push_back(face);
    places_.push_back(place(i, a, b, face));
    places_.push_back(place(j, b, a, face));
  }

  // where the segment from `a` to `b` in `face` leaves node `i`, which is at `a`
  Place place(Index i, const std::array<double, 3>& a, const std::array<double, 3>& b, Index face) const
  {
    const double pi = std::acos(-1.);
    const auto angle = [&](Index h)
    {
      const Planar d = CGAL::Cut_loci::internal::flat_position(mesh_, h, {{b[0] - a[0], b[1] - a[1], b[2] - a[2]}});
      return std::atan2(d[1], d[0]);
    };
    const Index border = border_halfedge(location_[i]), v = CGAL::Cut_loci::internal::vertex_of(mesh_, location_[i]);
    if(v != null)
    {
      Index k = connectivity_.ring_begin[v];
      while(connectivity_.ring_halfedge[k] / 3 != face || mesh_.source(connectivity_.ring_halfedge[k]) != v)
        ++k;
      return {{border == null ? 0. : -border_position_.at(border), double(k), angle(connectivity_.ring_halfedge[k])}};
    }
    const Index on = CGAL::Cut_loci::internal::edge_of(location_[i]);
    if(on == null)
      return {{0., 0., angle(3 * face)}};
    // Along a border the surface is on the left: counterclockwise around the loop is against that.
    if(border != null)
      return {{-border_position_.at(border) - location_[i].coordinates[(border + 1) % 3], 0., angle(border)}};
    const Index first = connectivity_.halfedge_of_edge[connectivity_.edge_of_halfedge[on]];
    const bool is_first = first / 3 == face;
    const double turn = (is_first ? 0. : pi) + (std::max)(0., angle(is_first ? first : mesh_.opposite[first]));
    return {{0., 0., turn < 2. * pi ? turn : 0.}};
  }

  // Walks along the sides of the arcs: at a node, on to the next arc around it.
  std::size_t number_of_walks()
  {
    std::vector<Index> order(places_.size()), next(places_.size()); // of the ends of arcs
    std::iota(order.begin(), order.end(), Index(0));
    const auto node = [&](Index end)
    {
      const auto& e = graph_.edges[arcs_[end / 2]];
      return nodes_.find(end % 2 == 0 ? e.source : e.target);
    };
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b)
              {
      const Index m = node(a), n = node(b);
      return m != n ? m < n : places_[a] < places_[b];
    });
    for(std::size_t first = 0, last; first < order.size(); first = last)
    {
      for(last = first + 1; last < order.size() && node(order[last]) == node(order[first]);)
        ++last;
      for(std::size_t i = first; i < last; ++i)
        next[order[i]] = order[i + 1 < last ? i + 1 : first];
    }
    std::vector<bool> is_walked(order.size(), false);
    std::size_t result = 0;
    for(Index start = 0; start < order.size(); ++start)
    {
      result += is_walked[start] ? 0 : 1;
      for(Index end = start; !is_walked[end]; end = next[end ^ 1])
        is_walked[end] = true;
    }
    return (std::max)(result, std::size_t(1));
  }

  // Whether arcs cross by more than rounding, elsewhere than at a node.
  bool has_crossing()
  {
    std::map<Index, std::vector<Index>> in_face;
    for(Index i = 0; i < arcs_.size(); ++i)
      in_face[faces_[i]].push_back(i);
    for(const auto& f : in_face)
      for(Index i : f.second)
        for(Index j : f.second)
          if(i < j && are_across(i, j, f.first) && are_across(j, i, f.first))
            return true;
    return false;
  }

  // whether the ends of arc `j` are on different sides of the line of arc `i`
  bool are_across(Index i, Index j, Index face)
  {
    const auto planar = [&](Index node) -> Planar
    {
      const auto c = CGAL::Cut_loci::internal::in_face(mesh_, location_[node], face).coordinates;
      return {{c[0], c[1]}};
    };
    const auto &d = graph_.edges[arcs_[i]], &e = graph_.edges[arcs_[j]];
    using namespace CGAL::Cut_loci::internal;
    const Planar p = planar(d.source), along = planar(d.target) - p;
    const double s = cross(along, planar(e.source) - p), t = cross(along, planar(e.target) - p);
    return s * t < 0. && (std::min)(std::abs(s), std::abs(t)) > rounding * norm(along);
  }

  static constexpr double rounding = 1e-12; // of barycentric coordinates, of whoever made the curve

  const Mesh mesh_;
  const CGAL::Cut_loci::Mesh_connectivity connectivity_;
  const Graph& graph_;
  Union_find nodes_; // of the graph, and the border loops
  std::map<Index, double> border_position_;
  std::vector<Location> location_;
  std::vector<Index> arcs_;   // edges of the graph
  std::vector<Index> faces_;  // of each arc
  std::vector<Place> places_; // of the ends of each arc
};

} // namespace internal
} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_CURVE_TOPOLOGY_H
