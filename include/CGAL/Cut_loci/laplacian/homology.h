// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_HOMOLOGY_H
#define CGAL_CUT_LOCI_LAPLACIAN_HOMOLOGY_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/vertex_queue.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>
#include <CGAL/Cut_loci/laplacian/region_growing_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

// A spanning tree of the faces that grows across edges that are not covered, faces of smallest mean distance first.
class Cotree
{
public:
  // `covered` edges are not crossed
  Cotree(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const std::vector<double>& distance,
         std::vector<bool> covered)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), covered_(std::move(covered)),
      source_(mesh.number_of_faces(), null_index)
  {
  }

  // Starts with a face of each source; what else is at one follows across edges at it.
  void start(const Source_roots& roots)
  {
    if(roots.number_of_sources() == 1 && roots.points().size() == 1)
      return start(roots.points().front());
    for(Index i = 0; i < roots.number_of_sources(); ++i)
      push(roots.face(i), i);
    std::vector<unsigned char> is_inside(connectivity_.number_of_edges(), 0);
    for(Index h : roots.crossings())
      is_inside[connectivity_.edge_of_halfedge[h]] = 1;
    cross_first(is_inside, 0);
  }

  // Starts with all faces around the source; around a vertex, from the covered edge on.
  void start(const Indexed_source& source)
  {
    const Source_element element(connectivity_, source);
    if(element.vertex == null_index)
    {
      push(source.location.face, 0);
      for(Index h = 3 * source.location.face; h < 3 * source.location.face + 3; ++h)
        if(element.edge != null_index && connectivity_.edge_of_halfedge[h] == element.edge)
          cross(h);
      return;
    }
    const Index begin = connectivity_.ring_begin[element.vertex], k = connectivity_.valence(element.vertex);
    Index first = 0;
    if(!connectivity_.is_border(element.vertex))
      while(first + 1 < k && !covered_[connectivity_.ring_edge(begin + first)])
        ++first;
    push(connectivity_.ring_halfedge[begin + first] / 3, 0);
    for(Index i = 1; i < k; ++i)
    {
      const Index before = mesh_.opposite[connectivity_.ring_halfedge[begin + (first + i) % k]];
      if(before != null_index && is_reached(before / 3))
        cross(before);
    }
  }

  // Crosses what can be reached of these edges, if there are any, from the face of this number on; returns the next one.
  std::size_t cross_first(const std::vector<unsigned char>& crossed, std::size_t i)
  {
    for(; i < faces_.size() && !crossed.empty(); ++i)
      for(Index h = 3 * faces_[i]; h < 3 * faces_[i] + 3; ++h)
        if(crossed[connectivity_.edge_of_halfedge[h]])
          cross(h);
    return i;
  }

  // Crosses these edges as soon as they are reached, then those of the faces of least distance.
  void grow(const std::vector<unsigned char>& crossed, const Progress& progress)
  {
    std::size_t next = cross_first(crossed, 0);
    for(std::size_t i = 0; !queue_.empty(); ++i)
    {
      progress(i, source_.size());
      const Index f = queue_.top().vertex;
      queue_.pop();
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        cross(h);
        next = cross_first(crossed, next);
      }
    }
  }

  // of the inner edges that are neither covered nor crossed
  std::vector<Index> rest() const
  {
    std::vector<Index> result;
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
      if(!covered_[e] && !mesh_.is_border_edge(connectivity_.halfedge_of_edge[e]))
        result.push_back(connectivity_.halfedge_of_edge[e]);
    return result;
  }

  // that of the disk of each face
  std::vector<Index>& sources() { return source_; }

private:
  bool is_reached(Index f) const { return source_[f] != null_index; }

  void push(Index f, Index source)
  {
    source_[f] = source;
    faces_.push_back(f);
    const Indexed_triangle_mesh::Triangle& t = mesh_.triangles[f];
    queue_.push({distance_[t[0]] + distance_[t[1]] + distance_[t[2]], f});
  }

  void cross(Index h)
  {
    const Index opposite = mesh_.opposite[h], edge = connectivity_.edge_of_halfedge[h];
    if(opposite == null_index || covered_[edge] || is_reached(opposite / 3))
      return;
    covered_[edge] = true;
    push(opposite / 3, source_[h / 3]);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  std::vector<bool> covered_; // edges
  std::vector<Index> source_; // of the faces that are reached
  std::vector<Index> faces_;  // in the order in which they are reached
  Vertex_queue queue_;        // of faces
};

} // namespace internal

/*
 * grows a spanning tree of the faces (the cotree) from those around the source, across edges that are not in the
 * spanning tree `tree`, faces of smallest mean distance first, and returns the halfedges of the edges that are in
 * neither: the generators of the first homology \cgalCite{cgal:ew-gohhb-05}, 2g of them on a surface of genus g,
 * where the two fronts of the cotree meet. The union of `tree` and the generators cuts the surface into one open
 * disk. Each border loop, which `tree` takes as one node, counts as part of that union. The source is in the cotree,
 * not on a generator, whatever the distances. O(n log n).
 *
 * A part of the border that is a source is one node, too. With k sources, the cotree is a forest with one tree for each of
 * them, there are 2g - 1 + k generators, and the union leaves k open disks.
 *
 * @param crossed edges that are in the cotree first, as `Way_forest` gives them: none of `tree`
 * @param source_of_face if not null, becomes the source in whose disk each face is
 */
inline std::vector<Index> homology_generators(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                              const Spanning_tree& tree, const std::vector<double>& distance,
                                              const Source_roots& roots, const std::vector<unsigned char>& crossed = {},
                                              const internal::Progress& progress = {},
                                              std::vector<Index>* source_of_face = nullptr)
{
  std::vector<bool> covered(connectivity.number_of_edges(), false);
  for(Index v : tree.order)
    if(v != tree.root)
      covered[connectivity.ring_edge(tree.parent_entry[v])] = true;
  progress(0.1);
  internal::Cotree cotree(mesh, connectivity, distance, std::move(covered));
  cotree.start(roots);
  cotree.grow(crossed, progress.part(0.1, 1.));
  if(source_of_face != nullptr)
    source_of_face->swap(cotree.sources());
  return cotree.rest();
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_HOMOLOGY_H
