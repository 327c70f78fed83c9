// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_SOURCE_MOVES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_SOURCE_MOVES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * moves sources away from where they are symmetric to the surface, by a little, and in directions that depend on nothing
 * but the surface: of sources that a symmetry takes to each other, it takes also the moved ones to each other. So what
 * rounding has left open is decided for all of them in the same way.
 *
 * The direction is found by the curvature of vertices as the source sees it: by its first moment that is not zero, the
 * k-th one if there are k directions that nothing tells from each other. From there it is turned, as it is in a plane of
 * symmetry often. Left out are vertices to which several shortest paths lead, and those behind them.
 */
class Source_moves
{
public:
  /// \pre `geodesics` has run with the sources where they are, and with directions
  explicit Source_moves(const Geodesic_results& geodesics)
  {
    const std::size_t n = geodesics.number_of_sources();
    std::vector<Moments> moments(n, Moments{});
    std::vector<double> size(n, 0.);
    add_vertices(geodesics, moments, size);
    for(std::size_t i = 0; i < n; ++i)
    {
      double number_of_directions = 1., argument = 0.;
      for(std::size_t k = 0; k < number_of_moments; ++k)
        if(std::abs(moments[i][k]) > 1e-6 * size[i])
        {
          number_of_directions = static_cast<double>(k + 1);
          argument = std::arg(moments[i][k]);
          break;
        }
      // the sectors between planes of symmetry are pi / k wide, of which no small number is a multiple
      for(int number = 1; number <= most_moves; ++number)
        ways_.push_back(way(geodesics, i, (argument + number) / number_of_directions));
    }
  }

  static constexpr int most_moves = 4;

  /// the source `i`, moved by a share of its face, for each number up to `most_moves` in another direction
  Indexed_location moved(std::size_t i, double share, int number) const
  {
    const Way& way = ways_[most_moves * i + static_cast<std::size_t>(number) - 1];
    Indexed_location result = way.from;
    for(std::size_t k = 0; k < 3; ++k)
      result.coordinates[k] += share * (way.to.coordinates[k] - way.from.coordinates[k]);
    return result;
  }

private:
  static constexpr std::size_t number_of_moments = 8;
  static constexpr double full_turn = 2. * geodesic_pi;
  using Moments = std::array<std::complex<double>, number_of_moments>;

  /// locations of one face
  struct Way
  {
    Indexed_location from, to;
  };

  static void add_vertices(const Geodesic_results& geodesics, std::vector<Moments>& moments, std::vector<double>& size)
  {
    const Geodesic_faces& faces = geodesics.faces();
    std::vector<Index> order;
    double sum = 0.;
    for(Index v = 0; v < faces.number_of_vertices(); ++v)
      if(geodesics.is_reached(v) && geodesics.distance(v) > 0.)
      {
        order.push_back(v);
        sum += geodesics.distance(v);
      }
    const double mean = sum / static_cast<double>((std::max)(order.size(), std::size_t(1)));
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return geodesics.distance(a) < geodesics.distance(b); });
    std::vector<unsigned char> is_unclear(faces.number_of_vertices(), 0);
    for(Index v : order)
    {
      const Geodesic_arrival& arrival = geodesics.arrival(v);
      is_unclear[v] = geodesics.has_several_paths(v) ||
                      (!geodesics.is_source(arrival.origin) && is_unclear[geodesics.vertex_of_origin(arrival.origin)]);
      if(is_unclear[v])
        continue;
      const double curvature = (faces.is_border(v) ? geodesic_pi : full_turn) - faces.total_angle(v);
      if(std::fabs(curvature) < 1e-9) // in a plane, up to rounding
        continue;
      const std::size_t i = geodesics.source_of(arrival);
      const double weight = curvature * mean / (geodesics.distance(v) + mean);
      const double angle = geodesics.direction_at_source(v) * full_turn / geodesics.source_angle(i);
      for(std::size_t k = 0; k < number_of_moments; ++k)
        moments[i][k] += std::polar(1., static_cast<double>(k + 1) * angle) * weight;
      size[i] += std::fabs(weight);
    }
  }

  /// `direction` as if a full turn were two pi
  static Way way(const Geodesic_results& geodesics, std::size_t i, double direction)
  {
    const Geodesic_faces& faces = geodesics.faces();
    double turn = direction / full_turn - std::floor(direction / full_turn);
    if(geodesics.is_source_on_border(i))
      turn = (std::min)((std::max)(turn, 0.1), 0.9);
    double angle = turn * geodesics.source_angle(i);
    Index h = geodesics.source_halfedge(i);
    Indexed_location at = geodesics.source_location(i);
    if(geodesics.source_vertex(i) != null_index)
    {
      for(Index next = faces.next_around_source(h); angle > faces.angle(h) && next != null_index;
          next = faces.next_around_source(h))
      {
        angle -= faces.angle(h);
        h = next;
      }
      at = location_on(h);
    }
    else if(geodesics.source_edge(i) != null_index && angle > geodesic_pi) // behind the edge
    {
      const Index o = faces.opposite(h);
      at = across(h, o, at);
      angle -= geodesic_pi;
      h = o;
    }
    return {at, end_of_way(faces, at, h, angle)};
  }

  /// in a direction, which is an angle from `h`, on the boundary of the face
  static Indexed_location end_of_way(const Geodesic_faces& faces, const Indexed_location& at, Index h, double angle)
  {
    const Plane_point apex = faces.apex(h);
    const double third = std::sin(angle) / apex.y, second = (std::cos(angle) - third * apex.x) / faces.length(h);
    std::array<double, 3> along;
    along[h % 3] = -second - third;
    along[(h + 1) % 3] = second;
    along[(h + 2) % 3] = third;
    double way = (std::numeric_limits<double>::infinity)();
    for(std::size_t i = 0; i < 3; ++i)
      if(along[i] < 0. && at.coordinates[i] > 0.)
        way = (std::min)(way, -at.coordinates[i] / along[i]);
    Indexed_location result = at;
    for(std::size_t i = 0; i < 3; ++i)
      result.coordinates[i] += way * along[i];
    normalize(result.coordinates);
    return result;
  }

  std::vector<Way> ways_; // of each source, one for each number
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_SOURCE_MOVES_H
