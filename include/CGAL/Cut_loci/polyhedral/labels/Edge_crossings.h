// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_EDGE_CROSSINGS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_EDGE_CROSSINGS_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_window_lists.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/internal/Growing_list.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/polyhedral/labels/Edge_envelope.h>
#include <CGAL/Cut_loci/polyhedral/labels/Halfedge_trail.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_jumps.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>

#include <algorithm>
#include <cstddef>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is a point of an edge of the mesh at which the label changes.
struct Edge_crossing
{
  Index halfedge;          // of the two of the edge, that of smaller index
  Index label;             // the number of the label before the point; the next one is behind it
  double t;                // the position on the halfedge
  double gap, angle;       // between the two paths: where they part and where they meet
  double distance;         // to the source
  bool is_shadow;          // it is the same path on both sides: the boundary of a shadow, not on the cut locus
  bool is_between_sources; // the paths come from different ones
  bool is_weak;            // see `Label_jumps::is_weak()`

  double larger_angle() const { return (std::max)(angle, gap); }
};

inline Edge_crossing edge_crossing(const Geodesic_results& geodesics, const Branch_strength& least, Index h,
                                   Index label, double t, const Path_label& left, const Path_label& right,
                                   const Parting_angle::Parting& parting, double angle, bool is_shadow)
{
  const bool is_between_sources = geodesics.source_of_origin(left.origin) != geodesics.source_of_origin(right.origin);
  const double distance = (std::min)(left.distance(t), right.distance(t)); // they differ by what windows are narrower
  return {h,
          label,
          t,
          parting.angle,
          angle,
          distance,
          is_shadow,
          is_between_sources,
          Label_jumps::is_weak(least, parting, angle, distance)};
}

/// is the numbers of the first and the last label of an edge of the mesh.
struct Edge_ends
{
  Index halfedge; // as in `Edge_crossing`
  Index first, last;
};

/*!
 * collects, while the windows are propagated, where the label changes on the edges of the faces that are drawn.
 *
 * It is an observer of `Exact_geodesic_propagation`. It keeps the windows of an edge until the front has passed it, so
 * that they take the memory of the front. An edge on which windows arrive after that is late. So is one of which it is
 * found only then that it has a face that is drawn, if these are not known before.
 */
class Edge_crossings : public Geodesic_window_observer
{
public:
  /// @param is_drawn by face; of their edges all changes become known, of other edges none
  /// @param least what is weaker is told from the rest
  /// @param slack how far beyond an edge the front has to be, in sizes of its faces, for its windows to be complete
  /// @param trail beside the halfedges of which faces may be drawn: they are added to those that are; which ones are has to
  ///        be known when `finish()` is called. Null if it is known before.
  Edge_crossings(Exact_geodesic_propagation& geodesics, std::vector<unsigned char>& is_drawn,
                 const Branch_strength& least, double slack, Halfedge_trail* trail = nullptr)
    : geodesics_(geodesics), faces_(geodesics.faces()), is_drawn_(is_drawn), envelope_(geodesics),
      parting_angle_(geodesics), least_(least), slack_(slack), kept_(faces_.number_of_halfedges(), nullptr),
      state_(faces_.number_of_halfedges(), 0), trail_(trail)
  {
  }

  // -- while the windows are propagated --------------------------------------------------------------------------------

  void advance(double front) override
  {
    if(trail_ != nullptr)
      trail_->throw_if_stopped();
    while(!waiting_.empty() && waiting_.top().until < front)
    {
      divide(waiting_.top().halfedge);
      waiting_.pop();
    }
    front_ = front;
  }

  bool take(Index h, Geodesic_window_list& list) override
  {
    const Index o = faces_.opposite(h);
    if(!may_be_needed(h, o))
      return false;
    if((state_[(std::min)(h, o)] & divided) != 0)
    {
      state_[(std::min)(h, o)] |= late;
      return false;
    }
    wait(h, o);
    if(kept_[h] == nullptr)
    {
      kept_[h] = &list;
      return true;
    }
    Geodesic_window_list* copy = geodesics_.allocate(list.size());
    if(geodesics_.is_approximate())
      copy->append<9>(list);
    else
      copy->append<7>(list);
    add(h, copy);
    return false;
  }

  /// windows reach the border halfedge `h` from its face; they are given in the frame of the opposite of `h`, which is
  /// not there. Takes over the list.
  void take_on_border(Index h, Geodesic_window_list* list) override
  {
    if((state_[h] & divided) != 0)
      state_[h] |= late;
    if(!may_be_needed(h, null_index) || (state_[h] & divided) != 0)
    {
      geodesics_.release(list);
      return;
    }
    wait(h, null_index);
    if(kept_[h] == nullptr)
      kept_[h] = list;
    else
      add(h, list);
  }

  /// the end of the propagation
  void finish(const Progress& progress = {})
  {
    for(Index h = 0; h < faces_.number_of_halfedges(); ++h)
    {
      progress(h, faces_.number_of_halfedges());
      if(h > faces_.opposite(h) || !is_needed(h, faces_.opposite(h)))
        continue;
      if((state_[h] & divided) == 0) // where the front ends, or edges along which all paths run
        divide(h);
      number_of_late_ += (state_[h] & late) != 0;
    }
    if(trail_ != nullptr)
    {
      // what is on edges of faces that are not drawn after all
      const auto is_needed_there = [this](const auto& e) { return is_needed(e.halfedge, faces_.opposite(e.halfedge)); };
      crossings.keep_if(is_needed_there);
      ends.keep_if(is_needed_there);
    }
  }

  // -- afterwards ------------------------------------------------------------------------------------------------------

  Growing_list<Edge_crossing> crossings; ///< those of an edge together, in order
  Growing_list<Path_label> labels;       ///< those of an edge together, in order, in the frame of its halfedge
  Growing_list<Edge_ends> ends;          ///< of all edges of the faces that are drawn

  /// of how many edges it is not known whether the windows are complete
  std::size_t number_of_late() const { return number_of_late_; }

private:
  enum : unsigned char { waits = 1, divided = 2, late = 4 };

  struct Waiting
  {
    Index halfedge;
    double until; // the front is there

    bool operator<(const Waiting& other) const { return until > other.until; } // the next one is on top
  };

  void wait(Index h, Index o)
  {
    const Index first = (std::min)(h, o);
    if((state_[first] & waits) != 0)
      return;
    state_[first] |= waits;
    waiting_.push({first, passed(h, o)});
  }

  /// where the front is when it has passed an edge
  double passed(Index h, Index o) const
  {
    double size = faces_.mean_edge_length(); // batches of the propagation are no finer
    for(Index k : {h, o})
      if(k != null_index)
        for(Index g = 3 * (k / 3); g < 3 * (k / 3) + 3; ++g)
          size = (std::max)(size, faces_.length(g));
    return front_ + slack_ * size;
  }

  /// whether it is, or that is not known yet; what is not is late if it turns out to be
  bool may_be_needed(Index h, Index o)
  {
    if(is_needed(h, o))
      return true;
    if(trail_ == nullptr)
      return false;
    trail_->follow_to(passed(h, o),
                      [this](Index g)
                      {
      is_drawn_[g / 3] = 1;
      if(faces_.opposite(g) != null_index)
        is_drawn_[faces_.opposite(g) / 3] = 1;
    });
    if(is_needed(h, o))
      return true;
    state_[(std::min)(h, o)] |= late;
    return false;
  }

  /// Around a spike windows come to the same halfedge many times.
  void add(Index h, Geodesic_window_list* list)
  {
    more_[h].add(list, [&](Geodesic_window_list* first, Geodesic_window_list* second)
                 { return joined(first, second, faces_.length(h)); });
  }

  /// all windows that have come to a halfedge, or null
  Geodesic_window_list* all(Index h)
  {
    const auto found = more_.find(h);
    if(found != more_.end())
    {
      const auto join = [&](Geodesic_window_list* first, Geodesic_window_list* second)
      { return joined(first, second, faces_.length(h)); };
      kept_[h] = join(kept_[h], found->second.release(join));
      more_.erase(found);
    }
    return std::exchange(kept_[h], nullptr);
  }

  /// the lower envelope of two lists, in place of them
  Geodesic_window_list* joined(Geodesic_window_list* first, Geodesic_window_list* second, double length)
  {
    Geodesic_window_list* both = geodesics_.allocate(4 * std::size_t(first->size() + second->size()));
    if(geodesics_.is_approximate())
      Geodesic_envelope<9>()(*first, *second, *both, length);
    else
      Geodesic_envelope<7>()(*first, *second, *both, length);
    geodesics_.release(first);
    geodesics_.release(second);
    return both;
  }

  bool is_needed(Index h, Index o) const { return is_drawn_[h / 3] || (o != null_index && is_drawn_[o / 3]); }

  // -- where the label changes -----------------------------------------------------------------------------------------

  void divide(Index h)
  {
    state_[h] |= divided;
    const Index o = faces_.opposite(h);
    Geodesic_window_list* along = o != null_index ? all(h) : nullptr;
    Geodesic_window_list* against = all(o != null_index ? o : h);
    const bool is_reached = geodesics_.is_reached(faces_.source(h)) && geodesics_.is_reached(faces_.target(h));
    if(is_reached)
      add_crossings(h, along, against);
    else
      state_[h] |= late; // nothing can be said of it yet
    for(Geodesic_window_list* list : {along, against})
      if(list != nullptr)
        geodesics_.release(list);
  }

  void add_crossings(Index h, Geodesic_window_list* along, Geodesic_window_list* against)
  {
    const std::vector<Edge_envelope::Piece>& pieces = envelope_(h, along, against);
    const Index first = static_cast<Index>(labels.size());
    for(const Edge_envelope::Piece& piece : pieces)
      labels.push_back(piece.label);
    ends.push_back({h, first, static_cast<Index>(labels.size() - 1)});
    longest_edge_ = parting_angle_.longest_edge_at(h);
    for(Index i = 1; i < pieces.size(); ++i)
      add_crossing(h, first + i - 1, pieces[i].begin, pieces[i - 1].label, pieces[i].label);
  }

  void add_crossing(Index h, Index label, double t, const Path_label& left, const Path_label& right)
  {
    const double angle = meeting_angle(left, right, t);
    const Parting_angle::Parting parting = parting_angle_.parting(left, right, t, angle);
    const bool is_seam = geodesics_.is_seam(left.origin, right.origin, angle);
    if(!geodesics_.is_approximate())
    {
      const double way = (std::min)(left.distance(t) - left.sigma, right.distance(t) - right.sigma);
      // or both sides of a shadow that is narrower here than windows are accurate: they come from one side, so that the
      // angle between them is not that of paths that meet
      const bool is_bend = angle < 0.5 * geodesic_pi && get_apart(left, right, t) &&
                           (parting.angle < Parting_angle::least_angle ||
                            parting.angle * way <= Edge_envelope::least_width * faces_.length(h));
      const bool is_shadow = is_seam || is_bend ||
                             Parting_angle::is_same_path(angle, parting, left.distance(t),
                                                         (std::max)(left.sigma, right.sigma), longest_edge_);
      crossings.push_back(edge_crossing(geodesics_, least_, h, label, t, left, right, parting, angle, is_shadow));
    }
    else if(!is_same_family(geodesics_, angle, parting.angle))
      crossings.push_back(edge_crossing(geodesics_, {}, h, label, t, left, right, parting, angle, false));
  }

public:
  /// whether two paths are one as far as distances with an error tell: what is less has not been told apart
  static bool is_same_family(const Geodesic_results& geodesics, double meeting, double parting)
  {
    return Parting_angle::is_same_path(meeting, parting) || (meeting < steep && parting < geodesics.merging_angle());
  }
  /// Beside a point where paths meet at less than that, the way to it is longer by less than that share of an edge.
  static constexpr double steep = 0.1;

private:
  Exact_geodesic_propagation& geodesics_;
  const Geodesic_faces& faces_;
  std::vector<unsigned char>& is_drawn_;
  Edge_envelope envelope_;
  Parting_angle parting_angle_;
  Branch_strength least_;
  double slack_, front_ = 0., longest_edge_ = 0.;         // the last at the edge in work
  std::vector<Geodesic_window_list*> kept_;               // by halfedge: the first list
  std::unordered_map<Index, Geodesic_window_lists> more_; // and others
  std::vector<unsigned char> state_;
  std::priority_queue<Waiting> waiting_; // edges with windows
  Halfedge_trail* trail_;
  std::size_t number_of_late_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_EDGE_CROSSINGS_H
