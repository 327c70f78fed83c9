// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_IO_EDGES_H
#define CGAL_CUT_LOCI_IO_EDGES_H

#include <CGAL/Cut_loci/internal/stream_output.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL::IO {

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes the edges of the mesh that a cut locus consists of, each as a line with the numbers of its two vertices. Edges
 * of the graph that follow no edge of the mesh are left out.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param tm the mesh it was computed on
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{a property map with the number of each vertex of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer as value type}
 *     \cgalParamDefault{the positions in the range `vertices(tm)`, counted from 0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map of the edges of the graph that are to be marked, by a third word, `marked`, in their lines}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<Cut_locus::Graph>::%edge_descriptor`
 *                    as key type and `bool` as value type}
 *     \cgalParamDefault{none: nothing is written about marks}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_edges(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus, const TriangleMesh& tm,
                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  auto position = get(dynamic_vertex_property_t<std::size_t>(), tm);
  std::size_t number = 0;
  for(auto v : CGAL::make_range(vertices(tm)))
    put(position, v, number++);
  const auto numbers = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_index), position);
  const auto is_marked = Cut_loci::internal::edge_marks(graph, np);
  for(auto e : CGAL::make_range(edges(graph)))
  {
    const auto h = graph[e].mesh_halfedge;
    if(h != boost::graph_traits<TriangleMesh>::null_halfedge())
      os << get(numbers, source(h, tm)) << ' ' << get(numbers, target(h, tm)) << (is_marked(e) ? " marked\n" : "\n");
  }
  return os.good();
}

/// \ingroup PkgSurfaceMeshCutLocusIO
/// does the same with a file of the name `filename`.
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_edges(const std::string& filename, const Cut_locus<TriangleMesh, Point_3>& cut_locus, const TriangleMesh& tm,
                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Cut_loci::internal::write_file(filename,
                                        [&](std::ostream& os) { return IO::write_edges(os, cut_locus, tm, np); });
}

} // namespace CGAL::IO

#endif // CGAL_CUT_LOCI_IO_EDGES_H
