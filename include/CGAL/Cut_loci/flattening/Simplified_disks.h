// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_SIMPLIFIED_DISKS_H
#define CGAL_CUT_LOCI_FLATTENING_SIMPLIFIED_DISKS_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/flattening/Disk_shape.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A disk with fewer and fewer faces: a vertex moves to a neighbor, and its faces become those of that one. Vertices of the
// border move along it, and only where it is nearly straight.
class Simplified_disks
{
public:
  struct Removed_vertex
  {
    Index vertex;
    std::vector<Index> link; // its neighbors, counterclockwise: the faces were those of it and two of them each
    bool is_on_border;       // then the first neighbor and the last one are on it, too, and not in a face with it
  };

  struct Level
  {
    std::vector<Triangle_corners> triangles;
    std::vector<Removed_vertex> removed; // from the level before, in this order
  };

  explicit Simplified_disks(const Disk_shape& disk)
  {
    levels.push_back({disk.triangles, {}});
    if(!build(disk))
      return;
    for(std::size_t size = disk.points.size(); all_edges_have_lengths(); size -= levels.back().removed.size())
    {
      levels.emplace_back();
      simplify();
      if(static_cast<double>(levels.back().removed.size()) >= least_part * static_cast<double>(size))
        continue;
      levels.pop_back();
      break;
    }
  }

  std::vector<Level> levels; // from the disk itself on

private:
  // Steps on all levels but the first cost less than those on the first, and as little is between two of them as Newton's
  // method levels out in a few.
  static constexpr double kept_part = 0.25;
  // else steps cost about as much as on the level before
  static constexpr double least_part = 0.5;
  // from a straight angle, where the border may go straight on: what turns more is a corner
  static constexpr double most_turn = 45.; // degrees

  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point_3>;
  using Profile = Surface_mesh_simplification::Edge_profile<Mesh>;

  // The vertex of an edge that stays: one of the border, if there is one.
  static bool first_stays(const Profile& profile)
  {
    const Mesh& mesh = profile.surface_mesh();
    return mesh.is_border(profile.v0()) && (!mesh.is_border(profile.v1()) || is_straight(mesh, profile.v1()));
  }

  // The neighbors of a vertex, counterclockwise; of one on the border, from the next vertex of that to the last one.
  static void find_link(const Mesh& mesh, Mesh::Vertex_index v, std::vector<Mesh::Vertex_index>& link)
  {
    Mesh::Halfedge_index first = mesh.halfedge(v);
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(mesh.is_border(h))
        first = h;
    link.clear();
    Mesh::Halfedge_index h = first;
    do
    {
      link.push_back(mesh.source(h));
      h = mesh.prev(mesh.opposite(h)); // counterclockwise
    } while(h != first);
  }

  // whether the border may go straight on where it has this vertex, and more than one face there
  static bool is_straight(const Mesh& mesh, Mesh::Vertex_index v)
  {
    std::vector<Mesh::Vertex_index> link;
    find_link(mesh, v, link);
    double angle = 0.;
    for(std::size_t i = 1; i < link.size(); ++i)
      angle += CGAL::approximate_angle(mesh.point(link[i - 1]), mesh.point(v), mesh.point(link[i]));
    return link.size() > 2 && std::fabs(angle - 180.) <= most_turn;
  }

  struct Stop
  {
    template <typename Cost, typename Size>
    bool operator()(const Cost&, const Profile&, Size, Size current) const
    {
      return static_cast<double>(current) <= edges;
    }
    double edges;
  };

  struct Placement
  {
    auto operator()(const Profile& profile) const
      -> decltype(Surface_mesh_simplification::Midpoint_placement<Mesh>()(profile))
    {
      const Mesh& mesh = profile.surface_mesh();
      if(mesh.is_border(profile.v0()) && mesh.is_border(profile.v1()) &&
         (!mesh.is_border(mesh.edge(profile.v0_v1())) ||
          (!is_straight(mesh, profile.v0()) && !is_straight(mesh, profile.v1()))))
        return {};
      return first_stays(profile) ? profile.p0() : profile.p1();
    }
  };

  struct Visitor : public Surface_mesh_simplification::Edge_collapse_visitor_base<Mesh>
  {
    template <typename Place>
    void OnCollapsing(const Profile& profile, const Place& place)
    {
      if(!place)
        return;
      const Mesh& mesh = profile.surface_mesh();
      const bool is_first = first_stays(profile);
      const Mesh::Vertex_index gone = is_first ? profile.v1() : profile.v0();
      stays = original[is_first ? profile.v0() : profile.v1()];
      Removed_vertex vertex;
      vertex.vertex = original[gone];
      vertex.is_on_border = mesh.is_border(gone);
      find_link(mesh, gone, link);
      for(const Mesh::Vertex_index v : link)
        vertex.link.push_back(original[v]);
      removed->push_back(vertex);
    }

    void OnCollapsed(const Profile&, const Mesh::Vertex_index& v) { original[v] = stays; }

    std::vector<Removed_vertex>* removed;
    Mesh::Property_map<Mesh::Vertex_index, Index> original;
    Index stays = null_index;
    std::vector<Mesh::Vertex_index> link;
  };

  // Returns whether a surface mesh can have these faces: not if two edges join the same vertices.
  bool build(const Disk_shape& disk)
  {
    for(const auto& p : disk.points)
      mesh_.add_vertex(Point_3(p[0], p[1], p[2]));
    original_ = mesh_.add_property_map<Mesh::Vertex_index, Index>("v:original").first;
    for(const Mesh::Vertex_index v : mesh_.vertices())
      original_[v] = static_cast<Index>(v);
    for(const Triangle_corners& t : disk.triangles)
      if(mesh_.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2])) ==
         Mesh::null_face())
        return false;
    return true;
  }

  // Others are collapsed without the visitor being asked.
  bool all_edges_have_lengths() const
  {
    const auto edges = mesh_.edges();
    return std::all_of(edges.begin(), edges.end(),
                       [&](Mesh::Edge_index e)
                       { return mesh_.point(mesh_.vertex(e, 0)) != mesh_.point(mesh_.vertex(e, 1)); });
  }

  void simplify()
  {
    Level& level = levels.back();
    Visitor visitor;
    visitor.removed = &level.removed;
    visitor.original = original_;
    Surface_mesh_simplification::edge_collapse(
      mesh_, Stop{kept_part * static_cast<double>(mesh_.number_of_edges())},
      parameters::get_cost(Surface_mesh_simplification::Edge_length_cost<Mesh>())
        .get_placement(Placement())
        .visitor(visitor));
    for(const Mesh::Face_index f : mesh_.faces())
    {
      const Mesh::Halfedge_index h = mesh_.halfedge(f);
      level.triangles.push_back(
        {{original_[mesh_.source(h)], original_[mesh_.target(h)], original_[mesh_.target(mesh_.next(h))]}});
    }
  }

  Mesh mesh_;
  Mesh::Property_map<Mesh::Vertex_index, Index> original_; // vertices keep other indices than their places do
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_SIMPLIFIED_DISKS_H
