// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_EXACT_DESCENT_H
#define CGAL_CUT_LOCI_LAPLACIAN_EXACT_DESCENT_H

#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Where the shortest paths lead that the exact solver has found, one step at a time.
//
// Distances alone do not tell that across edges that are long for what happens along them: at the ends of the edges of
// a slim fan, the distance may be that by other paths.
class Exact_descent
{
public:
  // The way to a point of a halfedge `h`, and on towards the image of where the straight piece starts; or to a vertex.
  struct Way
  {
    Index halfedge = null_index;
    double place = 0.;          // from the source of `halfedge` on, as a part
    Index vertex = null_index;  // if it leads there
    Planar_vector image{};      // in the frame of the opposite of `halfedge`
    double image_distance = 0.; // its own, 0 for the source

    bool exists() const { return halfedge != null_index || vertex != null_index; }
  };

  Exact_descent(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                const Geodesic_results& geodesics)
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics)
  {
  }

  // From vertex `v` across the opposite edge of a face, or to a neighbor. No way if neither is the case, as where the
  // source is in a face of `v`.
  Way leave(Index v) const
  {
    const Geodesic_arrival& arrival = geodesics_.arrival(v);
    Way result;
    result.image_distance = arrival.sigma;
    if(!arrival.crosses_halfedge)
    {
      result.vertex = neighbor_on_path(v, arrival.sigma);
      return result;
    }
    const Index h = arrival.halfedge;
    const Planar_vector p = apex(mesh_, h);
    if(v == mesh_.source(h) || v == mesh_.target(h) || !(arrival.y < p[1]))
      return Way();
    const double length = edge_length(mesh_, h);
    result.halfedge = h;
    result.place = (p[0] + (arrival.x - p[0]) * p[1] / (p[1] - arrival.y)) / length;
    result.image = {{length - arrival.x, -arrival.y}};
    stop_at_end({{length, 0.}}, {{0., 0.}}, result.image, result);
    return result;
  }

  // From the end of `way` through the next face.
  Way across(const Way& way) const
  {
    const Index o = mesh_.opposite[way.halfedge];
    const Planar_vector target = {{edge_length(mesh_, o), 0.}}, top = apex(mesh_, o), origin = {{0., 0.}};
    Way result;
    result.image_distance = way.image_distance;
    result.vertex = corner_at_image(o, {{origin, target, top}}, way);
    if(result.vertex != null_index)
      return result;
    const Planar_vector p = {{(1. - way.place) * target[0], 0.}}, on = way.image - p;
    const bool is_right = cross(on, top - p) > 0.;
    const Index h = is_right ? mesh_.next(o) : mesh_.previous(o);
    const Planar_vector a = is_right ? target : top, b = is_right ? top : origin;
    const double below = cross(a - p, on), above = cross(on, b - p);
    result.place = (std::min)(1., (std::max)(0., below / (below + above)));
    // A border is in the way, or the image is in the face and no corner of it: rounding.
    if(!(on[1] > 0.) || mesh_.is_border_edge(h) || !(norm(a + result.place * (b - a) - p) < norm(on)))
      return Way();
    result.halfedge = h;
    const Planar_vector unit = (1. / norm(a - b)) * (a - b), from_b = way.image - b;
    result.image = {{dot(unit, from_b), cross(unit, from_b)}};
    stop_at_end(a, b, way.image, result);
    return result;
  }

private:
  // what thin faces make of rounding errors, as in the tracing of paths
  static constexpr double tolerance = 1e-8;

  static bool is_close(double x, double y) { return std::abs(x - y) <= tolerance * (std::abs(x) + std::abs(y)); }

  Index neighbor_on_path(Index v, double its_distance) const
  {
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
    {
      const Index w = connectivity_.ring_vertex[k];
      const double length = edge_length(mesh_, connectivity_.ring_halfedge[k]);
      if(its_distance > 0. && is_close(geodesics_.distance(w), its_distance) &&
         is_close(its_distance + length, geodesics_.distance(v)))
        return w;
    }
    return null_index;
  }

  Index corner_at_image(Index o, const std::array<Planar_vector, 3>& corner, const Way& way) const
  {
    const double scale = norm(corner[1]) + norm(corner[2]);
    const std::array<Index, 3> vertex = {{mesh_.source(o), mesh_.target(o), mesh_.source(mesh_.previous(o))}};
    for(int i = 0; i < 3 && way.image_distance > 0.; ++i)
      if(is_close(geodesics_.distance(vertex[i]), way.image_distance) &&
         norm(corner[i] - way.image) <= tolerance * scale)
        return vertex[i];
    return null_index;
  }

  // A path may pass through vertices, from each of which another one leads on.
  void stop_at_end(const Planar_vector& a, const Planar_vector& b, const Planar_vector& image, Way& way) const
  {
    const bool is_source = way.place < tolerance;
    if(!is_source && !(way.place > 1. - tolerance))
      return;
    const Index w = is_source ? mesh_.source(way.halfedge) : mesh_.target(way.halfedge);
    if(is_close(way.image_distance + norm((is_source ? a : b) - image), geodesics_.distance(w)))
      way.vertex = w;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Geodesic_results& geodesics_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_EXACT_DESCENT_H
