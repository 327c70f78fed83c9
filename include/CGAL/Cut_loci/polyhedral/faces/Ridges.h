// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGES_H

#include <CGAL/Cut_loci/internal/Growing_list.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/polyhedral/faces/Face_boundary.h>
#include <CGAL/Cut_loci/polyhedral/faces/Face_ridges.h>
#include <CGAL/Cut_loci/polyhedral/labels/Edge_crossings.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_changes.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

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
    bool is_hidden = false; // no piece is drawn that ends there; those between two others are one tree
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
    const auto add_block = [&](Ridges& to, std::size_t i)
    { to.add_faces(drawn, i * block, (std::min)((i + 1) * block, drawn.size())); };
    const std::size_t at_once = threads.number_at_once();
    for(std::size_t first = 0; first < number; first += at_once)
    {
      progress(first, number);
      if(at_once == 1)
      {
        add_block(*this, first);
        continue;
      }
      std::vector<Ridges> parts;
      while(parts.size() < (std::min)(at_once, number - first))
        parts.push_back(empty_copy());
      threads.run(parts.size(), [&](std::size_t i) { add_block(parts[i], first + i); });
      for(const Ridges& part : parts)
        append(part);
    }
  }

  const std::vector<Face>& faces() const { return faces_; }
  Index number_of_faces() const { return number_of_faces_; }
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
      result =
        (std::max)(result, internal::meeting_angle(pieces_[i].images[0], pieces_[i].images[1], piece_end(i, end)));
    return result;
  }

  /// the curvature that the two paths to a point of the piece enclose, on that side of them where it is less: by
  /// Gauss-Bonnet, the sectors there between the paths, where they part and where they meet; and how long the paths are from
  /// where they part. At the end where it is more, as what paths bend at saddles on their way is not counted.
  struct Enclosed
  {
    double curvature, length;
  };
  Enclosed enclosed(std::size_t i, Index face) const
  {
    const std::array<Plane_point, 3> corners = layout(face);
    const Enclosed first = enclosed(pieces_[i], corners, 0), second = enclosed(pieces_[i], corners, 1);
    return first.curvature < second.curvature ? second : first;
  }

  Face_corners layout(Index f) const { return corners_of(geodesics_->faces(), f); }

  /// whether a piece ends there, by crossing
  std::vector<unsigned char> crossings_with_pieces() const
  {
    std::vector<unsigned char> result(changes_->number_of_crossings(), 0);
    for(std::size_t i = 0; i < nodes_.size(); ++i)
      if(nodes_[i].crossing != null_index)
        result[nodes_[i].crossing] = 1;
    return result;
  }

  /// gives crossings their new numbers, and adds those of the edges of a face at which no piece of the face ends
  void renumber_crossings(const std::vector<Index>& number)
  {
    const Growing_list<Node> old = std::move(nodes_);
    nodes_ = Growing_list<Node>();
    std::vector<Crossing_on_face> around;
    std::vector<Index> position, parent, group; // the last of hidden crossings: by what is drawn between them
    for(Face& face : faces_)
    {
      const Face before = face;
      const std::array<bool, 3> ends_at_corner = corners_with_nodes(old, before);
      face.first_node = static_cast<Index>(nodes_.size());
      position.clear();
      crossings_around(face.face, around);
      add_crossings_around(old, before, face, number, around, position);
      face.number_of_crossings = static_cast<Index>(nodes_.size()) - face.first_node;
      group_hidden_crossings(face, around, ends_at_corner, group);
      for(Index i = before.first_node + before.number_of_crossings; i < before.end_node; ++i)
        add_again(old[i], face, position);
      face.end_node = static_cast<Index>(nodes_.size());
      for(Index p = face.first_piece; p < face.end_piece; ++p)
      {
        pieces_[p].first_node = face.first_node;
        for(Index& i : pieces_[p].nodes)
          i = position[i];
      }
      number_trees(parent, face, group);
    }
  }

  /// the crossings that are on the cut locus, counterclockwise from the first corner
  void crossings_around(Index f, std::vector<Crossing_on_face>& result) const
  {
    result.clear();
    for(Index i = 0; i < 3; ++i)
      changes_->for_each_crossing(3 * f + i,
                                  [&](Index c, bool is_reversed)
                                  {
        if(!(*changes_)[c].is_shadow)
          result.push_back({c, i, is_reversed});
      });
  }

  /// keeps some pieces, which get new numbers in this order, and frees the memory of all others and of the faces
  void keep(const std::vector<Index>& kept)
  {
    Growing_list<Node> nodes;
    Growing_list<Piece> pieces;
    for(Index p : kept)
    {
      Piece piece = pieces_[p];
      const Index first_node = static_cast<Index>(nodes.size());
      for(Index& i : piece.nodes)
      {
        nodes.push_back(nodes_[piece.first_node + i]);
        i = static_cast<Index>(nodes.size() - 1) - first_node;
      }
      piece.first_node = first_node;
      pieces.push_back(piece);
    }
    nodes_ = std::move(nodes);
    pieces_ = std::move(pieces);
    faces_ = std::vector<Face>();
  }

private:
  /// what is used again from face to face
  struct Work
  {
    Face_boundary boundary;
    Face_ridges drawing;
    std::vector<Index> position, parent;
  };

  Enclosed enclosed(const Piece& piece, const std::array<Plane_point, 3>& corners, int end) const
  {
    const Image &a = piece.images[0], &b = piece.images[1]; // to the left and to the right
    const Plane_point from = nodes_[piece.first_node + piece.nodes[0]].point,
                      to = nodes_[piece.first_node + piece.nodes[1]].point, p = end == 0 ? from : to;
    const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
    const double meeting = angle_between(ax, ay, bx, by), rest = 2. * geodesic_pi - meeting;
    const Parting_angle::Parting parting = internal::parting(*geodesics_, a, b, p, corners);
    const double length = a.distance(p) - parting.distance;
    // paths that hardly part enclose what is between them, and nothing tells the sides of images with an error
    if(piece.gaps[end] < Parting_angle::least_angle || geodesics_->is_approximate())
      return {piece.gaps[end] + meeting, length};
    const bool come_from_ahead =
      meeting < Parting_angle::least_angle ? ax * (to.x - from.x) + ay * (to.y - from.y) > 0. : bx * ay - by * ax > 0.;
    return {
      (std::min)(parting.turn + (come_from_ahead ? meeting : rest), parting.rest + (come_from_ahead ? rest : meeting)),
      length};
  }

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
    Work work{Face_boundary(*mesh_, *geodesics_, *changes_), {}, {}, {}};
    for(std::size_t i = begin; i < end; ++i)
    {
      const Index f = drawn[i];
      while(next_at_vertex < at_vertices.size() && at_vertices[next_at_vertex].halfedge < 3 * f)
        ++next_at_vertex;
      if(has_crossings(f) || has_two_ends(f, next_at_vertex))
        add_face(work, f, next_at_vertex);
    }
  }

  void append(const Ridges& part)
  {
    const Index nodes = static_cast<Index>(nodes_.size()), pieces = static_cast<Index>(pieces_.size());
    for(std::size_t i = 0; i < part.nodes_.size(); ++i)
      nodes_.push_back(part.nodes_[i]);
    for(std::size_t i = 0; i < part.pieces_.size(); ++i)
    {
      pieces_.push_back(part.pieces_[i]);
      pieces_[pieces_.size() - 1].first_node += nodes;
    }
    for(Face face : part.faces_)
    {
      face.first_node += nodes;
      face.end_node += nodes;
      face.first_piece += pieces;
      face.end_piece += pieces;
      faces_.push_back(face);
    }
    number_of_faces_ += part.number_of_faces_;
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

  void add_face(Work& work, Index f, std::size_t next_at_vertex)
  {
    work.boundary.read(f, next_at_vertex);
    if(work.boundary.changes().empty())
      return; // all is weak
    const double size = (std::max)({geodesics_->faces().length(3 * f), geodesics_->faces().length(3 * f + 1),
                                    geodesics_->faces().length(3 * f + 2)});
    // a path that is wrong by an angle is too long by the angle times its way through the face, at most
    work.drawing.draw(
      work.boundary.corners(), work.boundary.changes(), (std::max)(1e-8, geodesics_->merging_angle()) * size,
      [&]() -> const std::vector<Face_ridges::Entry>& { return work.boundary.entries(); },
      [&](const Image& a, const Image& b, const Plane_point& p, bool are_on_line)
      { return are_on_line ? work.boundary.gap(a, b, p) < 1e-7 : work.boundary.is_seam(a, b, p); });
    number_of_doubtful_ += work.drawing.is_doubtful;
    store(work, f);
  }

  void store(Work& work, Index f)
  {
    Face face;
    face.face = f;
    face.first_node = static_cast<Index>(nodes_.size());
    face.first_piece = static_cast<Index>(pieces_.size());
    const std::size_t n = work.drawing.nodes.size();
    // crossings first, then what real pieces end at
    work.position.assign(n, null_index);
    Index number = 0;
    const std::vector<Face_boundary::Place>& places = work.boundary.places();
    for(std::size_t i = 0; i < places.size(); ++i)
      if(places[i].crossing != null_index)
        work.position[i] = number++;
    face.number_of_crossings = number;
    for(const Face_ridges::Ridge& r : work.drawing.ridges)
      for(Index i : r.nodes)
        if(!r.is_shadow && work.position[i] == null_index)
          work.position[i] = number++;
    nodes_.resize(face.first_node + std::size_t(number));
    for(std::size_t i = 0; i < n; ++i)
      if(work.position[i] != null_index)
      {
        Node& node = nodes_[face.first_node + work.position[i]];
        if(i < places.size())
        {
          node.crossing = places[i].crossing;
          node.vertex = places[i].vertex;
        }
        node.point = work.drawing.nodes[i];
      }
    for(const Face_ridges::Ridge& r : work.drawing.ridges)
      if(!r.is_shadow)
        add_piece(work, face, r);
    face.end_node = static_cast<Index>(nodes_.size());
    face.end_piece = static_cast<Index>(pieces_.size());
    number_trees(work.parent, face);
    faces_.push_back(face);
    ++number_of_faces_;
  }

  void add_piece(const Work& work, const Face& face, const Face_ridges::Ridge& r)
  {
    Piece piece{{work.position[r.nodes[0]], work.position[r.nodes[1]]},
                {r.images[0], r.images[1]},
                {0., 0.},
                face.first_node,
                !work.drawing.is_doubtful && !geodesics_->is_approximate()};
    for(int k = 0; k < 2; ++k)
    {
      Node& node = nodes_[face.first_node + piece.nodes[k]];
      node.distance = work.drawing.is_doubtful
                        ? work.drawing.distance_in_doubt(node.point)
                        : 0.5 * (piece.images[0].distance(node.point) + piece.images[1].distance(node.point));
      if(node.crossing != null_index)
        piece.gaps[k] = (*changes_)[node.crossing].gap;
      else if(node.vertex == null_index)
        piece.gaps[k] = work.boundary.gap(piece.images[0], piece.images[1], node.point);
    }
    if(geodesics_->is_approximate())
      use_own_images(work, r, piece);
    pieces_.push_back(piece);
  }

  /// The image of a family is one of several: at a crossing, a piece has those that are its own.
  static void use_own_images(const Work& work, const Face_ridges::Ridge& r, Piece& piece)
  {
    int best = -1;
    for(int k = 0; k < 2; ++k)
      if(r.nodes[k] < work.boundary.own_images().size() && work.boundary.places()[r.nodes[k]].crossing != null_index &&
         (best < 0 || piece.gaps[k] > piece.gaps[best]))
        best = k;
    if(best < 0)
      return;
    const std::array<Image, 2>& own = work.boundary.own_images()[r.nodes[best]];
    piece.images[0] = own[best];
    piece.images[1] = own[1 - best];
    piece.gaps[1 - best] = (std::min)(piece.gaps[1 - best], (1. - 1e-6) * piece.gaps[best]);
  }

  std::array<bool, 3> corners_with_nodes(const Growing_list<Node>& nodes, const Face& face) const
  {
    std::array<bool, 3> result = {{false, false, false}};
    for(Index i = face.first_node + face.number_of_crossings; i < face.end_node; ++i)
      for(Index k = 0; k < 3; ++k)
        result[k] = result[k] || nodes[i].vertex == mesh_->triangles[face.face][k];
    return result;
  }

  void add_again(Node node, const Face& face, std::vector<Index>& position)
  {
    if(!node.is_hidden)
      position.push_back(static_cast<Index>(nodes_.size()) - face.first_node);
    node.tree = null_index;
    nodes_.push_back(node);
  }

  /// those at which pieces end, and in between those at which none does
  void add_crossings_around(const Growing_list<Node>& old, const Face& before, const Face& face,
                            const std::vector<Index>& number, const std::vector<Crossing_on_face>& around,
                            std::vector<Index>& position)
  {
    for(const Crossing_on_face& c : around)
    {
      const std::size_t next = before.first_node + position.size();
      Node node;
      node.is_hidden = position.size() == before.number_of_crossings || number[old[next].crossing] != c.crossing;
      if(!node.is_hidden)
        node = old[next];
      node.crossing = c.crossing;
      add_again(node, face, position);
    }
  }

  /// Hidden crossings between the same two ends of pieces, at crossings or at corners, are one group; null for others.
  void group_hidden_crossings(const Face& face, const std::vector<Crossing_on_face>& around,
                              const std::array<bool, 3>& ends_at_corner, std::vector<Index>& group) const
  {
    group.clear();
    Index corner = 0, drawn = ends_at_corner[0];
    const auto go_on = [&](Index to)
    {
      while(corner < to)
        drawn += ends_at_corner[++corner];
    };
    for(Index i = 0; i < around.size(); ++i)
    {
      go_on(around[i].corner);
      const bool is_hidden = nodes_[face.first_node + i].is_hidden;
      group.push_back(is_hidden ? drawn : null_index);
      drawn += !is_hidden;
    }
    go_on(2);
    for(Index& g : group)
      if(g != null_index && drawn > 0)
        g %= drawn;
  }

  /// numbers the trees in the order of their first crossing; crossings of one group are one tree
  void number_trees(std::vector<Index>& parent, Face& face, const std::vector<Index>& group = {})
  {
    const Index n = face.end_node - face.first_node;
    parent.resize(n);
    for(Index i = 0; i < n; ++i)
      parent[i] = i;
    const auto root = [&](Index i)
    {
      while(parent[i] != i)
        i = parent[i];
      return i;
    };
    for(Index p = face.first_piece; p < face.end_piece; ++p)
    {
      const Index a = root(pieces_[p].nodes[0]), b = root(pieces_[p].nodes[1]);
      parent[(std::max)(a, b)] = (std::min)(a, b); // the root is a crossing, if there is one
    }
    for(Index i = 0; i < group.size(); ++i)
      for(Index k = i; k-- > 0 && group[i] != null_index;)
        if(group[k] == group[i])
        {
          parent[i] = root(k);
          break;
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
  Growing_list<Node> nodes_;
  Growing_list<Piece> pieces_;
  Index number_of_faces_ = 0, number_of_doubtful_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGES_H
