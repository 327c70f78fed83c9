// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DIRECTION_FIELD_H
#define CGAL_CUT_LOCI_DIRECTION_FIELD_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/internal/radix_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * holds for each vertex how the shortest path from the source arrives there.
 *
 * The spread `J` is the Jacobi field of the path: `J'' = -K J`, `J(0) = 0`, `J'(0) = 1`. Two paths that leave the
 * source at an angle of `epsilon` are `epsilon J` apart, and `J` is zero at a conjugate point.
 */
struct Direction_field
{
  struct Vertex
  {
    double distance = 0.;
    float direction = 0.f;   ///< at the source: an angle in its unrolled tangent plane
    float arrival = 0.f;     ///< the direction back to the source: a scaled polar angle of `Direction_geometry`
    float spread = 0.f;      ///< J
    float spread_rate = 1.f; ///< the derivative of J along the path
  };

  std::vector<Vertex> vertices;
  Indexed_source source;
  double total_angle = 0.; ///< at the source
  bool is_cyclic = true;   ///< whether a direction of `total_angle` is that of 0: no, if the source is on the border

  /// the signed difference of two directions at the source
  double turn(double from, double to) const
  {
    const double d = to - from;
    if(!is_cyclic || std::fabs(d) <= total_angle / 2.)
      return d;
    return d > 0. ? d - total_angle : d + total_angle;
  }

  /// the bend of the front at `v`: the geodesic curvature of the distance circle, J'/J, as far as the mesh can
  /// resolve it
  double bend(Index v, double mean_edge_length) const
  {
    const double limit = 0.5 / mean_edge_length;
    const double k = vertices[v].spread_rate / (std::max)(double(vertices[v].spread), 1e-30);
    return (std::min)((std::max)(k, -limit), limit);
  }
};

namespace internal {

// Shared by the two ways to obtain the field: integrates J along the last piece of the paths, vertices of smaller
// distance first.
class Spread_integration
{
public:
  Spread_integration(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const Direction_geometry& geometry, Direction_field& field)
    : connectivity_(connectivity), geometry_(geometry), field_(field), is_known_(mesh.number_of_vertices(), 0)
  {
  }

  bool is_known(Index v) const { return is_known_[v] != 0; }

  // a vertex that the source sees within its own face
  void set_near(Index v)
  {
    field_.vertices[v].spread = static_cast<float>(field_.vertices[v].distance);
    field_.vertices[v].spread_rate = 1.f;
    is_known_[v] = 1;
  }

  // Whether the paths to `u` and `v`, `l` apart, are neighbors: the gap of their directions is at most twice what the
  // spread explains.
  bool are_neighbors(const Direction_field::Vertex& u, double direction, double l) const
  {
    const double j = (std::min)(double(u.spread), u.distance);
    return std::fabs(field_.turn(u.direction, direction)) * j <= 2. * l;
  }

  // The path to `v` crosses the edge from `a` to `b` at the fraction `t`, `rest` before its end.
  void step_across(Index v, Index a, Index b, double t, double l, double rest)
  {
    const Direction_field::Vertex &va = field_.vertices[a], &vb = field_.vertices[b];
    const double reach = l + rest;
    const double wa = is_usable(v, a, reach) ? 1. - t : 0., wb = is_usable(v, b, reach) ? t : 0.;
    if(!(wa + wb > 0.))
    {
      step_from_ring(v);
      return;
    }
    const double foot = field_.vertices[v].distance - rest;
    const auto spread = [&](const Direction_field::Vertex& u)
    { return u.spread + u.spread_rate * (foot - u.distance); };
    const double s = 1. / (wa + wb);
    step(v, s * ((wa > 0. ? wa * spread(va) : 0.) + (wb > 0. ? wb * spread(vb) : 0.)),
         s * (wa * va.spread_rate + wb * vb.spread_rate), rest);
  }

  // the path to `v` comes straight from the vertex `u`
  void step_along(Index v, Index u)
  {
    if(!is_known(u))
    {
      step_from_ring(v);
      return;
    }
    step(v, field_.vertices[u].spread, field_.vertices[u].spread_rate,
         field_.vertices[v].distance - field_.vertices[u].distance);
  }

private:
  bool is_usable(Index v, Index u, double reach) const
  {
    return is_known(u) && are_neighbors(field_.vertices[u], field_.vertices[v].direction, reach);
  }

  // from the neighbor whose path is nearest
  void step_from_ring(Index v)
  {
    Index best = null_index;
    double least = (std::numeric_limits<double>::infinity)();
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
    {
      const Index u = connectivity_.ring_vertex[entry];
      if(!is_known(u))
        continue;
      const Direction_field::Vertex& vu = field_.vertices[u];
      const double gap =
        std::fabs(field_.turn(vu.direction, field_.vertices[v].direction)) * (std::min)(double(vu.spread), vu.distance);
      if(gap < least)
      {
        least = gap;
        best = u;
      }
    }
    if(best == null_index)
      set_near(v);
    else
      step_along(v, best);
  }

  // J'' = -K J over a short way
  void step(Index v, double spread, double rate, double s)
  {
    const double k = geometry_.curvature[v], ks = k * s * s;
    Direction_field::Vertex& vertex = field_.vertices[v];
    const double j = spread * (1. - 0.5 * ks) + rate * s * (1. - ks / 6.);
    // Beyond a conjugate point no path is shortest: where J comes out as negative it is a small number with an error.
    vertex.spread = static_cast<float>((std::max)(j, 1e-3 * geometry_.mean_edge_length));
    vertex.spread_rate = static_cast<float>(rate * (1. - 0.5 * ks) - spread * k * s);
    is_known_[v] = 1;
  }

  const Mesh_connectivity& connectivity_;
  const Direction_geometry& geometry_;
  Direction_field& field_;
  std::vector<unsigned char> is_known_;
};

inline std::vector<Index> order_by_distance(const std::vector<double>& distance)
{
  std::vector<float> key(distance.begin(), distance.end());
  return radix_sorted(key);
}

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * reads distances and directions off an exact solver that has run with directions from one source, and integrates the
 * spread along the paths. Linear time.
 */
template <typename ExactSolver>
Direction_field direction_field(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                const Direction_geometry& geometry, const Indexed_source& source,
                                const ExactSolver& solver)
{
  const Index nv = mesh.number_of_vertices();
  Direction_field field;
  field.source = source;
  field.vertices.resize(nv);
  field.total_angle = solver.source_angle();
  field.is_cyclic = source.vertex != null_index ? !connectivity.is_border(source.vertex)
                                                : solver.source_angle() > 4.; // pi on a border edge, else 2 pi
  internal::Spread_integration integration(mesh, connectivity, geometry, field);
  for(Index v : internal::order_by_distance(solver.distances()))
  {
    Direction_field::Vertex& vertex = field.vertices[v];
    vertex.distance = solver.distance(v);
    if(vertex.distance == 0.)
    {
      integration.set_near(v);
      continue;
    }
    vertex.direction = static_cast<float>(solver.direction_at_source(v));
    const auto arrival_direction = solver.arrival_direction(v);
    vertex.arrival =
      static_cast<float>(geometry.polar[arrival_direction.halfedge] + geometry.scale[v] * arrival_direction.angle);

    const auto& arrival = solver.arrival(v);
    const Index h = arrival.halfedge, a = mesh.source(h), b = mesh.target(h);
    if(!arrival.crosses_halfedge)
    {
      if(arrival.sigma > 0.)
      {
        // The path bends at a vertex of the face: at the one that is nearest to the image.
        const Index apex = mesh.source(Indexed_triangle_mesh::previous(h));
        const double l = geometry.length[h];
        integration.step_along(v, arrival.y > 1e-6 * l ? apex : arrival.x > 0.5 * l ? b : a);
      }
      else
        integration.set_near(v);
      continue;
    }
    const auto& face = solver.faces();
    const auto end = a == v   ? decltype(face.apex(h)){0., 0.}
                     : b == v ? decltype(face.apex(h)){face.length(h), 0.}
                              : face.apex(h);
    const double dx = end.x - arrival.x, dy = end.y - arrival.y;
    const double part = dy > 0. ? (std::min)((std::max)(-arrival.y / dy, 0.), 1.) : 0.; // before the crossing
    const double l = geometry.length[h];
    const double t = (std::min)((std::max)((arrival.x + part * dx) / l, 0.), 1.);
    integration.step_across(v, a, b, t, l, (1. - part) * std::sqrt(dx * dx + dy * dy));
  }
  return field;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_DIRECTION_FIELD_H
