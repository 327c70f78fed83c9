// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CURVES_TREE_CURVE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CURVES_TREE_CURVE_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/polyhedral/faces/Segment_crossings.h>
#include <CGAL/Cut_loci/polyhedral/curves/Merged_nodes.h>
#include <CGAL/Cut_loci/polyhedral/curves/planar_positions.h>
#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * turns the edges of an `Exact_tree` that are left into a curve through the faces.
 *
 * In a face, pieces that follow each other become one polyline that leaves them by a small share of an edge of the mesh
 * at most, and by less where it would cross others: corridors between branches may be of any width.
 */
class Tree_curve
{
public:
  Indexed_cut_locus graph;
  std::vector<Index> face; ///< that each edge runs through

  /// @param lone the vertex that is left if nothing else is
  Tree_curve(Exact_tree& tree, const std::vector<Tree_branches::Edge>& kept, Index lone, const Progress& progress = {})
    : mesh_(tree.mesh()), connectivity_(tree.connectivity()), geodesics_(tree.geodesics()), tree_(tree),
      nodes_(tree, kept, progress.part(0.1, 0.3)), is_drawn_(nodes_.is_nothing())
  {
    const Index root = tree_.root();
    number_.assign(tree_.graph().nodes.size(), null_index);
    join(kept);
    progress(0.4);
    root_ = root != null_index ? nodes_.representative(root) : null_index;
    if(root != null_index && tree_.graph().nodes[root].face != null_index)
      node(root); // it comes first
    for(const Tree_branches::Edge& b : kept)
      if(!is_drawn_[b.edge] && !tree_.graph().edges[b.edge].is_virtual)
        find_chain(b.edge);
    lay_out_chains(progress.part(0.5, 0.8));
    const Progress drawing = progress.part(0.8, 1.);
    std::size_t number = 0;
    for(const Chain& c : chains_)
    {
      drawing(number++, chains_.size());
      draw(c);
    }
    if(graph.edges.empty())
      graph.nodes.assign(1, {location_of_vertex(connectivity_, lone), lone, geodesics_.distance(lone)});
  }

private:
  Index node(Index i)
  {
    i = nodes_.representative(i);
    if(number_[i] == null_index)
    {
      number_[i] = static_cast<Index>(graph.nodes.size());
      const Tree_graph::Node& n = tree_.graph().nodes[i];
      const Index v = nodes_.vertex(i);
      const auto moved = moved_.find(i);
      graph.nodes.push_back({v != null_index         ? location_of_vertex(connectivity_, v)
                             : moved != moved_.end() ? location(n.face, moved->second)
                                                     : location(n),
                             v, n.distance});
    }
    return number_[i];
  }

  Indexed_location location(const Tree_graph::Node& n) const
  {
    if(n.halfedge == null_index)
      return location(n.face, n.point);
    return location_on(n.halfedge, n.t / geodesics_.faces().length(n.halfedge));
  }

  /// a point inside of a face, in the frame of its first halfedge
  Indexed_location location(Index f, const Plane_point& p) const { return {f, coordinates(f, p)}; }

  /// in the interior, as what is on an edge or at a vertex says so
  std::array<double, 3> coordinates(Index f, const Plane_point& p) const
  {
    constexpr double least = 1e-10;
    std::array<double, 3> result = coordinates_in(tree_.ridges().layout(f), p);
    normalize(result, least, least);
    return result;
  }

  /// where such a point is drawn
  Plane_point inside(Index f, const Plane_point& p) const
  {
    const std::array<Plane_point, 3> t = tree_.ridges().layout(f);
    const std::array<double, 3> c = coordinates(f, p);
    return {c[1] * t[1].x + c[2] * t[2].x, c[2] * t[2].y};
  }

  // -- pieces that follow each other in a face ---------------------------------------------------------------------------

  /// the nodes at which just two pieces of the same face meet
  void join(const std::vector<Tree_branches::Edge>& kept)
  {
    left_ = Edges_left(tree_.graph().nodes.size());
    for(const Tree_branches::Edge& b : kept)
      if(!is_drawn_[b.edge])
      {
        const auto& nodes = tree_.graph().edges[b.edge].nodes;
        left_.add(b.edge, {{nodes_.representative(nodes[0]), nodes_.representative(nodes[1])}});
      }
  }

  /// whether the curve only passes through a node, in the interior of a face
  bool is_passed(Index i) const
  {
    const Tree_graph::Node& n = tree_.graph().nodes[i];
    return left_.degree(i) == 2 && nodes_.vertex(i) == null_index && n.halfedge == null_index && n.loop == null_index &&
           i != root_;
  }

  /// is a polyline in a face.
  struct Chain
  {
    Index begin, end, widest; // nodes, and the edge with the largest gap
    std::size_t first_step, end_step;
    std::size_t first_point, end_point; // of what is drawn
  };

  struct Step
  {
    Index edge, from;
  };

  void find_chain(Index first)
  {
    // back to where it starts, then forth
    Index edge = first, from = nodes_.representative(tree_.graph().edges[first].nodes[0]);
    while(is_passed(from))
    {
      edge = left_.next(from, edge);
      if(edge == first)
        break; // a cycle within the face, which is not possible up to rounding
      from = other_end(edge, from);
    }
    Chain chain{from, from, edge, steps_.size(), 0, 0, 0};
    while(true)
    {
      is_drawn_[edge] = 1;
      if(tree_.graph().edges[edge].gap > tree_.graph().edges[chain.widest].gap)
        chain.widest = edge;
      steps_.push_back({edge, from});
      from = other_end(edge, from);
      if(!is_passed(from) || is_drawn_[left_.next(from, edge)])
        break;
      edge = left_.next(from, edge);
    }
    chain.end = from;
    chain.end_step = steps_.size();
    chains_.push_back(chain);
  }

  Index face_of(const Chain& c) const { return tree_.graph().edges[c.widest].face; }

  void lay_out_chains(const Progress& progress)
  {
    const auto enumerate = [&](const auto& add)
    {
      for(Index i = 0; i < chains_.size(); ++i)
        add(face_of(chains_[i]), i);
    };
    const Compressed_rows<Index> in_face(mesh_.number_of_faces(), enumerate);
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
    {
      progress(f, mesh_.number_of_faces());
      if(in_face.size(f) > 0)
        lay_out_face(in_face[f]);
    }
  }

  using Chains = Compressed_rows<Index>::Row; // of a face

  /// The tolerance is smaller where chains cross each other else: down to the accuracy of the nodes, and then the chains
  /// follow the nodes alone, between which they do not cross each other.
  void lay_out_face(const Chains& chains)
  {
    constexpr double finest = 1e-8, all = (std::numeric_limits<double>::infinity)();
    const std::size_t first_point = points_.size();
    for(double t = tolerance();; t = t > finest * connectivity_.mean_edge_length ? 0.1 * t : all)
    {
      points_.resize(first_point);
      for(Index i : chains)
        lay_out(chains_[i], t);
      if(chains.size() < 2 || !cross_each_other(chains))
        return;
      if(!(t < all))
        break;
    }
    untangle(chains);
  }

  /// Where even the lines between nodes cross each other, branches are closer than nodes are accurate. Nodes inside of the
  /// face are moved towards places where no lines cross, as little as is enough.
  void untangle(const Chains& chains)
  {
    const Index f = face_of(chains_[*chains.begin()]);
    const std::size_t first_point = chains_[*chains.begin()].first_point;
    std::vector<Index> nodes;
    std::vector<std::array<Index, 2>> links;
    for(Index i : chains)
      for(std::size_t k = chains_[i].first_step; k < chains_[i].end_step; ++k)
      {
        links.push_back({{steps_[k].from, other_end(steps_[k].edge, steps_[k].from)}});
        nodes.insert(nodes.end(), links.back().begin(), links.back().end());
      }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for(std::array<Index, 2>& link : links)
      for(Index& i : link)
        i = static_cast<Index>(std::lower_bound(nodes.begin(), nodes.end(), i) - nodes.begin());
    std::vector<Plane_point> before(nodes.size());
    std::vector<unsigned char> is_fixed(nodes.size());
    for(std::size_t i = 0; i < nodes.size(); ++i)
    {
      before[i] = place(nodes[i], f);
      is_fixed[i] = nodes_.rank(nodes[i]) > 0 || left_.degree(nodes[i]) == 1;
    }
    std::vector<Plane_point> planar = before;
    move_to_planar_positions(links, is_fixed, planar);
    const auto move = [&](double share)
    {
      for(std::size_t i = 0; i < nodes.size(); ++i)
        if(!is_fixed[i])
          moved_[nodes[i]] = between(before[i], planar[i], share);
      points_.resize(first_point);
      for(Index i : chains)
        lay_out(chains_[i], (std::numeric_limits<double>::infinity)());
    };
    for(double share = 1e-8; share < 2.; share *= 10.)
    {
      move(share);
      if(!cross_each_other(chains))
        return;
    }
    move(0.); // what crosses is on the boundary of the face
  }

  bool cross_each_other(const Chains& chains)
  {
    crossings_.clear();
    // in coordinates in which the face is not thin
    const Face_corners corners = tree_.ridges().layout(face_of(chains_[*chains.begin()]));
    const auto scaled = [&](const Plane_point& p) -> Plane_point
    {
      const std::array<double, 3> c = coordinates_in(corners, p);
      return {c[1], c[2]};
    };
    for(Index i : chains)
    {
      const Chain& c = chains_[i];
      for(std::size_t k = c.first_point + 1; k < c.end_point; ++k)
        crossings_.add(scaled(points_[k - 1].point), scaled(points_[k].point));
    }
    return crossings_.has_any();
  }

  Index other_end(Index edge, Index i) const
  {
    const std::array<Index, 2>& nodes = tree_.graph().edges[edge].nodes;
    const Index first = nodes_.representative(nodes[0]);
    return first == i ? nodes_.representative(nodes[1]) : first;
  }

  /// the end of the edge that node `i` stands for: that one has a place in the face of the edge
  Index own_end(Index i, Index edge) const
  {
    const std::array<Index, 2>& nodes = tree_.graph().edges[edge].nodes;
    return nodes_.representative(nodes[0]) == i ? nodes[0] : nodes[1];
  }

  struct Point
  {
    Plane_point point;
    double distance;
  };

  /// adds the points of a chain that are needed so that it leaves the cut locus by the tolerance at most
  void lay_out(Chain& c, double tolerance)
  {
    constexpr double all = (std::numeric_limits<double>::infinity)();
    all_points_.clear();
    add_point(c.begin, steps_[c.first_step].edge);
    for(std::size_t i = c.first_step; i < c.end_step; ++i)
    {
      if(tolerance < all)
        add_points_between(steps_[i].edge, steps_[i].from, tolerance);
      add_point(other_end(steps_[i].edge, steps_[i].from), steps_[i].edge);
    }
    is_left_.assign(all_points_.size(), tolerance < all ? 0 : 1);
    is_left_.front() = is_left_.back() = 1;
    starts_and_ends_on_edge_ = are_on_one_edge(c.begin, c.end);
    if(tolerance < all)
      simplify(0, all_points_.size() - 1, tolerance);
    c.first_point = points_.size();
    for(std::size_t k = 0; k < all_points_.size(); ++k)
      if(is_left_[k])
        points_.push_back(all_points_[k]);
    c.end_point = points_.size();
  }

  void add_point(Index i, Index edge)
  {
    const Index own = own_end(i, edge);
    const Index f = tree_.graph().edges[edge].face;
    const Plane_point p = place(i, f);
    all_points_.push_back({nodes_.rank(i) > 0 ? p : inside(f, p), tree_.graph().nodes[own].distance});
  }

  /// where a node is drawn, in the frame of the first halfedge of a face
  Plane_point place(Index i, Index f) const
  {
    const auto moved = moved_.find(i);
    if(moved != moved_.end())
      return moved->second;
    for(Index k = 0; k < 3; ++k)
      if(nodes_.vertex(i) != null_index && mesh_.triangles[f][k] == nodes_.vertex(i))
        return tree_.ridges().layout(f)[k];
    return nodes_.position(i, f);
  }

  void add_points_between(Index edge, Index from, double tolerance)
  {
    const Tree_graph::Edge& e = tree_.graph().edges[edge];
    if(e.piece == null_index)
      return;
    const Ridges::Piece& piece = tree_.ridges().piece(e.piece);
    if(!piece.is_bisector)
      return;
    samples_.clear();
    sample_bisector(piece.images[0], piece.images[1], tree_.ridges().piece_end(e.piece, 0),
                    tree_.ridges().piece_end(e.piece, 1), tolerance, samples_);
    const Plane_point p = nodes_.position(own_end(from, edge), e.face), q = tree_.ridges().piece_end(e.piece, 0),
                      r = tree_.ridges().piece_end(e.piece, 1);
    if(std::hypot(p.x - q.x, p.y - q.y) > std::hypot(p.x - r.x, p.y - r.y))
      std::reverse(samples_.begin(), samples_.end());
    for(const Plane_point& s : samples_)
      all_points_.push_back({inside(e.face, s), piece.images[0].distance(s)});
  }

  /// by which the curve leaves the cut locus at most: small beside what a face differs from any surface it stands for
  double tolerance() const { return 1e-4 * connectivity_.mean_edge_length; }

  void draw(const Chain& c)
  {
    const Index last = node(c.end);
    Index previous = node(c.begin);
    for(std::size_t i = c.first_point + 1; i + 1 < c.end_point; ++i)
    {
      const Index next = static_cast<Index>(graph.nodes.size());
      graph.nodes.push_back(
        {location(tree_.graph().edges[c.widest].face, points_[i].point), null_index, points_[i].distance});
      add_segment(previous, next, c.widest);
      previous = next;
    }
    add_segment(previous, last, c.widest);
  }

  bool are_on_one_edge(Index i, Index j) const
  {
    const Tree_graph::Node &a = tree_.graph().nodes[i], &b = tree_.graph().nodes[j];
    if(nodes_.rank(i) == 0 || nodes_.rank(j) == 0)
      return false;
    if(nodes_.rank(i) == 1 && nodes_.rank(j) == 1)
      return a.halfedge == b.halfedge;
    return true; // at a vertex
  }

  /// marks the points between two that are needed (Douglas and Peucker)
  void simplify(std::size_t first, std::size_t last, double tolerance)
  {
    const Plane_point &p = all_points_[first].point, &q = all_points_[last].point;
    const double ux = q.x - p.x, uy = q.y - p.y, uu = ux * ux + uy * uy;
    double most = 0.;
    std::size_t farthest = first;
    for(std::size_t i = first + 1; i < last; ++i)
    {
      const double vx = all_points_[i].point.x - p.x, vy = all_points_[i].point.y - p.y;
      const double s = uu > 0. ? (std::min)((std::max)((ux * vx + uy * vy) / uu, 0.), 1.) : 0.;
      const double away = std::hypot(vx - s * ux, vy - s * uy);
      if(away > most)
      {
        most = away;
        farthest = i;
      }
    }
    // between points of one edge of the mesh even the flattest arc stays: shortest paths may follow the edge
    if(most <= tolerance && !(first == 0 && last + 1 == all_points_.size() && starts_and_ends_on_edge_ && most > 0.))
      return;
    is_left_[farthest] = 1;
    simplify(first, farthest, tolerance);
    simplify(farthest, last, tolerance);
  }

  void add_segment(Index i, Index j, Index widest)
  {
    const Tree_graph::Edge& e = tree_.graph().edges[widest];
    Indexed_cut_locus::Edge edge{i, j, mesh_edge(graph.nodes[i].vertex, graph.nodes[j].vertex, e.face),
                                 e.is_between_sources() ? gap_between_sources : static_cast<float>(e.gap), null_index};
    edge.width = tree_.shown_width(widest);
    edge.curvature = static_cast<float>(tree_.curvature(widest));
    edge.sources = e.sources;
    graph.edges.push_back(edge);
    face.push_back(e.face);
  }

  /// the edge of the face between two of its vertices, if they are such
  Index mesh_edge(Index u, Index v, Index f) const
  {
    if(u != null_index && v != null_index)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if((mesh_.source(h) == u && mesh_.target(h) == v) || (mesh_.source(h) == v && mesh_.target(h) == u))
          return h;
    return null_index;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Exact_geodesic_propagation& geodesics_;
  Exact_tree& tree_;
  const Merged_nodes nodes_;
  std::vector<unsigned char> is_drawn_; // edges
  Index root_ = null_index;
  std::vector<Index> number_; // of nodes
  Edges_left left_;           // at nodes
  std::vector<Chain> chains_;
  std::vector<Step> steps_; // of all chains
  Segment_crossings crossings_;
  std::vector<Point> points_, all_points_; // of all chains, and more than are needed of the one in work
  std::vector<Plane_point> samples_;
  std::vector<unsigned char> is_left_;
  std::unordered_map<Index, Plane_point> moved_; // nodes, in the frame of the first halfedge of their face
  bool starts_and_ends_on_edge_ = false;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CURVES_TREE_CURVE_H
