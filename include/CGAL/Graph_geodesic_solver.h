// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_GRAPH_GEODESIC_SOLVER_H
#define CGAL_GRAPH_GEODESIC_SOLVER_H

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_bucket_queue.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * approximates geodesic distances by shortest paths in a graph whose nodes are the vertices of the mesh and whose arcs
 * are the edges and the dual edges: the straight line across an edge to the opposite vertex, where it lies in the two
 * triangles laid out flat. The graph is built once per mesh in linear time, a source costs one run of Dijkstra's
 * algorithm.
 *
 * A path in the graph is a path on the surface: the distances are never too short, and exact along edges and dual
 * edges. They are too long by a few percent, whatever the resolution, as the arcs leave a vertex in about twelve
 * directions only.
 *
 * \cgalModels{GeodesicSolver}
 */
class Graph_geodesic_solver
{
public:
  /// paths in the graph are longer than those on the surface
  static bool is_approximate() { return true; }

  void set_mesh(const Cut_loci::Indexed_triangle_mesh& mesh)
  {
    mesh_ = &mesh;
    graph_ = std::make_shared<const Graph>(mesh);
  }

  void compute_distances(const Cut_loci::Indexed_source& source, std::vector<double>& distances)
  {
    compute_distances(std::vector<Cut_loci::Indexed_source>(1, source), distances);
  }

  /// computes the distances to the nearest of several sources, in one run
  void compute_distances(const std::vector<Cut_loci::Indexed_source>& sources, std::vector<double>& distances)
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    distances.assign(mesh_->number_of_vertices(), infinity);
    std::vector<double> taken_at(distances); // the distance from which the arcs of a vertex have been followed
    Cut_loci::internal::Geodesic_bucket_queue queue(graph_->width);
    const auto reach = [&](Index v, double distance)
    {
      if(!(distance < distances[v]))
        return;
      distances[v] = distance;
      queue.push(distance, v);
    };
    const double scale = graph_->unit;
    for(const Cut_loci::Indexed_source& source : sources)
      if(source.vertex != Cut_loci::null_index)
        reach(source.vertex, 0.);
      else
        reach_from(source.location, [&](Index v, double distance) { reach(v, distance / scale); });

    // Within a bucket, vertices may be taken before a shorter way comes there, and then once more. The distances are the only
    // solution of Bellman's equations in floating point, whatever the order.
    for(Index v; queue.pop(v);)
    {
      const double distance = distances[v];
      if(!(distance < taken_at[v]))
        continue;
      taken_at[v] = distance;
      for(const Arc& arc : graph_->arcs[v])
        reach(arc.target, distance + arc.length);
    }
    for(double& d : distances)
      d *= scale;
  }

private:
  using Index = Cut_loci::Index;
  using Mesh = Cut_loci::Indexed_triangle_mesh;

  // Eight bytes: the arcs of a vertex fill one or two cache lines. The rounding of the length is far below the error
  // of the graph.
  struct Arc
  {
    Index target;
    float length;
  };

  struct Graph
  {
    Cut_loci::internal::Compressed_rows<Arc> arcs; // of each vertex
    double unit = 1.; // of the lengths: a power of two, so that meshes of any size fit single precision
    double width;     // of the buckets of waiting vertices: few arcs are shorter than a quarter of the mean edge

    explicit Graph(const Mesh& mesh)
    {
      using namespace Cut_loci::internal;
      double longest = 0., sum = 0.;
      for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      {
        longest = (std::max)(longest, edge_length(mesh, h));
        sum += edge_length(mesh, h);
      }
      if(longest > 0.)
        unit = std::ldexp(1., std::ilogb(longest));
      width = 0.25 * sum / (unit * mesh.number_of_halfedges());

      std::vector<float> dual_length(mesh.number_of_halfedges(), -1.f);
      for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
        if(!mesh.is_border_edge(h) && h < mesh.opposite[h])
        {
          const double length = straight_line_across(mesh, h, apex(mesh, h));
          dual_length[h] = length < 0. ? -1.f : static_cast<float>(length / unit);
        }
      const auto enumerate = [&](const auto& add)
      {
        const auto add_both = [&](Index v, Index w, float length)
        {
          add(v, {w, length});
          add(w, {v, length});
        };
        for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
        {
          const Index o = mesh.opposite[h];
          if(o < h)
            continue;
          add_both(mesh.source(h), mesh.target(h), static_cast<float>(edge_length(mesh, h) / unit));
          if(dual_length[h] >= 0.f)
            add_both(mesh.source(mesh.previous(h)), mesh.source(mesh.previous(o)), dual_length[h]);
        }
      };
      arcs = Compressed_rows<Arc>(mesh.number_of_vertices(), enumerate);
    }
  };

  // The length of the straight line from `p`, a point of the face of `h` laid out as by `flat_position`, across `h` to
  // the opposite vertex of the next face; negative if it misses the edge.
  static double straight_line_across(const Mesh& mesh, Index h, const std::array<double, 2>& p)
  {
    using namespace Cut_loci::internal;
    std::array<double, 2> q = apex(mesh, mesh.opposite[h]);
    const double length = edge_length(mesh, h);
    q = {{length - q[0], -q[1]}};
    const double height = p[1] - q[1];
    if(!(height > 0.))
      return -1.;
    const double crossing = (q[0] * p[1] - p[0] * q[1]) / height;
    if(!(crossing >= 0. && crossing <= length))
      return -1.;
    return std::hypot(q[0] - p[0], height);
  }

  // The vertices of the faces that the source lies in, and those across one more edge on a straight line.
  template <typename Reach>
  void reach_from(const Cut_loci::Indexed_location& location, const Reach& reach) const
  {
    reach_from_face(location, reach);
    for(Index i = 0; i < 3; ++i)
    {
      const Index h = 3 * location.face + i;
      if(location.coordinates[(i + 2) % 3] > 0. || mesh_->is_border_edge(h))
        continue;
      const Index o = mesh_->opposite[h];
      Cut_loci::Indexed_location other;
      other.face = o / 3;
      other.coordinates[o % 3] = location.coordinates[(i + 1) % 3];
      other.coordinates[(o + 1) % 3] = location.coordinates[i];
      reach_from_face(other, reach);
    }
  }

  template <typename Reach>
  void reach_from_face(const Cut_loci::Indexed_location& location, const Reach& reach) const
  {
    using namespace Cut_loci::internal;
    const Vector p = position(*mesh_, location);
    for(Index i = 0; i < 3; ++i)
    {
      const Index v = mesh_->triangles[location.face][i], h = 3 * location.face + i;
      reach(v, norm(mesh_->points[v] - p));
      if(mesh_->is_border_edge(h))
        continue;
      const double length = straight_line_across(*mesh_, h, flat_position(*mesh_, h, location.coordinates));
      if(length >= 0.)
        reach(mesh_->source(mesh_->previous(mesh_->opposite[h])), length);
    }
  }

  const Mesh* mesh_ = nullptr;
  std::shared_ptr<const Graph> graph_;
};

} // namespace CGAL

#endif // CGAL_GRAPH_GEODESIC_SOLVER_H
