// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DESCENT_FOREST_H
#define CGAL_CUT_LOCI_DESCENT_FOREST_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/internal/Steepest_descent.h>
#include <CGAL/Cut_loci/internal/vector_3.h>
#include <CGAL/Cut_loci/internal/vertex_queue.h>
#include <CGAL/Cut_loci/region_growing_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Follows the steepest descent of the distance, linear in each face, from every vertex to the source.
class Descent_tracer
{
public:
  Descent_tracer(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                 const std::vector<double>& distance, const Indexed_source& source)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), descent_(mesh, connectivity, distance_),
      exit_(mesh.number_of_faces(), null_index), is_claimed_(mesh.number_of_faces(), 0),
      is_at_source_(mesh.number_of_vertices(), 0)
  {
    claim_source(source);
    fill_pits();
  }

  // whether a path crosses each edge
  std::vector<unsigned char> operator()()
  {
    // From the farthest down: long paths come first, and later ones end where they meet one. So hardly any path is
    // made of many short pieces, each starting anew at a vertex, which would add up to a drift along edges of the mesh.
    std::vector<Index> order(mesh_.number_of_vertices());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(), [&](Index v, Index w) { return distance_[v] > distance_[w]; });
    for(Index v : order)
      if(!is_at_source_[v])
        descend(v);
    std::vector<unsigned char> result(connectivity_.number_of_edges(), 0);
    for(Index f = 0; f < exit_.size(); ++f)
      if(is_claimed_[f] && exit_[f] != null_index)
        result[connectivity_.edge_of_halfedge[exit_[f]]] = 1;
    return result;
  }

private:
  using Outflow = Steepest_descent::Outflow;
  using Slope = Steepest_descent::Slope;
  enum class Turn { AT_GOAL, CLAIMED, STUCK };

  // The source's faces are the root: those around a vertex, the two of an edge.
  void claim_source(const Indexed_source& source)
  {
    const Source_element element(connectivity_, source);
    if(element.vertex == null_index)
    {
      claim_root(source.location.face);
      if(element.edge == null_index)
        return;
      const Index h = connectivity_.halfedge_of_edge[element.edge];
      if(mesh_.is_border_edge(h))
        return;
      const Index inside = h / 3 == source.location.face ? h : mesh_.opposite[h], o = mesh_.opposite[inside];
      claim_root(o / 3);
      exit_[o / 3] = o;
      return;
    }
    is_at_source_[element.vertex] = 1;
    // The tree takes the source by the first edge in its ring (see `region_growing_tree()`): no path crosses that one.
    for(Index k = connectivity_.ring_begin[element.vertex]; k < connectivity_.ring_begin[element.vertex + 1]; ++k)
    {
      const Index h = connectivity_.ring_halfedge[k];
      is_at_source_[connectivity_.ring_vertex[k]] = 1;
      if(mesh_.source(h) != element.vertex)
        continue; // the last edge at a border
      is_claimed_[h / 3] = 1;
      if(k > connectivity_.ring_begin[element.vertex])
        exit_[h / 3] = h;
    }
  }

  void claim_root(Index f)
  {
    is_claimed_[f] = 1;
    for(Index v : mesh_.triangles[f])
      is_at_source_[v] = 1;
  }

  // Where the distance has minima of its own, as that of an approximate solver may, it is raised until it flows over.
  void fill_pits()
  {
    const Index nv = mesh_.number_of_vertices();
    bool has_pit = false;
    for(Index v = 0; v < nv && !has_pit; ++v)
      has_pit = !is_at_source_[v] && !has_lower_neighbor(v);
    if(!has_pit)
      return;
    // a slope that is far below any other, and far above rounding
    const double step = 1e-6 * connectivity_.mean_edge_length;
    Vertex_queue queue;
    std::vector<unsigned char> is_reached(nv, 0);
    for(Index v = 0; v < nv; ++v)
      if(is_at_source_[v])
      {
        is_reached[v] = 1;
        queue.push({distance_[v], v});
      }
    while(!queue.empty())
    {
      const Index v = queue.top().vertex;
      queue.pop();
      for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      {
        const Index w = connectivity_.ring_vertex[k];
        if(is_reached[w])
          continue;
        is_reached[w] = 1;
        distance_[w] = (std::max)(distance_[w], distance_[v] + step);
        queue.push({distance_[w], w});
      }
    }
  }

  bool has_lower_neighbor(Index v) const
  {
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      if(distance_[connectivity_.ring_vertex[k]] < distance_[v])
        return true;
    return false;
  }

  // Records the path from `v` until it meets a face that has one. What is recorded again overwrites the way that led
  // in a circle.
  void descend(Index v)
  {
    const Outflow out = descent_.outflow(v);
    if(out.halfedge == null_index)
      return;
    const Index start = out.halfedge / 3;
    Index f = start, steps = 0;
    if(is_claimed_[f])
      return;
    const bool arrives = out.is_along ? arrive(f, other_end(out.halfedge, v), steps)
                                      : cross_faces(f, mesh_.next(out.halfedge), out.place, steps);
    if(!arrives)
      return;
    for(f = start; !is_claimed_[f]; f = mesh_.opposite[exit_[f]] / 3)
      is_claimed_[f] = 1;
  }

  Index other_end(Index h, Index v) const { return mesh_.source(h) == v ? mesh_.target(h) : mesh_.source(h); }

  // Leaves `f` across its halfedge `h`; whether there is another face, and where.
  bool step(Index& f, Index h)
  {
    if(mesh_.is_border_edge(h))
      return false;
    exit_[f] = h;
    f = mesh_.opposite[h] / 3;
    return true;
  }

  // Goes on in face `f` towards the point at `place` of its halfedge `h`; false if the source is out of reach.
  bool cross_faces(Index f, Index h, double place, Index& steps)
  {
    while(++steps < mesh_.number_of_halfedges())
    {
      const Index lower = distance_[mesh_.target(h)] < distance_[mesh_.source(h)] ? mesh_.target(h) : mesh_.source(h);
      if(mesh_.is_border_edge(h))
        return arrive(f, lower, steps); // along the border
      const Index o = mesh_.opposite[h];
      if(is_claimed_[o / 3])
        return step(f, h);
      const Slope s = descent_.slope(o);
      if(!(s.y > 0.))
        return arrive(f, lower, steps); // the faces on both sides lead to the edge, which leads on
      step(f, h);
      const double x = (1. - place) * s.length, side = s.x * s.apex_y - s.y * (s.apex_x - x);
      // the distances of the ends of the edge that is left from the line of descent
      if(side > 0.)
      {
        const double below = s.y * (s.length - x);
        h = mesh_.next(o);
        place = below / (below + side);
      }
      else
      {
        const double below = s.y * x;
        h = mesh_.previous(o);
        place = -side / (below - side);
      }
    }
    return false;
  }

  // Goes on from vertex `w`, a corner of `f`, around it to where its own way down starts.
  bool arrive(Index f, Index w, Index& steps)
  {
    while(++steps < mesh_.number_of_halfedges())
    {
      if(is_at_source_[w])
        return turn_to_claimed(f, w);
      const Outflow out = descent_.outflow(w);
      if(out.halfedge == null_index)
        return false;
      const Index goal = out.halfedge / 3;
      const Turn turned = turn(f, w, [&](Index g) { return g == goal || (out.is_along && has_edge(g, out.halfedge)); });
      if(turned != Turn::AT_GOAL)
        return turned == Turn::CLAIMED;
      if(!out.is_along)
        return cross_faces(f, mesh_.next(out.halfedge), out.place, steps);
      w = other_end(out.halfedge, w);
    }
    return false;
  }

  bool has_edge(Index f, Index h) const
  {
    return f == h / 3 || (!mesh_.is_border_edge(h) && f == mesh_.opposite[h] / 3);
  }

  // At a corner of the source's faces, one of which is there.
  bool turn_to_claimed(Index& f, Index w)
  {
    return turn(f, w, [](Index) { return false; }) == Turn::CLAIMED;
  }

  // the face after `f` around `w`, and the halfedge of `f` between
  Index neighbor(Index f, Index w, bool is_counterclockwise, Index& h) const
  {
    h = 3 * f;
    while(mesh_.source(h) != w)
      ++h;
    if(is_counterclockwise)
      h = mesh_.previous(h);
    return mesh_.is_border_edge(h) ? null_index : mesh_.opposite[h] / 3;
  }

  // Walks around `w` to the first face that is a goal, or claimed, on the way with fewer faces.
  template <typename Is_goal>
  Turn turn(Index& f, Index w, const Is_goal& is_goal)
  {
    if(is_claimed_[f])
      return Turn::CLAIMED;
    if(is_goal(f))
      return Turn::AT_GOAL;
    Index best_steps = null_index;
    bool best_way = true;
    for(bool way : {true, false})
    {
      Index g = f, h, n = 0;
      do
      {
        g = neighbor(g, w, way, h);
        ++n;
      } while(g != null_index && g != f && !is_goal(g) && !is_claimed_[g]);
      if(g != null_index && g != f && n < best_steps)
      {
        best_steps = n;
        best_way = way;
      }
    }
    if(best_steps == null_index)
      return Turn::STUCK;
    for(Index n = 0; n < best_steps; ++n)
    {
      Index h;
      neighbor(f, w, best_way, h);
      step(f, h);
    }
    return is_claimed_[f] ? Turn::CLAIMED : Turn::AT_GOAL;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  std::vector<double> distance_; // without pits
  Steepest_descent descent_;
  std::vector<Index> exit_;
  std::vector<unsigned char> is_claimed_, is_at_source_;
};

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * follows the steepest descent of the distance from each vertex to the source, and tells for each edge whether such a
 * path crosses it. No shortest path crosses the cut locus: so the cut locus is looked for among the other edges.
 *
 * The distance is taken as linear in each face, whatever it comes from; pits that an approximate one may have are
 * filled first. A path that meets a face with a path follows that one from there on. So the faces and the edges that
 * are crossed form a tree with the faces of the source as root, and the other edges hold a tree of all vertices and 2g
 * edges more on a surface of genus g, each border loop being one node. Along the border, paths run in its faces. Time
 * is O(n log n).
 *
 * @return 1 for each edge of `connectivity` that is crossed, 0 for the others
 */
inline std::vector<unsigned char> edges_crossed_by_descents(const Indexed_triangle_mesh& mesh,
                                                            const Mesh_connectivity& connectivity,
                                                            const std::vector<double>& distance,
                                                            const Indexed_source& source)
{
  return internal::Descent_tracer(mesh, connectivity, distance, source)();
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_DESCENT_FOREST_H
