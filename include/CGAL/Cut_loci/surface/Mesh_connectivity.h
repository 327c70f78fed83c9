// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_MESH_CONNECTIVITY_H
#define CGAL_CUT_LOCI_SURFACE_MESH_CONNECTIVITY_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <vector>

namespace CGAL::Cut_loci {

/*
 * numbers the edges of an `Indexed_triangle_mesh` and lists the neighbors of each vertex in counterclockwise order, in
 * compressed rows: the entries of vertex `v` are `ring_begin[v]`, ..., `ring_begin[v + 1] - 1`. The ring of a border
 * vertex starts and ends on the border. Built once per mesh in time and space linear in its size.
 */
struct Mesh_connectivity
{
  std::vector<Index> edge_of_halfedge;
  std::vector<Index> halfedge_of_edge;   ///< the halfedge of smaller index, for each edge
  std::vector<Index> ring_begin;         ///< `number_of_vertices() + 1` offsets
  std::vector<Index> ring_vertex;        ///< the neighbor
  std::vector<Index> ring_halfedge;      ///< a halfedge on the edge: outgoing, but for the last one of a border vertex
  std::vector<Index> ring_reverse;       ///< the entry of the same edge in the ring of the neighbor
  std::vector<Index> border_loop;        ///< the border loop each vertex lies on, or `null_index`; empty without border
  std::vector<Index> first_non_manifold; ///< at most one vertex whose faces form more than one fan
  Index number_of_border_loops = 0;
  double mean_edge_length = 0.;

  Index number_of_edges() const { return static_cast<Index>(halfedge_of_edge.size()); }
  Index valence(Index v) const { return ring_begin[v + 1] - ring_begin[v]; }
  bool is_border(Index v) const { return !border_loop.empty() && border_loop[v] != null_index; }
  Index ring_edge(Index entry) const { return edge_of_halfedge[ring_halfedge[entry]]; }

  explicit Mesh_connectivity(const Indexed_triangle_mesh& mesh, const internal::Progress& progress = {})
  {
    number_edges(mesh, progress.part(0., 0.3));
    build_rings(mesh, progress.part(0.3, 0.7));
    if(first_non_manifold.empty())
    {
      reverse_rings(progress.part(0.7, 0.9));
      label_border(mesh, progress.part(0.9, 1.));
    }
  }

  /// the genus, from the Euler characteristic with each border loop closed by a disk
  Index genus(const Indexed_triangle_mesh& mesh) const
  {
    const std::int64_t chi = std::int64_t(mesh.number_of_vertices()) - number_of_edges() + mesh.number_of_faces();
    return static_cast<Index>((2 - chi - std::int64_t(number_of_border_loops)) / 2);
  }

private:
  void number_edges(const Indexed_triangle_mesh& mesh, const internal::Progress& progress)
  {
    const Index nh = mesh.number_of_halfedges();
    edge_of_halfedge.resize(nh);
    halfedge_of_edge.reserve(nh / 2 + nh / 16);
    for(Index h = 0; h < nh; ++h)
    {
      progress(h, nh);
      const Index o = mesh.opposite[h];
      if(o < h) // null_index is larger than any halfedge
      {
        edge_of_halfedge[h] = edge_of_halfedge[o];
        continue;
      }
      edge_of_halfedge[h] = number_of_edges();
      halfedge_of_edge.push_back(h);
    }
    mean_edge_length = internal::mean_edge_length(mesh);
  }

  void build_rings(const Indexed_triangle_mesh& mesh, const internal::Progress& progress)
  {
    const Index nv = mesh.number_of_vertices(), nh = mesh.number_of_halfedges();

    // Each vertex starts at an outgoing halfedge: the one on its border, else the one of smallest index.
    std::vector<Index> start(nv, null_index);
    ring_begin.assign(nv + 1, 0);
    const internal::Progress counting = progress.part(0., 0.3), filling = progress.part(0.3, 1.);
    for(Index h = 0; h < nh; ++h)
    {
      counting(h, nh);
      const Index v = mesh.source(h);
      ++ring_begin[v + 1];
      if(mesh.is_border_edge(h))
      {
        start[v] = h;
        ++ring_begin[mesh.target(h) + 1]; // the neighbor across the last edge of its fan has no outgoing halfedge
      }
      else if(start[v] == null_index)
        start[v] = h;
    }
    for(Index v = 0; v < nv; ++v)
      ring_begin[v + 1] += ring_begin[v];
    ring_vertex.resize(ring_begin[nv]);
    ring_halfedge.resize(ring_begin[nv]);

    for(Index v = 0; v < nv; ++v)
    {
      filling(v, nv);
      Index entry = ring_begin[v];
      const Index end = ring_begin[v + 1];
      Index h = start[v];
      do
      {
        ring_vertex[entry] = mesh.target(h);
        ring_halfedge[entry++] = h;
        const Index incoming = mesh.previous(h);
        h = mesh.opposite[incoming];
        if(h == null_index && entry < end)
        {
          ring_vertex[entry] = mesh.source(incoming);
          ring_halfedge[entry++] = incoming;
        }
      } while(h != null_index && h != start[v] && entry < end);
      if(entry != end || (h != null_index && h != start[v]))
      {
        first_non_manifold.push_back(v);
        return;
      }
    }
  }

  void reverse_rings(const internal::Progress& progress)
  {
    // The two entries of an edge are met one after the other.
    ring_reverse.resize(ring_vertex.size());
    std::vector<Index> entry_of_edge(number_of_edges(), null_index);
    for(Index entry = 0; entry < ring_vertex.size(); ++entry)
    {
      progress(entry, ring_vertex.size());
      Index& other = entry_of_edge[ring_edge(entry)];
      if(other == null_index)
        other = entry;
      else
      {
        ring_reverse[entry] = other;
        ring_reverse[other] = entry;
      }
    }
  }

  void label_border(const Indexed_triangle_mesh& mesh, const internal::Progress& progress)
  {
    const Index nh = mesh.number_of_halfedges();
    for(Index h = 0; h < nh; ++h)
    {
      progress(h, nh);
      if(!mesh.is_border_edge(h) || is_border(mesh.source(h)))
        continue;
      if(border_loop.empty())
        border_loop.assign(mesh.number_of_vertices(), null_index);
      Index v = mesh.source(h);
      do
      {
        border_loop[v] = number_of_border_loops;
        v = ring_vertex[ring_begin[v]]; // the ring of a border vertex starts along the border
      } while(border_loop[v] == null_index);
      ++number_of_border_loops;
    }
  }
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_SURFACE_MESH_CONNECTIVITY_H
