// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_DETOUR_H
#define CGAL_CUT_LOCI_HELPERS_DETOUR_H

#include "Union_find.h"
#include "curve_topology.h"

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/curve/curve_refinement.h>
#include <CGAL/Cut_loci/exact_geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/read_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>
#include <CGAL/Cut_locus.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

// How good a computed cut locus is on a mesh of which nobody knows the true one.
//
// No shortest path from the source crosses the cut locus: so cutting the mesh open along the curve must change no
// distance. The detour of a vertex is its distance on the mesh cut open, the smallest over its copies, minus that on
// the mesh. It is 0 everywhere for a curve on the cut locus, at most about one edge where mesh edges zigzag around it,
// and large where a branch lies across shortest paths.
namespace curve_measures {

using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::null_index;
using Indexed_mesh = CGAL::Cut_loci::Indexed_triangle_mesh;
using Seams = CGAL::Cut_loci::Seams;

// All detours are in units of the mean edge length.
struct Measures
{
  std::string topology_fault;   // the first thing that is wrong with the curve, or empty
  std::string measuring_failed; // why there is no detour, or empty
  double mean = 0., p99 = 0., max = 0.;
  Index worst = null_index; // the position of the vertex with the largest detour among those of the mesh
};

namespace internal {

// each edge once, without those on the border
inline bool is_inner_edge(const Indexed_mesh& mesh, Index h)
{
  return !mesh.is_border_edge(h) && h < mesh.opposite[h];
}

// The parts into which the seams divide the faces.
inline Union_find parts_of_faces(const Indexed_mesh& mesh, const Seams& seams)
{
  Union_find result(mesh.number_of_faces());
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(is_inner_edge(mesh, h) && !seams[h])
      result.unite(h / 3, mesh.opposite[h] / 3);
  return result;
}

// The graph of the seams and the border loops, each loop as one node, must be connected and have 2g cycles, and its
// complement one part: then the Euler characteristic of that is 1, and it is an open disk. `root` is on the curve even
// if it has no edge.
inline std::string topology_fault(const Indexed_mesh& mesh, const Seams& seams, Index root)
{
  const CGAL::Cut_loci::Mesh_connectivity connectivity(mesh);
  const Index nv = mesh.number_of_vertices(), loops = connectivity.number_of_border_loops;
  const auto node = [&](Index v) { return connectivity.is_border(v) ? nv + connectivity.border_loop[v] : v; };
  std::vector<bool> is_node(nv + loops, false);
  std::fill(is_node.begin() + nv, is_node.end(), true);
  is_node[node(root)] = true;
  Union_find graph(nv + loops);
  std::int64_t arcs = 0;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(is_inner_edge(mesh, h) && seams[h])
    {
      const Index a = node(mesh.source(h)), b = node(mesh.target(h));
      is_node[a] = is_node[b] = true;
      graph.unite(a, b);
      ++arcs;
    }
  const auto nodes = std::count(is_node.begin(), is_node.end(), true);
  const std::int64_t others = std::int64_t(nv) + loops - nodes;
  const std::int64_t components = std::int64_t(graph.number_of_parts()) - others;
  if(components != 1)
    return "the curve and the border have " + std::to_string(components) + " components";
  const std::int64_t cycles = arcs - nodes + 1, genus = connectivity.genus(mesh);
  if(cycles != 2 * genus)
    return std::to_string(cycles) + " independent cycles on a surface of genus " + std::to_string(genus);
  const std::size_t parts = parts_of_faces(mesh, seams).number_of_parts();
  return parts == 1 ? std::string() : "the complement has " + std::to_string(parts) + " parts";
}

// Opens seams until the complement is in one piece: pieces that are walled in have no distance.
inline void open_pockets(const Indexed_mesh& mesh, Seams& seams)
{
  Union_find faces = parts_of_faces(mesh, seams);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(is_inner_edge(mesh, h) && seams[h] && faces.unite(h / 3, mesh.opposite[h] / 3))
      seams[h] = seams[mesh.opposite[h]] = 0;
}

// The component of the source, its faces split along the curve. The first vertices are those of the component.
struct Prepared
{
  Indexed_mesh mesh;
  std::vector<Index> faces; // of the component, for each face
  Seams seams;
  Index root;
};

inline Prepared prepared(const CGAL::Cut_loci::internal::Curve_on_component& on, Index resolution)
{
  namespace lib = CGAL::Cut_loci::internal;
  const Indexed_mesh& mesh = on.component.mesh;
  Prepared result;
  if(on.curve.is_of_mesh_edges)
  {
    result.mesh = mesh;
    result.faces.resize(mesh.number_of_faces());
    std::iota(result.faces.begin(), result.faces.end(), Index(0));
    result.seams.assign(mesh.number_of_halfedges(), 0);
    for(const auto& e : on.curve.graph.edges)
      CGAL::Cut_loci::add_seam(mesh, e.halfedge, result.seams);
    result.root = on.curve.graph.nodes.front().vertex;
    return result;
  }
  CGAL::Cut_loci::Refined_mesh refined =
    CGAL::Cut_loci::refine_along_curve(mesh, lib::manifold_connectivity(mesh), on.curve.graph, resolution);
  result.root = refined.nodes.front();
  result.mesh = std::move(refined.mesh);
  result.faces = std::move(refined.faces);
  result.seams = std::move(refined.seams);
  return result;
}

// The place of a point of face `f` in the part of the face that has it, or that it misses least by rounding.
inline CGAL::Cut_loci::Indexed_location location_in_part(const Prepared& split, Index f,
                                                         const std::array<double, 3>& point)
{
  using namespace CGAL::Cut_loci::internal;
  CGAL::Cut_loci::Indexed_location best;
  double best_least = -(std::numeric_limits<double>::infinity)();
  for(Index part = 0; part < split.faces.size(); ++part)
  {
    if(split.faces[part] != f)
      continue;
    const auto& t = split.mesh.triangles[part];
    const Vector &p = split.mesh.points[t[0]], &q = split.mesh.points[t[1]], &r = split.mesh.points[t[2]];
    const Vector normal = cross(q - p, r - p);
    const double area = dot(normal, normal);
    std::array<double, 3> c = {{dot(cross(q - point, r - point), normal) / area,
                                dot(cross(r - point, p - point), normal) / area,
                                dot(cross(p - point, q - point), normal) / area}};
    const double least = *std::min_element(c.begin(), c.end());
    if(!(least > best_least))
      continue;
    double sum = 0.;
    for(double& x : c)
      sum += x = (std::max)(x, 0.);
    for(double& x : c)
      x /= sum;
    best_least = least;
    best.face = part;
    best.coordinates = c;
  }
  return best;
}

// A source on the curve has several copies, all of them sources.
inline std::vector<CGAL::Cut_loci::Indexed_location> sources(const CGAL::Cut_loci::internal::Curve_on_component& on,
                                                             const Prepared& split, const Indexed_mesh& cut,
                                                             const std::vector<Index>& origin)
{
  using namespace CGAL::Cut_loci::internal;
  std::vector<CGAL::Cut_loci::Indexed_location> result;
  if(on.curve.source_vertex == null_index)
  {
    Vector point = {{0., 0., 0.}};
    for(int i = 0; i < 3; ++i)
      point = point + on.curve.source.coordinates[i] *
                        on.component.mesh.points[on.component.mesh.triangles[on.curve.source.face][i]];
    result.push_back(location_in_part(split, on.curve.source.face, point));
    return result;
  }
  std::vector<bool> is_done(cut.number_of_vertices(), false);
  for(Index h = 0; h < cut.number_of_halfedges(); ++h)
  {
    const Index v = cut.source(h);
    if(origin[v] != on.curve.source_vertex || is_done[v])
      continue;
    is_done[v] = true;
    result.push_back(CGAL::Cut_loci::internal::location_on(h));
  }
  return result;
}

inline std::vector<double> exact_distances(const Indexed_mesh& mesh,
                                           const std::vector<CGAL::Cut_loci::Indexed_location>& sources)
{
  CGAL::Cut_loci::internal::Exact_geodesic_propagation propagation(mesh);
  propagation.run(sources);
  return propagation.distances();
}

// the smallest distance over the copies of each vertex of the component
inline std::vector<double> distances_cut_open(const CGAL::Cut_loci::internal::Curve_on_component& on,
                                              const Prepared& split)
{
  const CGAL::Cut_loci::Cut_mesh cut = CGAL::Cut_loci::cut_open(split.mesh, split.seams);
  const std::vector<double> distance = exact_distances(cut.mesh, sources(on, split, cut.mesh, cut.vertices));
  std::vector<double> result(on.component.mesh.number_of_vertices(), (std::numeric_limits<double>::infinity)());
  for(Index v = 0; v < distance.size(); ++v)
    if(cut.vertices[v] < result.size())
      result[cut.vertices[v]] = (std::min)(result[cut.vertices[v]], distance[v]);
  return result;
}

inline void set_detour(const std::vector<double>& before, const std::vector<double>& after, double unit,
                       Measures& result)
{
  std::vector<double> detour(before.size());
  double sum = 0.;
  for(std::size_t v = 0; v < detour.size(); ++v)
  {
    detour[v] = (std::max)(0., (after[v] - before[v]) / unit); // below 0 by rounding only
    if(!std::isfinite(detour[v]))
      throw CGAL::Cut_loci::Invalid_input("a distance on the mesh cut open is not a finite number");
    sum += detour[v];
  }
  const auto worst = std::max_element(detour.begin(), detour.end());
  result.worst = static_cast<Index>(worst - detour.begin());
  result.max = *worst;
  result.mean = sum / double(detour.size());
  const auto p99 = detour.begin() + static_cast<std::ptrdiff_t>(0.99 * double(detour.size() - 1));
  std::nth_element(detour.begin(), p99, detour.end());
  result.p99 = *p99;
}

} // namespace internal

/*
 * measures the topology and the detour of a cut locus of edges of the mesh, or through the faces.
 *
 * The faces that a curve runs through are split first. To keep the solver from faces without area the curve is rounded
 * to 2^-16 of an edge, or more coarsely if that is not enough; if no rounding helps, `measuring_failed` says why.
 *
 * `exact` keeps the exact distances of the vertices in the component of the source: they are computed if it is empty.
 */
template <typename TriangleMesh, typename Point_3>
Measures measure(const TriangleMesh& tm, const CGAL::Cut_locus<TriangleMesh, Point_3>& cut_locus,
                 std::vector<double>& exact)
{
  namespace lib = CGAL::Cut_loci::internal;
  Measures result;
  try
  {
    const auto read = lib::read_triangle_mesh(tm, get(CGAL::vertex_point, tm));
    const lib::Curve_on_component on = lib::on_component(read.mesh, lib::curve_on_mesh(read, tm, cut_locus));
    const double unit = CGAL::Cut_loci::Mesh_connectivity(on.component.mesh).mean_edge_length;
    if(exact.empty())
      exact = internal::exact_distances(on.component.mesh, {on.curve.source});
    for(const Index resolution : {Index(1) << 16, Index(1) << 12, Index(1) << 8})
      try
      {
        result = Measures();
        internal::Prepared split = internal::prepared(on, resolution);
        result.topology_fault = on.curve.is_of_mesh_edges
                                  ? internal::topology_fault(split.mesh, split.seams, split.root)
                                  : internal::Curve_topology(on.component.mesh, on.curve.graph).fault();
        internal::open_pockets(split.mesh, split.seams);
        internal::set_detour(exact, internal::distances_cut_open(on, split), unit, result);
        result.worst = read.positions[on.component.vertices[result.worst]];
        return result;
      }
      catch(const CGAL::Cut_loci::Invalid_input& error)
      {
        result.measuring_failed = error.what();
        if(on.curve.is_of_mesh_edges)
          break;
      }
  }
  catch(const CGAL::Cut_loci::Invalid_input& error)
  {
    result.measuring_failed = error.what();
  }
  return result;
}

template <typename TriangleMesh, typename Point_3>
Measures measure(const TriangleMesh& tm, const CGAL::Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  std::vector<double> exact;
  return measure(tm, cut_locus, exact);
}

} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_DETOUR_H
