// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DIRECTION_TRANSPORT_H
#define CGAL_CUT_LOCI_DIRECTION_TRANSPORT_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Finds the directions from exact distances alone, vertices of smaller distance first.
class Direction_transport
{
public:
  Direction_transport(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                      const Direction_geometry& geometry, const Indexed_source& source,
                      const std::vector<double>& distance)
    : mesh_(mesh), connectivity_(connectivity), geometry_(geometry), integration_(mesh, connectivity, geometry, field_)
  {
    field_.source = source;
    field_.vertices.resize(mesh.number_of_vertices());
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      field_.vertices[v].distance = distance[v];
    if(source.vertex != null_index)
      start_at_vertex(source.vertex);
    else
      start_in_face(source.location);
    for(Index v : order_by_distance(distance))
      if(!integration_.is_known(v))
        reach(v);
  }

  Direction_field take() { return std::move(field_); }

private:
  struct Arrival
  {
    double mismatch = (std::numeric_limits<double>::infinity)();
    double direction = 0., arrival = 0.;
    double part = 0., length = 0., rest = 0.; // where the path crosses the edge from a to b
    Index a = null_index, b = null_index;     // without b, the path is that to a, moved sideways
  };

  static double pi() { return 3.14159265358979323846; }

  void start_at_vertex(Index v)
  {
    field_.is_cyclic = !connectivity_.is_border(v);
    field_.vertices[v].distance = 0.;
    integration_.set_near(v);
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
    {
      const Index h = connectivity_.ring_halfedge[entry];
      const bool is_outgoing = mesh_.source(h) == v;
      const std::array<float, 2> polar = geometry_.polar_at_ends(mesh_, h);
      const double angle = polar[is_outgoing ? 0 : 1] / geometry_.scale[v];
      if(is_outgoing)
        field_.total_angle += geometry_.corner[h];
      set_start(connectivity_.ring_vertex[entry], geometry_.length[h], angle, polar[is_outgoing ? 1 : 0]);
    }
  }

  // The frame has the halfedge that the source is on, or any of the face, along its x axis.
  void start_in_face(const Indexed_location& location)
  {
    Index first = 3 * location.face;
    for(Index i = 0; i < 3; ++i)
      if(location.coordinates[(i + 2) % 3] == 0.)
        first = 3 * location.face + i;
    const bool is_on_edge = location.coordinates[Indexed_triangle_mesh::previous(first) % 3] == 0.;
    const Index opposite = mesh_.opposite[first];
    field_.is_cyclic = !is_on_edge || opposite != null_index;
    field_.total_angle = field_.is_cyclic ? 2. * pi() : pi();
    start_in_face(first, location.coordinates[Indexed_triangle_mesh::next(first) % 3],
                  location.coordinates[Indexed_triangle_mesh::previous(first) % 3], 0.);
    if(is_on_edge && opposite != null_index)
      start_in_face(opposite, 1. - location.coordinates[Indexed_triangle_mesh::next(first) % 3], 0., pi());
  }

  // the coordinates are those of the source for the target of `h` and the third vertex
  void start_in_face(Index h, double second, double third, double turn)
  {
    const double l = geometry_.length[h], r = geometry_.length[Indexed_triangle_mesh::previous(h)];
    const std::array<std::array<double, 2>, 3> p = {
      {{{0., 0.}}, {{l, 0.}}, {{r * std::cos(geometry_.corner[h]), r * std::sin(geometry_.corner[h])}}}};
    const double x = second * l + third * p[2][0], y = third * p[2][1];
    Index g = h;
    for(int i = 0; i < 3; ++i, g = Indexed_triangle_mesh::next(g))
    {
      const double dx = p[i][0] - x, dy = p[i][1] - y;
      double angle = turn + std::atan2(dy, dx);
      if(angle < 0. && field_.is_cyclic)
        angle += 2. * pi();
      const std::array<double, 2>& q = p[(i + 1) % 3];
      const double along = std::atan2(q[1] - p[i][1], q[0] - p[i][0]);
      double back = std::atan2(-dy, -dx) - along;
      if(back < -1e-6)
        back += 2. * pi();
      set_start(mesh_.source(g), std::sqrt(dx * dx + dy * dy), angle,
                geometry_.polar[g] + geometry_.scale[mesh_.source(g)] * back);
    }
  }

  void set_start(Index v, double straight, double direction, double arrival)
  {
    // a vertex of the face that a shorter path reaches from outside is none
    if(field_.vertices[v].distance < straight * (1. - 1e-6) || integration_.is_known(v))
      return;
    field_.vertices[v].direction = static_cast<float>(direction);
    field_.vertices[v].arrival = static_cast<float>(arrival);
    integration_.set_near(v);
  }

  void reach(Index v)
  {
    Arrival best;
    const Index begin = connectivity_.ring_begin[v], end = connectivity_.ring_begin[v + 1];
    for(Index entry = begin; entry < end; ++entry)
      if(mesh_.source(connectivity_.ring_halfedge[entry]) == v)
        reach_across(v, connectivity_.ring_halfedge[entry], best);
    // An exact distance is met by the path through one of the faces. Where none is, a path has bent at a saddle, or
    // comes along the cut locus: then the nearest neighbor tells more.
    constexpr double tolerance = 0.002;
    if(best.mismatch > tolerance * geometry_.mean_edge_length)
      for(Index entry = begin; entry < end; ++entry)
        reach_sideways(v, entry, tolerance, best);

    Direction_field::Vertex& vertex = field_.vertices[v];
    if(best.a == null_index)
    {
      integration_.set_near(v); // an isolated minimum: the distances are none
      return;
    }
    if(field_.is_cyclic)
    {
      best.direction = std::fmod(best.direction, field_.total_angle);
      if(best.direction < 0.)
        best.direction += field_.total_angle;
    }
    vertex.direction = static_cast<float>(best.direction);
    vertex.arrival = static_cast<float>(best.arrival);
    if(best.b != null_index)
      integration_.step_across(v, best.a, best.b, best.part, best.length, best.rest);
    else
      integration_.step_along(v, best.a);
  }

  // the path to `v` through its face on the side of `h`, in a frame with the opposite edge along the x axis
  void reach_across(Index v, Index h, Arrival& best) const
  {
    const Index base = Indexed_triangle_mesh::next(h);
    const Index a = mesh_.source(base), b = mesh_.target(base);
    if(!integration_.is_known(a) || !integration_.is_known(b))
      return;
    const Direction_field::Vertex &va = field_.vertices[a], &vb = field_.vertices[b];
    const double l = geometry_.length[base];
    if(!integration_.are_neighbors(va, vb.direction, l) || !integration_.are_neighbors(vb, va.direction, l))
      return;
    const double da = va.distance, db = vb.distance;
    const double x = (da * da - db * db + l * l) / (2. * l);
    const double y = std::sqrt((std::max)(da * da - x * x, 0.)); // the source is at (x, -y)
    const double vx = geometry_.length[h] * std::cos(geometry_.corner[base]);
    const double vy = geometry_.length[h] * std::sin(geometry_.corner[base]);
    const double dx = vx - x, dy = vy + y;
    const double part = y / dy, t = (x + part * dx) / l;
    if(!(t >= -1e-9 && t <= 1. + 1e-9))
      return;
    const double predicted = std::sqrt(dx * dx + dy * dy);
    const double mismatch = std::fabs(predicted - field_.vertices[v].distance);
    if(!(mismatch < best.mismatch))
      return;
    best.mismatch = mismatch;
    best.a = a;
    best.b = b;
    best.length = l;
    best.part = (std::min)((std::max)(t, 0.), 1.);
    best.rest = (1. - part) * predicted;
    const auto angle_between = [](double ux, double uy, double wx, double wy)
    { return std::atan2(ux * wy - uy * wx, ux * wx + uy * wy); };
    const double whole = angle_between(l - x, y, -x, y), first = angle_between(dx, dy, -x, y);
    const double fraction = whole > 1e-9 ? (std::min)((std::max)(first / whole, 0.), 1.) : best.part;
    best.direction = va.direction + fraction * field_.turn(va.direction, vb.direction);
    best.arrival = geometry_.polar[h] + geometry_.scale[v] * angle_between(-vx, -vy, -dx, -dy);
  }

  // the path to the neighbor in the ring of `v`, moved sideways
  void reach_sideways(Index v, Index entry, double penalty, Arrival& best) const
  {
    const Index u = connectivity_.ring_vertex[entry];
    if(!integration_.is_known(u) || field_.vertices[u].distance == 0.)
      return;
    const Direction_field::Vertex& vu = field_.vertices[u];
    const Index h = connectivity_.ring_halfedge[entry];
    const std::array<float, 2> polar = geometry_.polar_at_ends(mesh_, h);
    const bool is_outgoing = mesh_.source(h) == v;
    const double polar_u = polar[is_outgoing ? 1 : 0], polar_v = polar[is_outgoing ? 0 : 1];
    const double l = geometry_.length[h], bend = field_.bend(u, geometry_.mean_edge_length);
    const double back = (vu.arrival - polar_u) / geometry_.scale[u];
    const double cosine = -std::cos(back), sine = -std::sin(back); // of the path, against the edge from u to v
    const double predicted = vu.distance + l * cosine + 0.5 * bend * l * l * sine * sine;
    const double mismatch = std::fabs(predicted - field_.vertices[v].distance) + penalty * l;
    if(!(mismatch < best.mismatch))
      return;
    best = Arrival();
    best.mismatch = mismatch;
    best.a = u;
    best.direction = vu.direction - l * sine / (std::max)(double(vu.spread), 0.1 * l);
    // the gradient there, of the distance with a front that bends
    const double across = l * sine, gx = cosine + bend * across * sine, gy = sine - bend * across * cosine;
    best.arrival = polar_v + geometry_.scale[v] * std::atan2(gy, gx);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Direction_geometry& geometry_;
  Direction_field field_;
  Spread_integration integration_;
};

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * computes the field from exact distances alone, in one pass: the distances to two neighbors place the source in the
 * plane of the face behind them, as long as their paths leave the source side by side. Linear time.
 */
inline Direction_field direction_field(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                       const Direction_geometry& geometry, const Indexed_source& source,
                                       const std::vector<double>& distance)
{
  return internal::Direction_transport(mesh, connectivity, geometry, source, distance).take();
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_DIRECTION_TRANSPORT_H
