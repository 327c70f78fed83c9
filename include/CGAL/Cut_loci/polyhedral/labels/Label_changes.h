// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_LABEL_CHANGES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_LABEL_CHANGES_H

#include <CGAL/Cut_loci/internal/Growing_list.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/polyhedral/labels/Drawn_faces.h>
#include <CGAL/Cut_loci/polyhedral/labels/Edge_crossings.h>
#include <CGAL/Cut_loci/polyhedral/labels/Vertex_labels.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * lists for each edge of the mesh where its label changes, and for each vertex where that of the faces around it does.
 *
 * A vertex that several shortest paths reach has the label of one of them; the others start behind a crossing at the
 * end of an edge. So the cut locus never runs through a vertex, but beside it, by nothing.
 */
class Label_changes
{
public:
  Label_changes() = default;

  /// @param is_drawn by face, see `Drawn_faces::is_drawn`
  /// @param bend by halfedge, or empty
  /// @param least what is weaker is told from the rest
  Label_changes(const Mesh_connectivity& connectivity, const Geodesic_results& geodesics, Edge_crossings& found,
                std::vector<unsigned char> is_drawn, std::vector<float> bend, const Branch_strength& least,
                const Progress& progress = {})
    : connectivity_(&connectivity), geodesics_(&geodesics), least_(least), is_drawn_(std::move(is_drawn)),
      bend_(std::move(bend))
  {
    const Vertex_labels labels(geodesics);
    std::swap(crossings_, found.crossings);
    std::swap(labels_, found.labels);
    for(std::size_t i = 0; i < found.ends.size(); ++i)
      ends_.push_back(found.ends[i]);
    std::sort(ends_.begin(), ends_.end(),
              [](const Edge_ends& a, const Edge_ends& b) { return a.halfedge < b.halfedge; });
    add_crossings_at_ends(labels, progress.part(0., 0.5));
    sort(progress.part(0.5, 0.8));
    find_changes_at_vertices(labels, progress.part(0.8, 1.));
  }

  /// all crossings: those of edge `e` are `first(e)`, ..., `first(e + 1) - 1`, in order
  const Edge_crossing& operator[](std::size_t i) const { return crossings_[order_[i]]; }
  /// the labels before and behind a crossing, in the frame of its halfedge
  const Path_label& left(std::size_t i) const { return labels_[(*this)[i].label]; }
  const Path_label& right(std::size_t i) const { return labels_[(*this)[i].label + std::size_t(1)]; }
  Index number_of_crossings() const { return static_cast<Index>(crossings_.size()); }
  Index first(Index e) const { return first_[e]; }
  /// calls `function(c, is_reversed)` for the crossings of a halfedge, in its order
  template <typename Function>
  void for_each_crossing(Index h, const Function& function) const
  {
    const Index e = connectivity_->edge_of_halfedge[h];
    const Index begin = first(e), end = first(e + 1);
    if(connectivity_->halfedge_of_edge[e] == h)
      for(Index c = begin; c < end; ++c)
        function(c, false);
    else
      for(Index c = end; c-- > begin;)
        function(c, true);
  }

  /// the label at the begin of a halfedge of a face that is drawn
  Path_label label_at_begin(Index h) const
  {
    const Index first = connectivity_->halfedge_of_edge[connectivity_->edge_of_halfedge[h]];
    const auto ends = std::lower_bound(ends_.begin(), ends_.end(), first,
                                       [](const Edge_ends& a, Index halfedge) { return a.halfedge < halfedge; });
    return first == h ? labels_[ends->first] : labels_[ends->last].opposite(geodesics_->faces().length(h));
  }

  /// whether all that changes in a face, and on its edges, is known
  bool is_drawn(Index f) const { return is_drawn_[f] != 0; }
  /// whether also what is weak is drawn there
  bool is_drawn_wholly(Index f) const
  {
    return is_drawn_[f] == Drawn_faces::wholly || least_.is_none() || geodesics_->is_approximate();
  }
  const std::vector<unsigned char>& drawn_faces() const { return is_drawn_; }
  /// the angle that may be between the paths to the two ends of an edge of which nothing is known
  float bend(Index h) const { return bend_.empty() ? 0.f : bend_[h]; }

  /// the changes at vertices, by their halfedge
  const std::vector<Vertex_labels::Change>& at_vertices() const { return at_vertices_; }

  /// Frees the memory of the labels, once all faces have been drawn, and of crossings at which no piece ends, but for one
  /// between two others: where the most is left away.
  /// @return the new numbers
  std::vector<Index> forget_all_but(const std::vector<unsigned char>& is_kept)
  {
    labels_ = Growing_list<Path_label>();
    ends_ = std::vector<Edge_ends>();
    std::vector<Index> result(crossings_.size(), null_index);
    Growing_list<Edge_crossing> crossings;
    const auto keep = [&](Index c)
    {
      result[c] = static_cast<Index>(crossings.size());
      crossings.push_back((*this)[c]);
    };
    for(std::size_t e = 0; e + 1 < first_.size(); ++e)
    {
      const Index begin = std::exchange(first_[e], static_cast<Index>(crossings.size()));
      Index widest = null_index;
      for(Index c = begin; c <= first_[e + 1]; ++c)
      {
        const bool is_end = c == first_[e + 1];
        if(widest != null_index && (is_end || is_kept[c]))
          keep(std::exchange(widest, null_index));
        if(is_end)
          break;
        if(is_kept[c])
          keep(c);
        else if(!(*this)[c].is_shadow &&
                (widest == null_index || (*this)[widest].larger_angle() < (*this)[c].larger_angle()))
          widest = c;
      }
    }
    first_.back() = static_cast<Index>(crossings.size());
    crossings_ = std::move(crossings);
    order_.resize(crossings_.size());
    std::iota(order_.begin(), order_.end(), Index(0));
    return result;
  }

  /// frees that of all else but which faces are drawn
  void forget_crossings()
  {
    crossings_ = Growing_list<Edge_crossing>();
    order_ = std::vector<Index>();
    first_ = std::vector<Index>();
    at_vertices_ = std::vector<Vertex_labels::Change>();
    bend_ = std::vector<float>();
  }

private:
  void add_crossings_at_ends(const Vertex_labels& labels, const Progress& progress)
  {
    for(std::size_t i = 0; i < ends_.size(); ++i)
    {
      progress(i, ends_.size());
      const Index h = ends_[i].halfedge;
      const Path_label first = labels_[ends_[i].first], last = labels_[ends_[i].last];
      add_crossing_at_end(h, 0., labels.at_source(h), first, geodesics_->faces().source(h), labels);
      add_crossing_at_end(h, geodesics_->faces().length(h), last, labels.at_target(h), geodesics_->faces().target(h),
                          labels);
    }
  }

  /// if the label of an edge is not that of the vertex `v` at which it ends
  void add_crossing_at_end(Index h, double t, const Path_label& left, const Path_label& right, Index v,
                           const Vertex_labels& labels)
  {
    if(geodesics_->is_on_line(v))
      add_crossing_at_line(h, t, left, right);
    if(geodesics_->distance(v) == 0.)
      return;
    const Path_label& label = t == 0. ? right : left;
    if(label.origin == geodesics_->origin_of_vertex(v))
      return; // it comes through the vertex
    const Geodesic_arrival& arrival = geodesics_->arrival(v);
    const double angle = meeting_angle(left, right, t);
    const Parting_angle::Parting parting =
      Parting_angle(*geodesics_)
        .parting(arrival.origin, labels.direction_at_origin(v), label.origin, label.direction(t), angle);
    if(geodesics_->is_seam(arrival.origin, label.origin, angle))
      return;
    const double sigma = (std::max)(geodesics_->sigma_of_origin(arrival.origin), label.sigma);
    if(geodesics_->is_approximate() ? !Edge_crossings::is_same_family(*geodesics_, angle, parting.angle)
                                    : !Parting_angle::is_same_path(angle, parting, geodesics_->distance(v), sigma,
                                                                   Parting_angle(*geodesics_).longest_edge_at(h)))
      add_crossing(h, t, left, right, parting, angle);
  }

  /// where lines meet, and the branch between them runs along an edge
  void add_crossing_at_line(Index h, double t, const Path_label& left, const Path_label& right)
  {
    const double angle = meeting_angle(left, right, t);
    const Parting_angle::Parting parting = Parting_angle(*geodesics_).parting(left, right, t, angle);
    if(left.origin != right.origin && !geodesics_->is_seam(left.origin, right.origin, angle) &&
       !Parting_angle::is_same_path(angle, parting.angle))
      add_crossing(h, t, left, right, parting, angle);
  }

  void add_crossing(Index h, double t, const Path_label& left, const Path_label& right,
                    const Parting_angle::Parting& parting, double angle)
  {
    crossings_.push_back(
      edge_crossing(*geodesics_, least_, h, static_cast<Index>(labels_.size()), t, left, right, parting, angle, false));
    labels_.push_back(left);
    labels_.push_back(right);
  }

  void sort(const Progress& progress)
  {
    const Progress counting = progress.part(0., 0.3), numbering = progress.part(0.3, 0.6),
                   in_edges = progress.part(0.6, 1.);
    const std::vector<Index>& edge = connectivity_->edge_of_halfedge;
    first_.assign(connectivity_->number_of_edges() + std::size_t(1), 0);
    for(std::size_t i = 0; i < crossings_.size(); ++i)
    {
      counting(i, crossings_.size());
      ++first_[edge[crossings_[i].halfedge] + std::size_t(1)];
    }
    for(std::size_t e = 0; e + 1 < first_.size(); ++e)
      first_[e + 1] += first_[e];
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    order_.resize(crossings_.size());
    for(Index i = 0; i < crossings_.size(); ++i)
    {
      numbering(i, crossings_.size());
      order_[next[edge[crossings_[i].halfedge]]++] = i;
    }
    // they come in order, but for those at the ends
    const auto is_before = [this](Index a, Index b) { return crossings_[a].t < crossings_[b].t; };
    for(std::size_t e = 0; e + 1 < first_.size(); ++e)
    {
      in_edges(e, first_.size());
      const auto begin = order_.begin() + first_[e], end = order_.begin() + first_[e + 1];
      if(!std::is_sorted(begin, end, is_before))
        std::stable_sort(begin, end, is_before);
    }
  }

  void find_changes_at_vertices(const Vertex_labels& labels, const Progress& progress)
  {
    const Geodesic_faces& faces = geodesics_->faces();
    // as `Edge_crossings::is_same_family()`, for the crossings behind the vertex
    const double least = geodesics_->is_approximate() ? Edge_crossings::steep : 1e-7;
    std::vector<unsigned char> is_done(faces.number_of_vertices(), 0);
    for(Index h = 0; h < faces.number_of_halfedges(); ++h)
    {
      progress(h, faces.number_of_halfedges());
      const Index v = faces.source(h);
      if(is_done[v] || !is_drawn(h / 3))
        continue;
      is_done[v] = 1;
      if(faces.is_tip(v, least) || faces.is_pseudo_source(v) || geodesics_->is_on_line(v))
        for(Vertex_labels::Change& c : labels.changes(v))
          if(is_drawn(c.halfedge / 3))
          {
            const double angle = meeting_angle(c.before, c.after, 0.);
            c.is_weak = Label_jumps::is_weak(least_, Parting_angle(*geodesics_).parting(c.before, c.after, 0., angle),
                                             angle, geodesics_->distance(v));
            at_vertices_.push_back(c);
          }
    }
    std::stable_sort(at_vertices_.begin(), at_vertices_.end(),
                     [](const Vertex_labels::Change& a, const Vertex_labels::Change& b)
                     { return a.halfedge < b.halfedge; });
  }

  const Mesh_connectivity* connectivity_ = nullptr;
  const Geodesic_results* geodesics_ = nullptr;
  Branch_strength least_;
  Growing_list<Edge_crossing> crossings_;
  Growing_list<Path_label> labels_;
  std::vector<Edge_ends> ends_; // by halfedge, of the edges of all faces that are drawn
  std::vector<Index> order_;    // of the crossings, by edge and position
  std::vector<Index> first_;    // in that order, by edge
  std::vector<Vertex_labels::Change> at_vertices_;
  std::vector<unsigned char> is_drawn_; // by face
  std::vector<float> bend_;             // by halfedge
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_LABEL_CHANGES_H
