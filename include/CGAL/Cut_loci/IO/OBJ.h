// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_IO_OBJ_H
#define CGAL_CUT_LOCI_IO_OBJ_H

#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_loci/internal/stream_output.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>

#include <ostream>
#include <string>

namespace CGAL::IO {

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus in the format of Wavefront (extension `.obj`): a record `v` for each vertex of the graph and a
 * record `l` for each maximal chain of edges between vertices of degree other than 2. A vertex without edges, as of a
 * cut locus that is a single point, is a record `p`.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `write_cut_locus()`; edges are
 *        marked each by a comment `# marked` with its two vertices
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_OBJ(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  const Cut_loci::internal::Stream_format format(os, np);
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    os << "v ";
    Cut_loci::internal::write_point(os, graph[v].point);
    os << '\n';
  }
  for(const auto& chain : Cut_loci::internal::maximal_chains(graph))
  {
    if(cut_locus.number_of_sources() > 1 && !chain.edges.empty())
      os << "g sources_" << graph[chain.edges.front()].sources[0] << '_' << graph[chain.edges.front()].sources[1]
         << '\n';
    os << (chain.edges.empty() ? 'p' : 'l');
    for(auto v : chain.vertices)
      os << ' ' << v + 1;
    os << '\n';
  }
  const auto is_marked = Cut_loci::internal::edge_marks(graph, np);
  for(auto e : CGAL::make_range(edges(graph)))
    if(is_marked(e))
      os << "# marked " << source(e, graph) + 1 << ' ' << target(e, graph) + 1 << '\n';
  return os.good();
}

/// \ingroup PkgSurfaceMeshCutLocusIO
/// does the same with a file of the name `filename`.
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_OBJ(const std::string& filename, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Cut_loci::internal::write_file(filename, [&](std::ostream& os) { return IO::write_OBJ(os, cut_locus, np); });
}

} // namespace CGAL::IO

#endif // CGAL_CUT_LOCI_IO_OBJ_H
