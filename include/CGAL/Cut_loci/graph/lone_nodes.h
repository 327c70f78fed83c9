// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_LONE_NODES_H
#define CGAL_CUT_LOCI_GRAPH_LONE_NODES_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * adds a node in each part of a mesh in which a curve has no edges: what is left of a cut locus of which all branches are
 * weak.
 *
 * It is at the vertex farthest from the sources, on the border if that is no source, as all of a curve would be joined to
 * it; if sources have all vertices of that border, on an edge of it, and if they have all vertices, in a face.
 *
 * @param face of each edge of the curve
 * @param distance of each vertex
 * @param is_source whether a halfedge on the border is
 * @return whether one has been added that is at no vertex, so that its distance is not known
 */
template <typename Is_source>
bool add_lone_nodes(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                    const std::vector<double>& distance, const std::vector<Index>& face, const Is_source& is_source,
                    Indexed_cut_locus& curve)
{
  Union_find parts(mesh.number_of_faces());
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!mesh.is_border_edge(h))
      parts.unite(h / 3, mesh.opposite[h] / 3);
  std::vector<unsigned char> has_node(mesh.number_of_faces(), 0);
  for(Index f : face)
    has_node[parts.find(f)] = 1;
  std::vector<Index> best(mesh.number_of_faces(), null_index); // the halfedge that leaves the vertex
  const auto is_better = [&](Index v, Index w)
  {
    const bool is_border = connectivity.is_border(v) && distance[v] > 0.;
    return is_border != (connectivity.is_border(w) && distance[w] > 0.) ? is_border : distance[v] > distance[w];
  };
  std::vector<Index> border(mesh.number_of_faces(), null_index); // a halfedge of it that is no source
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    const Index part = parts.find(h / 3);
    if(best[part] == null_index || is_better(mesh.source(h), mesh.source(best[part])))
      best[part] = h;
    if(mesh.is_border_edge(h) && !is_source(h))
      border[part] = h;
  }
  bool result = false;
  for(Index part = 0; part < mesh.number_of_faces(); ++part)
  {
    const Index h = best[part];
    if(h == null_index || has_node[part])
      continue;
    Indexed_cut_locus::Node node;
    node.location.face = h / 3;
    node.distance = distance[mesh.source(h)];
    if(node.distance > 0. && (border[part] == null_index || connectivity.is_border(mesh.source(h))))
    {
      node.location.coordinates[h % 3] = 1.;
      node.vertex = mesh.source(h);
    }
    else
    {
      result = true;
      node.location.coordinates = {{1. / 3., 1. / 3., 1. / 3.}};
      if(border[part] != null_index)
        node.location = location_on(border[part], 0.5);
    }
    curve.nodes.push_back(node);
  }
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_LONE_NODES_H
