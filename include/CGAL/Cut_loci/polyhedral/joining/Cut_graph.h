// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_JOINING_CUT_GRAPH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_JOINING_CUT_GRAPH_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/internal/rough_sort.h>
#include <CGAL/Cut_loci/polyhedral/faces/Ridges.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_changes.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * joins the trees of all faces to one graph, whose complement is an open disk whatever the crossings are.
 *
 * The crossings divide the edges of the mesh, and the vertices and the intervals between two crossings of an edge are
 * the nodes of a *primal* graph. Its links are the edges without a crossing, the crossings, and the cells of a face,
 * which link those parts of its boundary that they touch. This graph is embedded, and each of its faces holds one tree
 * of pieces, or is a face of the mesh without any, or a border loop that a disk closes. So, as for the edges of a mesh
 * \cgalCite{cgal:ew-gohhb-05}, what is dual to the links outside of a spanning tree joins all trees to a graph of 2g
 * cycles. The weight of a link is the angle at which paths meet there, or at which they part at the source if that is
 * larger: vertices closer to each other than windows are accurate may be reached on different ways, and the paths through
 * both go on along one line. The tree of least weight, up to a quarter of it, does without all links that cross the cut
 * locus if that is possible; it is, where all crossings are known.
 *
 * With several sources the tree is a forest with one of them in each of its trees, and 2g - 1 more cycles than sources
 * are left. Links between points with different nearest sources come last. Where sources are edges on the border, these are
 * in the forest from the start, with the cycle that they may form, and nothing is dual to them.
 *
 * A face that is not drawn holds one star instead of its trees, and so does a part of a face in which nothing is drawn as
 * all is weak. It joins what leads into it only if the topology asks for that.
 */
class Cut_graph
{
public:
  /// what is dual to a link outside of the spanning tree: it joins two trees, faces or loops
  struct Joint
  {
    enum Kind : unsigned char { CROSSING, EDGE, CELL } kind;
    Index element;               // the crossing; the edge of the mesh; the face in `Ridges::faces()`
    Index nodes[2];              // that it joins
    Index crossings[2] = {0, 0}; // for a cell: one on each of the two trees, numbers in the face
    Index sources[2] = {0, 0};   // on its two sides
  };

  std::vector<Joint> joints;
  Index number_of_nodes = 0;
  Index first_loop = 0; ///< the nodes of the border loops

  /// @param source_vertices of several sources; of one it may be empty
  Cut_graph(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Geodesic_results& geodesics,
            const Label_changes& changes, const Ridges& ridges, const std::vector<Index>& source_vertices,
            const Progress& progress = {})
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics), changes_(changes), ridges_(ridges),
      has_several_sources_(source_vertices.size() > 1 || geodesics.has_lines())
  {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      largest_distance_ = (std::max)(largest_distance_, geodesics.distance(v));
    number_nodes();
    number_intervals(progress.part(0., 0.2));
    if(has_several_sources_)
      plant(source_vertices);
    // those of a spanning tree, and some for cycles
    joints.reserve(number_of_nodes + std::size_t(number_of_nodes) / 16);
    link_cells(progress.part(0.2, 0.4));
    link_edges(progress.part(0.4, 1.));
    if(has_several_sources_)
      name_sources();
  }

  /// whether a node stands for what is not drawn
  bool is_star(Index node) const { return is_star_[node] != 0; }
  /// that of a node of a star
  Index face_of_star(Index node) const { return node < first_loop ? node : face_of_extra_[node - first_extra()]; }

  /// the face of `Ridges::faces()` of a face of the mesh, or null
  Index record(Index f) const { return record_.empty() ? null_index : record_[f]; }
  /// the node of a tree
  Index node_of_tree(Index record, Index tree) const
  {
    return tree == 0 ? ridges_.faces()[record].face : first_extra_[record] + tree - 1;
  }
  /// a leaf of the tree whose crossing follows an edge of a face with crossings, counterclockwise: the first one on the
  /// way to that crossing; a number in the face
  Index leaf_behind(Index record, Index corner) const
  {
    const Ridges::Face& face = ridges_.faces()[record];
    ridges_.crossings_around(face.face, around_);
    Index crossing = 0;
    while(crossing < around_.size() && around_[crossing].corner <= corner)
      ++crossing;
    crossing = crossing < around_.size() ? crossing : 0;
    const Index tree = ridges_.node(face, crossing).tree;
    for(Index next = (corner + 1) % 3;; next = (next + 1) % 3)
    {
      for(Index i = face.number_of_crossings; i < face.end_node - face.first_node; ++i)
        if(ridges_.node(face, i).vertex == mesh_.triangles[face.face][next] && ridges_.node(face, i).tree == tree)
          return i;
      if(next == around_[crossing].corner)
        return crossing;
    }
  }
  Index first_extra() const { return first_loop + connectivity_.number_of_border_loops; }
  Index border_node(Index h) const { return first_loop + connectivity_.border_loop[mesh_.source(h)]; }

private:
  /// the nodes: the faces of the mesh, which are also the first tree in them; the loops; the other trees
  void number_nodes()
  {
    const std::vector<Ridges::Face>& faces = ridges_.faces();
    first_loop = mesh_.number_of_faces();
    number_of_nodes = first_loop + connectivity_.number_of_border_loops;
    record_.assign(mesh_.number_of_faces(), null_index);
    first_extra_.resize(faces.size());
    for(Index i = 0; i < faces.size(); ++i)
    {
      if(faces[i].number_of_crossings > 0)
        record_[faces[i].face] = i;
      first_extra_[i] = number_of_nodes;
      number_of_nodes += (std::max)(faces[i].number_of_trees, Index(1)) - 1;
      face_of_extra_.resize(number_of_nodes - first_extra(), faces[i].face);
    }
    is_star_.assign(number_of_nodes, 0);
    for(Index f = 0; f < first_loop; ++f)
      is_star_[f] = record_[f] == null_index;
    nodes_of_crossing_.assign(changes_.number_of_crossings(), {{null_index, null_index}});
    for(Index i = 0; i < faces.size(); ++i)
      for(Index k = 0; k < faces[i].number_of_crossings; ++k)
      {
        const Ridges::Node& node = ridges_.node(faces[i], k);
        const bool is_behind = changes_[node.crossing].halfedge / 3 != faces[i].face;
        const Index tree = node_of_tree(i, node.tree);
        nodes_of_crossing_[node.crossing][is_behind] = tree;
        is_star_[tree] = node.is_hidden;
      }
  }

  // -- the primal graph ------------------------------------------------------------------------------------------------

  bool is_real(Index c) const { return !changes_[c].is_shadow; }

  void number_intervals(const Progress& progress)
  {
    Index n = mesh_.number_of_vertices();
    before_.assign(changes_.number_of_crossings(), null_index);
    behind_.assign(changes_.number_of_crossings(), null_index);
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
    {
      progress(e, connectivity_.number_of_edges());
      Index previous = null_index;
      for(Index c = changes_.first(e); c < changes_.first(e + 1); ++c)
        if(is_real(c))
        {
          if(previous != null_index)
            behind_[previous] = n++;
          before_[c] = previous != null_index ? behind_[previous] : mesh_.source(connectivity_.halfedge_of_edge[e]);
          previous = c;
        }
      if(previous != null_index)
        behind_[previous] = mesh_.target(connectivity_.halfedge_of_edge[e]);
    }
    forest_ = Source_forest(n);
  }

  /// the primal node behind a crossing, as one goes around a face
  Index behind(const Ridges::Crossing_on_face& c) const
  {
    return c.is_reversed ? before_[c.crossing] : behind_[c.crossing];
  }

  /// one tree of the forest for each source
  void plant(const std::vector<Index>& source_vertices)
  {
    for(Index i = 0; i < source_vertices.size(); ++i)
      forest_.plant(source_vertices[i], i);
    if(!geodesics_.has_lines())
      return;
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      if(geodesics_.line_at(h) != null_index)
        forest_.link(mesh_.source(h), mesh_.target(h));
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      if(geodesics_.line_at(h) != null_index)
        forest_.plant(mesh_.source(h), geodesics_.owner(geodesics_.line_at(h)));
  }

  /// from the nodes beside a joint to the sources of their trees
  void name_sources()
  {
    for(Joint& joint : joints)
      for(Index& i : joint.sources)
        i = forest_.source(i);
  }

  /*
   * A cell touches the boundary of the face in parts between two crossings. From the crossing at the end of one, the
   * tree leads along the cell to the crossing of the same tree before it, where the next part starts. Links join one
   * part to the next; each separates the tree between them from the one between the last and the first.
   */
  void link_cells(const Progress& progress)
  {
    const std::vector<Ridges::Face>& faces = ridges_.faces();
    std::vector<unsigned char> is_done;
    std::vector<Index> parts, last_of_tree, previous;
    Progress::Counter told(progress, faces.empty() ? 0 : faces.back().end_node);
    for(Index r = 0; r < faces.size(); ++r)
    {
      told(faces[r].first_node);
      const Ridges::Face& face = faces[r];
      if(face.number_of_trees < 2)
        continue;
      const Index n = face.number_of_crossings;
      ridges_.crossings_around(face.face, around_);
      const auto tree = [&](Index i) { return ridges_.node(face, i).tree; };
      // of the crossings of the same tree, the one before, around the face
      last_of_tree.resize(face.number_of_trees);
      previous.resize(n);
      for(Index i = 0; i < n; ++i)
        last_of_tree[tree(i)] = i;
      for(Index i = 0; i < n; ++i)
      {
        previous[i] = last_of_tree[tree(i)];
        last_of_tree[tree(i)] = i;
      }
      is_done.assign(n, 0);
      for(Index seed = 0; seed < n; ++seed)
      {
        parts.clear();
        for(Index part = seed; !is_done[part];)
        {
          is_done[part] = 1;
          parts.push_back(part);
          part = previous[part + 1 < n ? part + 1 : 0];
        }
        for(std::size_t i = 0; i + 1 < parts.size(); ++i)
          if(!forest_.link(behind(around_[parts[i]]), behind(around_[parts[i + 1]])))
          {
            const Index end = (parts[i] + 1) % n, last = (parts.back() + 1) % n;
            joints.push_back({Joint::CELL, r, {node_of_tree(r, tree(end)), node_of_tree(r, tree(last))}, {end, last}});
            set_sides(behind(around_[parts[i]]), behind(around_[parts[i + 1]]));
          }
      }
    }
  }

  using Link = std::pair<Index, bool>; // an edge, or a crossing

  void link_edges(const Progress& progress)
  {
    std::vector<float> weight;
    std::vector<Link> links;
    weigh_links(weight, links, progress.part(0., 0.2));
    const Progress linking = progress.part(0.4, 1.);
    std::size_t number = 0;
    for(Index i : roughly_sorted(weight, progress.part(0.2, 0.4)))
    {
      linking(number++, links.size());
      const Index element = links[i].first;
      if(links[i].second)
      {
        if(!forest_.link(before_[element], behind_[element]))
          add_crossing(element);
        continue;
      }
      const Index h = connectivity_.halfedge_of_edge[element];
      if(!forest_.link(mesh_.source(h), mesh_.target(h)))
      {
        const Index o = mesh_.opposite[h];
        joints.push_back({Joint::EDGE, element, {node_beside(h), o != null_index ? node_beside(o) : border_node(h)}});
        set_sides(mesh_.source(h), mesh_.target(h));
      }
    }
  }

  /// edges and crossings by weight; an angle is at most pi
  void weigh_links(std::vector<float>& weight, std::vector<Link>& links, const Progress& progress) const
  {
    constexpr float last = 4.f * static_cast<float>(geodesic_pi);
    const std::size_t most = std::size_t(connectivity_.number_of_edges()) + changes_.number_of_crossings();
    weight.reserve(most);
    links.reserve(most);
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
    {
      progress(e, connectivity_.number_of_edges());
      if(geodesics_.line_at(connectivity_.halfedge_of_edge[e]) != null_index)
        continue;
      const Index h = connectivity_.halfedge_of_edge[e];
      bool is_crossed = false;
      for(Index c = changes_.first(e); c < changes_.first(e + 1); ++c)
        if(is_real(c))
        {
          is_crossed = true;
          links.push_back({c, true});
          const bool is_between_sources = has_several_sources_ && changes_[c].is_between_sources;
          weight.push_back(is_between_sources ? last : angle(changes_[c]));
        }
      if(!is_crossed)
      {
        links.push_back({e, false});
        const bool is_between_sources = has_several_sources_ && geodesics_.nearest_source(mesh_.source(h)) !=
                                                                  geodesics_.nearest_source(mesh_.target(h));
        weight.push_back(is_between_sources ? last : changes_.bend(h) > 0.f ? changes_.bend(h) : weight_of_place(h));
      }
    }
  }

  /// Where nothing tells which edges the cut locus crosses, it is rather those farther from the source: below all angles,
  /// with four digits in each power of two, see `roughly_sorted()`.
  float weight_of_place(Index h) const
  {
    constexpr double exponent = -100., range = 24.;
    const double distance = (std::min)(geodesics_.distance(mesh_.source(h)), geodesics_.distance(mesh_.target(h)));
    return static_cast<float>(std::exp2(exponent - range * (1. - distance / largest_distance_)));
  }

  static float angle(const Edge_crossing& c)
  {
    constexpr double least = 1e-29; // above `weight_of_place()`
    return static_cast<float>((std::min)((std::max)(c.larger_angle(), least), geodesic_pi));
  }

  /// the node on the side of `h`, an edge without crossing
  Index node_beside(Index h) const
  {
    const Index r = record_[h / 3];
    if(r == null_index)
      return h / 3;
    return node_of_tree(r, ridges_.node(ridges_.faces()[r], leaf_behind(r, h % 3)).tree);
  }

  void add_crossing(Index c)
  {
    const Index h = changes_[c].halfedge, o = mesh_.opposite[h];
    const auto node_in = [&](Index face, std::size_t side)
    {
      const Index node = nodes_of_crossing_[c][side];
      return node != null_index ? node : face;
    };
    joints.push_back({Joint::CROSSING, c, {node_in(h / 3, 0), o != null_index ? node_in(o / 3, 1) : border_node(h)}});
    set_sides(before_[c], behind_[c]);
  }

  /// the nodes on both sides of the last joint
  void set_sides(Index a, Index b)
  {
    if(!has_several_sources_)
      return;
    joints.back().sources[0] = a;
    joints.back().sources[1] = b;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Geodesic_results& geodesics_;
  const Label_changes& changes_;
  const Ridges& ridges_;
  double largest_distance_ = 0.;
  std::vector<Index> record_, first_extra_, face_of_extra_;
  std::vector<unsigned char> is_star_;                  // by node
  std::vector<std::array<Index, 2>> nodes_of_crossing_; // in the faces on the two sides
  std::vector<Index> before_, behind_;                  // the primal nodes beside each crossing that is real
  Source_forest forest_{0};
  bool has_several_sources_;
  mutable std::vector<Ridges::Crossing_on_face> around_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_JOINING_CUT_GRAPH_H
