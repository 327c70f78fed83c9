// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_CELLS_OF_FACES_H
#define CGAL_CUT_LOCI_FACE_GRAPH_CELLS_OF_FACES_H

#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/location_in_part.h>
#include <CGAL/Cut_locus.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci {

namespace internal {

// The sources of the parts into which the seams divide the faces.
class Part_sources
{
public:
  explicit Part_sources(const Refined_mesh& refined)
    : refined_(refined), parts_(refined.mesh.number_of_faces()), source_(refined.mesh.number_of_faces(), no_source)
  {
    for_each_inner_edge(
      [&](Index h)
      {
      if(!refined.seams[h])
        parts_.unite(h / 3, refined.mesh.opposite[h] / 3);
    });
  }

  // the first one that is found counts
  void set(Index face, std::size_t source)
  {
    std::size_t& at = source_[parts_.find(face)];
    at = at == no_source ? source : at;
  }

  // What rounding has cut off has the source of a part beside it.
  void spread()
  {
    for(bool has_changed = true; has_changed;)
    {
      has_changed = false;
      for_each_inner_edge(
        [&](Index h)
        {
        const std::size_t a = (*this)(h / 3), b = (*this)(refined_.mesh.opposite[h] / 3);
        if((a == no_source) == (b == no_source))
          return;
        set(h / 3, b);
        set(refined_.mesh.opposite[h] / 3, a);
        has_changed = true;
      });
    }
  }

  std::size_t operator()(Index face) { return source_[parts_.find(face)]; }

private:
  template <typename Function>
  void for_each_inner_edge(const Function& function) const
  {
    for(Index h = 0; h < refined_.mesh.number_of_halfedges(); ++h)
      if(!refined_.mesh.is_border_edge(h) && h < refined_.mesh.opposite[h])
        function(h);
  }

  const Refined_mesh& refined_;
  Union_find parts_;
  std::vector<std::size_t> source_;
};

// For each face of a mesh that has been split along the cut locus the source whose cell it is in. `vertices` tells the dense
// indices of those that the mesh had before.
//
// The points in faces first, as there may be no vertex in their cells; then what the vertices know that are on no seam,
// those close to their sources first: a smoothed curve may leave others in the cell of a source that is not their nearest.
template <typename TriangleMesh, typename Point_3>
std::vector<std::size_t> cells_of_faces(const Read_triangle_mesh<TriangleMesh>& read,
                                        const std::vector<Index>& vertices, const Curve_on_mesh& curve,
                                        const Refined_mesh& refined, const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  Part_sources parts(refined);
  for(std::size_t i = 0; i < curve.sources.size(); ++i)
    if(curve.sources[i].vertex == null_index)
      parts.set(location_in_part(read.mesh, refined.mesh, refined.faces, curve.sources[i].location).face, i);
  std::vector<bool> is_on_seam(refined.mesh.number_of_vertices(), false);
  for(Index h = 0; h < refined.mesh.number_of_halfedges(); ++h)
    if(refined.seams[h])
      is_on_seam[refined.mesh.source(h)] = is_on_seam[refined.mesh.target(h)] = true;
  std::vector<std::pair<double, Index>> inside; // distances, and a halfedge from each vertex
  for(Index h = 0; h < refined.mesh.number_of_halfedges(); ++h)
    if(const Index v = refined.mesh.source(h); v < vertices.size() && !is_on_seam[v])
      inside.emplace_back(cut_locus.distance(read.vertices[vertices[v]]), h);
  std::sort(inside.begin(), inside.end());
  for(const std::pair<double, Index>& at : inside)
    if(const auto nearest = cut_locus.nearest_source(read.vertices[vertices[refined.mesh.source(at.second)]]))
      parts.set(at.second / 3, *nearest);
  parts.spread();
  std::vector<std::size_t> result;
  for(Index f = 0; f < refined.mesh.number_of_faces(); ++f)
    result.push_back(parts(f));
  return result;
}

} // namespace internal
} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_FACE_GRAPH_CELLS_OF_FACES_H
