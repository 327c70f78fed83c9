// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_VERTEX_LABELS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_VERTEX_LABELS_H

#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>

#include <cmath>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells which paths reach the edges of the mesh right beside a vertex: the shortest path to the vertex and its
 * neighbors, unfolded around the vertex to both sides, as far as they go straight on.
 *
 * They meet behind a vertex of positive curvature, in the direction that halves the angle around it: there a branch of
 * the cut locus starts. Behind a vertex of negative curvature or on the border the path itself bends.
 */
class Vertex_labels
{
public:
  explicit Vertex_labels(const Geodesic_results& geodesics)
    : geodesics_(geodesics), faces_(geodesics.faces()), arrivals_(faces_.number_of_vertices(), {-1., 0., -1.})
  {
  }

  /// the direction in which the path to a vertex leaves its origin
  double direction_at_origin(Index v) const { return arrival(v).direction; }

  /// the label of the begin of `h`, a halfedge that leaves a vertex that has been reached
  Path_label at_source(Index h) const { return at_direction(faces_.source(h), faces_.angle_around_source(h)); }

  /// the same for the end of `h`
  Path_label at_target(Index h) const
  {
    const Index o = faces_.opposite(h);
    if(o != null_index)
      return at_source(o).opposite(faces_.length(h));
    const Index next = Indexed_triangle_mesh::next(h);
    const double angle = faces_.angle_around_source(next) + faces_.angle(next);
    return at_direction(faces_.source(next), angle).opposite(faces_.length(h));
  }

  /// is where the label changes in a face right beside its vertex.
  struct Change
  {
    Index halfedge;           // leaves the vertex before the change, counterclockwise
    Path_label before, after; // the change, in its frame, clockwise: as one goes around the face
    bool is_shadow;
    bool is_weak = false; // see `Label_jumps::is_weak()`
  };

  /// the branch that starts at `v`, or the boundaries of the shadow into which the paths bend there
  std::vector<Change> changes(Index v) const
  {
    std::vector<Change> result;
    if(geodesics_.is_on_line(v))
      add_changes_on_line(v, result);
    if(geodesics_.distance(v) == 0.)
      return result;
    if(faces_.is_pseudo_source(v))
    {
      if(!geodesics_.is_approximate()) // else the shadow is merged with what is beside it
        add_shadows(v, result);
    }
    else if(!faces_.is_border(v))
      result.push_back(branch(v));
    return result;
  }

private:
  static constexpr double margin = 1e-9; // of angles, as for the paths that go on at a bend

  /// of the path to a vertex, as it was when it had this distance: all edges there ask for it
  struct Arrival
  {
    double distance, direction, angle; // the last is negative as long as nobody has asked for it
  };
  Arrival& arrival(Index v) const
  {
    Arrival& result = arrivals_[v];
    const double d = geodesics_.distance(v);
    const Geodesic_arrival& path = geodesics_.arrival(v);
    if(result.distance != d)
      result = {d, Geodesic_results::direction_at_origin(path, geodesics_.end_in_frame(path, v)), -1.};
    return result;
  }

  /// as `Geodesic_results::arrival_angle()`
  double arrival_angle(Index v) const
  {
    double& angle = arrival(v).angle;
    return angle < 0. ? angle = geodesics_.arrival_angle(v) : angle;
  }

  /// calls `function(h, angle)` for the halfedges that leave `v`, counterclockwise from its first, with their angles from the
  /// path to `v`, counterclockwise
  template <typename Function>
  void for_each_halfedge(Index v, const Function& function) const
  {
    const double path = arrival_angle(v), full = faces_.is_border(v) ? 0. : faces_.total_angle(v);
    const Index first = faces_.first_halfedge(v);
    double around = 0.;
    Index h = first;
    do
    {
      function(h, around < path ? around - path + full : around - path);
      around += faces_.angle(h);
      h = faces_.next_around_source(h);
    } while(h != null_index && h != first);
  }

  /// behind the last halfedge with the label from the right, or, if all have the one from the left, before the first
  Change branch(Index v) const
  {
    const double full = faces_.total_angle(v);
    Index before = faces_.first_halfedge(v), last = before;
    double angle_before = -1., angle_last = -1.;
    for_each_halfedge(v,
                      [&](Index h, double angle)
                      {
      if(angle <= 0.5 * full && angle > angle_before)
      {
        angle_before = angle;
        before = h;
      }
      if(angle > angle_last)
      {
        angle_last = angle;
        last = h;
      }
    });
    if(angle_before < 0.)
    {
      before = last;
      angle_before = angle_last - full;
    }
    return {before, straight(v, angle_before - full), straight(v, angle_before), false};
  }

  void add_shadows(Index v, std::vector<Change>& result) const
  {
    constexpr double first_shadow = geodesic_pi - margin;
    const bool is_border = faces_.is_border(v);
    const double full = faces_.total_angle(v), last_shadow = is_border ? -first_shadow : full - first_shadow;
    for_each_halfedge(v,
                      [&](Index h, double angle)
                      {
      const double next = angle + faces_.angle(h);
      // the one that comes later around the vertex comes first around the face
      const bool has_last = angle < last_shadow && last_shadow <= next;
      if(has_last && !is_border)
        result.push_back({h, straight(v, angle - full), bent(v, angle), true});
      if(angle <= first_shadow && first_shadow < next)
        result.push_back({h, bent(v, angle), straight(v, angle), true});
      if(has_last && is_border)
        result.push_back({h, straight(v, angle), bent(v, angle), true});
    });
  }

  /// At a vertex on lines their waves meet, in the direction that halves the angle between them, or they leave room for
  /// paths that start there.
  void add_changes_on_line(Index v, std::vector<Change>& result) const
  {
    const std::array<double, 2> fan = geodesics_.fan(v);
    const bool do_meet = fan[1] < fan[0];
    // those that come later around the vertex come first around the face
    std::array<double, 2> places = {{fan[1], fan[0]}};
    if(do_meet)
      places = {{0.5 * (fan[0] + fan[1]), -1.}};
    const Index last = geodesics_.last_line(v), first = geodesics_.first_line(v);
    const bool is_seam = do_meet && geodesics_.is_seam(first, last, fan[0] - fan[1]);
    for(Index h = faces_.first_halfedge(v); h != null_index; h = faces_.next_around_source(h))
    {
      const Index behind = faces_.next_around_source(h);
      const double angle = faces_.angle_around_source(h),
                   next = behind != null_index ? faces_.angle_around_source(behind) : faces_.total_angle(v);
      for(std::size_t k = 0; k < 2; ++k)
        if(places[k] >= angle && places[k] < next)
        {
          const Path_label own = {0., 0., 0., angle, geodesics_.arrival(v).origin, false};
          if(do_meet)
            result.push_back({h, from_last_line(v, angle), from_first_line(v, angle), is_seam});
          else if(k == 0)
            result.push_back({h, from_last_line(v, angle), own, true});
          else
            result.push_back({h, own, from_first_line(v, angle), true});
        }
    }
  }

  /// of the lines at `v`, on an edge that leaves it in some direction
  Path_label from_first_line(Index v, double direction) const
  {
    const Index line = geodesics_.first_line(v);
    return from_line(line, geodesics_.half_opening(line) - 0.5 * geodesic_pi - direction, direction);
  }
  Path_label from_last_line(Index v, double direction) const
  {
    const Index line = geodesics_.last_line(v);
    const double turn = direction + geodesic_pi - faces_.total_angle(v);
    return from_line(line, 1.5 * geodesic_pi - geodesics_.half_opening(line) - turn, turn);
  }

  /// whose image is in the direction `angle` from the edge
  Path_label from_line(Index line, double angle, double turn) const
  {
    const double r = geodesics_.line_distance(), y = r * std::sin(angle);
    return {r * std::cos(angle), y, -r, turn, line, y > 0.};
  }

  Path_label at_source_vertex(Index v, double direction) const
  {
    if(geodesics_.is_on_line(v))
    {
      const std::array<double, 2> fan = geodesics_.fan(v);
      const double middle = 0.5 * (fan[0] + fan[1]);
      if(direction < fan[0] && (direction < fan[1] || direction <= middle))
        return from_first_line(v, direction);
      if(direction > fan[1])
        return from_last_line(v, direction);
    }
    return {0., 0., 0., direction, geodesics_.arrival(v).origin, false};
  }

  /// on an edge that leaves `v` in this direction, an angle from the first halfedge
  Path_label at_direction(Index v, double direction) const
  {
    if(geodesics_.distance(v) == 0.)
      return at_source_vertex(v, direction);
    double angle = direction - arrival_angle(v);
    if(faces_.is_border(v))
      return at_angle(v, angle);
    const double full = faces_.total_angle(v);
    if(angle < 0.)
      angle += full;
    return at_angle(v, angle <= 0.5 * full ? angle : angle - full);
  }

  /// on a halfedge at `v` that is at this angle from the path, counterclockwise, with the faces in between unfolded
  Path_label at_angle(Index v, double angle) const
  {
    if(std::fabs(angle) <= geodesic_pi - margin || !faces_.is_pseudo_source(v))
      return straight(v, angle);
    return bent(v, angle < 0. && !faces_.is_border(v) ? angle + faces_.total_angle(v) : angle);
  }

  /// a path that bends at `v`
  Path_label bent(Index v, double angle) const
  {
    const Geodesic_arrival start = geodesics_.from_vertex(v);
    return {0., 0., start.sigma, geodesics_.is_origin(v) ? angle : start.turn, start.origin, false, start.rate};
  }

  /// the path to `v` and its neighbors
  Path_label straight(Index v, double angle) const
  {
    const Geodesic_arrival& path = geodesics_.arrival(v);
    const double r = geodesics_.distance(v) - path.sigma;
    Path_label label{r * std::cos(angle), -r * std::sin(angle), path.sigma, 0., path.origin, angle < 0., path.rate};
    label.turn = arrival(v).direction - label.direction(0.);
    return label;
  }

  const Geodesic_results& geodesics_;
  const Geodesic_faces& faces_;
  mutable std::vector<Arrival> arrivals_; // by vertex
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_VERTEX_LABELS_H
