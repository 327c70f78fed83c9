// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_GEODESIC_FRONTS_H
#define CGAL_CUT_LOCI_INTERNAL_GEODESIC_FRONTS_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_field.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The distance near a vertex, along the paths of one side of the cut locus: to second order, with the bend of the
// front. Faces are laid out in the plane with the first halfedge on the x axis.
class Geodesic_fronts
{
public:
  using Point_2 = std::array<double, 2>;
  using Face_points = std::array<Point_2, 3>;

  struct Front
  {
    Point_2 origin = {{0., 0.}};
    Point_2 ahead = {{1., 0.}}; // the direction of the path
    double distance = 0., bend = 0.;

    double operator()(const Point_2& p) const
    {
      const double x = p[0] - origin[0], y = p[1] - origin[1];
      const double across = x * ahead[1] - y * ahead[0];
      return distance + x * ahead[0] + y * ahead[1] + 0.5 * bend * across * across;
    }

    Point_2 gradient(const Point_2& p) const
    {
      const double across = (p[0] - origin[0]) * ahead[1] - (p[1] - origin[1]) * ahead[0];
      return {{ahead[0] + bend * across * ahead[1], ahead[1] - bend * across * ahead[0]}};
    }
  };

  struct Crossing
  {
    Index halfedge; // of the edge
    double part;    // 0 at its source, 1 at its target
    double distance;
  };

  Geodesic_fronts(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                  const Direction_geometry& geometry, const Direction_field& field)
    : mesh_(mesh), connectivity_(connectivity), geometry_(geometry), field_(field)
  {
  }

  // where the fronts of the two ends of an edge meet
  Crossing crossing(Index e) const
  {
    const Index h = connectivity_.halfedge_of_edge[e];
    const Index a = mesh_.source(h), b = mesh_.target(h);
    const double l = geometry_.length[h];
    const std::array<float, 2> polar = geometry_.polar_at_ends(mesh_, h);
    const Front fa = edge_front(a, polar[0]), fb = edge_front(b, polar[1]);
    // the difference of the two, a quadratic in the distance s from a: negative at a and positive at b
    const double ka = 0.5 * fa.bend * fa.ahead[1] * fa.ahead[1], kb = 0.5 * fb.bend * fb.ahead[1] * fb.ahead[1];
    const double c2 = ka - kb, c1 = fa.ahead[0] + fb.ahead[0] + 2. * kb * l;
    const double c0 = fa.distance - fb.distance - fb.ahead[0] * l - kb * l * l;
    const auto f = [&](double s) { return c0 + s * (c1 + s * c2); };
    constexpr double margin = 1e-3; // keeps the nodes of the result apart
    double low = margin * l, high = (1. - margin) * l;
    if(f(low) >= 0.)
      high = low;
    else if(f(high) <= 0.)
      low = high;
    for(int i = 0; i < 60 && high - low > 1e-12 * l; ++i)
    {
      // regula falsi and bisection by turns
      const double fl = f(low), fh = f(high);
      const double s = i % 2 == 0 ? low - fl * (high - low) / (fh - fl) : 0.5 * (low + high);
      (f(s) <= 0. ? low : high) = s;
    }
    const double s = 0.5 * (low + high);
    const double da = fa.distance + s * fa.ahead[0] + ka * s * s;
    const double db = fb.distance + (l - s) * fb.ahead[0] + kb * (l - s) * (l - s);
    return {h, s / l, 0.5 * (da + db)};
  }

  Face_points layout(Index f) const
  {
    const Index h = 3 * f;
    const double l = geometry_.length[h], r = geometry_.length[h + 2], angle = geometry_.corner[h];
    return {{{{0., 0.}}, {{l, 0.}}, {{r * std::cos(angle), r * std::sin(angle)}}}};
  }

  // the front of vertex `i` of face `f`
  Front front(Index f, Index i, const Face_points& points) const
  {
    const Index v = mesh_.triangles[f][i];
    const Point_2 &p = points[i], &q = points[(i + 1) % 3];
    const double angle = std::atan2(q[1] - p[1], q[0] - p[0]) +
                         (field_.vertices[v].arrival - geometry_.polar[3 * f + i]) / geometry_.scale[v];
    Front result;
    result.origin = p;
    result.ahead = {{-std::cos(angle), -std::sin(angle)}};
    result.distance = field_.vertices[v].distance;
    result.bend = field_.bend(v, geometry_.mean_edge_length);
    return result;
  }

  // where the three fronts of a face meet, near the point `start` of it
  Point_2 triple_point(Index f, const Point_2& start) const
  {
    const Face_points points = layout(f);
    const std::array<Front, 3> fronts = {{front(f, 0, points), front(f, 1, points), front(f, 2, points)}};
    Point_2 p = start;
    for(int i = 0; i < 20; ++i)
    {
      const Point_2 g0 = fronts[0].gradient(p), g1 = fronts[1].gradient(p), g2 = fronts[2].gradient(p);
      const double a = g1[0] - g0[0], b = g1[1] - g0[1], c = g2[0] - g0[0], d = g2[1] - g0[1];
      const double u = fronts[0](p) - fronts[1](p), w = fronts[0](p) - fronts[2](p);
      const double determinant = a * d - b * c;
      if(!(std::fabs(determinant) > 1e-9))
        return start;
      const Point_2 step = {{(u * d - w * b) / determinant, (w * a - u * c) / determinant}};
      p = {{p[0] + step[0], p[1] + step[1]}};
      if(step[0] * step[0] + step[1] * step[1] < 1e-24 * geometry_.length[3 * f] * geometry_.length[3 * f])
        break;
    }
    const std::array<double, 3> c = coordinates(points, p);
    return *std::min_element(c.begin(), c.end()) > 1e-3 ? p : start;
  }

  static std::array<double, 3> coordinates(const Face_points& t, const Point_2& p)
  {
    const auto cross = [](const Point_2& a, const Point_2& b, const Point_2& c)
    { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
    const double area = cross(t[0], t[1], t[2]);
    return {{cross(p, t[1], t[2]) / area, cross(t[0], p, t[2]) / area, cross(t[0], t[1], p) / area}};
  }

  static Point_2 point(const Face_points& t, const std::array<double, 3>& c)
  {
    return {{c[0] * t[0][0] + c[1] * t[1][0] + c[2] * t[2][0], c[0] * t[0][1] + c[1] * t[1][1] + c[2] * t[2][1]}};
  }

  Indexed_location location(const Crossing& c) const
  {
    Indexed_location result;
    result.face = c.halfedge / 3;
    result.coordinates[c.halfedge % 3] = 1. - c.part;
    result.coordinates[(c.halfedge + 1) % 3] = c.part;
    return result;
  }

  // the coordinates of a crossing in a face at its edge
  std::array<double, 3> coordinates(const Crossing& c, Index f) const
  {
    std::array<double, 3> result = {{0., 0., 0.}};
    const bool is_inside = c.halfedge / 3 == f;
    const Index h = is_inside ? c.halfedge : mesh_.opposite[c.halfedge];
    const double part = is_inside ? c.part : 1. - c.part;
    result[h % 3] = 1. - part;
    result[Indexed_triangle_mesh::next(h) % 3] = part;
    return result;
  }

private:
  // in a frame with the vertex at the origin and the edge along the x axis
  Front edge_front(Index v, float polar) const
  {
    const double angle = (field_.vertices[v].arrival - polar) / geometry_.scale[v];
    Front result;
    result.ahead = {{-std::cos(angle), -std::sin(angle)}};
    result.distance = field_.vertices[v].distance;
    result.bend = field_.bend(v, geometry_.mean_edge_length);
    return result;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Direction_geometry& geometry_;
  const Direction_field& field_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_GEODESIC_FRONTS_H
