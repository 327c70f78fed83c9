// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_RIDGES_H
#define CGAL_CUT_LOCI_EXACT_TREE_RIDGES_H

#include <CGAL/Cut_loci/exact_tree/Edge_crossings.h>
#include <CGAL/Cut_loci/exact_tree/Face_ridges.h>
#include <CGAL/Cut_loci/exact_tree/Label_changes.h>
#include <CGAL/Cut_loci/exact_tree/Path_label.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * holds the pieces of the cut locus in all faces that it crosses, in trees.
 *
 * In each such face the crossings of its edges, counterclockwise, are the leaves of its trees; further leaves are
 * vertices at which a branch ends.
 */
class Ridges
{
public:
  struct Node
  {
    Plane_point point;           // in the frame of the first halfedge of the face
    Index crossing = null_index; // of an edge of the face
    Index vertex = null_index;   // a branch ends there
    Index tree = null_index;     // of the face, or null if no tree reaches the boundary from here
    double distance = 0.;
  };

  struct Piece
  {
    Index nodes[2]; // numbers in the face
    Image images[2];
    double gaps[2];   // at the nodes: the angle at which the two paths part
    Index first_node; // of the face
    bool is_bisector; // whether it follows the bisector of the images, and not a straight line for want of a better one
  };

  struct Face
  {
    Index face;
    Index first_node, number_of_crossings; // the nodes of crossings come first, counterclockwise
    Index end_node, first_piece, end_piece;
    Index number_of_trees;
  };

  /// a crossing on the boundary of a face, as one goes around the face
  struct Crossing_on_face
  {
    Index crossing;
    Index corner; // where its edge starts
    bool is_reversed;
  };

  Ridges() = default;

  Ridges(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Geodesic_results& geodesics,
         const Label_changes& changes, const Threads& threads = {}, const Progress& progress = {})
    : mesh_(&mesh), connectivity_(&connectivity), geodesics_(&geodesics), changes_(&changes)
  {
    constexpr std::size_t block = 128; // faces, which take some milliseconds where they have hundreds of crossings
    std::vector<Index> drawn;
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
      if(changes.is_drawn(f))
        drawn.push_back(f);
    const std::size_t number = (drawn.size() + block - 1) / block;
    std::vector<Ridges> parts(number, empty_copy());
    for(std::size_t first = 0; first < number; first += threads.number_at_once())
    {
      progress(0.8 * static_cast<double>(first) / static_cast<double>(number));
      threads.run((std::min)(threads.number_at_once(), number - first),
                  [&](std::size_t i)
                  {
        const std::size_t begin = (first + i) * block;
        parts[first + i].add_faces(drawn, begin, (std::min)(begin + block, drawn.size()));
      });
    }
    append(parts, progress.part(0.8, 1.));
  }

  const std::vector<Face>& faces() const { return faces_; }
  /// the number of faces in which labels did not fit each other
  Index number_of_doubtful() const { return number_of_doubtful_; }
  const Node& node(const Face& f, Index i) const { return nodes_[f.first_node + i]; }
  const Piece& piece(std::size_t i) const { return pieces_[i]; }
  /// an end of a piece, in the frame of the first halfedge of its face
  Plane_point piece_end(std::size_t i, int end) const
  {
    return nodes_[pieces_[i].first_node + pieces_[i].nodes[end]].point;
  }

  /// the larger one of the angles at which the paths to the ends of a piece meet
  double meeting_angle(std::size_t i) const
  {
    double result = 0.;
    for(int end : {0, 1})
    {
      const Plane_point p = piece_end(i, end);
      const Image &a = pieces_[i].images[0], &b = pieces_[i].images[1];
      result = (std::max)(result, angle_between(a.x - p.x, a.y - p.y, b.x - p.x, b.y - p.y));
    }
    return result;
  }

  /// the corners of a face in the frame of its first halfedge
  std::array<Plane_point, 3> layout(Index f) const
  {
    return {{{0., 0.}, {geodesics_->faces().length(3 * f), 0.}, geodesics_->faces().apex(3 * f)}};
  }

  /// the crossings that are on the cut locus, counterclockwise from the first corner
  void crossings_around(Index f, std::vector<Crossing_on_face>& result) const
  {
    result.clear();
    for(Index i = 0; i < 3; ++i)
      for_each_crossing(3 * f + i,
                        [&](Index c, bool is_reversed)
                        {
        if(!(*changes_)[c].is_shadow)
          result.push_back({c, i, is_reversed});
      });
  }

private:
  // with the same mesh and changes, and no face
  Ridges empty_copy() const
  {
    Ridges result;
    result.mesh_ = mesh_;
    result.connectivity_ = connectivity_;
    result.geodesics_ = geodesics_;
    result.changes_ = changes_;
    return result;
  }

  void add_faces(const std::vector<Index>& drawn, std::size_t begin, std::size_t end)
  {
    const std::vector<Vertex_labels::Change>& at_vertices = changes_->at_vertices();
    const auto is_before = [](const Vertex_labels::Change& c, Index h) { return c.halfedge < h; };
    std::size_t next_at_vertex = static_cast<std::size_t>(
      std::lower_bound(at_vertices.begin(), at_vertices.end(), 3 * drawn[begin], is_before) - at_vertices.begin());
    for(std::size_t i = begin; i < end; ++i)
    {
      const Index f = drawn[i];
      while(next_at_vertex < at_vertices.size() && at_vertices[next_at_vertex].halfedge < 3 * f)
        ++next_at_vertex;
      if(has_crossings(f) || has_two_ends(f, next_at_vertex))
        add_face(f, next_at_vertex);
    }
  }

  /// all at the end, when their sizes are known: growing would copy them, and take long at once
  void append(std::vector<Ridges>& parts, const Progress& progress)
  {
    std::size_t nodes = 0, pieces = 0, faces = 0;
    for(const Ridges& part : parts)
    {
      nodes += part.nodes_.size();
      pieces += part.pieces_.size();
      faces += part.faces_.size();
    }
    nodes_.reserve(nodes);
    pieces_.reserve(pieces);
    faces_.reserve(faces);
    for(std::size_t i = 0; i < parts.size(); ++i)
    {
      progress(static_cast<double>(i) / static_cast<double>(parts.size()));
      append(parts[i]);
      parts[i] = Ridges();
    }
  }

  void append(const Ridges& part)
  {
    const Index nodes = static_cast<Index>(nodes_.size()), pieces = static_cast<Index>(pieces_.size());
    nodes_.insert(nodes_.end(), part.nodes_.begin(), part.nodes_.end());
    for(Piece piece : part.pieces_)
    {
      piece.first_node += nodes;
      pieces_.push_back(piece);
    }
    for(Face face : part.faces_)
    {
      face.first_node += nodes;
      face.end_node += nodes;
      face.first_piece += pieces;
      face.end_piece += pieces;
      faces_.push_back(face);
    }
    number_of_doubtful_ += part.number_of_doubtful_;
  }

  bool has_crossings(Index f) const
  {
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index e = connectivity_->edge_of_halfedge[h];
      for(Index c = changes_->first(e); c < changes_->first(e + 1); ++c)
        if(!(*changes_)[c].is_shadow)
          return true;
    }
    return false;
  }

  /// whether two branches end at vertices of the face: it may be one and the same
  bool has_two_ends(Index f, std::size_t next_at_vertex) const
  {
    const std::vector<Vertex_labels::Change>& at_vertices = changes_->at_vertices();
    int number = 0;
    for(; next_at_vertex < at_vertices.size() && at_vertices[next_at_vertex].halfedge < 3 * f + 3; ++next_at_vertex)
      number += !at_vertices[next_at_vertex].is_shadow;
    return number > 1;
  }

  template <typename Function>
  void for_each_crossing(Index h, const Function& function) const
  {
    const Index e = connectivity_->edge_of_halfedge[h];
    const Index begin = changes_->first(e), end = changes_->first(e + 1);
    if(connectivity_->halfedge_of_edge[e] == h)
      for(Index c = begin; c < end; ++c)
        function(c, false);
    else
      for(Index c = end; c-- > begin;)
        function(c, true);
  }

  /// from the frame of `h` to that of the first halfedge of its face
  Plane_point to_face(Index h, double x, double y) const
  {
    const Plane_point &p = corners_[h % 3], &q = corners_[(h + 1) % 3];
    const double l = geodesics_->faces().length(h), c = (q.x - p.x) / l, s = (q.y - p.y) / l;
    return {p.x + c * x - s * y, p.y + s * x + c * y};
  }

  /// the image of a label of `h`
  Image image(Index h, const Path_label& label) const
  {
    Plane_point p = to_face(h, label.x, label.y);
    fit_to_source(h, label, p);
    const Index axis = h % 3 + (label.from_face ? 3 : 0);
    const double direction = label.turn + label.rate * (label.from_face ? -0.5 : 0.5) * geodesic_pi;
    return {p.x, p.y, label.sigma, label.origin, static_cast<unsigned char>(axis), direction, label.rate};
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

  /// the same for a label right beside the begin of `h`, which may come from any side
  Image image_at_vertex(Index h, const Path_label& label) const
  {
    Image result = image(h, label);
    result.direction += label.direction(0.) - result.direction_to(corners_[h % 3], corners_);
    return result;
  }

  void add_face(Index f, std::size_t next_at_vertex)
  {
    corners_ = layout(f);
    local_changes_.clear();
    nodes_of_changes_.clear();
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
    const double size = (std::max)({geodesics_->faces().length(3 * f), geodesics_->faces().length(3 * f + 1),
                                    geodesics_->faces().length(3 * f + 2)});
    // a path that is wrong by an angle is too long by the angle times its way through the face, at most
    drawing_.draw(
      corners_, local_changes_, (std::max)(1e-8, geodesics_->merging_angle()) * size,
      [this, f]() -> const std::vector<Face_ridges::Entry>& { return entries(f); },
      [this](const Image& a, const Image& b, const Plane_point& p, bool are_on_line)
      { return are_on_line ? gap(a, b, p) < 1e-7 : is_seam(a, b, p); });
    number_of_doubtful_ += drawing_.is_doubtful;
    store(f);
  }

  void add_change_at_vertex(const Vertex_labels::Change& c)
  {
    const Index v = mesh_->source(c.halfedge);
    const bool is_ray = c.is_shadow && !(geodesics_->is_line(c.before.origin) && geodesics_->is_line(c.after.origin));
    local_changes_.push_back({corners_[c.halfedge % 3], null_index, image_at_vertex(c.halfedge, c.before),
                              image_at_vertex(c.halfedge, c.after), is_ray, c.is_shadow});
    Node node;
    node.vertex = c.is_shadow ? null_index : v;
    nodes_of_changes_.push_back(node);
  }

  /*
   * A path that passes several vertices on one line, as along an edge of the mesh, comes from the image of any of them.
   * At a corner, where the labels of the edges end, it may have been given different ones: they become the same, that
   * of the edge, or change there.
   */
  void fit_labels_at_corners()
  {
    for(std::size_t i = 0; i < local_changes_.size(); ++i)
    {
      const std::size_t next = i + 1 < local_changes_.size() ? i + 1 : 0;
      Face_ridges::Change &a = local_changes_[i], &b = local_changes_[next];
      if(is_same_image(a.after, b.before))
        continue;
      const Plane_point end = a.edge == null_index ? a.point : corners_[(a.edge + 1) % 3];
      const Plane_point begin = b.edge == null_index ? b.point : corners_[b.edge];
      // An edge of a curve has one label: that of the change at its corner.
      const bool has_line_between = geodesics_->has_lines() && (a.edge == null_index) != (b.edge == null_index) &&
                                    (end.x != begin.x || end.y != begin.y);
      const bool is_corner = !has_line_between && (a.edge == null_index || b.edge == null_index);
      const Plane_point p = (b.edge == null_index) != has_line_between ? begin : end;
      if(a.edge == b.edge || !(gap(a.after, b.before, p) < 1e-7) || !are_on_one_line(a.after, b.before, p))
        continue;
      if(is_corner && b.edge == null_index)
        b.before = a.after;
      else if(is_corner)
        a.after = b.before;
      else
      {
        local_changes_.insert(local_changes_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                              {p, null_index, a.after, b.before, true, true});
        nodes_of_changes_.insert(nodes_of_changes_.begin() + static_cast<std::ptrdiff_t>(i) + 1, Node());
      }
    }
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
    return Edge_crossings::is_same_family(*geodesics_, angle_between(a.x - p.x, a.y - p.y, b.x - p.x, b.y - p.y),
                                          gap(a, b, p));
  }

  bool are_on_one_line(const Image& a, const Image& b, const Plane_point& p) const
  {
    return angle_between(a.x - p.x, a.y - p.y, b.x - p.x, b.y - p.y) < 1e-7 || is_seam(a, b, p);
  }

  bool is_seam(const Image& a, const Image& b, const Plane_point& p) const
  {
    return geodesics_->is_seam(a.origin, b.origin, angle_between(a.x - p.x, a.y - p.y, b.x - p.x, b.y - p.y));
  }

  /// whether both paths come along one line; where the waves of a curve's edge and of its end touch, they do so over the
  /// square root of the rounding
  bool is_ray(const Edge_crossing& c) const
  {
    return c.angle < 1e-7 || (c.is_shadow && geodesics_->is_line(c.left.origin) != geodesics_->is_line(c.right.origin));
  }

  void add_changes_on_edge(Index h)
  {
    const double length = geodesics_->faces().length(h);
    for_each_crossing(h,
                      [&](Index c, bool is_reversed)
                      {
      const Edge_crossing& crossing = (*changes_)[c];
      const double t = is_reversed ? length - crossing.t : crossing.t;
      local_changes_.push_back({to_face(h, t, 0.), h % 3, image(h, label_before(c, is_reversed)),
                                image(h, label_after(c, is_reversed)), is_ray(crossing), crossing.is_shadow,
                                geodesics_->is_approximate() ? crossing.gap : 0.});
      Node node;
      node.crossing = crossing.is_shadow ? null_index : c;
      nodes_of_changes_.push_back(node);
    });
  }

  /// the labels of a crossing as one goes around the face
  Path_label label_before(Index c, bool is_reversed) const
  {
    const Edge_crossing& crossing = (*changes_)[c];
    return is_reversed ? crossing.right.opposite(geodesics_->faces().length(crossing.halfedge)) : crossing.left;
  }
  Path_label label_after(Index c, bool is_reversed) const
  {
    const Edge_crossing& crossing = (*changes_)[c];
    return is_reversed ? crossing.left.opposite(geodesics_->faces().length(crossing.halfedge)) : crossing.right;
  }

  /// all straight ways into the face
  const std::vector<Face_ridges::Entry>& entries(Index f)
  {
    entries_.clear();
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const double length = geodesics_->faces().length(h);
      double last = 0.;
      Path_label label = Vertex_labels(*geodesics_).at_source(h); // of all of an edge without crossings
      for_each_crossing(h,
                        [&](Index c, bool is_reversed)
                        {
        const double t = is_reversed ? length - (*changes_)[c].t : (*changes_)[c].t;
        add_entry(h, label_before(c, is_reversed), last, t);
        last = t;
        label = label_after(c, is_reversed);
      });
      add_entry(h, label, last, length);
    }
    add_entries_inside(f);
    return entries_;
  }

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

  void store(Index f)
  {
    Face face;
    face.face = f;
    face.first_node = static_cast<Index>(nodes_.size());
    face.first_piece = static_cast<Index>(pieces_.size());
    const std::size_t n = drawing_.nodes.size();
    // crossings first, then what real pieces end at
    position_.assign(n, null_index);
    Index number = 0;
    for(std::size_t i = 0; i < nodes_of_changes_.size(); ++i)
      if(nodes_of_changes_[i].crossing != null_index)
        position_[i] = number++;
    face.number_of_crossings = number;
    for(const Face_ridges::Ridge& r : drawing_.ridges)
      for(Index i : r.nodes)
        if(!r.is_shadow && position_[i] == null_index)
          position_[i] = number++;
    nodes_.resize(face.first_node + std::size_t(number));
    for(std::size_t i = 0; i < n; ++i)
      if(position_[i] != null_index)
      {
        Node& node = nodes_[face.first_node + position_[i]];
        if(i < nodes_of_changes_.size())
          node = nodes_of_changes_[i];
        node.point = drawing_.nodes[i];
      }
    for(const Face_ridges::Ridge& r : drawing_.ridges)
      if(!r.is_shadow)
        add_piece(face, r);
    face.end_node = static_cast<Index>(nodes_.size());
    face.end_piece = static_cast<Index>(pieces_.size());
    number_trees(face);
    faces_.push_back(face);
  }

  void add_piece(const Face& face, const Face_ridges::Ridge& r)
  {
    Piece piece{{position_[r.nodes[0]], position_[r.nodes[1]]},
                {r.images[0], r.images[1]},
                {0., 0.},
                face.first_node,
                !drawing_.is_doubtful && !geodesics_->is_approximate()};
    for(int k = 0; k < 2; ++k)
    {
      Node& node = nodes_[face.first_node + piece.nodes[k]];
      node.distance = 0.5 * (piece.images[0].distance(node.point) + piece.images[1].distance(node.point));
      if(node.crossing != null_index)
        piece.gaps[k] = (*changes_)[node.crossing].gap;
      else if(node.vertex == null_index)
        piece.gaps[k] = gap(piece.images[0], piece.images[1], node.point);
    }
    if(geodesics_->is_approximate())
      use_own_images(r, piece);
    pieces_.push_back(piece);
  }

  /// The image of a family is one of several: at a crossing, a piece has those that are its own.
  void use_own_images(const Face_ridges::Ridge& r, Piece& piece) const
  {
    int best = -1;
    for(int k = 0; k < 2; ++k)
      if(r.nodes[k] < own_images_.size() && nodes_of_changes_[r.nodes[k]].crossing != null_index &&
         (best < 0 || piece.gaps[k] > piece.gaps[best]))
        best = k;
    if(best < 0)
      return;
    const std::array<Image, 2>& own = own_images_[r.nodes[best]];
    piece.images[0] = own[best];
    piece.images[1] = own[1 - best];
    piece.gaps[1 - best] = (std::min)(piece.gaps[1 - best], (1. - 1e-6) * piece.gaps[best]);
  }

  /// the angle at which the paths from two images to a point part
  double gap(const Image& a, const Image& b, const Plane_point& p) const
  {
    return Parting_angle(*geodesics_)(a.origin, a.direction_to(p, corners_), b.origin, b.direction_to(p, corners_),
                                      angle_between(a.x - p.x, a.y - p.y, b.x - p.x, b.y - p.y));
  }

  /// numbers the trees in the order of their first crossing
  void number_trees(Face& face)
  {
    const Index n = face.end_node - face.first_node;
    parent_.resize(n);
    for(Index i = 0; i < n; ++i)
      parent_[i] = i;
    const auto root = [&](Index i)
    {
      while(parent_[i] != i)
        i = parent_[i];
      return i;
    };
    for(Index p = face.first_piece; p < face.end_piece; ++p)
    {
      const Index a = root(pieces_[p].nodes[0]), b = root(pieces_[p].nodes[1]);
      parent_[(std::max)(a, b)] = (std::min)(a, b); // the root is a crossing, if there is one
    }
    face.number_of_trees = 0;
    for(Index i = 0; i < n; ++i)
    {
      Node& node = nodes_[face.first_node + i];
      const Index r = root(i);
      if(r == i && i < face.number_of_crossings)
        node.tree = face.number_of_trees++;
      else if(r != i)
        node.tree = nodes_[face.first_node + r].tree;
    }
  }

  const Indexed_triangle_mesh* mesh_ = nullptr;
  const Mesh_connectivity* connectivity_ = nullptr;
  const Geodesic_results* geodesics_ = nullptr;
  const Label_changes* changes_ = nullptr;
  std::vector<Face> faces_;
  std::vector<Node> nodes_;
  std::vector<Piece> pieces_;
  Index number_of_doubtful_ = 0;

  // of the face in work
  std::array<Plane_point, 3> corners_;
  std::vector<Face_ridges::Change> local_changes_;
  std::vector<Face_ridges::Entry> entries_;
  std::vector<Node> nodes_of_changes_;
  std::vector<std::array<Image, 2>> own_images_; // of the changes, before those of a family become one
  Face_ridges drawing_;
  std::vector<Index> position_, parent_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_RIDGES_H
