// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_WAVE_ARRIVALS_H
#define CGAL_CUT_LOCI_LAPLACIAN_WAVE_ARRIVALS_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/ways/Straight_waves.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/ways/Way_arrival.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

// The distances of points on an edge at a vertex along the path to that, straight on behind it.
class Wave_past_vertex
{
public:
  Wave_past_vertex(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Way_arrival& arrival,
                   double distance, Index entry)
    : straight_(arrival.straight), before_(distance - arrival.straight)
  {
    const Index v = mesh.source(arrival.halfedge);
    const Index begin = connectivity.ring_begin[v], end = connectivity.ring_begin[v + 1];
    double to_path = 0., to_edge = 0., around = 0.; // counterclockwise from the first edge
    for(Index k = begin; k < end; ++k)
    {
      const Index h = connectivity.ring_halfedge[k];
      if(h == arrival.halfedge)
        to_path = around + arrival.angle;
      if(k == entry)
        to_edge = around;
      if(mesh.source(h) != v)
        break; // the last edge at a border
      const Planar_vector top = apex(mesh, h);
      around += std::atan2(top[1], top[0]);
    }
    const double turn = std::abs(to_edge - to_path), other = connectivity.is_border(v) ? turn : around - turn;
    // behind a saddle the path bends around the vertex
    cosine_ = std::cos((std::min)({turn, other, 3.14159265358979323846}));
  }

  // at a length along the edge
  double operator()(double s) const
  {
    const double square = straight_ * straight_ + s * (s - 2. * straight_ * cosine_);
    return before_ + std::sqrt((std::max)(0., square));
  }

private:
  double straight_, before_, cosine_;
};

// How the shortest paths arrive at vertices of a graph of mesh edges that none of them crosses, and at their neighbors.
//
// That is as the way of the forest, if it is as long as given. Where it is longer, another face may tell more: the distances
// of the two other corners, seen as circles, meet where what comes in across the edge between them seems to come from, and so
// say how far the vertex is. What agrees best with the given distance is right. But the path to a corner on the graph arrives
// on one side of that, and tells nothing to the faces on the others. So vertices are looked at in the order of their distances.
class Wave_arrivals
{
public:
  Wave_arrivals(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                const std::vector<double>& distance, const std::vector<Way_arrival>& ways,
                const Indexed_cut_locus& graph)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), arrivals_(distance.size()),
      side_(mesh.number_of_halfedges(), 0)
  {
    std::vector<unsigned char> is_edge(connectivity.number_of_edges(), 0);
    for(const Indexed_cut_locus::Edge& e : graph.edges)
      is_edge[connectivity.edge_of_halfedge[e.halfedge]] = 1;
    std::vector<Index> vertices;
    for(const Indexed_cut_locus::Node& node : graph.nodes)
    {
      number_sides(node.vertex, is_edge);
      vertices.push_back(node.vertex);
      for(Index k = connectivity.ring_begin[node.vertex]; k < connectivity.ring_begin[node.vertex + 1]; ++k)
        vertices.push_back(connectivity.ring_vertex[k]);
    }
    std::sort(vertices.begin(), vertices.end(),
              [&](Index v, Index w) { return std::tie(distance[v], v) < std::tie(distance[w], w); });
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for(Index v : vertices)
      arrivals_[v] = ways[v];
    for(Index v : vertices)
      look_around(v);
  }

  const Way_arrival& operator[](Index v) const { return arrivals_[v]; }

private:
  // of the halfedges that leave a vertex: those of the faces on one side of the graph have the same number
  void number_sides(Index v, const std::vector<unsigned char>& is_edge)
  {
    const Index begin = connectivity_.ring_begin[v], end = connectivity_.ring_begin[v + 1];
    Index side = 0;
    for(Index k = begin; k < end; ++k)
    {
      side += is_edge[connectivity_.ring_edge(k)];
      if(const Index h = connectivity_.ring_halfedge[k]; mesh_.source(h) == v) // not the last one at a border
        side_[h] = side;
    }
    for(Index k = begin; k < end && !connectivity_.is_border(v) && !is_edge[connectivity_.ring_edge(k)]; ++k)
      side_[connectivity_.ring_halfedge[k]] = side;
  }

  // whether the path to the source of a halfedge arrives on the side of its face
  bool arrives(Index h) const
  {
    const Index own = arrivals_[mesh_.source(h)].halfedge;
    return own == null_index || side_[own] == side_[h];
  }

  void look_around(Index v)
  {
    Way_arrival& best = arrivals_[v];
    if(best.halfedge == null_index)
      best.error = (std::numeric_limits<double>::infinity)();
    else if(best.length <= distance_[v])
      best.error = 0.;
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      if(const Index h = connectivity_.ring_halfedge[k]; mesh_.source(h) == v)
        look_at(h, best);
  }

  void look_at(Index h, Way_arrival& best) const
  {
    const Index to_right = mesh_.next(h), to_left = mesh_.previous(h);
    const bool is_right_known = arrives(to_right), is_left_known = arrives(to_left);
    const Planar_vector left = apex(mesh_, h), right = {{edge_length(mesh_, h), 0.}};
    const double of_left = distance_[mesh_.source(to_left)], of_right = distance_[mesh_.source(to_right)];
    const double given = distance_[mesh_.source(h)];
    const auto offer = [&](const Planar_vector& from, double before)
    {
      const double straight = norm(from), error = std::abs(before + straight - given);
      if(error + 1e-9 * given < best.error) // more than rounding
        best = {h, std::atan2(from[1], from[0]), straight, given, error};
    };
    if(is_right_known)
      offer(right, of_right);
    if(is_left_known)
      offer(left, of_left);
    if(!is_right_known || !is_left_known)
      return;
    if(Planar_vector from; find_virtual_source(right, left, of_right, of_left, from))
      offer(from, 0.);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  std::vector<Way_arrival> arrivals_;
  std::vector<Index> side_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_WAVE_ARRIVALS_H
