// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BRANCH_ENDS_H
#define CGAL_CUT_LOCI_BRANCH_ENDS_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/cusp_fit.h>
#include <CGAL/Cut_loci/direction_field.h>
#include <CGAL/Cut_loci/direction_pruning.h>
#include <CGAL/Cut_loci/internal/Geodesic_fronts.h>
#include <CGAL/Cut_loci/internal/vector_3.h>
#include <CGAL/Cut_loci/sub_edge_placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * moves the ends of the branches of a curve through the faces to where `Cusp_fit` finds them: a branch that is too
 * short is continued towards the source, and one that is too long is cut back. Where there is no valid fit, it stays
 * as it is.
 */
class Branch_ends
{
public:
  Branch_ends(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
              const Direction_geometry& geometry, const Direction_field& field)
    : mesh_(mesh), connectivity_(connectivity), geometry_(geometry), field_(field),
      fronts_(mesh, connectivity, geometry, field), cusp_(mesh, connectivity, geometry, field)
  {
  }

  /// the vertices nearest to the continuations, each list from the end of the branch on
  std::vector<std::vector<Index>> operator()(const std::vector<Direction_branches::Edge>& branches,
                                             Sub_edge_curve& curve) const
  {
    std::vector<std::vector<Index>> result;
    std::vector<Index> faces; // with a part of the curve in them
    for(const Direction_branches::Edge& e : branches)
      faces.insert(faces.end(), {e.outer, e.inner});
    std::sort(faces.begin(), faces.end());
    std::vector<unsigned char> is_removed(curve.graph.edges.size(), 0);
    for(Index i = 0; i < branches.size(); ++i)
      for(Index f : {branches[i].outer, branches[i].inner})
      {
        const auto range = std::equal_range(faces.begin(), faces.end(), f);
        if(f < mesh_.number_of_faces() && range.second - range.first == 1)
          move_end(branches, i, f, faces, curve, is_removed, result);
      }
    remove(curve, is_removed);
    return result;
  }

private:
  using Fronts = internal::Geodesic_fronts;

  void move_end(const std::vector<Direction_branches::Edge>& branches, Index node, Index f,
                const std::vector<Index>& faces, Sub_edge_curve& curve, std::vector<unsigned char>& is_removed,
                std::vector<std::vector<Index>>& continuations) const
  {
    using namespace internal;
    const Index h = connectivity_.halfedge_of_edge[branches[node].edge];
    const Index inside = h / 3 == f ? h : mesh_.opposite[h];
    const Fronts::Face_points points = fronts_.layout(f);
    const Fronts::Crossing crossing = fronts_.crossing(branches[node].edge);
    const Fronts::Point_2 p = Fronts::point(points, fronts_.coordinates(crossing, f));
    const Fronts::Point_2 ga = fronts_.front(f, inside % 3, points).gradient(p),
                          gb = fronts_.front(f, (inside + 1) % 3, points).gradient(p);
    Fronts::Point_2 ahead = {{ga[0] + gb[0], ga[1] + gb[1]}};
    const double size = std::sqrt(ahead[0] * ahead[0] + ahead[1] * ahead[1]);
    // Paths that come from opposite sides are at no cusp. On a coarse mesh they meet at more than 120 degrees two edges
    // beside one; then it is for the fit to say.
    if(size < 0.5)
      return;
    ahead = {{ahead[0] / size, ahead[1] / size}};

    const Vector &p0 = mesh_.points[mesh_.triangles[f][0]], &p1 = mesh_.points[mesh_.triangles[f][1]],
                 &p2 = mesh_.points[mesh_.triangles[f][2]];
    Vector e1 = p1 - p0;
    e1 = (1. / norm(e1)) * e1;
    Vector e2 = p2 - p0;
    e2 = e2 - dot(e2, e1) * e1;
    e2 = (1. / norm(e2)) * e2;
    const Vector start = p0 + p[0] * e1 + p[1] * e2;
    const Vector left = (-ahead[1]) * e1 + ahead[0] * e2;
    const Index a = mesh_.source(h), b = mesh_.target(h);
    const double from = field_.vertices[a].direction;
    const double direction = from + 0.5 * field_.turn(from, field_.vertices[b].direction);
    const std::optional<Cusp_fit::Cusp> cusp = cusp_(a, start, crossing.distance, direction, left);
    if(!cusp)
      return;
    const double excess = crossing.distance - cusp->distance;
    if(excess <= 0.)
    {
      cut_back(node, cusp->distance, curve, is_removed);
      return;
    }
    // towards the source, and sideways where the branch is bent
    const double side = (std::min)((std::max)(cusp->across, -excess), excess);
    const Fronts::Point_2 way = {{-excess * ahead[0] - side * ahead[1], -excess * ahead[1] + side * ahead[0]}};
    continue_branch(node, f, p, way, crossing.part < 0.5 ? a : b, branches[node].strength, cusp->distance, faces, curve,
                    is_removed, continuations);
  }

  // walks straight across the faces
  void continue_branch(Index node, Index f, Fronts::Point_2 p, Fronts::Point_2 way, Index snapped, float strength,
                       double end_distance, const std::vector<Index>& faces, Sub_edge_curve& curve,
                       std::vector<unsigned char>& is_removed, std::vector<std::vector<Index>>& continuations) const
  {
    std::vector<Index> vertices(1, snapped);
    double start_distance = curve.graph.nodes[node].distance;
    const double whole = std::sqrt(way[0] * way[0] + way[1] * way[1]);
    const auto add = [&](const std::array<double, 3>& c, double rest)
    {
      Indexed_location location;
      location.face = f;
      location.coordinates = c;
      const Index next = static_cast<Index>(curve.graph.nodes.size());
      curve.graph.nodes.push_back({location, null_index, end_distance + rest * (start_distance - end_distance)});
      curve.graph.edges.push_back({node, next, null_index, strength, null_index});
      curve.face.push_back(f);
      is_removed.push_back(0);
      const Index nearest = mesh_.triangles[f][std::max_element(c.begin(), c.end()) - c.begin()];
      if(nearest != vertices.back())
        vertices.push_back(nearest);
      node = next;
    };
    double done = 0.;
    for(int step = 0; step < 30 && whole > 1e-6 * geometry_.mean_edge_length; ++step)
    {
      const Fronts::Face_points points = fronts_.layout(f);
      const std::array<double, 3> c = Fronts::coordinates(points, p),
                                  end = Fronts::coordinates(points, {{p[0] + way[0], p[1] + way[1]}});
      double part = 1.;
      int exit = -1; // the vertex opposite to the edge
      bool turns_back = false;
      for(int i = 0; i < 3; ++i)
      {
        if(!(end[i] < 0.))
          continue;
        turns_back = turns_back || c[i] <= 1e-9;
        if(c[i] / (c[i] - end[i]) < part)
        {
          part = c[i] / (c[i] - end[i]);
          exit = i;
        }
      }
      if(turns_back)
        break;
      if(exit < 0)
      {
        std::array<double, 3> inside;
        for(int i = 0; i < 3; ++i)
          inside[i] = (std::max)(end[i], 0.);
        const double sum = inside[0] + inside[1] + inside[2];
        for(double& x : inside)
          x /= sum;
        add(inside, 0.);
        break;
      }
      std::array<double, 3> at;
      for(int i = 0; i < 3; ++i)
        at[i] = c[i] + part * (end[i] - c[i]);
      at[exit] = 0.;
      done += part * (1. - done);
      const Index h = 3 * f + (exit + 1) % 3, o = mesh_.opposite[h];
      add(at, 1. - done);
      if(o == null_index || std::binary_search(faces.begin(), faces.end(), o / 3) ||
         o / 3 == field_.source.location.face)
        break;
      // the rest of the way, in the frame of the next face
      const Fronts::Point_2 &s = points[h % 3], &t = points[(h + 1) % 3];
      const double angle_here = std::atan2(t[1] - s[1], t[0] - s[0]);
      f = o / 3;
      const Fronts::Face_points next_points = fronts_.layout(f);
      const Fronts::Point_2 &s2 = next_points[(o + 1) % 3], &t2 = next_points[o % 3];
      const double turn = std::atan2(t2[1] - s2[1], t2[0] - s2[0]) - angle_here;
      const double u = at[h % 3], w = at[(h + 1) % 3];
      p = {{u * s2[0] + w * t2[0], u * s2[1] + w * t2[1]}};
      const double rest = 1. - part;
      way = {{rest * (std::cos(turn) * way[0] - std::sin(turn) * way[1]),
              rest * (std::sin(turn) * way[0] + std::cos(turn) * way[1])}};
    }
    if(vertices.size() > 1)
      continuations.push_back(vertices);
  }

  // removes the nodes from the end that are nearer to the source than the cusp, up to the next branch point
  void cut_back(Index node, double distance, Sub_edge_curve& curve, std::vector<unsigned char>& is_removed) const
  {
    Indexed_cut_locus& graph = curve.graph;
    for(int steps = 0; steps < 30; ++steps)
    {
      Index edge = null_index, others = 0;
      for(Index e = 0; e < graph.edges.size(); ++e)
        if(!is_removed[e] && (graph.edges[e].source == node || graph.edges[e].target == node))
        {
          edge = e;
          ++others;
        }
      if(others != 1)
        return;
      Indexed_cut_locus::Edge& segment = graph.edges[edge];
      const Index next = segment.source == node ? segment.target : segment.source;
      const double d = graph.nodes[node].distance, e = graph.nodes[next].distance;
      if(e > distance)
      {
        // A new end on the segment, in its face.
        const double t = e > d ? (std::min)((std::max)((distance - d) / (e - d), 0.), 0.99) : 0.;
        const std::array<double, 3> c = coordinates(graph.nodes[node].location, curve.face[edge]),
                                    b = coordinates(graph.nodes[next].location, curve.face[edge]);
        Indexed_cut_locus::Node& end = graph.nodes[node];
        end.location.face = curve.face[edge];
        for(int i = 0; i < 3; ++i)
          end.location.coordinates[i] = (1. - t) * c[i] + t * b[i];
        end.distance = distance;
        return;
      }
      is_removed[edge] = 1;
      node = next;
    }
  }

  std::array<double, 3> coordinates(const Indexed_location& location, Index f) const
  {
    std::array<double, 3> result = {{0., 0., 0.}};
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        if(mesh_.triangles[location.face][i] == mesh_.triangles[f][j])
          result[j] = location.coordinates[i];
    return result;
  }

  static void remove(Sub_edge_curve& curve, const std::vector<unsigned char>& is_removed)
  {
    Indexed_cut_locus& graph = curve.graph;
    if(std::find(is_removed.begin(), is_removed.end(), 1) == is_removed.end())
      return;
    std::vector<Index> index(graph.nodes.size(), null_index);
    std::size_t size = 0;
    for(std::size_t e = 0; e < graph.edges.size(); ++e)
      if(!is_removed[e])
      {
        index[graph.edges[e].source] = index[graph.edges[e].target] = 0;
        graph.edges[size] = graph.edges[e];
        curve.face[size++] = curve.face[e];
      }
    graph.edges.resize(size);
    curve.face.resize(size);
    Index n = 0;
    for(std::size_t i = 0; i < index.size(); ++i)
      if(index[i] != null_index)
      {
        graph.nodes[n] = graph.nodes[i];
        index[i] = n++;
      }
    graph.nodes.resize(n);
    for(Indexed_cut_locus::Edge& e : graph.edges)
    {
      e.source = index[e.source];
      e.target = index[e.target];
    }
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Direction_geometry& geometry_;
  const Direction_field& field_;
  Fronts fronts_;
  Cusp_fit cusp_;
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_BRANCH_ENDS_H
