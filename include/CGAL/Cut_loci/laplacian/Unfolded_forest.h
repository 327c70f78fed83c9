// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_UNFOLDED_FOREST_H
#define CGAL_CUT_LOCI_LAPLACIAN_UNFOLDED_FOREST_H

#include <CGAL/Cut_loci/laplacian/Source_roots.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The shortest ways from point sources to the vertices that cross no edges but those of a forest of faces.
//
// Each tree of the forest is laid out in the plane, where faces may overlap, from the face of its source on. What the
// source sees through a row of faces is a funnel: between two chains of corners, which the ways to the ends of the last
// edge bend around. The corner behind that edge is seen past one of them, or straight from where the chains part: the
// funnel algorithm \cgalCite{cgal:lp-espsb-84}, in a tree of triangles.
class Unfolded_forest
{
public:
  // `crossed` tells the edges of the forest
  Unfolded_forest(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Source_roots& roots,
                  const std::vector<double>& distance, const std::vector<unsigned char>& crossed)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), exit_(mesh.number_of_faces(), null_index),
      corners_(mesh.number_of_faces()), length_(mesh.number_of_vertices(), infinity())
  {
    for(Index i = 0; i < roots.points().size(); ++i)
      start(roots.points()[i], roots.face(i));
    while(!stack_.empty())
    {
      const Index f = stack_.back();
      stack_.pop_back();
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(crossed[connectivity.edge_of_halfedge[h]] && h != exit_[f])
          if(const Index o = mesh.opposite[h], g = o / 3; exit_[g] == null_index)
          {
            exit_[g] = o;
            enter(g);
            double& length = length_[corner_behind(o)];
            length = (std::min)(length, corners_[g].length);
            stack_.push_back(g);
          }
    }
  }

  // by how much the shortest way to a vertex is longer than its distance
  double detour(Index v) const { return detour(v, length_[v]); }

  // Leads the faces of a path, given by the halfedges across which it leaves them, all along it, if that makes the squares
  // of all detours less in sum: those that are long count most. `faces` is how many may be passed and laid out anew, and
  // becomes less by those that are.
  bool reroute(const std::vector<Index>& path, std::size_t& faces)
  {
    if(path.empty() || leads_back(path, faces) || faces == 0)
      return false;
    next_attempt();
    changed_.clear();
    for(Index h : path)
      if(exit_[h / 3] != h)
        changed_.push_back({h / 3, exit_[h / 3]});
    if(changed_.empty())
      return false;
    laid_out_.clear();
    vertices_.clear();
    for(Index h : path)
      exit_[h / 3] = h;
    for(std::size_t i = changed_.size(); i-- > 0;) // those next to the source first, as others hang on them
    {
      if(changed_[i].second != null_index)
        add_vertex(corner_behind(changed_[i].second));
      if(attempt_of_face_[changed_[i].first] != attempt_)
        lay_out_again(changed_[i].first);
    }
    faces -= (std::min)(faces, laid_out_.size());
    if(has_gain())
      return is_changed_ = true;
    for(const auto& c : changed_)
      exit_[c.first] = c.second;
    for(std::size_t i = laid_out_.size(); i-- > 0;) // backwards, as a face may be there twice
      corners_[laid_out_[i].first] = laid_out_[i].second;
    return false;
  }

  // Leads the way to a vertex along the edge to a neighbor, and on as that to the neighbor goes, if that is shorter and
  // makes the squares of all detours less in sum. Where shortest paths to several vertices pass the same slim faces and
  // then part, one of them at most can have those; such a way needs none but the faces around the neighbor.
  void lead_along_edge(Index v, std::size_t& faces)
  {
    Index along = null_index;
    double least = length_[v];
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
    {
      const Index w = connectivity_.ring_vertex[k];
      const double length = length_[w] + edge_length(mesh_, connectivity_.ring_halfedge[k]);
      if(length < least)
      {
        least = length;
        along = connectivity_.ring_halfedge[k];
      }
    }
    if(along == null_index)
      return;
    const Index o = mesh_.opposite[along], w = mesh_.source(along) == v ? mesh_.target(along) : mesh_.source(along);
    for(Index h : {along, o})
      if(h != null_index && turn(h, w))
        if(reroute(turn_, faces))
          return;
  }

  bool is_changed() const { return is_changed_; }

  // the edges of the forest now; what had no source keeps those of `before`
  std::vector<unsigned char> crossed_edges(const std::vector<unsigned char>& before) const
  {
    std::vector<unsigned char> result(before.size(), 0);
    for(Index e = 0; e < before.size(); ++e)
      if(before[e])
        result[e] = exit_[connectivity_.halfedge_of_edge[e] / 3] == null_index;
    for(Index h : exit_)
      if(h < mesh_.number_of_halfedges())
        result[connectivity_.edge_of_halfedge[h]] = 1;
    return result;
  }

private:
  static constexpr double infinity() { return (std::numeric_limits<double>::infinity)(); }

  // The corner of a face opposite to the edge across which it is entered; or a source, or a corner of its face.
  struct Corner
  {
    Planar_vector position = {{0., 0.}};
    double length = infinity();  // of the shortest way
    Index previous = null_index; // the corner around which that bends last, or the source
    // the corners at the ends of that edge, as seen from there, and where the ways to them part
    Index left = null_index, right = null_index, parting = null_index;
    int side = 0; // of the chain on which `previous` is: -1 left, 1 right, 0 where they part
  };

  void start(const Indexed_source& source, Index f)
  {
    const std::array<double, 3> c = in_face(mesh_, source.location, f).coordinates;
    const Index h = 3 * f, first = static_cast<Index>(corners_.size());
    const std::array<Planar_vector, 3> position = {{{{0., 0.}}, {{edge_length(mesh_, h), 0.}}, apex(mesh_, h)}};
    corners_.resize(corners_.size() + 4);
    Corner& origin = corners_[first];
    origin.position = c[0] * position[0] + (c[1] * position[1] + c[2] * position[2]);
    origin.length = 0.;
    for(Index i = 0; i < 3; ++i)
    {
      Corner& corner = corners_[first + 1 + i];
      corner.position = position[i];
      corner.length = norm(position[i] - origin.position);
      corner.previous = first;
      length_[mesh_.source(h + i)] = (std::min)(length_[mesh_.source(h + i)], corner.length);
    }
    exit_[f] = mesh_.number_of_halfedges() + first; // a number that no halfedge has
    stack_.push_back(f);
  }

  bool is_root(Index f) const { return exit_[f] != null_index && exit_[f] >= mesh_.number_of_halfedges(); }

  Index corner_behind(Index exit) const { return mesh_.source(mesh_.previous(exit)); }

  // the corner at the source of a halfedge of a face that has been entered
  Index corner_at(Index h) const
  {
    const Index f = h / 3, x = exit_[f];
    if(!is_root(f))
      return h == x ? corners_[f].left : h == mesh_.next(x) ? corners_[f].right : f;
    const Index first = x - mesh_.number_of_halfedges(), corner = first + 1 + h % 3;
    return corners_[corner].length > 0. ? corner : first;
  }

  // Where the ways to the ends of a halfedge part, which is not the one across which its face has been entered.
  Index parting_at(Index h) const
  {
    const Index f = h / 3;
    if(is_root(f))
      return exit_[f] - mesh_.number_of_halfedges();
    const int side = h == mesh_.previous(exit_[f]) ? -1 : 1; // between the corner behind and the left end, or the right
    return corners_[f].side == side ? corners_[f].previous : corners_[f].parting;
  }

  // Lays out face `f`, after that to which its exit leads.
  void enter(Index f)
  {
    const Index x = exit_[f], o = mesh_.opposite[x];
    Corner& c = corners_[f];
    c.left = corner_at(mesh_.next(o));
    c.right = corner_at(o);
    c.parting = parting_at(o);
    const Planar_vector& a = corners_[c.left].position;
    const Planar_vector base = corners_[c.right].position - a, along = (1. / norm(base)) * base, top = apex(mesh_, x);
    c.position = {{a[0] + top[0] * along[0] - top[1] * along[1], a[1] + top[0] * along[1] + top[1] * along[0]}};
    c.side = bends(c.left, 1., c) ? -1 : bends(c.right, -1., c) ? 1 : 0;
    if(c.side == 0)
      c.previous = c.parting;
    c.length = corners_[c.previous].length + norm(c.position - corners_[c.previous].position);
  }

  // Whether the way to a corner bends around one of the chain from `u` back to where the chains part, and where last.
  bool bends(Index u, double sign, Corner& c) const
  {
    for(; u != c.parting; u = corners_[u].previous)
    {
      const Planar_vector &at = corners_[u].position, &before = corners_[corners_[u].previous].position;
      if(sign * cross(at - before, c.position - at) >= 0.)
      {
        c.previous = u;
        return true;
      }
    }
    return false;
  }

  double length_to(Index v) const
  {
    double result = infinity();
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      if(const Index h = connectivity_.ring_halfedge[k]; mesh_.source(h) == v && exit_[h / 3] != null_index)
        result = (std::min)(result, corners_[corner_at(h)].length);
    return result;
  }

  double detour(Index v, double length) const
  {
    return length < infinity() ? (std::max)(0., length - distance_[v]) : 0.;
  }

  // Whether the way behind a path comes back to it, if its faces are left along it, or ends before a source.
  bool leads_back(const std::vector<Index>& path, std::size_t& faces)
  {
    next_attempt();
    for(Index h : path)
      attempt_of_face_[h / 3] = attempt_;
    Index f = mesh_.opposite[path.back()] / 3;
    for(; exit_[f] != null_index && !is_root(f) && attempt_of_face_[f] != attempt_; f = mesh_.opposite[exit_[f]] / 3)
      faces -= faces > 0 ? 1 : 0;
    return !is_root(f);
  }

  // Whether the lengths of the ways to the vertices of an attempt are better than before, which they become then.
  bool has_gain()
  {
    double gain = 0.;
    new_length_.clear();
    for(Index v : vertices_)
    {
      new_length_.push_back(length_to(v));
      const double before = detour(v), after = detour(v, new_length_.back());
      gain += before * before - after * after;
    }
    for(std::size_t i = 0; i < vertices_.size() && gain > 0.; ++i)
      length_[vertices_[i]] = new_length_[i];
    return gain > 0.;
  }

  // Sets the halfedges that a way around `w` crosses, from the face of `h`, which is at `w`, on the side where that is not
  // across `h`, to where the shortest way to `w` arrives; false if there is a border before.
  bool turn(Index h, Index w)
  {
    turn_.clear();
    const bool is_counterclockwise = mesh_.source(h) == w;
    const auto corner = [&](Index g) { return corner_at(mesh_.source(g) == w ? g : mesh_.next(g)); };
    while(exit_[h / 3] == null_index || corners_[corner(h)].length > length_[w])
    {
      const Index x = is_counterclockwise ? mesh_.previous(h) : mesh_.next(h);
      if(mesh_.is_border_edge(x) || is_root(h / 3) || turn_.size() > connectivity_.valence(w))
        return false;
      turn_.push_back(x);
      h = mesh_.opposite[x];
    }
    return true;
  }

  void next_attempt()
  {
    ++attempt_;
    attempt_of_face_.resize(mesh_.number_of_faces(), 0);
    attempt_of_vertex_.resize(mesh_.number_of_vertices(), 0);
  }

  void add_vertex(Index v)
  {
    if(attempt_of_vertex_[v] != attempt_)
      vertices_.push_back(v);
    attempt_of_vertex_[v] = attempt_;
  }

  // A face and all that hang on it.
  void lay_out_again(Index root)
  {
    stack_.assign(1, root);
    while(!stack_.empty())
    {
      const Index f = stack_.back();
      stack_.pop_back();
      attempt_of_face_[f] = attempt_;
      laid_out_.push_back({f, corners_[f]});
      enter(f);
      add_vertex(corner_behind(exit_[f]));
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(const Index o = mesh_.opposite[h]; o != null_index && exit_[o / 3] == o)
          stack_.push_back(o / 3);
    }
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  std::vector<Index> exit_;     // the halfedge across which a face is left towards the source
  std::vector<Corner> corners_; // of the faces, then those of the sources
  std::vector<double> length_;  // of the shortest way to each vertex
  bool is_changed_ = false;
  // attempts to make detours shorter: their number, that of the last one at each face and vertex, and what it has changed
  Index attempt_ = 0;
  std::vector<Index> attempt_of_face_, attempt_of_vertex_;
  std::vector<std::pair<Index, Index>> changed_;   // faces, and their exits before
  std::vector<std::pair<Index, Corner>> laid_out_; // faces, and their corners before
  std::vector<Index> vertices_, stack_, turn_;
  std::vector<double> new_length_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_UNFOLDED_FOREST_H
