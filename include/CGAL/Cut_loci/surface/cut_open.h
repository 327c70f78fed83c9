// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_CUT_OPEN_H
#define CGAL_CUT_LOCI_SURFACE_CUT_OPEN_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Cut_loci {

// tells for each halfedge of an `Indexed_triangle_mesh` whether the mesh is to be cut along its edge. Both halfedges
// of an edge have the same value; edges on the border are no seams.
using Seams = std::vector<unsigned char>;

// makes the edge of `h` a seam, unless it is on the border.
inline void add_seam(const Indexed_triangle_mesh& mesh, Index h, Seams& seams)
{
  if(!mesh.is_border_edge(h))
    seams[h] = seams[mesh.opposite[h]] = 1;
}

/*
 * is a mesh cut open along seams. It has the faces of the other mesh, with the same indices and the same first corners.
 * Vertex `v` keeps its index; its further copies, one for each further part into which the seams divide the faces
 * around it, follow at the end.
 */
struct Cut_mesh
{
  Indexed_triangle_mesh mesh;
  std::vector<Index> vertices; ///< for each vertex the one that it is a copy of
};

/*
 * cuts a mesh open along `seams`. A vertex at which seams meet becomes one vertex for each fan of faces between them,
 * so that the result is manifold whatever the seams; without any, the mesh falls apart where parts of it touch in a vertex
 * alone. Time is linear in the size of the mesh.
 */
inline Cut_mesh cut_open(const Indexed_triangle_mesh& mesh, const Seams& seams = {})
{
  const Index nh = mesh.number_of_halfedges();
  const auto is_open = [&](Index h) { return (!seams.empty() && seams[h]) || mesh.is_border_edge(h); };

  Cut_mesh result;
  result.mesh = mesh;
  result.vertices.resize(mesh.number_of_vertices());
  std::iota(result.vertices.begin(), result.vertices.end(), Index(0));
  std::vector<unsigned char> is_taken(mesh.number_of_vertices(), 0), is_done(nh, 0);
  for(Index h = 0; h < nh; ++h)
  {
    if(is_done[h])
      continue;
    Index first = h; // of the fan, clockwise
    while(!is_open(first))
    {
      first = mesh.next(mesh.opposite[first]);
      if(first == h)
        break;
    }
    const Index v = mesh.source(h);
    Index copy = v;
    if(is_taken[v])
    {
      copy = static_cast<Index>(result.vertices.size());
      result.vertices.push_back(v);
      result.mesh.points.push_back(mesh.points[v]);
    }
    is_taken[v] = 1;
    for(Index k = first;;)
    {
      is_done[k] = 1;
      result.mesh.triangles[k / 3][k % 3] = copy;
      const Index incoming = mesh.previous(k);
      if(is_open(incoming))
        break;
      k = mesh.opposite[incoming];
      if(k == first)
        break;
    }
  }
  for(std::size_t h = 0; h < seams.size(); ++h)
    if(seams[h])
      result.mesh.opposite[h] = null_index;
  return result;
}

// tells whether a mesh is one topological disk: manifold, connected, with one border loop and Euler characteristic 1.
inline bool is_disk(const Indexed_triangle_mesh& mesh)
{
  const Mesh_connectivity connectivity(mesh);
  if(!connectivity.first_non_manifold.empty() || connectivity.number_of_border_loops != 1)
    return false;
  Index number_of_components = 0;
  internal::face_components(mesh, number_of_components);
  return number_of_components == 1 && std::int64_t(mesh.number_of_vertices()) + mesh.number_of_faces() ==
                                        std::int64_t(connectivity.number_of_edges()) + 1;
}

namespace internal {

// The number of edges from each vertex to the next seam or border, or, if there is neither, to `start`.
inline std::vector<Index> steps_to_seams(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                         Index start, const Seams& seams)
{
  std::vector<Index> steps(mesh.number_of_vertices(), null_index), front;
  const auto reach = [&](Index v, Index n)
  {
    if(steps[v] == null_index)
    {
      steps[v] = n;
      front.push_back(v);
    }
  };
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(seams[h] || mesh.is_border_edge(h))
    {
      reach(mesh.source(h), 0);
      reach(mesh.target(h), 0);
    }
  if(front.empty())
    reach(start, 0);
  for(std::size_t i = 0; i < front.size(); ++i)
    for(Index k = connectivity.ring_begin[front[i]]; k < connectivity.ring_begin[front[i] + 1]; ++k)
      reach(connectivity.ring_vertex[k], steps[front[i]] + 1);
  return steps;
}

// Drops candidates for seams from where they end at no other one, nor at a seam or the border.
inline void drop_dead_ends(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Seams& seams,
                           Seams& is_candidate)
{
  std::vector<Index> degree(mesh.number_of_vertices(), 0);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(seams[h] || mesh.is_border_edge(h))
      degree[mesh.source(h)] = degree[mesh.target(h)] = 2; // not a dead end
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    degree[mesh.source(h)] += is_candidate[h]; // both halfedges of an edge are
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(Index end = v; degree[end] == 1;)
    {
      Index k = connectivity.ring_begin[end];
      while(!is_candidate[connectivity.ring_halfedge[k]])
        ++k;
      const Index h = connectivity.ring_halfedge[k];
      is_candidate[h] = is_candidate[mesh.opposite[h]] = 0;
      --degree[end];
      end = connectivity.ring_vertex[k];
      --degree[end];
    }
}

} // namespace internal

/*
 * adds and removes seams until they leave one open disk of a connected mesh; seams that do so already stay as they are.
 *
 * Seams with different pieces of the complement on their sides are removed. What is then missing is added along edges:
 * a spanning tree of the complement's faces that runs where the seams are far leaves short ways between them, and dead
 * ends are dropped. `start` is a vertex to begin at if there are neither seams nor a border. Time is O(n log n).
 */
inline void repair_seams(const Indexed_triangle_mesh& mesh, Index start, Seams& seams)
{
  const Index nh = mesh.number_of_halfedges();
  const auto is_first = [&](Index h) { return !mesh.is_border_edge(h) && h < mesh.opposite[h]; };
  internal::Union_find pieces(mesh.number_of_faces());
  for(bool is_seam : {false, true})
    for(Index h = 0; h < nh; ++h)
      if(is_first(h) && bool(seams[h]) == is_seam && pieces.unite(h / 3, mesh.opposite[h] / 3))
        seams[h] = seams[mesh.opposite[h]] = 0;
  if(is_disk(cut_open(mesh, seams).mesh))
    return;

  // The spanning tree takes edges far from the seams first; what it leaves are the candidates.
  const Mesh_connectivity connectivity(mesh);
  const std::vector<Index> steps = internal::steps_to_seams(mesh, connectivity, start, seams);
  std::vector<Index> order;
  for(Index h = 0; h < nh; ++h)
    if(is_first(h) && !seams[h])
      order.push_back(h);
  const auto steps_of = [&](Index h) { return steps[mesh.source(h)] + steps[mesh.target(h)]; };
  std::stable_sort(order.begin(), order.end(), [&](Index g, Index h) { return steps_of(g) > steps_of(h); });
  internal::Union_find tree(mesh.number_of_faces());
  Seams is_candidate(nh, 0);
  for(Index h : order)
    if(!tree.unite(h / 3, mesh.opposite[h] / 3))
      is_candidate[h] = is_candidate[mesh.opposite[h]] = 1;
  internal::drop_dead_ends(mesh, connectivity, seams, is_candidate);
  for(Index h = 0; h < nh; ++h)
    if(is_candidate[h])
      seams[h] = 1;
}

/*
 * adds seams at `vertex` where there are less than two, on a surface without border: a cut along none leaves a sphere,
 * and one along a single edge splits no vertex, so that whoever glues equal edges closes it again. The two seams form
 * the straightest path that avoids the vertex `avoided`, which may be `null_index`; a triangle covered doubly has none,
 * and the path ends there.
 */
inline void complete_seams(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Index vertex,
                           Index avoided, Seams& seams)
{
  if(connectivity.number_of_border_loops > 0)
    return;
  Index seam = null_index; // any halfedge on one
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(seams[h] && h < mesh.opposite[h])
    {
      if(seam != null_index)
        return;
      seam = h;
    }
  if(seam != null_index)
    vertex = mesh.source(seam) == avoided ? mesh.target(seam) : mesh.source(seam);

  const Index begin = connectivity.ring_begin[vertex], n = connectivity.valence(vertex);
  const auto leads_to = [&](Index i, Index v) { return connectivity.ring_vertex[begin + i] == v; };
  Index first = 0;
  if(seam != null_index)
    while(connectivity.ring_edge(begin + first) != connectivity.edge_of_halfedge[seam])
      ++first;
  else
    while(first + 1 < n && leads_to(first, avoided))
      ++first;
  Index second = null_index, best = 0;
  for(Index end : {avoided, null_index}) // in the second place only, a path that ends at the vertex to be avoided
    for(Index step = 1; step < n && (end == avoided || second == null_index); ++step)
    {
      const Index i = (first + step) % n, apart = step < n - step ? step : n - step;
      if(apart > best && !leads_to(i, end) && !leads_to(i, connectivity.ring_vertex[begin + first]))
      {
        best = apart;
        second = i;
      }
    }
  if(second == null_index)
    throw Invalid_input(Cause::TOO_INACCURATE, "the surface has too few edges to cut it open");
  add_seam(mesh, connectivity.ring_halfedge[begin + first], seams);
  add_seam(mesh, connectivity.ring_halfedge[begin + second], seams);
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_SURFACE_CUT_OPEN_H
