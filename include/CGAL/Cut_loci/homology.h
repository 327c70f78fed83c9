// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HOMOLOGY_H
#define CGAL_CUT_LOCI_HOMOLOGY_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/internal/vector_3.h>
#include <CGAL/Cut_loci/internal/vertex_queue.h>
#include <CGAL/Cut_loci/region_growing_tree.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * grows a spanning tree of the vertices from the root of `tree`, those of largest distance first, so that its front
 * moves from the cut locus towards the source. Connected parts of `tree` in which all vertices have a strength of at
 * least `threshold` join as a whole as soon as one of their vertices does. Strong parts of the cut locus are thus
 * joined along the highest ridges of the distance: a weak part of the cut locus nearly follows the gradient. O(n log
 * n).
 */
inline Spanning_tree strength_aware_tree(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                         const Spanning_tree& tree, const std::vector<float>& strength,
                                         double threshold, const std::vector<double>& distance,
                                         const Source_element& source = Source_element())
{
  // the edges of `tree` between strong vertices, as lists of children
  const auto is_strong_edge = [&](Index v)
  { return strength[v] >= threshold && strength[tree.parent[v]] >= threshold; };
  std::vector<Index> first_child(tree.parent.size(), null_index), next_sibling(tree.parent.size(), null_index);
  for(Index v : tree.order)
    if(v != tree.root && is_strong_edge(v))
    {
      next_sibling[v] = first_child[tree.parent[v]];
      first_child[tree.parent[v]] = v;
    }

  // ascent of the distance from `w` along an edge in its ring; among edges of the same height the steepest is taken
  const auto slope = [&](Index w, Index entry)
  {
    using internal::operator-;
    const Index v = connectivity.ring_vertex[entry];
    return (distance[v] - distance[w]) / internal::norm(mesh.points[v] - mesh.points[w]);
  };

  // Prim's algorithm for the edges of largest height, the smaller distance of their ends
  Spanning_tree result = internal::rooted_tree(connectivity, tree.root);
  internal::Vertex_queue queue;
  std::vector<double> best(tree.parent.size(), -(std::numeric_limits<double>::infinity)());
  std::vector<Index> best_entry(tree.parent.size()); // in the ring of the vertex that waits
  std::vector<Index> joined(1, tree.root);           // in the tree, but what follows from that is not done yet
  const auto join = [&](Index v) { joined.push_back(v); };
  if(connectivity.is_border(tree.root))
    internal::add_border_loop(result, connectivity, tree.root, join);
  while(true)
  {
    while(!joined.empty())
    {
      const Index v = joined.back();
      joined.pop_back();
      if(v != tree.root && tree.contains(v) && is_strong_edge(v))
        internal::add_with_border_loop(result, connectivity, tree.parent_entry[v], v, source, join);
      for(Index c = first_child[v]; c != null_index; c = next_sibling[c])
        internal::add_with_border_loop(result, connectivity, connectivity.ring_reverse[tree.parent_entry[c]], v, source,
                                       join);
      for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
      {
        const Index w = connectivity.ring_vertex[entry];
        const double height = (std::min)(distance[v], distance[w]);
        if(result.contains(w) || height < best[w] || internal::is_at_source(connectivity, entry, v, source))
          continue;
        const Index candidate = connectivity.ring_reverse[entry];
        if(height > best[w])
          queue.push({-height, w});
        else if(slope(w, candidate) <= slope(w, best_entry[w]))
          continue;
        best[w] = height;
        best_entry[w] = candidate;
      }
    }
    if(queue.empty())
      break;
    const Index w = queue.top().vertex;
    queue.pop();
    if(!result.contains(w))
    {
      const Index entry = best_entry[w];
      internal::add_with_border_loop(result, connectivity, connectivity.ring_reverse[entry],
                                     connectivity.ring_vertex[entry], source, join);
    }
  }
  internal::add_source(result, connectivity, source);
  return result;
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * grows a spanning tree of the faces (the cotree) from those around the source, across edges that are not in the
 * spanning tree `tree`, faces of smallest mean distance first, and returns the halfedges of the edges that are in
 * neither: the generators of the first homology \cgalCite{cgal:ew-gohhb-05}, 2g of them on a surface of genus g,
 * where the two fronts of the cotree meet. The union of `tree` and the generators cuts the surface into one open
 * disk. Each border loop, which `tree` takes as one node, counts as part of that union. The source is in the cotree,
 * not on a generator, whatever the distances. O(n log n).
 *
 * @param crossed edges that are in the cotree first, as `edges_crossed_by_descents()` gives them: none of `tree`
 */
inline std::vector<Index> homology_generators(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                              const Spanning_tree& tree, const std::vector<double>& distance,
                                              const Indexed_source& source,
                                              const std::vector<unsigned char>& crossed = {})
{
  std::vector<bool> covered(connectivity.number_of_edges(), false);
  for(Index v : tree.order)
    if(v != tree.root)
      covered[connectivity.ring_edge(tree.parent_entry[v])] = true;

  std::vector<bool> reached(mesh.number_of_faces(), false);
  std::vector<Index> faces; // in the order in which they are reached
  internal::Vertex_queue queue;
  const auto push = [&](Index f)
  {
    reached[f] = true;
    faces.push_back(f);
    const Indexed_triangle_mesh::Triangle& t = mesh.triangles[f];
    queue.push({distance[t[0]] + distance[t[1]] + distance[t[2]], f});
  };
  const auto cross = [&](Index h)
  {
    const Index opposite = mesh.opposite[h], edge = connectivity.edge_of_halfedge[h];
    if(opposite == null_index || covered[edge] || reached[opposite / 3])
      return;
    covered[edge] = true;
    push(opposite / 3);
  };

  const Source_element element(connectivity, source);
  if(element.vertex != null_index)
  {
    // all faces around, from the tree's edge on
    const Index begin = connectivity.ring_begin[element.vertex], k = connectivity.valence(element.vertex);
    Index first = 0;
    if(!connectivity.is_border(element.vertex))
      while(first + 1 < k && !covered[connectivity.ring_edge(begin + first)])
        ++first;
    push(connectivity.ring_halfedge[begin + first] / 3);
    for(Index i = 1; i < k; ++i)
    {
      const Index before = mesh.opposite[connectivity.ring_halfedge[begin + (first + i) % k]];
      if(before != null_index && reached[before / 3])
        cross(before);
    }
  }
  else
    push(source.location.face);
  if(element.edge != null_index)
    for(Index h = 3 * source.location.face; h < 3 * source.location.face + 3; ++h)
      if(connectivity.edge_of_halfedge[h] == element.edge)
        cross(h);
  for(std::size_t i = 0; !crossed.empty() && i < faces.size(); ++i)
    for(Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h)
      if(crossed[connectivity.edge_of_halfedge[h]])
        cross(h);
  while(!queue.empty())
  {
    const Index f = queue.top().vertex;
    queue.pop();
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      cross(h);
  }

  std::vector<Index> generators;
  for(Index e = 0; e < connectivity.number_of_edges(); ++e)
    if(!covered[e] && !mesh.is_border_edge(connectivity.halfedge_of_edge[e]))
      generators.push_back(connectivity.halfedge_of_edge[e]);
  return generators;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_HOMOLOGY_H
