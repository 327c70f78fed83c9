// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_DESCENT_FOREST_H
#define CGAL_CUT_LOCI_LAPLACIAN_DESCENT_FOREST_H

#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/vertex_queue.h>
#include <CGAL/Cut_loci/laplacian/Exact_descent.h>
#include <CGAL/Cut_loci/laplacian/Path_flow.h>
#include <CGAL/Cut_loci/laplacian/Source_roots.h>
#include <CGAL/Cut_loci/laplacian/Steepest_descent.h>
#include <CGAL/Cut_loci/laplacian/Unfolded_forest.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Follows the ways down from every vertex to a source: the shortest paths where these are known, or else the steepest
// descent of the distance, linear in each face.
class Descent_tracer
{
public:
  // `geodesics` may be null
  Descent_tracer(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                 const std::vector<double>& distance, const Source_roots& roots, const Geodesic_results* geodesics)
    : mesh_(mesh), connectivity_(connectivity), roots_(roots), distance_(distance),
      descent_(mesh, connectivity, distance_), flow_(mesh, connectivity),
      place_on_path_(mesh.number_of_halfedges(), null_index), is_at_source_(mesh.number_of_vertices(), 0)
  {
    if(geodesics != nullptr)
      exact_.reset(new Exact_descent(mesh, connectivity, *geodesics));
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
      if(is_root(f))
        for(Index v : mesh.triangles[f])
          is_at_source_[v] = 1;
    if(roots.number_of_sources() > 1)
    {
      source_of_path_.assign(mesh.number_of_halfedges(), null_index);
      nearest_.assign(mesh.number_of_vertices(), null_index);
      name_vertices_at_sources();
    }
    fill_pits();
  }

  // whether a path crosses each edge
  std::vector<unsigned char> operator()(const Progress& progress)
  {
    // From the farthest down: long paths come first, and later ones end where they meet one. So hardly any path is
    // made of many short pieces, each starting anew at a vertex, which would add up to a drift along edges of the mesh.
    std::vector<Index> order(mesh_.number_of_vertices());
    std::iota(order.begin(), order.end(), Index(0));
    progress(0.05);
    std::stable_sort(order.begin(), order.end(), [&](Index v, Index w) { return distance_[v] > distance_[w]; });
    const Progress descents = progress.part(0.1, 0.7);
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      descents(i, order.size());
      if(!is_at_source_[order[i]])
        descend(order[i]);
    }
    name_other_vertices(order);
    std::vector<unsigned char> result = flow_.forest(roots_, progress.part(0.7, 0.9));
    if(roots_.parts().empty())
      shorten_detours(result, progress.part(0.9, 1.));
    return result;
  }

  // of several sources, the one where the way from each vertex ends
  std::vector<Index>& nearest_sources() { return nearest_; }

private:
  using Outflow = Steepest_descent::Outflow;
  using Slope = Steepest_descent::Slope;
  enum class Turn { AT_GOAL, ARRIVED, STUCK };

  // How a path leaves a vertex: along an edge to another one, or through a face.
  struct Start
  {
    Index face = null_index;
    Index along = null_index;
    Exact_descent::Way way; // `image` means nothing unless it is exact
    bool is_exact = false;
  };

  bool is_root(Index f) const { return roots_.owner(f) != null_index; }

  // No way is followed from there: the nearest of the sources in the faces around.
  void name_vertices_at_sources()
  {
    std::vector<double> least(mesh_.number_of_vertices(), (std::numeric_limits<double>::infinity)());
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
      if(is_root(f))
        for(Index v : mesh_.triangles[f])
          if(const double d = distance_to_root(f, v); d < least[v])
          {
            least[v] = d;
            nearest_[v] = roots_.owner(f);
          }
  }

  // from a corner of a face to what the source to which that belongs has in it
  double distance_to_root(Index f, Index v) const
  {
    const Index owner = roots_.owner(f);
    if(owner < roots_.points().size())
      return norm(mesh_.points[v] - position(mesh_, roots_.points()[owner].location));
    const Index part = owner - static_cast<Index>(roots_.points().size());
    double result = (std::numeric_limits<double>::infinity)();
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(roots_.parts().part(mesh_.source(h)) == part)
        result =
          (std::min)(result, roots_.parts().is_on_source(h) ? distance_to_edge(v, h)
                                                            : norm(mesh_.points[v] - mesh_.points[mesh_.source(h)]));
    return result;
  }

  double distance_to_edge(Index v, Index h) const
  {
    const Vector& a = mesh_.points[mesh_.source(h)];
    const Vector along = mesh_.points[mesh_.target(h)] - a, to = mesh_.points[v] - a;
    const double share = (std::max)(0., (std::min)(1., dot(to, along) / dot(along, along)));
    return norm(to - share * along);
  }

  // Those whose way does not arrive have the source of a neighbor further down.
  void name_other_vertices(const std::vector<Index>& from_farthest)
  {
    for(std::size_t i = from_farthest.size(); i-- > 0 && !nearest_.empty();)
    {
      const Index v = from_farthest[i];
      double least = nearest_[v] == null_index ? distance_[v] : 0.; // nothing is below that
      for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
        if(const Index w = connectivity_.ring_vertex[k]; distance_[w] < least)
        {
          least = distance_[w];
          nearest_[v] = nearest_[w];
        }
    }
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

  // Records the path from `v`, unless it ends before a source.
  void descend(Index v)
  {
    if(!trace(v))
      return;
    if(!nearest_.empty())
      name_source(v);
    if(!path_.empty())
      flow_.add(path_);
  }

  // Paths that join older ones, and those for which the forest has no room, have become longer. Leads what has become much
  // longer another way again, where others lose less by that: along an edge first, which takes few faces from others, then
  // along a path of its own.
  void shorten_detours(std::vector<unsigned char>& crossed, const Progress& progress)
  {
    Unfolded_forest forest(mesh_, connectivity_, roots_, distance_, crossed);
    progress(0.5);
    shorten_detours(forest, [&](Index v, std::size_t& faces) { forest.lead_along_edge(v, faces); });
    progress(0.75);
    joins_older_ = false;
    shorten_detours(forest,
                    [&](Index v, std::size_t& faces)
                    {
      const bool arrives = trace(v);
      faces -= (std::min)(faces, path_.size());
      if(arrives)
        forest.reroute(path_, faces);
    });
    if(forest.is_changed())
      crossed = forest.crossed_edges(crossed);
  }

  // The longest ones first, by `shorten`, which is given how many faces may be passed and makes that less by those that
  // are: as many as have been unfolded, so that this takes no longer.
  template <typename Shorten>
  void shorten_detours(const Unfolded_forest& forest, const Shorten& shorten) const
  {
    const double most = connectivity_.mean_edge_length; // a curve of mesh edges is not more accurate
    std::vector<Index> order;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(forest.detour(v) > most)
        order.push_back(v);
    std::stable_sort(order.begin(), order.end(), [&](Index v, Index w) { return forest.detour(v) > forest.detour(w); });
    std::size_t faces = mesh_.number_of_faces();
    for(std::size_t i = 0; i < order.size() && faces > 0; ++i)
      if(forest.detour(order[i]) > most)
        shorten(order[i], faces);
  }

  // that of an older path if this one ends there, or of the face where it ends
  void name_source(Index v)
  {
    const Index met = path_.empty() || !flow_.is_recorded(path_.back()) ? null_index : source_of_path_[path_.back()];
    nearest_[v] = met != null_index ? met : roots_.owner(end_);
    for(Index h : path_)
      source_of_path_[h] = nearest_[v];
  }

  // Sets the path from `v` to the source, or to an older path.
  bool trace(Index v)
  {
    path_.clear();
    const Start start = leave(v);
    if(start.face == null_index)
      return false;
    Index f = start.face, steps = 0;
    const bool arrives = is_root(f) || (start.along != null_index ? arrive(f, start.way.vertex, steps)
                                                                  : cross_faces(f, start.way, start.is_exact, steps));
    for(Index h : path_)
      place_on_path_[h] = null_index;
    end_ = f;
    return arrives;
  }

  Start leave(Index v) const
  {
    Start result;
    if(exact_ != nullptr)
      result.way = exact_->leave(v);
    result.is_exact = result.way.exists();
    if(!result.is_exact)
    {
      const Outflow out = descent_.outflow(v);
      if(out.halfedge == null_index)
        return result;
      if(out.is_along)
        result.way.vertex = mesh_.source(out.halfedge) == v ? mesh_.target(out.halfedge) : mesh_.source(out.halfedge);
      else
      {
        result.way.halfedge = mesh_.next(out.halfedge);
        result.way.place = out.place;
      }
    }
    if(result.way.vertex == null_index)
      result.face = result.way.halfedge / 3;
    else
      for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
        if(connectivity_.ring_vertex[k] == result.way.vertex)
        {
          result.along = connectivity_.ring_halfedge[k];
          result.face = result.along / 3;
        }
    return result;
  }

  bool joins_older(Index h) const { return joins_older_ && flow_.is_recorded(h); }

  // Leaves `f` across its halfedge `h`; whether there is another face, and where. What leads in a circle is forgotten.
  bool step(Index& f, Index h)
  {
    if(mesh_.is_border_edge(h))
      return false;
    while(place_on_path_[h] < path_.size())
    {
      place_on_path_[path_.back()] = null_index;
      path_.pop_back();
    }
    place_on_path_[h] = static_cast<Index>(path_.size());
    path_.push_back(h);
    f = mesh_.opposite[h] / 3;
    return true;
  }

  // Goes on in face `f` towards the end of `way`; false if the source is out of reach.
  bool cross_faces(Index& f, Exact_descent::Way way, bool is_exact, Index& steps)
  {
    while(++steps < mesh_.number_of_halfedges())
    {
      const Index h = way.halfedge;
      const Index lower = distance_[mesh_.target(h)] < distance_[mesh_.source(h)] ? mesh_.target(h) : mesh_.source(h);
      if(mesh_.is_border_edge(h))
        return arrive(f, lower, steps); // along the border
      const Index o = mesh_.opposite[h];
      if(is_root(o / 3) || joins_older(h))
        return step(f, h);
      Exact_descent::Way next;
      if(is_exact)
        next = exact_->across(way);
      is_exact = next.exists();
      if(!is_exact && !descend_across(o, way.place, next))
        return arrive(f, lower, steps); // the faces on both sides lead to the edge, which leads on
      if(next.vertex == null_index || (next.vertex != mesh_.source(h) && next.vertex != mesh_.target(h)))
        step(f, h);
      if(next.vertex != null_index)
        return arrive(f, next.vertex, steps);
      way = next;
    }
    return false;
  }

  // The steepest descent in the face of `o`, from the point at `place` of its opposite.
  bool descend_across(Index o, double place, Exact_descent::Way& next) const
  {
    const Slope s = descent_.slope(o);
    if(!(s.y > 0.))
      return false;
    const double x = (1. - place) * s.length, side = s.x * s.apex_y - s.y * (s.apex_x - x);
    // the distances of the ends of the edge that is left from the line of descent
    const double below = s.y * (side > 0. ? s.length - x : x);
    next.halfedge = side > 0. ? mesh_.next(o) : mesh_.previous(o);
    next.place = side > 0. ? below / (below + side) : -side / (below - side);
    return true;
  }

  // Goes on from vertex `w`, a corner of `f`, around it to where its own way down starts.
  bool arrive(Index& f, Index w, Index& steps)
  {
    while(++steps < mesh_.number_of_halfedges())
    {
      if(is_at_source_[w])
        return turn(f, w, [](Index) { return false; }) == Turn::ARRIVED;
      const Start start = leave(w);
      if(start.face == null_index)
        return false;
      const Turn turned =
        turn(f, w, [&](Index g) { return g == start.face || (start.along != null_index && has_edge(g, start.along)); });
      if(turned != Turn::AT_GOAL)
        return turned == Turn::ARRIVED;
      if(start.along == null_index)
        return cross_faces(f, start.way, start.is_exact, steps);
      w = start.way.vertex;
    }
    return false;
  }

  bool has_edge(Index f, Index h) const
  {
    return f == h / 3 || (!mesh_.is_border_edge(h) && f == mesh_.opposite[h] / 3);
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

  // Walks around `w` to the first face that is a goal, or one of the source, on the way with fewer faces. An older path
  // may be met on the way.
  template <typename Is_goal>
  Turn turn(Index& f, Index w, const Is_goal& is_goal)
  {
    if(is_root(f))
      return Turn::ARRIVED;
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
      } while(g != null_index && g != f && !is_goal(g) && !is_root(g));
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
      const bool is_recorded = joins_older(h);
      step(f, h);
      if(is_recorded)
        return Turn::ARRIVED;
    }
    return is_root(f) ? Turn::ARRIVED : Turn::AT_GOAL;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Source_roots& roots_;
  std::vector<double> distance_; // without pits
  Steepest_descent descent_;
  std::unique_ptr<const Exact_descent> exact_; // if shortest paths are known
  bool joins_older_ = true;                    // where it meets one
  Path_flow flow_;
  std::vector<Index> path_, place_on_path_;     // the halfedges that the present one crosses, and the inverse
  Index end_ = null_index;                      // the face where it ends
  std::vector<unsigned char> is_at_source_;     // vertices
  std::vector<Index> source_of_path_, nearest_; // of several: by halfedges of recorded paths, and by vertex
};

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * follows the way down from each vertex to the sources, and tells for each edge whether such a path crosses it. No
 * shortest path crosses the cut locus: so the cut locus is looked for among the other edges.
 *
 * The paths are the shortest ones if an exact solver has found them. Else they are the steepest descents of the distance,
 * taken as linear in each face, whatever it comes from; pits that an approximate one may have are filled first. A path
 * that crosses an edge as an older one did follows that one from there on.
 *
 * The faces and the edges that are crossed must form a forest, so that the other edges hold a tree of all vertices and 2g
 * edges more on a surface of genus g, each border loop being one node. Where paths pass something on both sides, the
 * crossings by the fewest are given up. Then the forest is unfolded. Where the shortest way to a vertex that crosses no
 * other edges is longer than its distance by more than a mean edge, the forest is led along an edge to a neighbor and on as
 * that goes, or along a path of its own, if the squares of all detours become less in sum; so it is if all sources are
 * points. Of several sources, no tree of that forest has more than one. Along the border, paths run in its
 * faces. Time is O(n log n).
 *
 * @param geodesics what the exact solver found with `distance`, or null
 * @param nearest_sources if not null, becomes the number of the source where the path from each vertex ends; empty if
 *        there is one source
 *
 * @return 1 for each edge of `connectivity` that is crossed, 0 for the others
 */
inline std::vector<unsigned char>
edges_crossed_by_descents(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                          const std::vector<double>& distance, const Source_roots& roots,
                          const internal::Geodesic_results* geodesics = nullptr,
                          const internal::Progress& progress = {}, std::vector<Index>* nearest_sources = nullptr)
{
  internal::Descent_tracer tracer(mesh, connectivity, distance, roots, geodesics);
  std::vector<unsigned char> result = tracer(progress);
  if(nearest_sources != nullptr)
    nearest_sources->swap(tracer.nearest_sources());
  return result;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_DESCENT_FOREST_H
