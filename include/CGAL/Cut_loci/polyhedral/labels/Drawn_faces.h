// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_DRAWN_FACES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_DRAWN_FACES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/labels/Halfedge_trail.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_jumps.h>
#include <CGAL/Cut_loci/polyhedral/labels/Vertex_labels.h>

#include <algorithm>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * finds, while the windows are propagated, the faces in which the cut locus has to be drawn: those with an edge on which
 * the label changes by as much as a branch of the least strength needs, and those that link such faces, where it changes
 * by half as much.
 *
 * It is an observer of `Exact_geodesic_propagation`, and keeps no windows. Which faces matter is known at the end only:
 * `Edge_crossings` gets the windows of their edges from a second run. Which ones may matter is known as soon as all windows
 * have come to their edges, so that the second run may follow the first one in another thread.
 */
class Drawn_faces : public Geodesic_window_observer
{
public:
  /// by face: 0; 1, if what is weak is left away where that is possible; or `wholly`, which the topology may ask for
  std::vector<unsigned char> is_drawn;
  static constexpr unsigned char wholly = 2;
  /// for other edges, by halfedge of smaller index: see `Label_jumps::bend()`
  std::vector<float> bend;

  /// @param trail gets the halfedges beside faces that may matter
  Drawn_faces(Exact_geodesic_propagation& geodesics, const Branch_strength& least, Halfedge_trail& trail)
    : is_drawn(geodesics.faces().number_of_halfedges() / 3, 0), bend(geodesics.faces().number_of_halfedges(), 0.f),
      geodesics_(geodesics), faces_(geodesics.faces()), at_vertices_(geodesics),
      jumps_(geodesics, at_vertices_, least, 1.),
      weak_jumps_(geodesics, at_vertices_, least, Label_jumps::linking_share),
      is_crossed_(faces_.number_of_halfedges(), 0), is_weak_(faces_.number_of_halfedges(), 0), trail_(trail)
  {
  }

  void advance(double front) override { trail_.advance(front); }

  bool take(Index h, Geodesic_window_list& list) override
  {
    const Index o = faces_.opposite(h);
    is_crossed_[h] = 1;
    if(is_drawn[h / 3] && is_drawn[o / 3])
      return false;
    unsigned char& is_weak = is_weak_[(std::min)(h, o)];
    if(!is_weak)
    {
      is_weak = has_jump(weak_jumps_, h, o, list);
      if(is_weak)
        trail_.add(h);
    }
    if(is_weak && has_jump(jumps_, h, o, list))
      is_drawn[h / 3] = is_drawn[o / 3] = 1;
    return false;
  }

  /// see `Exact_geodesic_propagation::run()`
  void take_on_border(Index h, Geodesic_window_list* list) override
  {
    jumps_.start(faces_.target(h), faces_.source(h), faces_.length(h)); // in the frame of the opposite
    if(!is_drawn[h / 3] &&
       (geodesics_.is_approximate() ? has_jump_on_border<9>(h, *list) : has_jump_on_border<7>(h, *list)))
    {
      is_drawn[h / 3] = 1;
      trail_.add(h);
    }
    geodesics_.release(list);
  }

  /// the end of the propagation: adds the faces that link others, which are left of those with weak jumps when the ends of
  /// what these link have been taken away
  void finish()
  {
    std::vector<unsigned char> number(is_drawn.size(), 0);
    std::vector<Index> ends;
    for(Index f = 0; f < is_drawn.size(); ++f)
    {
      for_each_weak_neighbor(f, [&](Index) { ++number[f]; });
      if(!is_drawn[f] && number[f] == 1)
        ends.push_back(f);
    }
    while(!ends.empty())
    {
      const Index end = ends.back();
      ends.pop_back();
      number[end] = 0;
      for_each_weak_neighbor(end,
                             [&](Index f)
                             {
        if(!is_drawn[f] && number[f] > 0 && --number[f] == 1)
          ends.push_back(f);
      });
    }
    for(Index f = 0; f < is_drawn.size(); ++f)
      is_drawn[f] = is_drawn[f] || number[f] > 0;
  }

private:
  template <typename Function>
  void for_each_weak_neighbor(Index f, const Function& function) const
  {
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index o = faces_.opposite(h);
      if(o != null_index && is_weak_[(std::min)(h, o)])
        function(o / 3);
    }
  }

  bool has_jump(Label_jumps& jumps, Index h, Index o, const Geodesic_window_list& list)
  {
    jumps.start(faces_.source(h), faces_.target(h), faces_.length(h));
    return geodesics_.is_approximate() ? has_jump<9>(jumps, h, o, list) : has_jump<7>(jumps, h, o, list);
  }

  template <int columns>
  bool has_jump(const Label_jumps& jumps, Index h, Index o, const Geodesic_window_list& list)
  {
    const bool is_second = is_crossed_[o] || geodesics_.waits(o);
    return jumps.between_windows<columns>(list) || has_jump_at_end<columns>(jumps, list, h, o) ||
           (is_second && jumps.is_mirrored(list.get<columns>(list.begin), list.get<columns>(list.end - 1)));
  }

  template <int columns>
  bool has_jump_on_border(Index h, const Geodesic_window_list& list)
  {
    return jumps_.between_windows<columns>(list) || has_jump_at_end<columns>(jumps_, list, h, h);
  }

  template <int columns>
  bool has_jump_at_end(const Label_jumps& jumps, const Geodesic_window_list& list, Index h, Index o)
  {
    const Geodesic_window first = list.get<columns>(list.begin), last = list.get<columns>(list.end - 1);
    if(jumps.at_ends(first, last))
      return true;
    float& known = bend[(std::min)(h, o)];
    known = (std::max)(known, static_cast<float>(jumps.bend(first, last)));
    return false;
  }

  Exact_geodesic_propagation& geodesics_;
  const Geodesic_faces& faces_;
  Vertex_labels at_vertices_;
  Label_jumps jumps_, weak_jumps_;
  std::vector<unsigned char> is_crossed_; // by halfedge: whether windows have come to it
  std::vector<unsigned char> is_weak_;    // by that of smaller index: whether a jump is half as large as needed
  Halfedge_trail& trail_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_DRAWN_FACES_H
