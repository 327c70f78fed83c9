// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_FACES_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_FACES_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Cut_loci::internal {

constexpr double geodesic_pi = 3.14159265358979323846;

/// is a point or a vector of the plane into which faces are unfolded.
struct Plane_point
{
  double x, y;
};

/// a point in the frame that begins at `from` and has its x-axis towards `to`, which is `length` away
inline Plane_point change_frame(const Plane_point& p, const Plane_point& from, const Plane_point& to, double length)
{
  const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  const double dx = p.x - from.x, dy = p.y - from.y;
  return {dx * ux + dy * uy, dy * ux - dx * uy};
}

/// twice the arc tangent of `y / x`, where `0 <= y <= x` and `x > 0`, within two roundings
///
/// It has no branches and needs half the time of `std::atan2`. The series is a polynomial interpolated in Chebyshev
/// points, in the square of the tangent for angles up to 45 degrees, and off by less than 2e-18 of the result there.
inline double twice_arc_tangent(double y, double x)
{
  constexpr double tangent_of_eighth = 0.41421356237309503; // of pi / 8; beyond, the angle is measured from pi / 4
  const double is_large = y > tangent_of_eighth * x ? 1. : 0.;
  const double t = (y - is_large * x) / (x + is_large * y), u = t * t;
  constexpr std::array<double, 12> c = {{1.0, -0.3333333333333312, 0.19999999999940893, -0.14285714279250245,
                                         0.11111110744919658, -0.09090896809064027, 0.07692045330902225,
                                         -0.06662951813629191, 0.05846878297330872, -0.05035102456601552,
                                         0.03796525745386593, -0.017805397205419446}};
  double sum = c[11];
  for(std::size_t i = 11; i-- > 0;)
    sum = sum * u + c[i];
  return is_large * (0.5 * geodesic_pi) + 2. * t * sum;
}

/// is all that unfolding a face needs, in two cache lines: corner `i` is at vertex `i`, where edge `i` starts.
struct alignas(64) Geodesic_face
{
  struct Corner
  {
    double length; // of the edge that starts at the corner
    double cosine, sine, angle;
  };

  std::array<Index, 3> vertex;
  std::array<Index, 3> opposite;
  std::array<Corner, 3> corner;
};

/// is a direction at a vertex: an angle from a halfedge that leaves it, counterclockwise, in the face of the halfedge.
struct Geodesic_direction
{
  Index halfedge;
  double angle;
};

/*!
 * holds the intrinsic geometry of a triangle mesh, read once.
 *
 * The frame of a halfedge has its origin at the source of the halfedge, its x-axis along it and its face at `y > 0`.
 */
class Geodesic_faces
{
public:
  using Mesh = Indexed_triangle_mesh;

  /// \throws Invalid_input if a coordinate is not finite, a face has no area, or a vertex has more than one fan; faces of
  /// given lengths must have some
  explicit Geodesic_faces(const Mesh& mesh, const std::vector<Index>* positions = nullptr,
                          const Progress& progress = {})
    : total_angle_(mesh.number_of_vertices(), 0.), first_(mesh.number_of_vertices(), null_index),
      kind_(mesh.number_of_vertices(), 0)
  {
    read_faces(mesh, positions, progress.part(0., 0.8));
    read_vertices(positions, progress.part(0.8, 1.));
  }

  Index number_of_faces() const { return static_cast<Index>(faces_.size()); }
  Index number_of_halfedges() const { return static_cast<Index>(3 * faces_.size()); }
  Index number_of_vertices() const { return static_cast<Index>(first_.size()); }

  const Geodesic_face& face(Index f) const { return faces_[f]; }
  const Geodesic_face& face_of(Index h) const { return faces_[h / 3]; }

  Index source(Index h) const { return faces_[h / 3].vertex[h % 3]; }
  Index target(Index h) const { return source(Mesh::next(h)); }
  Index opposite(Index h) const { return faces_[h / 3].opposite[h % 3]; }
  double length(Index h) const { return faces_[h / 3].corner[h % 3].length; }
  /// the angle of the face of `h` at the source of `h`
  double angle(Index h) const { return faces_[h / 3].corner[h % 3].angle; }

  /// the third vertex of the face, in the frame of `h`
  Plane_point apex(Index h) const
  {
    const Geodesic_face::Corner& corner = faces_[h / 3].corner[h % 3];
    const double reach = length(Mesh::previous(h));
    return {reach * corner.cosine, reach * corner.sine};
  }

  /// a location of the face of `h` in the frame of `h`
  Plane_point in_frame(Index h, const std::array<double, 3>& coordinates) const
  {
    const Index i = h % 3;
    const Plane_point c = apex(h);
    const double second = coordinates[(i + 1) % 3], third = coordinates[(i + 2) % 3];
    return {second * length(h) + third * c.x, third * c.y};
  }

  /// the sum of the angles at `v`
  double total_angle(Index v) const { return total_angle_[v]; }
  /// the halfedge at which the angles around `v` start: the first of its fan if `v` is on the border, else the halfedge
  /// of least index that leaves `v`; null if no face has `v`
  Index first_halfedge(Index v) const { return first_[v]; }
  bool is_border(Index v) const { return (kind_[v] & border) != 0; }
  /// whether shortest paths may bend at `v`
  bool is_pseudo_source(Index v) const { return (kind_[v] & bends) != 0; }
  /// whether a branch of the cut locus ends at `v`, as no shortest path goes on behind it
  /// @param least curvature that is no rounding
  bool is_tip(Index v, double least = 1e-7) const
  {
    return !is_border(v) && 2. * geodesic_pi - total_angle_[v] > least;
  }
  double mean_edge_length() const { return mean_edge_length_; }

  /// the halfedge that follows `h` counterclockwise around the source of `h`, or null
  Index next_around_source(Index h) const { return opposite(Mesh::previous(h)); }
  /// the halfedge that precedes `h` counterclockwise around the source of `h`, or null
  Index previous_around_source(Index h) const
  {
    const Index o = opposite(h);
    return o == null_index ? null_index : Mesh::next(o);
  }

  /// the angle of `h` in the unrolled tangent plane of its source, counterclockwise from the first halfedge
  double angle_around_source(Index h) const
  {
    double sum = 0.;
    for(Index g = first_[source(h)]; g != h; g = next_around_source(g))
      sum += angle(g);
    return sum;
  }

  /// the direction at any finite angle from `h`, counterclockwise; none is beyond the border
  Geodesic_direction direction(Index h, double angle) const
  {
    while(angle < 0.)
    {
      const Index before = previous_around_source(h);
      if(before == null_index)
        return {h, 0.};
      h = before;
      angle += this->angle(h);
    }
    while(angle > this->angle(h))
    {
      const Index behind = next_around_source(h);
      if(behind == null_index)
        return {h, this->angle(h)};
      angle -= this->angle(h);
      h = behind;
    }
    return {h, angle};
  }

  /// the mesh that has been read, by its lengths: all points are zero
  Mesh mesh() const
  {
    Mesh result;
    result.points.resize(number_of_vertices());
    for(const Geodesic_face& face : faces_)
    {
      result.triangles.push_back(face.vertex);
      result.opposite.insert(result.opposite.end(), face.opposite.begin(), face.opposite.end());
      for(const Geodesic_face::Corner& corner : face.corner)
        result.lengths.push_back(corner.length);
    }
    return result;
  }

private:
  enum : unsigned char { border = 1, bends = 2 };

  static double norm(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

  void read_faces(const Mesh& mesh, const std::vector<Index>* positions, const Progress& progress)
  {
    double sum = 0.;
    faces_.reserve(mesh.number_of_faces());
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
    {
      progress(f, mesh.number_of_faces());
      faces_.emplace_back();
      Geodesic_face& face = faces_.back();
      std::array<double, 3> length, dots;
      double twice_area;
      if(mesh.lengths.empty())
        read_points(mesh, f, length, dots, twice_area);
      else
        read_lengths(mesh, f, length, dots, twice_area);
      const double longest = (std::max)((std::max)(length[0], length[1]), length[2]);
      // below this height the rounding of the coordinates decides the shape; the test also fails on NaN and infinity
      if(!(twice_area > 1e-13 * longest * longest) || !(twice_area < (std::numeric_limits<double>::max)()))
        throw Invalid_input(Cause::FACE_WITHOUT_AREA, describe_bad_face(mesh, f, positions));
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t k = i == 0 ? 2 : i - 1;
        const double scale = 1. / (length[i] * length[k]);
        face.vertex[i] = mesh.triangles[f][i];
        face.opposite[i] = mesh.opposite[3 * f + i];
        face.corner[i].length = length[i];
        face.corner[i].cosine = dots[i] * scale;
        face.corner[i].sine = twice_area * scale;
        sum += length[i];
      }
      // the largest angle is the rest: that keeps small angles accurate
      const std::size_t i = longest == length[0] ? 2 : longest == length[1] ? 0 : 1, j = (i + 1) % 3, k = (i + 2) % 3;
      // the tangent of half of it is the sine over one plus the cosine
      face.corner[j].angle = twice_arc_tangent(twice_area, length[j] * length[i] + dots[j]);
      face.corner[k].angle = twice_arc_tangent(twice_area, length[k] * length[j] + dots[k]);
      face.corner[i].angle = geodesic_pi - face.corner[j].angle - face.corner[k].angle;
    }
    if(mesh.number_of_faces() > 0)
      mean_edge_length_ = sum / (3. * mesh.number_of_faces());
  }

  static void read_points(const Mesh& mesh, Index f, std::array<double, 3>& length, std::array<double, 3>& dots,
                          double& twice_area)
  {
    std::array<Mesh::Point, 3> edge;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = i == 2 ? 0 : i + 1;
      const Mesh::Point& p = mesh.points[mesh.triangles[f][i]];
      const Mesh::Point& q = mesh.points[mesh.triangles[f][j]];
      edge[i] = {{q[0] - p[0], q[1] - p[1], q[2] - p[2]}};
      length[i] = norm(edge[i][0], edge[i][1], edge[i][2]);
    }
    twice_area =
      norm(edge[0][1] * edge[1][2] - edge[0][2] * edge[1][1], edge[0][2] * edge[1][0] - edge[0][0] * edge[1][2],
           edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t k = i == 0 ? 2 : i - 1;
      dots[i] = -(edge[i][0] * edge[k][0] + edge[i][1] * edge[k][1] + edge[i][2] * edge[k][2]);
    }
  }

  static void read_lengths(const Mesh& mesh, Index f, std::array<double, 3>& length, std::array<double, 3>& dots,
                           double& twice_area)
  {
    for(std::size_t i = 0; i < 3; ++i)
      length[i] = mesh.lengths[3 * std::size_t(f) + i];
    const Triangle_shape shape(length);
    dots = shape.dots;
    twice_area = shape.twice_area;
  }

  static std::string name(Index v, const std::vector<Index>* positions)
  {
    return "vertex #" + std::to_string(positions == nullptr ? v : (*positions)[v]);
  }

  static std::string describe_bad_face(const Mesh& mesh, Index f, const std::vector<Index>* positions)
  {
    for(Index v : mesh.triangles[f])
      for(double c : mesh.points[v])
        if(!std::isfinite(c))
          return name(v, positions) + " has a coordinate that is not finite";
    return "face #" + std::to_string(f) + " has no area";
  }

  void read_vertices(const std::vector<Index>* positions, const Progress& progress)
  {
    progress(0.);
    std::vector<Index> valence(number_of_vertices(), 0);
    for(Index f = 0; f < number_of_faces(); ++f)
      for(Index i = 0; i < 3; ++i)
      {
        const Index v = faces_[f].vertex[i];
        ++valence[v];
        total_angle_[v] += faces_[f].corner[i].angle;
        if(faces_[f].opposite[i] == null_index)
        {
          if(kind_[v] != 0)
            throw Invalid_input(Cause::NON_MANIFOLD, describe_bad_vertex(v, positions));
          kind_[v] = border;
          first_[v] = 3 * f + i;
        }
        else if(first_[v] == null_index)
          first_[v] = 3 * f + i;
      }
    for(Index v = 0; v < number_of_vertices(); ++v)
    {
      progress(v, number_of_vertices());
      Index h = first_[v], count = 0;
      while(h != null_index && count <= valence[v])
      {
        ++count;
        h = next_around_source(h);
        if(h == first_[v])
          break;
      }
      if(count != valence[v])
        throw Invalid_input(Cause::NON_MANIFOLD, describe_bad_vertex(v, positions));
      // sums of angles carry rounding errors of some 1e-15 each: an excess below 1e-11 is none, and the detour it could
      // save is of the square of it
      if(is_border(v) ? total_angle_[v] > geodesic_pi + 1e-11 : total_angle_[v] > 2. * geodesic_pi + 1e-11)
        kind_[v] = static_cast<unsigned char>(kind_[v] | bends);
    }
  }

  static std::string describe_bad_vertex(Index v, const std::vector<Index>* positions)
  {
    return name(v, positions) + " is not manifold: the faces around it do not form one fan";
  }

  std::vector<Geodesic_face> faces_;
  std::vector<double> total_angle_;
  std::vector<Index> first_;
  std::vector<unsigned char> kind_;
  double mean_edge_length_ = 1.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_FACES_H
