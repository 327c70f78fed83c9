// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_JOINING_TREE_GRAPH_BUILDER_H
#define CGAL_CUT_LOCI_POLYHEDRAL_JOINING_TREE_GRAPH_BUILDER_H

#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/polyhedral/faces/Ridges.h>
#include <CGAL/Cut_loci/polyhedral/joining/Cut_graph.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/polyhedral/joining/weak_islands.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_changes.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * makes a `Tree_graph` of the pieces in the faces and the joints between them.
 */
class Tree_graph_builder
{
public:
  Tree_graph_builder(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const Geodesic_results& geodesics, const Label_changes& changes, const Ridges& ridges,
                     const Cut_graph& cut, Tree_graph& graph, const Progress& progress = {})
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics), changes_(changes), ridges_(ridges), cut_(cut),
      graph_(graph)
  {
    graph_.nodes.clear();
    graph_.edges.clear();
    graph_.number_of_open = 0;
    drop_weak_leaves(progress.part(0., 0.2));
    reserve();
    add_loops();
    add_ridges(progress.part(0.2, 0.6));
    add_joints(progress.part(0.6, 0.7));
    add_stars(progress.part(0.7, 0.8));
    add_pieces_between_vertices(progress.part(0.8, 0.9));
    drop_open_ends_on_border();
    drop_weak_islands(progress.part(0.9, 1.));
  }

private:
  using Joint = Cut_graph::Joint;
  using Node = Tree_graph::Node;
  using Edge = Tree_graph::Edge;

  /// What is not drawn and a leaf of the graph is no part of the cut locus.
  void drop_weak_leaves(const Progress& progress)
  {
    const auto nodes = [this](Index j) -> Edges_left::Nodes {
      return {{cut_.joints[j].nodes[0], cut_.joints[j].nodes[1]}};
    };
    Edges_left left(cut_.number_of_nodes, cut_.joints.size(), nodes, progress.part(0., 0.5));
    is_kept_.assign(cut_.joints.size(), 1);
    left.peel(
      nodes, [&](Index j, Index i) { return (is_kept_[j] = !cut_.is_star(i)) == 0; }, progress.part(0.5, 1.));
  }

  /// what is needed at most, but for few faces: growing would copy all there is, and take long at once
  void reserve()
  {
    const std::size_t joints = static_cast<std::size_t>(std::count(is_kept_.begin(), is_kept_.end(), 1));
    std::size_t nodes = 0, pieces = 0;
    for(const Ridges::Face& face : ridges_.faces())
    {
      nodes += face.end_node - face.first_node;
      pieces += face.end_piece - face.first_piece;
    }
    graph_.nodes.reserve(number_of_loops() + joints + nodes);
    graph_.edges.reserve(2 * joints + pieces);
  }

  Index add_node(const Node& node)
  {
    graph_.nodes.push_back(node);
    return static_cast<Index>(graph_.nodes.size() - 1);
  }

  Index number_of_loops() const { return graph_.number_of_loops(); }

  /// the first nodes
  void add_loops()
  {
    for(Index i = 0; i < number_of_loops(); ++i)
    {
      Node node;
      node.loop = i;
      add_node(node);
    }
  }

  Node node_on_edge(Index h, double t) const
  {
    const double length = geodesics_.faces().length(h);
    Node node;
    node.face = h / 3;
    node.halfedge = h;
    node.t = t;
    // Nearer to a vertex than the accuracy of the windows: at it. But what passes a vertex of the border does not end there.
    const double margin = geodesic_cover * length;
    const bool is_border = mesh_.opposite[h] == null_index;
    if(t <= margin && (is_border || !connectivity_.is_border(mesh_.source(h))))
      node.vertex = mesh_.source(h);
    else if(t >= length - margin && (is_border || !connectivity_.is_border(mesh_.target(h))))
      node.vertex = mesh_.target(h);
    else
      node.t = t = (std::min)((std::max)(t, margin), length - margin);
    const std::array<Plane_point, 3> corners = ridges_.layout(h / 3);
    node.point = between(corners[h % 3], corners[(h + 1) % 3], t / length);
    if(mesh_.opposite[h] == null_index)
      node.loop = connectivity_.border_loop[mesh_.source(h)];
    return node;
  }

  void add_piece(Index a, Index b, Index face, Index p)
  {
    const Ridges::Piece& piece = ridges_.piece(p);
    Edge edge{{{a, b}}, face, p, (std::max)(piece.gaps[0], piece.gaps[1]), false};
    edge.sources = {
      {geodesics_.source_of_origin(piece.images[0].origin), geodesics_.source_of_origin(piece.images[1].origin)}};
    add_between_sources(edge);
  }

  void add_joint(Index a, Index b, Index face, const Joint& joint)
  {
    Edge edge{{{a, b}}, face, null_index, 0., face == null_index};
    edge.sources = {{joint.sources[0], joint.sources[1]}};
    add_between_sources(edge);
  }

  /// Nothing is weak about what is between two sources, and what is not has a gap.
  void add_between_sources(Edge& edge)
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    if(edge.sources[1] < edge.sources[0])
      std::swap(edge.sources[0], edge.sources[1]);
    if(edge.is_between_sources())
      edge.gap = infinity;
    else if(edge.gap == infinity) // labels that do not fit each other
      edge.gap = 0.;
    graph_.edges.push_back(edge);
  }

  /// the pieces in the faces; two faces share the node of a crossing if a joint joins them there
  void add_ridges(const Progress& progress)
  {
    node_of_crossing_.assign(changes_.number_of_crossings(), null_index);
    const Progress crossing = progress.part(0., 0.3), drawing = progress.part(0.3, 1.);
    for(Index j = 0; j < cut_.joints.size(); ++j)
    {
      crossing(j, cut_.joints.size());
      if(is_kept_[j] && cut_.joints[j].kind == Joint::CROSSING)
      {
        const Index c = cut_.joints[j].element;
        node_of_crossing_[c] = add_crossing(c);
        const Node& node = graph_.nodes[node_of_crossing_[c]];
        if(node.loop != null_index)
          add_joint(node_of_crossing_[c], node.loop, null_index, cut_.joints[j]);
      }
    }
    const std::vector<Ridges::Face>& faces = ridges_.faces();
    first_of_face_.resize(faces.size() + 1, 0);
    Progress::Counter told(drawing, faces.empty() ? 0 : faces.back().end_node);
    for(Index r = 0; r < faces.size(); ++r)
    {
      told(faces[r].first_node);
      first_of_face_[r] = static_cast<Index>(node_in_face_.size());
      for(Index i = 0; i < faces[r].end_node - faces[r].first_node; ++i)
        node_in_face_.push_back(add_node_of_face(faces[r], i));
      for(Index p = faces[r].first_piece; p < faces[r].end_piece; ++p)
        if(node_in_face(r, ridges_.piece(p).nodes[0]) != null_index)
          add_piece(node_in_face(r, ridges_.piece(p).nodes[0]), node_in_face(r, ridges_.piece(p).nodes[1]),
                    faces[r].face, p);
    }
  }

  Index add_crossing(Index c)
  {
    Node node = node_on_edge(changes_[c].halfedge, changes_[c].t);
    node.crossing = c;
    node.distance = changes_[c].distance;
    return add_node(node);
  }

  Index add_node_of_face(const Ridges::Face& face, Index i)
  {
    const Ridges::Node& from = ridges_.node(face, i);
    if(from.is_hidden)
      return node_of_crossing_[from.crossing];
    if(from.crossing != null_index)
    {
      graph_.number_of_open += node_of_crossing_[from.crossing] == null_index;
      return node_of_crossing_[from.crossing] != null_index ? node_of_crossing_[from.crossing]
                                                            : add_crossing(from.crossing);
    }
    if(from.tree == null_index)
      return null_index;
    Node node;
    node.face = face.face;
    node.point = from.point;
    node.vertex = from.vertex != null_index ? from.vertex : vertex_at(face.face, from.point);
    node.distance = node.vertex != null_index ? geodesics_.distance(node.vertex) : from.distance;
    return add_node(node);
  }

  /// the corner of the face at this point, if any
  Index vertex_at(Index f, const Plane_point& p) const
  {
    const std::array<Plane_point, 3> corners = ridges_.layout(f);
    for(Index i = 0; i < 3; ++i)
      if(std::hypot(p.x - corners[i].x, p.y - corners[i].y) <= geodesic_cover * geodesics_.faces().length(3 * f + i) &&
         !connectivity_.is_border(mesh_.triangles[f][i]))
        return mesh_.triangles[f][i];
    return null_index;
  }

  /// A piece that ends on the border without being joined to it there would join it all the same.
  void drop_open_ends_on_border()
  {
    if(graph_.number_of_open == 0 || number_of_loops() == 0)
      return;
    const auto is_open = [&](Index i)
    {
      const Node& n = graph_.nodes[i];
      return n.loop != null_index && n.crossing != null_index && node_of_crossing_[n.crossing] == null_index;
    };
    std::vector<unsigned char> is_removed(graph_.edges.size(), 0);
    for(std::size_t e = 0; e < graph_.edges.size(); ++e)
      is_removed[e] = is_open(graph_.edges[e].nodes[0]) || is_open(graph_.edges[e].nodes[1]);
    graph_.remove(is_removed);
  }

  Index node_in_face(Index record, Index i) const { return node_in_face_[first_of_face_[record] + i]; }

  /// joints without a crossing: straight across an edge of the mesh, or a cell
  void add_joints(const Progress& progress)
  {
    node_of_joint_.assign(cut_.joints.size(), null_index);
    for(Index j = 0; j < cut_.joints.size(); ++j)
    {
      progress(j, cut_.joints.size());
      const Joint& joint = cut_.joints[j];
      if(!is_kept_[j])
        continue;
      if(joint.kind == Joint::CELL)
        add_joint(end_of_cell(joint, 0), end_of_cell(joint, 1), ridges_.faces()[joint.element].face, joint);
      if(joint.kind == Joint::EDGE)
        add_joint_across_edge(j);
    }
  }

  /// At its middle, or where the tree of one side ends at a vertex of the edge: along the edge may be a piece.
  void add_joint_across_edge(Index j)
  {
    const Joint& joint = cut_.joints[j];
    const Index h = connectivity_.halfedge_of_edge[joint.element];
    const std::array<Index, 2> sides = {{h, mesh_.opposite[h]}};
    std::array<Index, 2> leaves = {{null_index, null_index}};
    double share = 0.5;
    for(std::size_t k = 0; k < 2; ++k)
      if(sides[k] != null_index && !cut_.is_star(joint.nodes[k]))
      {
        const Index r = cut_.record(sides[k] / 3);
        leaves[k] = node_in_face(r, cut_.leaf_behind(r, sides[k] % 3));
        const Index v = graph_.nodes[leaves[k]].vertex;
        if(share == 0.5 && v != null_index)
          share = v == mesh_.source(h) ? 0. : v == mesh_.target(h) ? 1. : 0.5;
      }
    Node node = node_on_edge(h, share * geodesics_.faces().length(h));
    node.distance = (1. - share) * geodesics_.distance(mesh_.source(h)) + share * geodesics_.distance(mesh_.target(h));
    node_of_joint_[j] = add_node(node);
    if(node.loop != null_index)
      add_joint(node_of_joint_[j], node.loop, null_index, joint);
    for(std::size_t k = 0; k < 2; ++k)
      if(leaves[k] != null_index)
        add_joint(node_of_joint_[j], leaves[k], sides[k] / 3, joint);
  }

  /// the node of the crossing at an end of a joint across a cell
  Index end_of_cell(const Joint& joint, std::size_t k)
  {
    Index& result = node_in_face_[first_of_face_[joint.element] + joint.crossings[k]];
    if(result == null_index)
      result = add_crossing(ridges_.node(ridges_.faces()[joint.element], joint.crossings[k]).crossing);
    return result;
  }

  void drop_weak_islands(const Progress& progress)
  {
    // the accuracy of coordinates with seven digits, in angles of faces that are not well shaped
    constexpr double least = 1e-5;
    const auto is_known = [](const Edge& e) { return e.piece != null_index || e.is_virtual; };
    const auto is_weak = [&](const Edge& e)
    { return e.piece != null_index && e.gap < least && ridges_.meeting_angle(e.piece) < least; };
    graph_.remove(
      weak_islands(graph_.edges, graph_.nodes.size(), number_of_loops(), is_known, is_weak, progress.part(0., 0.8)),
      progress.part(0.8, 1.));
  }

  /// what is not drawn and is left: it leads from one edge to another
  void add_stars(const Progress& progress)
  {
    std::unordered_map<Index, std::vector<Index>> at_star; // the joints
    std::vector<Index> order;
    const Progress finding = progress.part(0., 0.5), adding = progress.part(0.5, 1.);
    for(Index j = 0; j < cut_.joints.size(); ++j)
    {
      finding(j, cut_.joints.size());
      const Joint& joint = cut_.joints[j];
      if(!is_kept_[j])
        continue;
      for(Index i : joint.nodes)
        if(cut_.is_star(i))
        {
          std::vector<Index>& at = at_star[i];
          if(at.empty())
            order.push_back(i);
          at.push_back(j);
        }
    }
    std::size_t number = 0;
    for(Index star : order)
    {
      adding(number++, order.size());
      add_star(star, at_star[star]);
    }
  }

  void add_star(Index star, const std::vector<Index>& joints)
  {
    std::vector<std::pair<Index, Index>> ends; // nodes, with their joints
    for(Index j : joints)
    {
      const Index end = end_at_star(j, star);
      if(std::none_of(ends.begin(), ends.end(), [end](const auto& e) { return e.first == end; }))
        ends.push_back({end, j});
    }
    const Index f = cut_.face_of_star(star);
    if(ends.size() == 2)
      add_joint(ends[0].first, ends[1].first, f, cut_.joints[ends[0].second]);
    if(ends.size() <= 2)
      return;
    Node node;
    node.face = f;
    for(const Plane_point& p : ridges_.layout(f))
    {
      node.point.x += p.x / 3.;
      node.point.y += p.y / 3.;
    }
    for(Index v : mesh_.triangles[f])
      node.distance += geodesics_.distance(v) / 3.;
    const Index center = add_node(node);
    for(const auto& end : ends)
      add_joint(center, end.first, f, cut_.joints[end.second]);
  }

  Index end_at_star(Index j, Index star)
  {
    const Joint& joint = cut_.joints[j];
    if(joint.kind == Joint::CELL)
      return end_of_cell(joint, joint.nodes[0] == star ? 0 : 1);
    return joint.kind == Joint::EDGE ? node_of_joint_[j] : node_of_crossing_[joint.element];
  }

  /*
   * A tree that crosses no edge ends at vertices only. Either it is all of the cut locus, or one of the vertices is on
   * other branches: there it belongs to them.
   */
  void add_pieces_between_vertices(const Progress& progress)
  {
    std::unordered_map<Index, Index> node_at_vertex;
    const Progress finding = progress.part(0., 0.5), adding = progress.part(0.5, 1.);
    for(Index i = 0; i < graph_.nodes.size(); ++i)
    {
      finding(i, graph_.nodes.size());
      if(graph_.nodes[i].vertex != null_index)
        node_at_vertex.insert({graph_.nodes[i].vertex, i});
    }
    const bool is_all = graph_.edges.empty();
    for(Index r = 0; r < ridges_.faces().size(); ++r)
    {
      adding(r, ridges_.faces().size());
      const Ridges::Face& face = ridges_.faces()[r];
      // pieces between vertices, one after the other; the nodes inside of the face when they come
      std::unordered_map<Index, Index> node_inside;
      for(Index p = face.first_piece; p < face.end_piece; ++p)
        if(ridges_.node(face, ridges_.piece(p).nodes[0]).tree == null_index)
          add_piece_between_vertices(face, p, is_all, node_at_vertex, node_inside);
    }
  }

  void add_piece_between_vertices(const Ridges::Face& face, Index p, bool is_all,
                                  std::unordered_map<Index, Index>& node_at_vertex,
                                  std::unordered_map<Index, Index>& node_inside)
  {
    const auto find = [&](Index i)
    {
      const Index v = ridges_.node(face, i).vertex;
      const auto& map = v != null_index ? node_at_vertex : node_inside;
      const auto found = map.find(v != null_index ? v : i);
      return found != map.end() ? found->second : null_index;
    };
    const std::array<Index, 2> ends = {{ridges_.piece(p).nodes[0], ridges_.piece(p).nodes[1]}};
    std::array<Index, 2> found = {{find(ends[0]), find(ends[1])}};
    if(found[0] == null_index && found[1] == null_index && !is_all)
      return;
    // it is joined to the rest at one end only
    if(found[0] != null_index && found[1] != null_index && !is_all)
      found[1] = null_index;
    for(std::size_t k = 0; k < 2; ++k)
      if(found[k] == null_index)
      {
        const Ridges::Node& from = ridges_.node(face, ends[k]);
        Node node;
        node.face = face.face;
        node.point = from.point;
        node.vertex = from.vertex;
        node.distance = from.vertex != null_index ? geodesics_.distance(from.vertex) : from.distance;
        found[k] = add_node(node);
        if(from.vertex != null_index)
          node_at_vertex.insert({from.vertex, found[k]});
        else
          node_inside.insert({ends[k], found[k]});
      }
    add_piece(found[0], found[1], face.face, p);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Geodesic_results& geodesics_;
  const Label_changes& changes_;
  const Ridges& ridges_;
  const Cut_graph& cut_;
  Tree_graph& graph_;
  std::vector<unsigned char> is_kept_; // joints
  std::vector<Index> node_of_crossing_, node_of_joint_, node_in_face_, first_of_face_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_JOINING_TREE_GRAPH_BUILDER_H
