// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CURVES_UNFOLDED_POLYGON_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CURVES_UNFOLDED_POLYGON_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/polyhedral/curves/Unfolded_boundary.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the source unfolding of a polyhedron: what is left of it without its cut locus, as a polygon around the source.
 *
 * If the source is a vertex at which the faces do not lie flat, a further cut leads from it to a point of the cut locus.
 */
class Unfolded_polygon
{
public:
  struct Corner
  {
    Plane_point point;
    Index node;
  };
  /// a part of an edge of the mesh
  struct Fold
  {
    Index halfedge;
    std::array<Plane_point, 2> ends;
  };

  std::vector<Indexed_cut_locus::Node> nodes;
  std::vector<Corner> corners; ///< counterclockwise
  std::vector<Index> glued;    ///< to each edge, which starts at the corner of its number; null on the border
  std::vector<Fold> folds;
  Indexed_location source;      ///< where it is; see `Exact_tree_solver`
  bool is_source_moved = false; ///< from where it was wanted

  /// \pre the paths do not bend; see `throw_if_paths_bend()`
  Unfolded_polygon(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   const Geodesic_results& geodesics, const Exact_tree& tree, const Indexed_source& wanted)
    : source(geodesics.source_location(0)), mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics),
      boundary_(mesh, connectivity, geodesics, tree)
  {
    if(order().size() < 2)
      fail();
    find_center(wanted);
    for(Index side : order())
    {
      start_.push_back(seen_from_center(boundary_.sides[side].ends[0]));
      size_ = (std::max)(size_, start_.back().radius);
    }
    check_joints();
    nodes.swap(boundary_.nodes);
    for(std::size_t i = 0; i < 3; ++i)
      is_source_moved = is_source_moved || std::fabs(source.coordinates[i] - wanted.location.coordinates[i]) > 1e-12;
    if(is_cone_)
      cut_to(nearest_end());
    unroll();
    place_corners(wanted);
    add_folds();
    remove_unused_nodes();
  }

private:
  [[noreturn]] static void fail() { throw Unfolding_failure(); }

  static Plane_point cartesian(const Polar_point& p)
  {
    return {p.radius * std::cos(p.angle), p.radius * std::sin(p.angle)};
  }

  std::vector<Index>& order() { return boundary_.order; }
  const std::vector<Index>& order() const { return boundary_.order; }

  double wrapped(double angle) const { return std::remainder(angle, full_); }

  // -- the center ------------------------------------------------------------------------------------------------------

  /*
   * If the source has been moved away from a vertex, the branch that starts there has been left out of the tree. What
   * is left has a gap, with the vertex as its apex. It closes where the vertex is in the center.
   */
  void find_center(const Indexed_source& wanted)
  {
    full_ = geodesics_.is_source_on_border() ? 4. * geodesic_pi : geodesics_.source_angle();
    const Index v = wanted.vertex;
    if(v == null_index || geodesics_.faces().is_border(v))
      return;
    cone_ = v;
    is_cone_ = geodesics_.faces().total_angle(v) < 2. * geodesic_pi - 1e-7; // as for the ends of branches
    if(!is_cone_ || geodesics_.source_vertex(0) == v)
      return;
    const Polar_point p = boundary_.polar(v);
    is_moved_ = true;
    center_ = cartesian(p);
    axis_ = p.angle + geodesic_pi; // away from the gap
    full_ = geodesics_.faces().total_angle(v);
  }

  Polar_point seen_from_center(const Polar_point& p) const
  {
    if(!is_moved_)
      return p;
    const Plane_point q = cartesian(p);
    const double dx = q.x - center_.x, dy = q.y - center_.y, c = std::cos(axis_), s = std::sin(axis_);
    return {std::hypot(dx, dy), std::atan2(c * dy - s * dx, c * dx + s * dy)};
  }

  /// Where one side ends, the next one starts; and all copies of a point are at the same distance from the source, up to
  /// the accuracy of the cut locus.
  void check_joints() const
  {
    for(std::size_t i = 0; i < start_.size(); ++i)
    {
      const Unfolded_boundary::Side& side = boundary_.sides[order()[i]];
      const Polar_point end = seen_from_center(side.ends[1]);
      const Polar_point& next = start_[i + 1 < start_.size() ? i + 1 : 0];
      const double away = end.radius * wrapped(next.angle - end.angle);
      if(!(std::hypot(next.radius - end.radius, away) <= 1e-9 * size_))
        fail();
      if(!(std::fabs(side.ends[0].radius - boundary_.nodes[side.nodes[0]].distance) <= 1e-8 * size_))
        fail();
    }
  }

  Polar_point seen_from_center(Index v) const
  {
    return is_cone_ && v == cone_ ? Polar_point{0., 0.} : seen_from_center(boundary_.polar(v));
  }

  /// the nearest end of a branch, at a vertex of the mesh, or, without any, the nearest corner
  std::size_t nearest_end() const
  {
    std::vector<Index> copies(nodes.size(), 0);
    for(Index s : order())
      ++copies[boundary_.sides[s].nodes[0]];
    std::size_t best = 0;
    double least = (std::numeric_limits<double>::infinity)();
    bool has_end = false;
    for(std::size_t i = 0; i < order().size(); ++i)
    {
      const Index node = boundary_.sides[order()[i]].nodes[0];
      const bool is_end = copies[node] == 1 && nodes[node].vertex != null_index;
      // of several at the same distance, but for the way by which the source is moved, the first
      if((is_end && !has_end) || (is_end == has_end && start_[i].radius < (1. - 1e-4) * least))
      {
        has_end = is_end;
        least = start_[i].radius;
        best = i;
      }
    }
    return best;
  }

  void cut_to(std::size_t corner)
  {
    const auto middle = static_cast<std::ptrdiff_t>(corner);
    std::rotate(order().begin(), order().begin() + middle, order().end());
    std::rotate(start_.begin(), start_.begin() + middle, start_.end());
    seam_ = start_.front().angle;
  }

  /// Angles grow, but for rounding, up to a full turn. Where they do not, the way around folds back.
  void unroll()
  {
    if(geodesics_.is_source_on_border() && !is_moved_)
      return;
    const Polar_point first = start_.front();
    const double angle = is_cone_ ? 0. : first.angle, least = -1e-12 * size_ * size_;
    double sum = 0.;
    Polar_point previous = first;
    for(std::size_t i = 1; i <= start_.size(); ++i)
    {
      const Polar_point next = i < start_.size() ? start_[i] : first;
      const double step = wrapped(next.angle - previous.angle);
      if(!(previous.radius * next.radius * step >= least))
        fail();
      previous = next;
      sum += step;
      if(i < start_.size())
        start_[i].angle = angle + sum;
    }
    start_.front().angle = angle;
    if(!(std::fabs(sum - full_) < 1e-6))
      fail();
  }

  // -- the result ------------------------------------------------------------------------------------------------------

  void place_corners(const Indexed_source& wanted)
  {
    const Index shift = is_cone_ ? 1 : 0;
    std::vector<Index> number(boundary_.sides.size(), null_index);
    for(Index i = 0; i < order().size(); ++i)
      number[order()[i]] = i + shift;
    if(is_cone_)
    {
      corners.push_back({{0., 0.}, static_cast<Index>(nodes.size())});
      glued.push_back(static_cast<Index>(order().size() + 1));
      nodes.push_back({wanted.location, wanted.vertex, 0.});
    }
    for(std::size_t i = 0; i < order().size(); ++i)
    {
      const Unfolded_boundary::Side& side = boundary_.sides[order()[i]];
      corners.push_back({cartesian(start_[i]), side.nodes[0]});
      glued.push_back(side.twin != null_index ? number[side.twin] : null_index);
    }
    if(is_cone_)
    {
      corners.push_back({cartesian({start_.front().radius, full_}), corners[1].node});
      glued.push_back(0);
    }
  }

  void add_folds()
  {
    std::size_t next = 0;
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
    {
      const Index h = connectivity_.halfedge_of_edge[e];
      Polar_point from = seen_from_center(mesh_.source(h));
      for(; next < boundary_.crossings.size() && boundary_.crossings[next].edge == e; ++next)
      {
        const Unfolded_boundary::Crossing& c = boundary_.crossings[next];
        add_fold(h, from, seen_from_center(c.before));
        from = seen_from_center(c.behind);
      }
      add_fold(h, from, seen_from_center(mesh_.target(h)));
    }
  }

  void add_fold(Index h, Polar_point p, Polar_point q)
  {
    if(mesh_.is_border_edge(h))
      return;
    if(!is_cone_)
    {
      push_fold(h, cartesian(p), cartesian(q));
      return;
    }
    // angles from the seam, so that the part has no more of it than half a turn
    if(p.radius == 0.)
      p.angle = q.angle;
    if(q.radius == 0.)
      q.angle = p.angle;
    constexpr double margin = 1e-9;
    const double turn = wrapped(q.angle - p.angle);
    p.angle = std::fmod(std::fmod(p.angle - seam_, full_) + full_, full_);
    if(p.angle < margin || p.angle > full_ - margin)
    {
      if(std::fabs(turn) < margin)
        return; // it is the seam
      p.angle = turn > 0. ? 0. : full_;
    }
    q.angle = p.angle + turn;
    if(q.angle >= -margin && q.angle <= full_ + margin)
    {
      push_fold(h, cartesian(p), cartesian(q));
      return;
    }
    // across the seam
    const double seam = q.angle < 0. ? 0. : full_;
    const double a = p.angle - seam, b = q.angle - seam;
    const double radius = p.radius * q.radius * std::sin(b - a) / (q.radius * std::sin(b) - p.radius * std::sin(a));
    push_fold(h, cartesian(p), cartesian({radius, seam}));
    push_fold(h, cartesian({radius, full_ - seam}), cartesian({q.radius, b + full_ - seam}));
  }

  void push_fold(Index h, const Plane_point& p, const Plane_point& q)
  {
    if(std::hypot(q.x - p.x, q.y - p.y) > 1e-9 * geodesics_.faces().length(h))
      folds.push_back({h, {{p, q}}});
  }

  void remove_unused_nodes()
  {
    std::vector<Index> number(nodes.size(), null_index);
    std::vector<Indexed_cut_locus::Node> used;
    for(Corner& c : corners)
    {
      if(number[c.node] == null_index)
      {
        number[c.node] = static_cast<Index>(used.size());
        used.push_back(nodes[c.node]);
      }
      c.node = number[c.node];
    }
    nodes.swap(used);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Geodesic_results& geodesics_;
  Unfolded_boundary boundary_;
  std::vector<Polar_point> start_; // of each
  double size_ = 0.;               // the largest distance
  Index cone_ = null_index;
  bool is_cone_ = false;          // whether the source is a vertex, and the surface is not flat there
  bool is_moved_ = false;         // whether the solver's source is beside it
  Plane_point center_ = {0., 0.}; // seen from there
  double axis_ = 0., full_ = 2. * geodesic_pi, seam_ = 0.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CURVES_UNFOLDED_POLYGON_H
