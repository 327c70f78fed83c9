// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_PATH_TRACING_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_PATH_TRACING_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * traces shortest paths back to their sources.
 *
 * Each straight piece of a path is followed from its end to the image of its (pseudo-)source, which is unfolded into
 * one face after the other, until it coincides with the source itself.
 */
class Geodesic_path_tracing
{
public:
  explicit Geodesic_path_tracing(const Exact_geodesic_propagation& geodesics)
    : geodesics_(geodesics), faces_(geodesics.faces())
  {
  }

  /// the last straight piece of the shortest path to `v`, from there to the vertex `begin`, to a source in a face, or to the
  /// first face edge nearer than a distance; valid until the next call
  /// \pre `v` is reached and no source
  const std::vector<Indexed_location>& last_piece(Index v, double least_distance, Index& begin)
  {
    path_.clear();
    add(at_vertex(v));
    const Geodesic_arrival& arrival = geodesics_.arrival(v);
    distance_ = geodesics_.distance(v);
    begin = trace_piece(arrival, geodesics_.end_in_frame(arrival, v), least_distance);
    return path_;
  }

  /// the shortest path from a vertex or a query location to its source, empty if it is not reached
  std::vector<Indexed_location> path_from_query(const Geodesic_query& query)
  {
    path_.clear();
    if(!(query.distance < (std::numeric_limits<double>::infinity)()))
      return path_;
    add(classify(query.location));
    distance_ = query.distance;
    const Index root = trace_piece(query.arrival, faces_.in_frame(query.arrival.halfedge, query.location.coordinates));
    if(root != null_index)
      trace_from_vertex(root);
    return path_;
  }

private:
  using Mesh = Indexed_triangle_mesh;

  /// a location with the vertex or the halfedge it is on, to recognize a point in other coordinates
  struct Place
  {
    Indexed_location location;
    Index vertex, halfedge;
    double t; // position on the halfedge, from 0 to 1
  };

  /// where a straight piece may end: a vertex, or null for a source in a face
  struct Root
  {
    Index vertex;
    double offset;      // from the image
    std::size_t length; // of the path that leads there
  };

  Place at_vertex(Index v) const { return {geodesics_.vertex_location(v), v, null_index, 0.}; }

  Place on_halfedge(Index h, double t) const
  {
    if(t < geodesic_cover)
      return at_vertex(faces_.source(h));
    if(t > 1. - geodesic_cover)
      return at_vertex(faces_.target(h));
    Place place;
    place.location = location_on(h, t);
    const Index o = faces_.opposite(h);
    place.vertex = null_index;
    place.halfedge = h < o ? h : o;
    place.t = h < o ? t : 1. - t;
    return place;
  }

  Place classify(const Indexed_location& location) const
  {
    const std::array<double, 3>& c = location.coordinates;
    for(Index i = 0; i < 3; ++i)
      if(c[i] < geodesic_cover)
      {
        const Index h = Mesh::next(3 * location.face + i);
        const Place place = on_halfedge(h, c[Mesh::next(h) % 3]);
        if(place.vertex != null_index)
          return place;
        return {location, null_index, place.halfedge, place.t};
      }
    return {location, null_index, null_index, 0.};
  }

  static bool is_same(const Place& p, const Place& q)
  {
    if(p.vertex != null_index || q.vertex != null_index)
      return p.vertex == q.vertex;
    if(p.halfedge != null_index || q.halfedge != null_index)
      return p.halfedge == q.halfedge && std::fabs(p.t - q.t) < geodesic_cover;
    if(p.location.face != q.location.face)
      return false;
    double difference = 0.;
    for(std::size_t i = 0; i < 3; ++i)
      difference = (std::max)(difference, std::fabs(p.location.coordinates[i] - q.location.coordinates[i]));
    return difference < geodesic_cover;
  }

  void add(const Place& place)
  {
    if(!path_.empty() && is_same(last_, place))
      return;
    path_.push_back(place.location);
    last_ = place;
  }

  void trace_from_vertex(Index v)
  {
    while(v != null_index && geodesics_.distance(v) > 0.)
    {
      const Geodesic_arrival& arrival = geodesics_.arrival(v);
      distance_ = geodesics_.distance(v);
      v = trace_piece(arrival, geodesics_.end_in_frame(arrival, v));
    }
  }

  /// adds a straight piece, and returns the vertex at which it starts, or null if that is a source, or nearer than a distance
  Index trace_piece(const Geodesic_arrival& arrival, Plane_point p, double least_distance = 0.)
  {
    Plane_point image{arrival.x, arrival.y};
    Index h = arrival.halfedge;
    root_ = {null_index, (std::numeric_limits<double>::infinity)(), path_.size()};
    if(!arrival.crosses_halfedge)
      look_for_root(arrival, h, image);
    // a shortest path meets each face at most once
    for(Index step = 0; arrival.crosses_halfedge && step <= faces_.number_of_faces(); ++step)
    {
      const double length = faces_.length(h);
      const double t = image.y < p.y ? p.x + (image.x - p.x) * p.y / (p.y - image.y) : image.x;
      add(on_halfedge(h, t / length));
      if(leads_through_last_vertex(arrival, image, p, h))
        return last_.vertex;
      if(arrival.sigma + std::hypot(image.x - t, image.y) < least_distance)
        return null_index;
      const Index g = faces_.opposite(h);
      if(g == null_index && geodesics_.is_line(arrival.origin))
        return null_index; // on the line itself
      if(g == null_index)
        break;
      p = {length - p.x, -p.y};
      image = {length - image.x, -image.y};
      if(look_for_root(arrival, g, image))
        break;
      const Plane_point apex = faces_.apex(g);
      const bool apex_is_left = (image.x - p.x) * (apex.y - p.y) > (image.y - p.y) * (apex.x - p.x);
      if(apex_is_left)
      {
        h = Mesh::next(g);
        const Plane_point corner{length, 0.};
        p = change_frame(p, corner, apex, faces_.length(h));
        image = change_frame(image, corner, apex, faces_.length(h));
      }
      else
      {
        h = Mesh::previous(g);
        const Plane_point corner{0., 0.};
        p = change_frame(p, apex, corner, faces_.length(h));
        image = change_frame(image, apex, corner, faces_.length(h));
      }
      if(image.y >= 0.)
        break; // the image is in the face
    }
    path_.resize(root_.length);
    if(root_.vertex != null_index && arrival.sigma > 0.)
    {
      add(at_vertex(root_.vertex));
      return root_.vertex;
    }
    add(classify(geodesics_.source_location(geodesics_.source_of(arrival))));
    return null_index;
  }

  /// whether the rest of a path is the shortest path from the vertex of `h` at which it has just arrived
  bool leads_through_last_vertex(const Geodesic_arrival& arrival, const Plane_point& image, const Plane_point& end,
                                 Index h) const
  {
    const Index v = last_.vertex;
    if(v == null_index || !(geodesics_.distance(v) > 0.) || !(geodesics_.distance(v) < distance_))
      return false;
    const Plane_point p = geodesics_.vertex_in_frame(h, v);
    const double d = geodesics_.is_line(arrival.origin) ? distance_ - std::hypot(p.x - end.x, p.y - end.y)
                                                        : arrival.sigma + std::hypot(p.x - image.x, p.y - image.y);
    return std::fabs(geodesics_.distance(v) - d) <= geodesic_cover * d;
  }

  /// remembers the point of the face of `h` that fits the image best; returns whether it fits
  bool look_for_root(const Geodesic_arrival& arrival, Index h, const Plane_point& image)
  {
    if(geodesics_.is_line(arrival.origin))
      return false; // which ends at the border
    const double scale = faces_.length(h) + faces_.length(Mesh::next(h));
    if(arrival.sigma == 0.)
    {
      Plane_point p;
      if(!geodesics_.source_in_frame(geodesics_.source_of(arrival), h, p))
        return false;
      return consider(p, image, null_index, scale);
    }
    for(Index i = 0; i < 3; ++i)
    {
      const Index g = 3 * (h / 3) + i, v = faces_.source(g);
      if(std::fabs(geodesics_.distance(v) - arrival.sigma) > 1e-9 * arrival.sigma)
        continue;
      if(consider(geodesics_.vertex_in_frame(h, v), image, v, scale))
        return true;
    }
    return false;
  }

  bool consider(const Plane_point& p, const Plane_point& image, Index v, double scale)
  {
    const double offset = std::hypot(p.x - image.x, p.y - image.y);
    if(offset < root_.offset)
      root_ = {v, offset, path_.size()};
    // unfolding adds rounding errors, which thin faces enlarge; another vertex at this distance would be as good an end
    return offset <= 1e-8 * scale;
  }

  const Exact_geodesic_propagation& geodesics_;
  const Geodesic_faces& faces_;
  std::vector<Indexed_location> path_;
  Place last_;
  double distance_ = 0.; // of the end of the piece
  Root root_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_PATH_TRACING_H
