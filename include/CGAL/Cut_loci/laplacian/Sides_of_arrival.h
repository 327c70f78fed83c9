// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_SIDES_OF_ARRIVAL_H
#define CGAL_CUT_LOCI_LAPLACIAN_SIDES_OF_ARRIVAL_H

#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/image_ray.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// On which side of a graph of mesh edges the shortest paths arrive that must not cross it.
//
// On the mesh cut open along the graph, each vertex of that has a copy for each side. The distances of the copies come
// from those of their neighbors: the two other corners of a face laid flat, and their distances, give an image of the
// source, and so the distance of the third. Where a side is reached along the graph, its copies pass it on, as in the
// algorithm of Dijkstra. This is the only way to know: the distances next to a vertex tell where its shortest path
// arrives, but not whether that has crossed the graph before.
class Sides_of_arrival
{
public:
  // The last piece of a path, across the edge opposite to the vertex. Where none is known, but for paths along an edge, it
  // is next to that, on the side where they arrive: the graph may have that edge, too.
  struct Leg
  {
    Index halfedge = null_index;
    double place = 0.; // from its source on, as a part
  };

  Sides_of_arrival(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   const std::vector<double>& distance, const Indexed_cut_locus& graph, const Curve_network& network)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), graph_(graph), network_(network)
  {
    make_copies();
    for(Index c = 0; c < copies_.size(); ++c)
      for(Index h : copies_[c].halfedges)
        relax(c, h);
    propagate();
  }

  // The faces on the side where the shortest path to the vertex of `node` arrives: none at a leaf, which has one side,
  // and at the border.
  std::vector<Index> faces(Index node) const
  {
    std::vector<Index> result;
    if(has_sides(node))
      for(Index h : copies_[nearest(node)].halfedges)
        result.push_back(h / 3);
    return result;
  }

  Leg leg(Index node) const
  {
    if(!has_sides(node))
      return Leg();
    const Copy& copy = copies_[nearest(node)];
    return copy.leg.halfedge != null_index ? copy.leg : copy.along;
  }

private:
  struct Copy
  {
    Index node;
    std::vector<Index> halfedges; // that leave the vertex, one in each face of the side
    double distance = (std::numeric_limits<double>::infinity)();
    double distance_by_leg = distance, distance_along = distance;
    bool is_settled = false;
    Leg leg, along;
  };
  using Entry = std::tuple<double, Index>; // distance, copy

  bool has_sides(Index node) const
  {
    return network_.degree(node) > 1 && !connectivity_.is_border(graph_.nodes[node].vertex);
  }

  void make_copies()
  {
    for(Index node = 0; node < graph_.nodes.size(); ++node)
    {
      first_copy_.push_back(static_cast<Index>(copies_.size()));
      if(!has_sides(node))
        continue;
      const auto is_graph_edge = [&](Index h)
      { return network_.is_graph_edge(node, connectivity_.edge_of_halfedge[h]); };
      const Index v = graph_.nodes[node].vertex;
      Index start = connectivity_.ring_halfedge[connectivity_.ring_begin[v]];
      while(!is_graph_edge(start))
        start = next_around(start);
      Index h = start;
      do
      {
        if(is_graph_edge(h))
        {
          copies_.emplace_back();
          copies_.back().node = node;
        }
        copies_.back().halfedges.push_back(h);
        h = next_around(h);
      } while(h != start);
    }
    first_copy_.push_back(static_cast<Index>(copies_.size()));
  }

  // counterclockwise
  Index next_around(Index h) const { return mesh_.opposite[mesh_.previous(h)]; }

  Index nearest(Index node) const
  {
    Index result = first_copy_[node];
    for(Index c = result; c < first_copy_[node + 1]; ++c)
      if(copies_[c].distance < copies_[result].distance)
        result = c;
    return result;
  }

  // the copy of the source of `h` in its face, or `null_index`
  Index copy_at(Index h) const
  {
    const Index node = network_.node_of_vertex(mesh_.source(h));
    if(node == null_index)
      return null_index;
    for(Index c = first_copy_[node]; c < first_copy_[node + 1]; ++c)
      for(Index k : copies_[c].halfedges)
        if(k == h)
          return c;
    return null_index;
  }

  // the distance of the source of `h` on the side of its face
  double distance_at(Index h) const
  {
    const Index c = copy_at(h);
    if(c == null_index)
      return distance_[mesh_.source(h)];
    return copies_[c].is_settled ? copies_[c].distance : (std::numeric_limits<double>::infinity)();
  }

  // Distances that come by the face of `h`, which leaves the vertex of copy `c`.
  void relax(Index c, Index h)
  {
    if(copies_[c].is_settled)
      return;
    const Index next = mesh_.next(h), previous = mesh_.previous(h);
    const double a = distance_at(next), b = distance_at(previous);
    Copy& copy = copies_[c];
    // So little beside an edge as makes no difference to who cuts along the curve, see `Smoothing_limits`.
    constexpr double beside = 1. / (1 << 16);
    offer(c, a + edge_length(mesh_, h), {next, beside}, copy.distance_along, copy.along);
    offer(c, b + edge_length(mesh_, previous), {next, 1. - beside}, copy.distance_along, copy.along);
    Image_ray ray;
    if(std::isfinite(a) && std::isfinite(b) && image_ray(mesh_, next, a, b, ray))
      offer(c, ray.distance, {next, ray.place}, copy.distance_by_leg, copy.leg);
  }

  // `best` and `leg_of_best` are those of the same kind.
  void offer(Index c, double distance, const Leg& leg, double& best, Leg& leg_of_best)
  {
    if(!std::isfinite(distance))
      return;
    Copy& copy = copies_[c];
    // A distance below the given one comes of corners that different paths reach: it is as wrong as one above.
    const double given = distance_[graph_.nodes[copy.node].vertex];
    distance = given + std::abs(distance - given);
    if(distance < best)
    {
      best = distance;
      leg_of_best = leg;
    }
    if(!(distance < copy.distance))
      return;
    copy.distance = distance;
    queue_.push({distance, c});
  }

  void propagate()
  {
    while(!queue_.empty())
    {
      const Index c = std::get<1>(queue_.top());
      queue_.pop();
      if(copies_[c].is_settled)
        continue;
      copies_[c].is_settled = true;
      for(Index h : copies_[c].halfedges)
        for(Index other : {mesh_.next(h), mesh_.previous(h)})
        {
          const Index d = copy_at(other);
          if(d != null_index)
            relax(d, other);
        }
    }
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  const Indexed_cut_locus& graph_;
  const Curve_network& network_;
  std::vector<Copy> copies_;
  std::vector<Index> first_copy_; // of each node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_SIDES_OF_ARRIVAL_H
