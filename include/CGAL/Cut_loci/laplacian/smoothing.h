// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_H
#define CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/laplacian/Curve_beside_vertices.h>
#include <CGAL/Cut_loci/laplacian/Wave_arrivals.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/ways/Way_arrival.h>
#include <CGAL/Cut_loci/ways/Ways_across_edges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

// Moves a cut locus from the edges of the mesh onto the smooth curves it stands for, through the faces.
//
// The branches stay as they are and meet as they did. Each edge of the result lies in one face and tells the edge of the graph
// that it comes from; no edge has length zero. Distances are those along the shortest paths to the vertices next to a node,
// taken straight on.
//
// No shortest path crosses the cut locus. So a vertex of the graph belongs to the side from which the path to it arrives, as
// its way or the distances next to it tell, whichever agrees better with its own. The curve is pushed off it to the others,
// where it crosses the edges at the vertex. These points are nodes, and move along their edges alone: so no order changes,
// segments between them meet nowhere, and the complement stays an open disk. Nor do nodes move beyond where a short way to a
// vertex crosses their edge: where faces are slim, the distances of their corners tell less than the ways.
//
// The scheme is that of Mancinelli, Livesu and Puppo \cgalCite{cgal:mlp-pccld-21}: nodes move in iterations, and a relaxation
// comes last. In the paper, the step is the component of the gradient along the normal; but a gradient estimated across the
// cut locus averages both sides. Here a node moves to where the distances of both ends of its edge, taken straight on along
// their paths, are equal. So the damping leaves 0.5 of the way at first, and half of that with each iteration, where the
// paper's takes it. Where the paths do not converge, the node follows its neighbors.
//
// Linear in the size of the mesh, for tables, and of the graph, for everything else.
class Cut_locus_smoother
{
public:
  // `crossed` are the edges that ways cross; `source_of_face` the source whose faces each one belongs to, which the curve does
  // not enter, or null.
  Cut_locus_smoother(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const std::vector<double>& distance, const std::vector<Way_arrival>& ways,
                     const std::vector<unsigned char>& crossed, const Indexed_cut_locus& input,
                     const std::vector<Index>& source_of_face)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), ways_(mesh, connectivity, ways, crossed),
      input_(input), arrivals_(mesh, connectivity, distance, ways, input),
      curve_(mesh, connectivity, arrivals_, input, source_of_face)
  {
    for(const Point& p : curve_.points())
      places_.push_back(place_of(p));
    for(const Chain& chain : curve_.chains())
      for(std::size_t i = 0; i < chain.stops.size(); ++i)
      {
        Place& place = places_[chain.stops[i].point];
        place.is_used = true;
        if(i > 0)
          place.neighbors.push_back(chain.stops[i - 1].point);
        if(i + 1 < chain.stops.size())
          place.neighbors.push_back(chain.stops[i + 1].point);
      }
    keep_order();
  }

  Indexed_cut_locus operator()(const Smoothing_parameters& parameters, const Progress& progress)
  {
    double rest = parameters.damping;
    for(Index k = 0; k < parameters.number_of_iterations; ++k)
    {
      progress(0.8 * k / parameters.number_of_iterations);
      move([&](const Place& p, double straight)
           { return (1. - rest) * ((p.is_balanced ? p.balance : straight) - p.share); });
      rest *= 0.5;
    }
    progress(0.8);
    for(Index k = 0; k < parameters.number_of_relaxations; ++k)
      move([](const Place& p, double straight) { return p.is_end ? 0. : 0.5 * (straight - p.share); });
    return joined();
  }

private:
  using Chain = Curve_beside_vertices::Chain;
  using Point = Curve_beside_vertices::Point;

  // Where a point is on its edge.
  struct Place
  {
    Index halfedge; // from the vertex next to which it is
    double share = 0., least = 0., most = 0.;
    double balance = 0.5; // where both paths are equally long
    bool is_balanced = false, is_end = false, is_used = false;
    std::vector<Index> neighbors;
  };

  Place place_of(const Point& p) const
  {
    Place result;
    result.is_end = p.is_end;
    result.halfedge = location_of_vertex(connectivity_, p.vertex).face; // any
    if(p.entry == null_index)
      return result;
    result.halfedge = connectivity_.ring_halfedge[p.entry];
    result.least = least_share;
    result.most = (std::max)(least_share, (std::min)(1., ways_.first(result.halfedge)) - least_share);
    set_balance(p, result);
    return result;
  }

  Wave_past_vertex wave(Index v, Index entry) const
  {
    return {mesh_, connectivity_, arrivals_[v], distance_[v], entry};
  }
  Wave_past_vertex wave_from_here(const Point& p) const { return wave(p.vertex, p.entry); }
  Wave_past_vertex wave_from_there(const Point& p) const
  {
    return wave(connectivity_.ring_vertex[p.entry], connectivity_.ring_reverse[p.entry]);
  }

  // Where the distance along the path to one end of the edge, and on, is that along the path to the other.
  void set_balance(const Point& p, Place& place) const
  {
    const Wave_past_vertex from_here = wave_from_here(p), from_there = wave_from_there(p);
    const double length = edge_length(mesh_, place.halfedge);
    const auto difference = [&](double share) { return from_here(share * length) - from_there((1. - share) * length); };
    place.is_balanced = difference(1.) > difference(0.);
    double low = 0., high = 1.;
    for(int i = 0; i < 30; ++i) // a billionth of the edge
      (difference(0.5 * (low + high)) > 0. ? high : low) = 0.5 * (low + high);
    place.balance = low;
  }

  // Two points on one edge, next to its ends, are on either side of where the first one should be.
  void keep_order()
  {
    std::vector<std::pair<Index, Index>> edges;
    for(Index i = 0; i < places_.size(); ++i)
      if(places_[i].is_used && curve_.points()[i].entry != null_index)
        edges.push_back({curve_.edge_of(curve_.points()[i]), i});
    std::sort(edges.begin(), edges.end());
    for(std::size_t i = 0; i + 1 < edges.size(); ++i)
      if(edges[i].first == edges[i + 1].first)
      {
        Place &a = places_[edges[i].second], &b = places_[edges[i + 1].second];
        const double middle = (std::max)(2. * least_share, (std::min)(1. - 2. * least_share, a.balance));
        a.most = (std::min)(a.most, middle - least_share);
        b.most = (std::min)(b.most, 1. - middle - least_share);
      }
  }

  // The point on the diamond of faces around an edge that is laid out along the x-axis.
  Planar_vector beside(Index h, Index point) const
  {
    const Index o = mesh_.opposite[h];
    const Point& p = curve_.points()[point];
    const double length = edge_length(mesh_, h);
    for(Index g : {h, o})
      for(Index k = 3 * (g / 3); k < 3 * (g / 3) + 3; ++k)
      {
        if(p.entry == null_index ? mesh_.source(k) != p.vertex : connectivity_.edge_of_halfedge[k] != curve_.edge_of(p))
          continue;
        const double share = p.entry == null_index         ? 0.
                             : mesh_.source(k) == p.vertex ? places_[point].share
                                                           : 1. - places_[point].share;
        const Planar_vector at = flat_position(mesh_, g, location_on(k, share).coordinates);
        return g == h ? at : Planar_vector{{length - at[0], -at[1]}};
      }
    return {{0.5 * length, 0.}};
  }

  // where the line between the neighbors crosses the edge; of more than two, their mean
  double straight(const Place& place) const
  {
    const Index h = place.halfedge;
    Planar_vector sum = {{0., 0.}};
    for(Index neighbor : place.neighbors)
      sum = sum + beside(h, neighbor);
    double along = sum[0] / static_cast<double>(place.neighbors.size());
    if(place.neighbors.size() == 2)
    {
      const Planar_vector p = beside(h, place.neighbors[0]), q = beside(h, place.neighbors[1]);
      if(p[1] * q[1] < 0.)
        along = p[0] + (q[0] - p[0]) * p[1] / (p[1] - q[1]);
    }
    return along / edge_length(mesh_, h);
  }

  template <typename Way>
  void move(const Way& way)
  {
    std::vector<double> shares;
    for(const Place& p : places_)
      shares.push_back(p.most > 0. && p.is_used ? p.share + way(p, straight(p)) : 0.);
    for(std::size_t i = 0; i < shares.size(); ++i)
      places_[i].share = (std::max)(places_[i].least, (std::min)(places_[i].most, shares[i]));
  }

  Indexed_cut_locus::Node node_of(Index i) const
  {
    const Point& p = curve_.points()[i];
    if(p.entry == null_index)
      return {location_of_vertex(connectivity_, p.vertex), p.vertex, distance_[p.vertex]};
    const Index h = places_[i].halfedge;
    const double share = places_[i].share, length = edge_length(mesh_, h);
    const double between = (1. - share) * distance_[p.vertex] + share * distance_[connectivity_.ring_vertex[p.entry]];
    const double ahead = (std::min)(wave_from_here(p)(share * length), wave_from_there(p)((1. - share) * length));
    return {location_on(h, share), null_index, (std::max)(between, ahead)}; // waves of a user's map may be slower
  }

  Indexed_cut_locus joined() const
  {
    Indexed_cut_locus result;
    std::vector<Index> output(places_.size(), null_index);
    const auto add = [&](Index point)
    {
      if(output[point] == null_index)
      {
        output[point] = static_cast<Index>(result.nodes.size());
        result.nodes.push_back(node_of(point));
      }
      return output[point];
    };
    add(curve_.root());
    for(const Chain& chain : curve_.chains())
      for(std::size_t i = 1; i < chain.stops.size(); ++i)
      {
        const Curve_beside_vertices::Stop &from = chain.stops[i - 1], &to = chain.stops[i];
        const auto edge = static_cast<std::size_t>(0.5 * (from.place + to.place));
        const Indexed_cut_locus::Edge& origin = input_.edges[chain.edges[(std::min)(edge, chain.edges.size() - 1)]];
        const Index source = add(from.point), target = add(to.point);
        result.edges.push_back({source, target, to.halfedge, origin.strength, origin.origin, 0.f, origin.sources});
      }
    return result;
  }

  // from the ends of an edge, and between two points on it: else they could be taken for one
  static constexpr double least_share = 2. * snapping_tolerance;

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  Ways_across_edges ways_;
  const Indexed_cut_locus& input_;
  Wave_arrivals arrivals_;
  Curve_beside_vertices curve_;
  std::vector<Place> places_; // of its points
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_H
