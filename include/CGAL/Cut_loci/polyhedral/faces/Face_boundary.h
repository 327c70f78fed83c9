// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_FACE_BOUNDARY_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_FACE_BOUNDARY_H

#include <CGAL/Cut_loci/polyhedral/faces/Face_ridges.h>
#include <CGAL/Cut_loci/polyhedral/labels/Edge_crossings.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_changes.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * reads where the label changes around a face, as `Face_ridges` needs it: as images in the plane of the face, which fit
 * each other from one edge to the next.
 */
class Face_boundary
{
public:
  /// where a change is: one of the two, or none at the boundary of a shadow
  struct Place
  {
    Index crossing = null_index; // of an edge of the face
    Index vertex = null_index;   // a branch ends there
    bool is_weak = true;         // see `Label_jumps::is_weak()`
    bool is_whole_edge = false;  // nothing changes there: while labels are compared
  };

  Face_boundary(const Indexed_triangle_mesh& mesh, const Geodesic_results& geodesics, const Label_changes& changes)
    : mesh_(&mesh), geodesics_(&geodesics), changes_(&changes)
  {
  }

  /// @param next_at_vertex of `Label_changes::at_vertices()`, the first one that is not before the face
  void read(Index f, std::size_t next_at_vertex)
  {
    face_ = f;
    corners_ = corners_of(geodesics_->faces(), f);
    local_changes_.clear();
    places_.clear();
    const std::vector<Vertex_labels::Change>& at_vertices = changes_->at_vertices();
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      for(; next_at_vertex < at_vertices.size() && at_vertices[next_at_vertex].halfedge == h; ++next_at_vertex)
        add_change_at_vertex(at_vertices[next_at_vertex]);
      add_changes_on_edge(h);
    }
    if(geodesics_->is_approximate())
      unite_families();
    else
      fit_labels_at_corners();
    if(!changes_->is_drawn_wholly(f))
      cut_off_weak_cells();
  }

  /// in the frame of the first halfedge of the face, as all that follows
  const std::array<Plane_point, 3>& corners() const { return corners_; }
  /// counterclockwise from the first corner
  const std::vector<Face_ridges::Change>& changes() const { return local_changes_; }
  /// those of the changes
  const std::vector<Place>& places() const { return places_; }
  /// of the changes, before those of a family become one; of exact distances there are none
  const std::vector<std::array<Image, 2>>& own_images() const { return own_images_; }

  /// all straight ways into the face
  const std::vector<Face_ridges::Entry>& entries()
  {
    entries_.clear();
    for(Index h = 3 * face_; h < 3 * face_ + 3; ++h)
    {
      const double length = geodesics_->faces().length(h);
      double last = 0.;
      Path_label label = changes_->label_at_begin(h);
      changes_->for_each_crossing(h,
                                  [&](Index c, bool is_reversed)
                                  {
        const double t = is_reversed ? length - (*changes_)[c].t : (*changes_)[c].t;
        add_entry(h, label_before(c, is_reversed), last, t);
        last = t;
        label = label_after(c, is_reversed);
      });
      add_entry(h, label, last, length);
    }
    add_entries_inside(face_);
    return entries_;
  }

  /// the angle at which the paths from two images to a point part
  double gap(const Image& a, const Image& b, const Plane_point& p) const
  {
    return parting(*geodesics_, a, b, p, corners_).angle;
  }

  /// whether the paths from two images to a point are one, in two pieces
  bool is_one_path(const Image& a, const Image& b, const Plane_point& p) const
  {
    if(is_seam(a, b, p))
      return true;
    return Parting_angle::is_same_path(meeting_angle(a, b, p), parting(*geodesics_, a, b, p, corners_), a.distance(p),
                                       (std::max)(a.sigma, b.sigma),
                                       Parting_angle(*geodesics_).longest_edge_at(3 * face_));
  }

  bool is_seam(const Image& a, const Image& b, const Plane_point& p) const
  {
    return geodesics_->is_seam(a.origin, b.origin, meeting_angle(a, b, p));
  }

private:
  /// from the frame of `h` to that of the first halfedge of its face
  Plane_point to_face(Index h, double x, double y) const
  {
    const Plane_point &p = corners_[h % 3], &q = corners_[(h + 1) % 3];
    const double l = geodesics_->faces().length(h), c = (q.x - p.x) / l, s = (q.y - p.y) / l;
    return {p.x + c * x - s * y, p.y + s * x + c * y};
  }

  /// the image of a label of `h`, which has paths to all of it, or at least to its begin
  Image image(Index h, const Path_label& label, bool is_of_edge = true) const
  {
    Plane_point p = to_face(h, label.x, label.y);
    fit_to_source(h, label, p);
    const double t = is_of_edge ? 0.5 * geodesics_->faces().length(h) : 0.;
    return {p.x, p.y, label.sigma, label.origin, label.direction(t), label.rate, h % 3, is_of_edge};
  }

  /// The image of one of several sources that is in the face is the source itself, from whichever edge it is seen.
  void fit_to_source(Index h, const Path_label& label, Plane_point& p) const
  {
    Plane_point source;
    if(geodesics_->number_of_sources() == 1 || !geodesics_->is_source(label.origin) ||
       !geodesics_->source_in_frame(label.origin, 3 * (h / 3), source))
      return;
    const double rounding = 1e-9 * geodesics_->faces().length(h); // as for two images
    if(std::fabs(p.x - source.x) + std::fabs(p.y - source.y) <= rounding)
      p = source;
  }

  /// The same for a label right beside the begin of `h`, which may come from any side. From there itself, it comes to all of `h`.
  Image image_at_vertex(Index h, const Path_label& label) const
  {
    return image(h, label, std::fabs(label.x) + std::fabs(label.y) <= 1e-9 * geodesics_->faces().length(h));
  }

  void add_change_at_vertex(const Vertex_labels::Change& c)
  {
    const Index v = mesh_->source(c.halfedge);
    const bool is_ray = c.is_shadow && !(geodesics_->is_line(c.before.origin) && geodesics_->is_line(c.after.origin));
    local_changes_.push_back({corners_[c.halfedge % 3], null_index, image_at_vertex(c.halfedge, c.before),
                              image_at_vertex(c.halfedge, c.after), is_ray, c.is_shadow});
    Place place;
    place.vertex = c.is_shadow ? null_index : v;
    place.is_weak = c.is_weak;
    places_.push_back(place);
  }

  /*
   * A path that passes several vertices on one line, as along an edge of the mesh, comes from the image of any of them.
   * At a corner, where the labels of the edges end, it may have been given different ones: a branch that starts there
   * takes those of the edges, or they change there.
   */
  void fit_labels_at_corners()
  {
    add_whole_edges();
    for(std::size_t i = 0; i < local_changes_.size(); ++i)
    {
      Face_ridges::Change &a = local_changes_[i], &b = local_changes_[i + 1 < local_changes_.size() ? i + 1 : 0];
      const Index corner = corner_between(a, b);
      if(is_same_image(a.after, b.before) || !is_one_path(a.after, b.before, corners_[corner]))
        continue;
      if(b.edge == null_index)
        b.before = a.after;
      else if(a.edge == null_index)
        a.after = b.before;
      else
        insert(i + 1, {corners_[corner], null_index, a.after, b.before, true, true}, Place());
    }
    remove_whole_edges();
  }

  /// Edges on which nothing changes have labels too: where those before and after them differ, such an edge becomes a change
  /// from its label to itself.
  void add_whole_edges()
  {
    for(std::size_t n = local_changes_.size(), i = n; i-- > 0;)
    {
      const Face_ridges::Change &a = local_changes_[i], &b = local_changes_[i + 1 < n ? i + 1 : 0];
      const Image after = a.after, before = b.before;
      if(is_same_image(after, before))
        continue;
      const Index begin = place(a) + 1;
      for(Index k = place(b) + (i + 1 < n ? 0 : 6); k-- > begin;)
        if(k % 2 == 1)
        {
          const Index edge = k % 6 / 2, h = 3 * face_ + edge;
          const Image label = image(h, changes_->label_at_begin(h));
          insert(i + 1, {corners_[edge], edge, label, label, false, false}, Place());
          places_[i + 1].is_whole_edge = true;
        }
    }
  }

  /// of two neighbors: the one they have in common
  Index corner_between(const Face_ridges::Change& a, const Face_ridges::Change& b) const
  {
    return a.edge == null_index ? corner_at(a.point) : b.edge == null_index ? corner_at(b.point) : b.edge;
  }

  void remove_whole_edges()
  {
    std::size_t number = 0;
    for(std::size_t i = 0; i < places_.size(); ++i)
      if(!places_[i].is_whole_edge)
      {
        local_changes_[number] = local_changes_[i];
        places_[number++] = places_[i];
      }
    local_changes_.resize(number);
    places_.resize(number);
  }

  void insert(std::size_t i, const Face_ridges::Change& change, const Place& place)
  {
    local_changes_.insert(local_changes_.begin() + static_cast<std::ptrdiff_t>(i), change);
    places_.insert(places_.begin() + static_cast<std::ptrdiff_t>(i), place);
  }

  /// around the face: corners are even, and edges odd
  Index place(const Face_ridges::Change& c) const
  {
    return c.edge == null_index ? 2 * corner_at(c.point) : 2 * c.edge + 1;
  }

  Index corner_at(const Plane_point& p) const
  {
    Index k = 0;
    while(k < 2 && (corners_[k].x != p.x || corners_[k].y != p.y))
      ++k;
    return k;
  }

  /*
   * A straight path that enters the face and leaves it is in one cell. So where the boundary comes back to a cell, on such
   * a path, and all changes since it has left it are weak, the path separates them from all that is strong, and nothing
   * there has to be drawn. What is left of weak changes are those of cells that may touch strong pieces.
   */
  void cut_off_weak_cells()
  {
    const std::size_t n = places_.size();
    std::size_t strong = 0;
    while(strong < n && places_[strong].is_weak)
      ++strong;
    left_.clear();
    std::size_t first = 0; // of those that are left: behind the last strong one
    for(std::size_t k = 0; k < n && strong < n; ++k)
    {
      const Index i = static_cast<Index>((strong + k) % n);
      const Left change{i, rays_behind(i)};
      if(!places_[i].is_weak)
        first = left_.size() + 1;
      else if(returns_to_cell(change, first))
        continue;
      left_.push_back(change);
    }
    const auto is_before = [](const Left& a, const Left& b) { return a.change < b.change; };
    std::sort(left_.begin(), left_.end(), is_before);
    for(std::size_t i = 0; i < left_.size(); ++i)
    {
      local_changes_[i] = local_changes_[left_[i].change];
      places_[i] = places_[left_[i].change];
    }
    local_changes_.resize(left_.size());
    places_.resize(left_.size());
  }

  /// the straight paths from an image, between two that lead to points of the face, counterclockwise
  struct Rays
  {
    Plane_point first, last;

    void add(const Image& image, const Plane_point& p)
    {
      if(cross(image.place(), first, p) < 0.)
        first = p;
      if(cross(image.place(), last, p) > 0.)
        last = p;
    }
    bool overlap(const Image& image, const Rays& other) const
    {
      return cross(image.place(), first, other.last) > 0. && cross(image.place(), other.first, last) > 0.;
    }
  };

  /// a change that is left, and the paths to the cell behind it, as far as the cell is known
  struct Left
  {
    Index change;
    Rays rays;
  };

  /// to the part of the boundary between a change and the next one
  Rays rays_behind(Index i) const
  {
    const Face_ridges::Change &a = local_changes_[i], &b = local_changes_[i + 1 < local_changes_.size() ? i + 1 : 0];
    Rays result{a.point, a.point};
    const Index last = edge_of(b);
    for(Index k = edge_of(a); k != last;)
    {
      k = (k + 1) % 3;
      result.add(a.after, corners_[k]);
    }
    result.add(a.after, b.point);
    return result;
  }

  Index edge_of(const Face_ridges::Change& c) const { return c.edge == null_index ? corner_at(c.point) : c.edge; }

  /// takes away the changes since the boundary has left the cell behind a change, if that has not been long ago
  bool returns_to_cell(const Left& change, std::size_t first)
  {
    constexpr std::size_t most = 32; // of the cells that end between two edges there are few
    const Image& image = local_changes_[change.change].after;
    for(std::size_t size = left_.size(); size >= first && size + most > left_.size(); --size)
    {
      Left& cell = left_[size - 1];
      if(!is_same_image(local_changes_[cell.change].after, image) || !cell.rays.overlap(image, change.rays))
        continue;
      cell.rays.add(image, change.rays.first);
      cell.rays.add(image, change.rays.last);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(size), left_.end());
      return true;
    }
    return false;
  }

  /*
   * Where windows have been merged, paths that belong together have different images on the edges of a face, and these fit
   * each other up to the error of the distance. All of a family, between two changes and the next ones, get the image of
   * its first part of the boundary.
   */
  void unite_families()
  {
    const std::size_t n = local_changes_.size();
    own_images_.clear();
    for(const Face_ridges::Change& c : local_changes_)
      own_images_.push_back({{c.before, c.after}});
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t next = i + 1 < n ? i + 1 : 0;
      const Plane_point p = local_changes_[i].point;
      const Image own = local_changes_[i].after;
      Image* const last = i > 0 ? &local_changes_[i - 1].after : nullptr;
      for(std::size_t k = 0; k + 1 < i; ++k)
      {
        const Image& other = local_changes_[k].after;
        if(!is_same_image(other, *last) && are_one_family(own, other, p) &&
           (next != 0 || !is_same_image(other, local_changes_[0].after)))
        {
          local_changes_[i].after = other;
          break;
        }
      }
      local_changes_[next].before = local_changes_[i].after;
    }
  }

  bool are_one_family(const Image& a, const Image& b, const Plane_point& p) const
  {
    return Edge_crossings::is_same_family(*geodesics_, meeting_angle(a, b, p), gap(a, b, p));
  }

  /// whether both paths come along one line, if not quite: where the waves of a curve's edge and of its end touch, they do
  /// so over the square root of the rounding, and beside the vertex that casts a shadow both of its sides are one
  bool is_ray(Index c) const
  {
    const bool are_lines =
      geodesics_->is_line(changes_->left(c).origin) && geodesics_->is_line(changes_->right(c).origin);
    return (*changes_)[c].angle < Parting_angle::least_angle || ((*changes_)[c].is_shadow && !are_lines);
  }

  void add_changes_on_edge(Index h)
  {
    const double length = geodesics_->faces().length(h);
    Index known = null_index; // the label behind the last crossing
    changes_->for_each_crossing(h,
                                [&](Index c, bool is_reversed)
                                {
      const Edge_crossing& crossing = (*changes_)[c];
      const double t = is_reversed ? length - crossing.t : crossing.t;
      const Image before = crossing.label + Index(is_reversed) == known ? local_changes_.back().after
                                                                        : image(h, label_before(c, is_reversed));
      known = crossing.label + Index(!is_reversed);
      local_changes_.push_back({to_face(h, t, 0.), h % 3, before, image(h, label_after(c, is_reversed)), is_ray(c),
                                crossing.is_shadow, geodesics_->is_approximate() ? crossing.gap : 0.});
      Place place;
      place.crossing = crossing.is_shadow ? null_index : c;
      place.is_weak = crossing.is_weak;
      places_.push_back(place);
    });
  }

  /// the labels of a crossing as one goes around the face
  Path_label label_before(Index c, bool is_reversed) const
  {
    return is_reversed ? changes_->right(c).opposite(length_at(c)) : changes_->left(c);
  }
  Path_label label_after(Index c, bool is_reversed) const
  {
    return is_reversed ? changes_->left(c).opposite(length_at(c)) : changes_->right(c);
  }
  double length_at(Index c) const { return geodesics_->faces().length((*changes_)[c].halfedge); }

  void add_entry(Index h, const Path_label& label, double from, double to)
  {
    if(label.from_face && label.y > 0.)
      return;
    entries_.push_back({image(h, label), to_face(h, from, 0.), to_face(h, to, 0.)});
  }

  /// paths through a corner, and from a source in the face
  void add_entries_inside(Index f)
  {
    for(Index i = 0; i < 3; ++i)
    {
      const Index v = mesh_->triangles[f][i], origin = geodesics_->origin_of_vertex(v);
      const double d = geodesics_->distance(v);
      entries_.push_back({{corners_[i].x, corners_[i].y, d, origin, 0, 0.}, corners_[i], corners_[i]});
    }
    for(Index i = 0; i < geodesics_->number_of_sources(); ++i)
    {
      Plane_point p;
      if(geodesics_->source_in_frame(i, 3 * f, p))
        entries_.push_back({{p.x, p.y, 0., i, 0, 0.}, p, p});
    }
  }

  const Indexed_triangle_mesh* mesh_;
  const Geodesic_results* geodesics_;
  const Label_changes* changes_;
  // of the face in work
  Index face_ = null_index;
  std::array<Plane_point, 3> corners_;
  std::vector<Face_ridges::Change> local_changes_;
  std::vector<Face_ridges::Entry> entries_;
  std::vector<Place> places_;
  std::vector<std::array<Image, 2>> own_images_;
  std::vector<Left> left_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_FACE_BOUNDARY_H
