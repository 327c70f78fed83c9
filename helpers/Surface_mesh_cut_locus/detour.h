// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_DETOUR_H
#define CGAL_CUT_LOCI_HELPERS_DETOUR_H

#include "Source_set.h"
#include "Union_find.h"
#include "curve_topology.h"
#include "topology_beside_curves.h"

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/location_in_part.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_locus.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

// How good a computed cut locus is on a mesh of which nobody knows the true one.
//
// No shortest path from the source, or from several, crosses the cut locus: so cutting the mesh open along the curve must change no
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

// The graph of the seams and the border loops, each loop as one node, must be connected and have 2g - 1 + k cycles for k
// sources, and its complement k parts, with one of them in each: then the Euler characteristic of that is k, and it is k
// open disks. `root` is on the curve even if it has no edge.
inline std::string topology_fault(const Indexed_mesh& mesh, const Seams& seams, Index root, const Source_set& set)
{
  const auto disks = static_cast<std::int64_t>(set.points.size());
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
  if(cycles != 2 * genus - 1 + disks)
    return std::to_string(cycles) + " independent cycles on a surface of genus " + std::to_string(genus);
  Union_find faces = parts_of_faces(mesh, seams);
  if(std::int64_t(faces.number_of_parts()) != disks)
    return "the complement has " + std::to_string(faces.number_of_parts()) + " parts";
  std::set<Index> at_sources;
  for(Index f : set.faces_at_points(mesh))
    at_sources.insert(faces.find(f));
  return std::int64_t(at_sources.size()) == disks ? std::string() : "a part of the complement has no source";
}

// Opens seams until there is a source in each piece: those that are walled in have no distance. The faces at the sources
// are given if there are several; else one piece is left.
inline void open_pockets(const Indexed_mesh& mesh, const std::vector<Index>& at_sources, Seams& seams)
{
  Union_find faces = parts_of_faces(mesh, seams);
  std::vector<bool> has_source(mesh.number_of_faces(), false); // for each part, at its representative
  for(Index f : at_sources)
    has_source[faces.find(f)] = true;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    if(!is_inner_edge(mesh, h) || !seams[h])
      continue;
    const Index p = faces.find(h / 3), q = faces.find(mesh.opposite[h] / 3);
    if(p == q || (has_source[p] && has_source[q]))
      continue;
    const bool has_one = has_source[p] || has_source[q];
    faces.unite(p, q);
    has_source[faces.find(p)] = has_one;
    seams[h] = seams[mesh.opposite[h]] = 0;
  }
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

// the faces of the split mesh that the sources are in, or at
inline std::vector<Index> faces_at(const Source_set& set, const CGAL::Cut_loci::internal::Curve_on_component& on,
                                   const Prepared& split)
{
  std::vector<Index> result;
  std::set<Index> at = set.vertices_of_curves(on.component.mesh);
  for(const CGAL::Cut_loci::Indexed_source& source : set.points)
    if(source.vertex != null_index)
      at.insert(source.vertex);
    else
      result.push_back(
        CGAL::Cut_loci::internal::location_in_part(on.component.mesh, split.mesh, split.faces, source.location).face);
  for(Index h = 0; h < split.mesh.number_of_halfedges(); ++h)
    if(at.count(split.mesh.source(h)) > 0)
      result.push_back(h / 3);
  return result;
}

// Where a mesh is cut open the points have several copies, all of them sources, and so have the vertices of curves.
inline std::vector<CGAL::Cut_loci::Indexed_location> sources(const Source_set& set,
                                                             const CGAL::Cut_loci::internal::Curve_on_component& on,
                                                             const Prepared& split, const CGAL::Cut_loci::Cut_mesh& cut)
{
  std::vector<CGAL::Cut_loci::Indexed_location> result;
  std::set<Index> at = set.vertices_of_curves(on.component.mesh);
  for(const CGAL::Cut_loci::Indexed_source& source : set.points)
    if(source.vertex != null_index)
      at.insert(source.vertex);
    else
      result.push_back(
        CGAL::Cut_loci::internal::location_in_part(on.component.mesh, split.mesh, split.faces, source.location));
  std::vector<bool> is_done(cut.mesh.number_of_vertices(), false);
  for(Index h = 0; h < cut.mesh.number_of_halfedges(); ++h)
  {
    const Index v = cut.mesh.source(h);
    if(is_done[v] || at.count(cut.vertices[v]) == 0)
      continue;
    is_done[v] = true;
    result.push_back(CGAL::Cut_loci::internal::location_on(h));
  }
  return result;
}

struct Exact_distances
{
  std::vector<double> of_vertices, of_queries;
};

inline Exact_distances exact_distances(const Indexed_mesh& mesh,
                                       const std::vector<CGAL::Cut_loci::Indexed_location>& sources,
                                       const std::vector<Index>& lines = {},
                                       const std::vector<CGAL::Cut_loci::Indexed_location>& queries = {})
{
  const Indexed_mesh measured = with_areas(mesh);
  CGAL::Cut_loci::internal::Exact_geodesic_propagation propagation(measured);
  CGAL::Cut_loci::internal::Exact_geodesic_options options;
  options.owners.assign(sources.size(), 0);
  std::vector<CGAL::Cut_loci::internal::Geodesic_line> all_lines;
  for(Index h : lines)
    all_lines.push_back({h, 0});
  if(!lines.empty())
    set_lines(all_lines, options);
  options.queries = queries;
  propagation.run(sources, options);
  Exact_distances result{propagation.distances(), {}};
  for(std::size_t i = 0; i < queries.size(); ++i)
    result.of_queries.push_back(propagation.query_distance(i));
  return result;
}

// The smallest distance over the copies of each vertex of the component, and that of places, on the mesh cut open along the
// seams and along the curves that are sources, which no shortest path crosses.
inline Exact_distances distances_cut_open(const Source_set& set, const CGAL::Cut_loci::internal::Curve_on_component& on,
                                          const Prepared& split,
                                          const std::vector<CGAL::Cut_loci::Indexed_location>& places = {})
{
  const std::vector<Index> lines = set.lines(on.component.mesh, split.mesh, split.faces);
  Seams seams = split.seams;
  for(Index h : lines)
    CGAL::Cut_loci::add_seam(split.mesh, h, seams);
  const CGAL::Cut_loci::Cut_mesh cut = CGAL::Cut_loci::cut_open(split.mesh, seams); // faces keep their numbers
  Exact_distances result = exact_distances(cut.mesh, sources(set, on, split, cut), lines, places);
  const std::vector<double> of_copies = std::move(result.of_vertices);
  result.of_vertices.assign(on.component.mesh.number_of_vertices(), (std::numeric_limits<double>::infinity)());
  for(Index v = 0; v < of_copies.size(); ++v)
    if(cut.vertices[v] < result.of_vertices.size())
      result.of_vertices[cut.vertices[v]] = (std::min)(result.of_vertices[cut.vertices[v]], of_copies[v]);
  return result;
}

// the component with no seams
inline Prepared whole(const Indexed_mesh& mesh)
{
  Prepared result;
  result.mesh = mesh;
  result.faces.resize(mesh.number_of_faces());
  std::iota(result.faces.begin(), result.faces.end(), Index(0));
  result.seams.assign(mesh.number_of_halfedges(), 0);
  return result;
}

inline std::string topology_fault(const Source_set& set, const CGAL::Cut_loci::internal::Curve_on_component& on,
                                  const Prepared& split)
{
  if(!set.curves.empty())
    return topology_fault_beside_curves(on.component.mesh, on.curve.graph, set);
  if(on.curve.is_of_mesh_edges)
    return topology_fault(split.mesh, split.seams, split.root, set);
  return Curve_topology(on.component.mesh, on.curve.graph).fault(set.points.size());
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
      throw CGAL::Cut_loci::Invalid_input(CGAL::Cut_loci::Cause::TOO_INACCURATE,
                                          "a distance on the mesh cut open is not a finite number");
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
 * measures the topology and the detour of a cut locus of edges of the mesh, or through the faces: all of it, and not the
 * Voronoi diagram of several sources alone. Sources that are curves have to be given, in their order.
 *
 * The faces that a curve runs through are split first. To keep the solver from faces without area the curve is rounded
 * to 2^-16 of an edge, or more coarsely if that is not enough; if no rounding helps, `measuring_failed` says why. Where
 * vertices are as close to each other as that, rounding is what leads paths astray: then less of it is tried, too, and the
 * least detour counts.
 *
 * `exact` keeps the exact distances of the vertices in the component of the source: they are computed if it is empty.
 */
template <typename TriangleMesh, typename Point_3>
Measures measure(const TriangleMesh& tm, const CGAL::Cut_locus<TriangleMesh, Point_3>& cut_locus,
                 std::vector<double>& exact, const Edge_curves<TriangleMesh>& source_curves = {})
{
  namespace lib = CGAL::Cut_loci::internal;
  Measures result;
  try
  {
    const auto read = lib::read_triangle_mesh(tm, get(CGAL::vertex_point, tm));
    const lib::Curve_on_component on = lib::on_component(read.mesh, lib::curve_on_mesh(read, tm, cut_locus));
    const internal::Source_set set = internal::source_set(tm, read, on, source_curves);
    const double unit = CGAL::Cut_loci::Mesh_connectivity(on.component.mesh).mean_edge_length;
    if(exact.empty())
      exact = internal::distances_cut_open(set, on, internal::whole(on.component.mesh)).of_vertices;
    const auto at_resolution = [&](Index resolution)
    {
      Measures measures;
      try
      {
        internal::Prepared split = internal::prepared(on, resolution);
        measures.topology_fault = internal::topology_fault(set, on, split);
        const bool is_one = set.points.size() + set.curves.size() == 1;
        internal::open_pockets(split.mesh, is_one ? std::vector<Index>() : faces_at(set, on, split), split.seams);
        internal::set_detour(exact, internal::distances_cut_open(set, on, split).of_vertices, unit, measures);
        measures.worst = read.positions[on.component.vertices[measures.worst]];
      }
      catch(const CGAL::Cut_loci::Invalid_input& error)
      {
        measures.measuring_failed = error.what();
      }
      return measures;
    };
    constexpr double least = 1e-6; // a detour that is none
    const bool rounds = !on.curve.is_of_mesh_edges;
    const Index usual = 16, fine = 30, coarsest = 8, step = 4; // binary digits
    result = at_resolution(Index(1) << usual);
    for(Index digits = usual - step; rounds && !result.measuring_failed.empty() && digits >= coarsest; digits -= step)
      result = at_resolution(Index(1) << digits);
    if(rounds && !(result.max < least))
      if(const Measures finer = at_resolution(Index(1) << fine);
         finer.measuring_failed.empty() && finer.max < result.max)
        result = finer;
  }
  catch(const CGAL::Cut_loci::Invalid_input& error)
  {
    result.measuring_failed = error.what();
  }
  return result;
}

template <typename TriangleMesh, typename Point_3>
Measures measure(const TriangleMesh& tm, const CGAL::Cut_locus<TriangleMesh, Point_3>& cut_locus,
                 const Edge_curves<TriangleMesh>& source_curves = {})
{
  std::vector<double> exact;
  return measure(tm, cut_locus, exact, source_curves);
}

} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_DETOUR_H
