// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_METHOD_HOMOLOGY_H
#define CGAL_CUT_LOCI_LAPLACIAN_METHOD_HOMOLOGY_H

#include <CGAL/Cut_loci/internal/vertex_queue.h>
#include <CGAL/Cut_loci/laplacian_method/region_growing_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {

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

#endif // CGAL_CUT_LOCI_LAPLACIAN_METHOD_HOMOLOGY_H
