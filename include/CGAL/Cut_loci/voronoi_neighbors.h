// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_VORONOI_NEIGHBORS_H
#define CGAL_CUT_LOCI_VORONOI_NEIGHBORS_H

#include <CGAL/Cut_loci/face_graph/cells_of_faces.h>
#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/vector_3.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// two sources whose cells of the geodesic Voronoi diagram touch along a curve: an edge of the dual graph.
struct Voronoi_neighbors
{
  std::array<std::size_t, 2> sources; ///< the smaller number first
  double length;                      ///< of the curve, in the unit of the points
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * finds which cells of the geodesic Voronoi diagram touch, and along what length, in the order of the sources: the dual
 * graph of the diagram, which on a smooth surface is the geodesic Delaunay triangulation if there are enough sources.
 *
 * Cells that touch in points alone are none. Time is O(n log k) for `n` edges of the cut locus and `k` pairs.
 *
 * @param cut_locus the cut locus of several points or curves, such as by `Surface_mesh_cut_locus::set_sources()`; of its
 *        edges those between two sources count
 */
template <typename TriangleMesh, typename Point_3>
std::vector<Voronoi_neighbors> voronoi_neighbors(const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  const auto& graph = cut_locus.graph();
  std::map<std::array<std::size_t, 2>, double> length;
  for(auto e : CGAL::make_range(edges(graph)))
    if(graph[e].sources[0] != graph[e].sources[1])
    {
      const Point_3 &p = graph[source(e, graph)].point, &q = graph[target(e, graph)].point;
      length[graph[e].sources] += std::sqrt(CGAL::to_double((p - q) * (p - q)));
    }
  std::vector<Voronoi_neighbors> result;
  result.reserve(length.size());
  for(const auto& entry : length)
    result.push_back({entry.first, entry.second});
  return result;
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * measures the cells of the geodesic Voronoi diagram, in the order of the sources.
 *
 * The areas are those of the parts into which the cut locus divides the mesh, after its barycentric coordinates have been
 * rounded to multiples of 2^-20: together they are the area of all components with a source, up to rounding of `double`. Time
 * is that of `refine_along_cut_locus()`, which also tells the cell of each face.
 *
 * @param tm the triangle mesh of which the cut locus was computed, with points
 * @param cut_locus the cut locus of several points or curves, through the faces; what it has inside the cells does not count
 *
 * @throws Invalid_input if the cut locus is not one of `tm`
 */
template <typename TriangleMesh, typename Point_3>
std::vector<double> voronoi_cell_areas(const TriangleMesh& tm, const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  const auto read = internal::read_triangle_mesh(tm, get_const_property_map(CGAL::vertex_point, tm));
  const internal::Curve_on_mesh curve = internal::curve_on_mesh(read, tm, cut_locus);
  const Cut_mesh fans = cut_open(read.mesh); // components may touch in a vertex
  const Refined_mesh refined =
    refine_along_curve(fans.mesh, Mesh_connectivity(fans.mesh), curve.graph, internal::finest_resolution);
  const std::vector<std::size_t> cells = internal::cells_of_faces(read, fans.vertices, curve, refined, cut_locus);
  std::vector<double> result(cut_locus.number_of_sources(), 0.);
  for(std::size_t f = 0; f < cells.size(); ++f)
    if(cells[f] != no_source)
    {
      const auto& t = refined.mesh.triangles[f];
      using internal::operator-;
      const internal::Vector p = refined.mesh.points[t[0]];
      result[cells[f]] +=
        0.5 * internal::norm(internal::cross(refined.mesh.points[t[1]] - p, refined.mesh.points[t[2]] - p));
    }
  return result;
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_VORONOI_NEIGHBORS_H
