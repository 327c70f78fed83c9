// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef DISTANCE_BY_POINTS_H
#define DISTANCE_BY_POINTS_H

#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// The distance of a point from curves, by waves that start from the point: the least one of samples of the curves, which
// become denser where there may be less. It is too long by 1e-9 of an edge at most.
template <typename Built>
class Distance_by_points
{
  using Mesh = typename Built::Mesh;
  using Index = CGAL::Cut_loci::Index;
  using Indexed_location = CGAL::Cut_loci::Indexed_location;

public:
  template <typename Curves>
  Distance_by_points(const Built& built, const Curves& curves)
    : built_(built), read_(CGAL::Cut_loci::internal::read_triangle_mesh(built.mesh, built.mesh.points(), true, {}))
  {
    for(const auto& curve : curves)
      for(const auto e : curve)
        halfedges_.push_back(number(built.mesh.is_border(built.mesh.halfedge(e, 0)) ? built.mesh.halfedge(e, 1)
                                                                                    : built.mesh.halfedge(e, 0)));
  }

  template <typename FT>
  double operator()(const std::pair<typename Mesh::Face_index, std::array<FT, 3>>& location) const
  {
    Indexed_location at;
    at.face = number(built_.mesh.halfedge(location.first)) / 3;
    const Index first = number(built_.mesh.halfedge(location.first)) % 3;
    for(Index k = 0; k < 3; ++k)
      at.coordinates[(first + k) % 3] = std::max(location.second[k], 0.);
    return distance(at);
  }

  double operator()(typename Mesh::Vertex_index v) const
  {
    typename Mesh::Halfedge_index h = built_.mesh.opposite(built_.mesh.halfedge(v));
    while(built_.mesh.is_border(h))
      h = built_.mesh.next_around_source(h);
    return distance(CGAL::Cut_loci::internal::location_on(number(h)));
  }

private:
  struct Part
  {
    Index halfedge;
    double from, to;
  };
  static constexpr int parts = 32;

  Index number(typename Mesh::Halfedge_index h) const
  {
    return Index(std::find(read_.halfedges.begin(), read_.halfedges.end(), h) - read_.halfedges.begin());
  }

  double distance(const Indexed_location& at) const
  {
    std::vector<Part> where;
    for(const Index h : halfedges_)
      where.push_back({h, 0., 1.});
    double least = std::numeric_limits<double>::infinity();
    for(int round = 0; round < 6 && where.size() <= 400; ++round)
      where = where_less(at, where, least);
    return read_.unit * least;
  }

  // the parts of parts where the distance may be less than at all samples
  std::vector<Part> where_less(const Indexed_location& at, const std::vector<Part>& where, double& least) const
  {
    CGAL::Cut_loci::internal::Exact_geodesic_propagation propagation(read_.mesh);
    CGAL::Cut_loci::internal::Exact_geodesic_options options;
    const auto t = [](const Part& part, int k) { return part.from + (part.to - part.from) * k / parts; };
    for(const Part& part : where)
      for(int k = 0; k <= parts; ++k)
        options.queries.push_back(CGAL::Cut_loci::internal::location_on(part.halfedge, t(part, k)));
    propagation.run({at}, options);
    for(std::size_t i = 0; i < propagation.number_of_queries(); ++i)
      least = std::min(least, propagation.query_distance(i));
    std::vector<Part> result;
    for(std::size_t i = 0; i < where.size(); ++i)
      for(int k = 0; k < parts; ++k)
      {
        const std::size_t q = i * (parts + 1) + std::size_t(k);
        const double l = propagation.faces().length(where[i].halfedge) * (where[i].to - where[i].from) / parts;
        if(std::min(propagation.query_distance(q), propagation.query_distance(q + 1)) - 0.5 * l < least)
          result.push_back({where[i].halfedge, t(where[i], k), t(where[i], k + 1)});
      }
    return result;
  }

  const Built& built_;
  decltype(CGAL::Cut_loci::internal::read_triangle_mesh(std::declval<const Mesh&>(),
                                                        std::declval<const Mesh&>().points(), true, {})) read_;
  std::vector<Index> halfedges_;
};

#endif // DISTANCE_BY_POINTS_H
