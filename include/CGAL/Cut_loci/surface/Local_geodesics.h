// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_LOCAL_GEODESICS_H
#define CGAL_CUT_LOCI_SURFACE_LOCAL_GEODESICS_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * joins nearby points of a mesh by geodesic segments through the faces.
 *
 * The fewest faces that lead from one point to the other are laid out flat, the shortest path in that strip is found by
 * the funnel algorithm \cgalCite{cgal:lp-espsb-84}, and where it bends around a vertex the strip is led around the
 * other side of that vertex if the angle there is less than pi, until no such vertex is left: the path is then a
 * geodesic. The time is in proportion to the square of the number of faces between the points.
 */
class Local_geodesics
{
public:
  Local_geodesics(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
    : mesh_(mesh), connectivity_(connectivity), reached_(mesh.number_of_faces(), 0), from_(mesh.number_of_faces())
  {
  }

  /*!
   * appends to `path` the points at which a geodesic from `a` to `b` crosses edges, and `b`. Two points in a row lie
   * in a common face and differ; their coordinates tell it: those that are not zero belong to vertices of that face.
   * Nothing is appended if `a` and `b` are the same point.
   *
   * @return whether there is a path
   */
  bool append_segment(Indexed_location a, Indexed_location b, std::vector<Indexed_location>& path)
  {
    internal::snap(a);
    internal::snap(b);
    previous_ = a;
    if(is_same_point(a, b))
      return true;
    if(!find_strip(a, b))
      return false;
    straighten(a, b);
    const std::size_t first = path.size();
    for(std::size_t i = 0; i < corners_.size(); ++i)
      cross_edges(i, path);
    // The end is kept, whatever it falls together with.
    if(path.size() > first && is_same_point(path.back(), b))
      path.back() = b;
    else
      path.push_back(b);
    return true;
  }

  /// calls `f` with each face that two locations, with zeros where they are on edges and vertices, have in common
  template <typename Function>
  void for_each_common_face(const Indexed_location& a, const Indexed_location& b, const Function& f) const
  {
    for_each_face(a,
                  [&](Index face)
                  {
      if(is_in_face(b, face))
        f(face);
    });
  }

  /// the same point, which is in `face`, in the coordinates of that face
  Indexed_location in_face(const Indexed_location& location, Index face) const
  {
    return internal::in_face(mesh_, location, face);
  }

private:
  using Planar = internal::Planar_vector;

  // A portal of the strip: an edge that is crossed, from the face of `halfedge` to the one on the other side.
  struct Portal
  {
    Index halfedge;
    Planar left, right;
  };
  // A bend of the shortest path, or its end: it is straight up to there.
  struct Corner
  {
    Planar point;
    std::size_t portal; // the number of portals crossed before
    Index vertex;
  };

  template <typename Function>
  void for_each_face(const Indexed_location& location, const Function& f) const
  {
    const Index v = internal::vertex_of(mesh_, location), h = internal::edge_of(location);
    if(v != null_index)
    {
      for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
        if(mesh_.source(connectivity_.ring_halfedge[entry]) == v)
          f(connectivity_.ring_halfedge[entry] / 3);
      return;
    }
    f(location.face);
    if(h != null_index && !mesh_.is_border_edge(h))
      f(mesh_.opposite[h] / 3);
  }

  bool is_in_face(const Indexed_location& location, Index face) const
  {
    bool result = false;
    for_each_face(location, [&](Index f) { result = result || f == face; });
    return result;
  }

  // The fewest faces from `a` to `b`, by breadth.
  bool find_strip(const Indexed_location& a, const Indexed_location& b)
  {
    strip_.clear();
    if(++visit_ == 0)
    {
      std::fill(reached_.begin(), reached_.end(), 0);
      visit_ = 1;
    }
    queue_.clear();
    const auto reach = [&](Index face, Index from)
    {
      if(reached_[face] == visit_)
        return;
      reached_[face] = visit_;
      from_[face] = from;
      queue_.push_back(face);
    };
    for_each_face(a, [&](Index f) { reach(f, null_index); });
    for(std::size_t i = 0; i < queue_.size(); ++i)
    {
      Index f = queue_[i];
      if(is_in_face(b, f))
      {
        for(; from_[f] != null_index; f = from_[f] / 3)
          strip_.push_back({from_[f], {}, {}});
        std::reverse(strip_.begin(), strip_.end());
        first_face_ = f;
        return true;
      }
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(!mesh_.is_border_edge(h))
          reach(mesh_.opposite[h] / 3, h);
    }
    return false;
  }

  void straighten(const Indexed_location& a, const Indexed_location& b)
  {
    // Each turn makes the path shorter, so that no strip comes back. Rounding must not keep this from ending.
    for(std::size_t turns = 0;; ++turns)
    {
      trim(a, b);
      lay_out(a, b);
      pull_string();
      bool has_turned = false;
      for(std::size_t i = 0; i + 1 < corners_.size() && !has_turned; ++i)
        has_turned = lead_around(corners_[i].vertex, corners_[i].portal);
      if(!has_turned || turns > mesh_.number_of_faces())
        return;
    }
  }

  // Drops steps back and forth, and faces that hold `a` at the start or `b` at the end.
  void trim(const Indexed_location& a, const Indexed_location& b)
  {
    std::size_t size = 0;
    for(const Portal& p : strip_)
      if(size > 0 && mesh_.opposite[strip_[size - 1].halfedge] == p.halfedge)
        --size;
      else
        strip_[size++] = p;
    strip_.resize(size);
    std::size_t begin = 0;
    for(std::size_t i = 0; i < strip_.size(); ++i)
      if(is_in_face(a, mesh_.opposite[strip_[i].halfedge] / 3))
        begin = i + 1;
    if(begin > 0)
      first_face_ = mesh_.opposite[strip_[begin - 1].halfedge] / 3;
    strip_.erase(strip_.begin(), strip_.begin() + static_cast<std::ptrdiff_t>(begin));
    for(std::size_t i = 0; i < strip_.size(); ++i)
      if(is_in_face(b, strip_[i].halfedge / 3))
        strip_.resize(i);
  }

  void lay_out(const Indexed_location& a, const Indexed_location& b)
  {
    using namespace internal;
    // the first face: its halfedge 0 on the x-axis
    Index base = 3 * first_face_;
    Planar origin = {{0., 0.}}, axis = {{1., 0.}};
    const auto placed = [&](const Planar& p) {
      return Planar{{origin[0] + p[0] * axis[0] - p[1] * axis[1], origin[1] + p[0] * axis[1] + p[1] * axis[0]}};
    };
    begin_ = placed(flat_position(mesh_, base, in_face(a, first_face_).coordinates));
    for(Portal& p : strip_)
    {
      std::array<double, 3> from = {{0., 0., 0.}}, to = from;
      from[p.halfedge % 3] = 1.;
      to[(p.halfedge % 3 + 1) % 3] = 1.;
      p.right = placed(flat_position(mesh_, base, from));
      p.left = placed(flat_position(mesh_, base, to));
      base = mesh_.opposite[p.halfedge];
      origin = p.left;
      const Planar e = p.right - p.left;
      axis = (1. / norm(e)) * e;
    }
    end_ = placed(flat_position(mesh_, base, in_face(b, base / 3).coordinates));
  }

  // The shortest path through the portals: the funnel from the last corner narrows until it closes.
  void pull_string()
  {
    using namespace internal;
    corners_.clear();
    Planar apex = begin_;
    std::size_t start = 0; // the first portal beyond the apex
    while(true)
    {
      std::size_t left = strip_.size(), right = strip_.size(), i = start;
      Planar l = {{0., 0.}}, r = l;
      bool has_l = false, has_r = false, is_bent = false;
      for(; i <= strip_.size() && !is_bent; ++i)
      {
        const Planar nl = (i < strip_.size() ? strip_[i].left : end_) - apex;
        const Planar nr = (i < strip_.size() ? strip_[i].right : end_) - apex;
        if(has_l && cross(l, nr) > 0.) // beyond the left side: the path bends there
        {
          corners_.push_back({apex + l, last_portal_at(left, true), mesh_.target(strip_[left].halfedge)});
          is_bent = true;
          break;
        }
        if(has_r && cross(r, nl) < 0.)
        {
          corners_.push_back({apex + r, last_portal_at(right, false), mesh_.source(strip_[right].halfedge)});
          is_bent = true;
          break;
        }
        if(i == strip_.size())
          break;
        if(!has_l || cross(l, nl) <= 0.)
        {
          l = nl;
          left = i;
          has_l = nl != Planar{{0., 0.}};
        }
        if(!has_r || cross(r, nr) >= 0.)
        {
          r = nr;
          right = i;
          has_r = nr != Planar{{0., 0.}};
        }
      }
      if(!is_bent)
        break;
      apex = corners_.back().point;
      start = corners_.back().portal;
    }
    corners_.push_back({end_, strip_.size(), null_index});
  }

  // One beyond the last portal of the fan around the left or right end of `portal`.
  std::size_t last_portal_at(std::size_t portal, bool is_left) const
  {
    const Index v = end_of(portal, is_left);
    std::size_t i = portal + 1;
    while(i < strip_.size() && end_of(i, is_left) == v)
      ++i;
    return i;
  }

  Index end_of(std::size_t portal, bool is_left) const
  {
    return is_left ? mesh_.target(strip_[portal].halfedge) : mesh_.source(strip_[portal].halfedge);
  }

  // Leads the strip around the other side of `v`, where the portals up to `end` turn around it, if that is shorter.
  bool lead_around(Index v, std::size_t end)
  {
    using namespace internal;
    if(connectivity_.is_border(v))
      return false;
    const bool is_left = end_of(end - 1, true) == v;
    std::size_t begin = end - 1;
    while(begin > 0 && end_of(begin - 1, is_left) == v)
      --begin;

    // the angle of the path at v within the strip, and all around
    std::size_t corner = 0;
    while(corners_[corner].portal != end || corners_[corner].vertex != v)
      ++corner;
    const Planar p = corners_[corner].point;
    const Planar before = (corner > 0 ? corners_[corner - 1].point : begin_) - p;
    const Planar after = corners_[corner + 1].point - p;
    const double turn = std::atan2(cross(before, after), dot(before, after));
    double inside = is_left ? turn : -turn; // the strip passes on the right of a left end: counterclockwise
    if(inside < 0.)
      inside += 2. * pi();
    double total = 0.;
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
    {
      const Planar q = apex(mesh_, connectivity_.ring_halfedge[entry]);
      total += std::atan2(q[1], q[0]);
    }
    // Less than pi by more than rounding: a straight path along a vertex stays as it is.
    if(!(total - inside < pi() - snapping_tolerance))
      return false;

    const Index first = strip_[begin].halfedge / 3, last = mesh_.opposite[strip_[end - 1].halfedge] / 3;
    fan_.clear();
    Index f = first;
    while(f != last)
    {
      // The strip leaves `first` by an edge at v; the way around the other side leaves it by the other one.
      Index h = 3 * f;
      while(mesh_.source(h) != v)
        ++h;
      const Index out = is_left ? h : mesh_.previous(h);
      fan_.push_back({out, {}, {}});
      f = mesh_.opposite[out] / 3;
      if(fan_.size() > connectivity_.valence(v))
        return false;
    }
    const auto begin_of_fan = strip_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto next = strip_.erase(begin_of_fan, begin_of_fan + static_cast<std::ptrdiff_t>(end - begin));
    strip_.insert(next, fan_.begin(), fan_.end());
    return true;
  }

  // Appends the points on the straight piece that ends at corner `i`.
  void cross_edges(std::size_t i, std::vector<Indexed_location>& path)
  {
    using namespace internal;
    const Corner& corner = corners_[i];
    const Planar from = i > 0 ? corners_[i - 1].point : begin_, direction = corner.point - from;
    for(std::size_t k = i > 0 ? corners_[i - 1].portal : 0; k < corner.portal; ++k)
    {
      const Portal& p = strip_[k];
      if(corner.vertex != null_index && (end_of(k, true) == corner.vertex || end_of(k, false) == corner.vertex))
        break; // the fan around the corner
      const double l = cross(direction, p.left - from), r = cross(direction, p.right - from);
      const double t = l > r ? (std::min)(1., (std::max)(0., -r / (l - r))) : 0.5;
      append(location_on(p.halfedge, t), path);
    }
    if(corner.vertex != null_index)
      append(location_of_vertex(connectivity_, corner.vertex), path);
  }

  void append(Indexed_location x, std::vector<Indexed_location>& path)
  {
    internal::snap(x);
    if(is_same_point(previous_, x))
      return;
    path.push_back(x);
    previous_ = x;
  }

  // Equal up to the tolerance, with which a point next to an edge is taken to be on it.
  bool is_same_point(const Indexed_location& a, const Indexed_location& b) const
  {
    if(!is_in_face(a, b.face))
      return false;
    const Indexed_location c = in_face(a, b.face);
    for(int i = 0; i < 3; ++i)
      if(std::abs(c.coordinates[i] - b.coordinates[i]) > internal::snapping_tolerance)
        return false;
    return true;
  }

  static double pi() { return 3.14159265358979323846; }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  std::vector<Index> reached_; // the visit in which the search reached each face
  std::vector<Index> from_;    // the halfedge across which it did
  Index visit_ = 0;

  std::vector<Index> queue_;
  std::vector<Portal> strip_, fan_;
  std::vector<Corner> corners_;
  Index first_face_ = null_index;
  Planar begin_ = {{0., 0.}}, end_ = {{0., 0.}};
  Indexed_location previous_;
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SURFACE_LOCAL_GEODESICS_H
