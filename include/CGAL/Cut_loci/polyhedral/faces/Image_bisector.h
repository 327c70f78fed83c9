// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_IMAGE_BISECTOR_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_IMAGE_BISECTOR_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is the image of a source, or of a vertex at which paths bend, in the plane of a face.
struct Image
{
  double x, y, sigma; // `sigma` is the distance of what it is the image of
  Index origin;
  double direction;    // in which a path to some point of the boundary leaves the origin
  double rate = 1.;    // by which that turns with the path
  Index corner = 0;    // of the face: that point,
  bool is_edge = true; // or the middle of the edge that starts there

  Plane_point place() const { return {x, y}; }
  double distance(const Plane_point& p) const
  {
    return sigma + std::sqrt((p.x - x) * (p.x - x) + (p.y - y) * (p.y - y));
  }

  /// The direction in which the path to a point of the face leaves the origin. An image is not inside of the face, unless the
  /// source is: what it sees of the face is less than half a turn.
  double direction_to(const Plane_point& p, const Face_corners& corners) const
  {
    const Plane_point &from = corners[corner], &to = corners[corner == 2 ? 0 : corner + 1];
    const Plane_point known = is_edge ? between(from, to, 0.5) : from;
    const double ux = known.x - x, uy = known.y - y, vx = p.x - x, vy = p.y - y;
    const double cross = ux * vy - uy * vx;
    return direction + rate * std::copysign(upper_angle(ux * vx + uy * vy, std::fabs(cross)), cross);
  }
};

/// the angle at which the paths from two images to a point meet, and where they part
inline double meeting_angle(const Image& a, const Image& b, const Plane_point& p)
{
  return angle_between(a.x - p.x, a.y - p.y, b.x - p.x, b.y - p.y);
}
inline Parting_angle::Parting parting(const Geodesic_results& geodesics, const Image& a, const Image& b,
                                      const Plane_point& p, const Face_corners& corners)
{
  return Parting_angle(geodesics).parting(a.origin, a.direction_to(p, corners), b.origin, b.direction_to(p, corners),
                                          meeting_angle(a, b, p));
}

inline bool is_same_image(const Image& a, const Image& b)
{
  const double scale = std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.sigma);
  return a.origin == b.origin && std::fabs(a.x - b.x) + std::fabs(a.y - b.y) <= 1e-9 * scale;
}

/// the points at the same distance from three images, in which three pieces of the cut locus meet; up to two
inline std::size_t equidistant_points(const Image& a, const Image& b, const Image& c,
                                      std::array<Plane_point, 2>& points)
{
  // the image of a line, far behind it, would take digits from the others
  if(b.sigma < 0. && a.sigma >= 0.)
    return equidistant_points(b, a, c, points);
  if(b.sigma < 0. && c.sigma >= 0.)
    return equidistant_points(a, c, b, points);
  // With `b` as the origin, and the distance rho from it as the third coordinate, two of the three equations are linear.
  // Their line is computed from its direction: images that are on one line, as the vertices of a straight edge are, leave
  // neither the point as a function of rho nor any other coordinate that could be taken for a parameter.
  const double ax = a.x - b.x, ay = a.y - b.y, az = b.sigma - a.sigma;
  const double cx = c.x - b.x, cy = c.y - b.y, cz = b.sigma - c.sigma;
  const double ak = 0.5 * (ax * ax + ay * ay - az * az), ck = 0.5 * (cx * cx + cy * cy - cz * cz);
  const double wx = ay * cz - az * cy, wy = az * cx - ax * cz, wz = ax * cy - ay * cx;
  const double ww = wx * wx + wy * wy + wz * wz;
  if(ww == 0.)
    return 0;
  // the point of the line nearest to the origin
  const double ux = (ak * (cy * wz - cz * wy) + ck * (wy * az - wz * ay)) / ww;
  const double uy = (ak * (cz * wx - cx * wz) + ck * (wz * ax - wx * az)) / ww;
  const double uz = (ak * (cx * wy - cy * wx) + ck * (wx * ay - wy * ax)) / ww;
  const double k2 = wx * wx + wy * wy - wz * wz, k1 = ux * wx + uy * wy - uz * wz, k0 = ux * ux + uy * uy - uz * uz;
  const double discriminant = k1 * k1 - k2 * k0;
  if(!(discriminant >= 0.))
    return 0;
  const double q = -(k1 + (k1 < 0. ? -1. : 1.) * std::sqrt(discriminant));
  std::size_t n = 0;
  for(const double t : {q / k2, k0 / q})
  {
    const double rho = uz + t * wz;
    if(rho >= 0. && rho + b.sigma >= a.sigma && rho + b.sigma >= c.sigma && rho < 1e300)
      points[n++] = {b.x + ux + t * wx, b.y + uy + t * wy};
  }
  return n;
}

/// the points of the line through `p` and `q` at the same distance from two images; up to two
inline std::size_t equidistant_points(const Plane_point& p, const Plane_point& q, const Image& a, const Image& b,
                                      std::array<Plane_point, 2>& points)
{
  const double l = std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
  if(!(l > 0.))
    return 0;
  const double dx = (q.x - p.x) / l, dy = (q.y - p.y) / l;
  // the images from `p`; the distance r from `a` and the way s along the line: r^2 = s^2 - 2 s a + |a|^2
  const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y, k = a.sigma - b.sigma;
  const double pa = ax * dx + ay * dy, pb = bx * dx + by * dy;
  const double na = ax * ax + ay * ay, nb = bx * bx + by * by;
  if(a.sigma < 0. && b.sigma >= 0.) // as for three
    return equidistant_points(p, q, b, a, points);
  // (r + k)^2 = s^2 - 2 s b + |b|^2, so that 2 k r = e - 2 m s
  const double m = pb - pa, e = nb - na - k * k;
  if(k == 0.)
  {
    if(m == 0.)
      return 0;
    const double s = 0.5 * e / m;
    points[0] = {p.x + s * dx, p.y + s * dy};
    return 1;
  }
  const double k2 = m * m - k * k, k1 = k * k * pa - 0.5 * m * e, k0 = 0.25 * e * e - k * k * na;
  const double discriminant = k1 * k1 - k2 * k0;
  if(!(discriminant >= 0.))
    return 0;
  const double root = -(k1 + (k1 < 0. ? -1. : 1.) * std::sqrt(discriminant));
  std::size_t n = 0;
  for(const double s : {root / k2, k0 / root})
    if((e - 2. * m * s) * k >= 0. && std::fabs(s) < 1e300)
      points[n++] = {p.x + s * dx, p.y + s * dy};
  return n;
}

/// appends points of the hyperbola between two images, from `p` to `q` and without these, so that chords leave it by at
/// most `tolerance`
///
/// The ends are on it up to rounding, which moves it the farther the smaller the angle is at which the paths meet: by more
/// than they are away from the boundary of the face, maybe. So the points have what the ends have by which the paths
/// differ, in parts.
inline void sample_bisector(const Image& a, const Image& b, const Plane_point& p, const Plane_point& q,
                            double tolerance, std::vector<Plane_point>& points, int depth = 0)
{
  constexpr int most = 10; // a thousand points
  if(a.sigma == b.sigma || depth == most)
    return;
  Image c = a;
  c.sigma -= 0.5 * (a.distance(p) - b.distance(p) + a.distance(q) - b.distance(q));
  const Plane_point middle{0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
  const Plane_point beside{middle.x - (q.y - p.y), middle.y + (q.x - p.x)};
  std::array<Plane_point, 2> candidates;
  const std::size_t n = equidistant_points(middle, beside, c, b, candidates);
  double least = 0.5 * std::hypot(q.x - p.x, q.y - p.y); // a branch of a hyperbola bends by less than a right angle
  std::size_t best = n;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double sagitta = std::hypot(candidates[i].x - middle.x, candidates[i].y - middle.y);
    if(sagitta < least)
    {
      least = sagitta;
      best = i;
    }
  }
  if(best == n || least <= tolerance)
    return;
  const Plane_point point = candidates[best];
  sample_bisector(a, b, p, point, tolerance, points, depth + 1);
  points.push_back(point);
  sample_bisector(a, b, point, q, tolerance, points, depth + 1);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_IMAGE_BISECTOR_H
