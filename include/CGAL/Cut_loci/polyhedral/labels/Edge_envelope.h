// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_EDGE_ENVELOPE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_EDGE_ENVELOPE_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>
#include <CGAL/Cut_loci/polyhedral/labels/Vertex_labels.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * divides an edge of the mesh by the shortest paths that reach its points: the lower envelope of the windows of both of
 * its halfedges and of the paths along the edge itself.
 */
class Edge_envelope
{
public:
  struct Piece
  {
    double begin, end; // on the halfedge
    Path_label label;  // in its frame
  };

  /// as a share of the edge: narrower windows are left away
  static constexpr double least_width = Parting_angle::least_width;

  explicit Edge_envelope(Exact_geodesic_propagation& geodesics)
    : geodesics_(geodesics), faces_(geodesics.faces()), vertex_labels_(geodesics)
  {
  }

  /// the pieces of the edge of `h`, in order and without gaps
  ///
  /// The two lists, of which either or both may be null, hold the windows that cross `h` and its opposite.
  const std::vector<Piece>& operator()(Index h, Geodesic_window_list* along, Geodesic_window_list* against)
  {
    halfedge_ = h;
    length_ = faces_.length(h);
    windows_.clear();
    if(geodesics_.is_approximate())
      read_windows<9>(along, against);
    else
      read_windows<7>(along, against);
    add_paths_along(h);
    add_path_to_end(h, 0., faces_.source(h));
    add_path_to_end(h, length_, faces_.target(h));
    return pieces_;
  }

private:
  template <int columns>
  void read_windows(Geodesic_window_list* along, Geodesic_window_list* against)
  {
    Geodesic_window_list* mirrored = against != nullptr ? mirror<columns>(*against) : nullptr;
    for(Geodesic_window_list* list : {along, mirrored})
      if(list != nullptr)
        close_gaps<columns>(*list);
    if(along == nullptr || mirrored == nullptr)
    {
      Geodesic_window_list* list = along != nullptr ? along : mirrored;
      if(list != nullptr)
        append<columns>(*list);
    }
    else
    {
      Geodesic_window_list* both = geodesics_.allocate(4 * std::size_t(along->size() + mirrored->size()));
      Geodesic_envelope<columns>()(*along, *mirrored, *both, length_);
      append<columns>(*both);
      geodesics_.release(both);
    }
    if(mirrored != nullptr)
      geodesics_.release(mirrored);
  }

  /// Where paths run nearly along the edge, what their rays lack of meeting each other is long on it. A path that goes
  /// there, and so passes the vertex that bounds its window on the wrong side, is too short by about the square of that.
  template <int columns>
  void close_gaps(Geodesic_window_list& list) const
  {
    Geodesic_trimming<columns> trim(list, length_, true);
    trim(list.begin);
    bool is_open = false;
    for(std::size_t i = list.begin + std::size_t(1); i < list.end; ++i)
    {
      Geodesic_window left = list.template get<columns>(i - 1), right = list.template get<columns>(i);
      if(!(left.b < right.a) || !(width_seen(left, left.b, right.a) <= least_width * length_) ||
         !(width_seen(right, left.b, right.a) <= least_width * length_))
        continue;
      std::swap(left.b, right.a);
      list.template set<columns>(i - 1, left);
      list.template set<columns>(i, right);
      is_open = true;
    }
    if(is_open)
      trim(list.begin);
  }

  /// how wide a part of the edge looks from the image of a window, across the way to it
  static double width_seen(const Geodesic_window& w, double from, double to)
  {
    const double nearest = (std::max)(from, (std::min)(w.x, to)), d = std::hypot(nearest - w.x, w.y);
    return d > 0. ? (to - from) * std::fabs(w.y) / d : to - from;
  }

  /// the windows of the opposite halfedge as if they came from behind the halfedge, at the same distances; numbers of
  /// their origins below zero mark them
  template <int columns>
  Geodesic_window_list* mirror(const Geodesic_window_list& list) const
  {
    Geodesic_window_list* result = geodesics_.allocate(list.size());
    for(std::size_t i = list.end; i-- > list.begin;)
    {
      Geodesic_window w = list.template get<columns>(i);
      const double a = w.a;
      w.a = length_ - w.b;
      w.b = length_ - a;
      w.x = length_ - w.x;
      w.origin = -1. - w.origin;
      result->append<columns>(w);
    }
    return result;
  }

  template <int columns>
  void append(const Geodesic_window_list& list)
  {
    for(std::size_t i = list.begin; i < list.end; ++i)
    {
      const Geodesic_window w = list.template get<columns>(i);
      Path_label label{w.x, w.y, w.sigma, w.turn, 0, w.origin < 0., w.rate};
      label.origin = static_cast<Index>(label.from_face ? -1. - w.origin : w.origin);
      if(label.from_face)
      {
        label.y = -w.y;
        label.turn += label.rate * geodesic_pi;
      }
      windows_.push_back({w.a, w.b, label});
    }
  }

  /// What no window reaches is reached along the edge, from its ends or from a source on it. So it is at an end; between
  /// two windows it is a rounding error of the rays that bound these.
  void add_paths_along(Index h)
  {
    pieces_.clear();
    const double margin = geodesic_cover * length_;
    Path_label on_edge;
    if(is_source_on(h, on_edge))
    {
      pieces_.push_back({0., length_, on_edge});
      return;
    }
    drop_slower_windows(h);
    if(windows_.empty())
    {
      add_labels_of_ends(h);
      return;
    }
    if(windows_.front().begin > margin)
      pieces_.push_back({0., windows_.front().begin, vertex_labels_.at_source(h)});
    // what shows in between is not there
    for(std::size_t i = 0; i < windows_.size(); ++i)
      if((windows_[i].end - windows_[i].begin > least_width * length_ && !is_leap(i)) || windows_.size() == 1)
        add(windows_[i]);
    if(pieces_.empty())
      add(windows_.front());
    if(windows_.back().end < length_ - margin)
      pieces_.push_back({windows_.back().end, length_, vertex_labels_.at_target(h)});
    // Pieces shorter than this at an end are rounding: they belong to the vertex.
    const double at_begin = margin_at(faces_.source(h)), at_end = margin_at(faces_.target(h));
    while(pieces_.size() > 1 && (pieces_[0].end < at_begin || is_shorter(pieces_[1], pieces_[0], 0., faces_.source(h))))
      pieces_.erase(pieces_.begin());
    while(pieces_.size() > 1 && (pieces_.back().begin > length_ - at_end ||
                                 is_shorter(pieces_.end()[-2], pieces_.back(), length_, faces_.target(h))))
      pieces_.pop_back();
    pieces_.front().begin = 0.;
    pieces_.back().end = length_;
    for(std::size_t i = 1; i < pieces_.size(); ++i)
      pieces_[i - 1].end = pieces_[i].begin = 0.5 * (pieces_[i - 1].end + pieces_[i].begin);
  }

  /// Near the vertex from which a branch between two lines starts, their distances differ by less than they are known to.
  double margin_at(Index v) const { return (geodesics_.is_on_line(v) ? 1e-6 : geodesic_cover) * length_; }

  /// A branch may leave its vertex nearly along the edge: then rounding tells on which side of it, and where it crosses the
  /// edge; and windows that end a little beside the vertex leave a gap, in which the paths around its other side show.
  /// @return whether another label, that of a neighbor, leads to the vertex, and is shorter on a piece at an end, or, where
  ///         no rounding tells, beyond it
  bool is_shorter(const Piece& neighbor, const Piece& piece, double end, Index v) const
  {
    const double rounding = 1e-14 * (geodesics_.distance(v) + length_);
    if(piece.label.origin == geodesics_.origin_of_vertex(v) || // a shadow of the vertex
       std::fabs(neighbor.label.distance(end) - geodesics_.distance(v)) > rounding)
      return false;
    const auto gain = [&](double t) { return piece.label.distance(t) - neighbor.label.distance(t); };
    const double inner = 0.5 * (piece.begin + piece.end), far = end == 0. ? piece.end : piece.begin,
                 beyond = end == 0. ? neighbor.end : neighbor.begin;
    const double least = (std::min)(gain(inner), gain(far));
    if(least > rounding)
      return true;
    // Where a shadow begins, both are the same path: rays tell where that is.
    return least > -rounding && gain(beyond) > rounding &&
           !Parting_angle(geodesics_).is_same_path(neighbor.label, piece.label, far, halfedge_);
  }

  /// whether the distance leaps up to a window from both of its neighbors, windows or ends of the edge: a gap between these
  /// that rounding has left, and that shows what is behind
  bool is_leap(std::size_t i) const
  {
    const Piece& window = windows_[i];
    const bool is_first = i == 0, is_last = i + 1 == windows_.size();
    const double from = is_first ? 0. : windows_[i - 1].end, to = is_last ? length_ : windows_[i + 1].begin,
                 least = to - from + 1e-9 * length_;
    const double before =
                   is_first ? geodesics_.distance(faces_.source(halfedge_)) : windows_[i - 1].label.distance(from),
                 behind = is_last ? geodesics_.distance(faces_.target(halfedge_)) : windows_[i + 1].label.distance(to);
    return window.label.distance(window.begin) > before + least && window.label.distance(window.end) > behind + least;
  }

  void add(const Piece& piece)
  {
    if(!pieces_.empty())
    {
      Path_label& last = pieces_.back().label;
      const double scale = std::fabs(last.x) + std::fabs(last.y) + length_;
      if(last.origin == piece.label.origin && last.from_face == piece.label.from_face &&
         std::fabs(last.x - piece.label.x) + std::fabs(last.y - piece.label.y) <= 1e-12 * scale &&
         Parting_angle(geodesics_).parting(last, piece.label, piece.begin, 0.).angle < Parting_angle::least_angle)
      {
        pieces_.back().end = piece.end;
        return;
      }
    }
    pieces_.push_back(piece);
  }

  /// At an end from which paths start in all directions, or in those of a shadow, or at which the shortest path goes on
  /// along the edge, the one along the edge is shorter than the windows up to some point.
  void drop_slower_windows(Index h)
  {
    const Index a = faces_.source(h), b = faces_.target(h);
    if(emits(a) || goes_on_along(vertex_labels_.at_source(h), 0., length_))
    {
      std::size_t n = 0;
      while(n < windows_.size() &&
            !end_slower(windows_[n], windows_[n].end, windows_[n].begin, 0., geodesics_.distance(a)))
        ++n;
      windows_.erase(windows_.begin(), windows_.begin() + static_cast<std::ptrdiff_t>(n));
    }
    if(emits(b) || goes_on_along(vertex_labels_.at_target(h), length_, 0.))
      while(!windows_.empty() &&
            !end_slower(windows_.back(), windows_.back().begin, windows_.back().end, length_, geodesics_.distance(b)))
        windows_.pop_back();
  }

  /// whether a path to an end of the edge goes on along it to the other one, straight through the vertex
  bool goes_on_along(const Path_label& label, double from, double to) const
  {
    return label.distance(from) + length_ - label.distance(to) <= geodesic_cover * length_;
  }

  bool emits(Index v) const { return geodesics_.distance(v) == 0. || faces_.is_pseudo_source(v); }

  /// Ends the window where the path along the edge from its end at `from` becomes shorter; returns whether it is not so
  /// on all of it. `near` is the end of the window on that side. What rounding does not tell apart is the window's, whose
  /// direction is the more accurate one.
  bool end_slower(const Piece& window, double far, double& near, double from, double distance) const
  {
    const auto gain = [&](double t) { return distance + std::fabs(t - from) - window.label.distance(t); };
    const double rounding = 1e-14 * (distance + length_);
    if(gain(near) >= -rounding)
      return true;
    if(gain(far) <= rounding)
      return false;
    double slow = near;
    for(int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (slow + far);
      (gain(middle) <= 0. ? slow : far) = middle;
    }
    near = far;
    return true;
  }

  /// The label of one end, or of both up to a tie.
  void add_labels_of_ends(Index h)
  {
    const Path_label begin = vertex_labels_.at_source(h), end = vertex_labels_.at_target(h);
    const double rounding = geodesic_cover * length_;
    if(begin.distance(length_) - geodesics_.distance(faces_.target(h)) <= rounding)
      pieces_.push_back({0., length_, begin});
    else if(end.distance(0.) - geodesics_.distance(faces_.source(h)) <= rounding)
      pieces_.push_back({0., length_, end});
    else
    {
      double low = 0., high = length_;
      for(int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        (begin.distance(middle) < end.distance(middle) ? low : high) = middle;
      }
      pieces_.push_back({0., low, begin});
      pieces_.push_back({low, length_, end});
    }
  }

  /// A path along the edge, straight through a vertex, is in no window. What leads to an end of the edge belongs to it.
  void add_path_to_end(Index h, double t, Index v)
  {
    const bool is_begin = t == 0.;
    const Path_label& known = is_begin ? pieces_.front().label : pieces_.back().label;
    if(!(known.distance(t) - geodesics_.distance(v) > geodesic_cover * length_))
      return;
    const Path_label label = is_begin ? vertex_labels_.at_source(h) : vertex_labels_.at_target(h);
    // up to the first point, from that end, that another path reaches as soon
    while(pieces_.size() > 1)
    {
      const Piece& last = is_begin ? pieces_.front() : pieces_.back();
      const double end = is_begin ? last.end : last.begin;
      if(last.label.distance(end) <= label.distance(end))
        break;
      pieces_.erase(is_begin ? pieces_.begin() : pieces_.end() - 1);
    }
    Piece& next = is_begin ? pieces_.front() : pieces_.back();
    double low = is_begin ? next.begin : next.end, high = is_begin ? next.end : next.begin;
    for(int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      (label.distance(middle) < next.label.distance(middle) ? low : high) = middle;
    }
    if(is_begin)
    {
      next.begin = low;
      pieces_.insert(pieces_.begin(), {0., low, label});
    }
    else
    {
      next.end = low;
      pieces_.push_back({low, length_, label});
    }
  }

  bool is_source_on(Index h, Path_label& label) const
  {
    const Index line = geodesics_.line_at(h);
    if(line != null_index)
    {
      const Plane_point image = geodesics_.line_image(line);
      label = {image.x, image.y, geodesics_.sigma_of_origin(line), 0., line, false};
      return true;
    }
    for(Index i = 0; i < geodesics_.number_of_sources(); ++i)
    {
      const Index g = geodesics_.source_edge(i);
      if(g == null_index || (g != h && faces_.opposite(g) != h))
        continue;
      const double t = geodesics_.source_location(i).coordinates[Indexed_triangle_mesh::next(g) % 3] * length_;
      label = {g == h ? t : length_ - t, 0., 0., g == h ? 0. : geodesic_pi, i, false};
      return true;
    }
    return false;
  }

  Exact_geodesic_propagation& geodesics_;
  const Geodesic_faces& faces_;
  Vertex_labels vertex_labels_;
  Index halfedge_ = null_index;
  double length_ = 0.;
  std::vector<Piece> windows_, pieces_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_EDGE_ENVELOPE_H
