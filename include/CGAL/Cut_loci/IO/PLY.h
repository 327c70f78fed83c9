// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_IO_PLY_H
#define CGAL_CUT_LOCI_IO_PLY_H

#include <CGAL/Cut_loci/internal/edge_arrays.h>
#include <CGAL/Cut_loci/internal/stream_output.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>

#include <ostream>
#include <string>

namespace CGAL::IO {

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus as an ASCII file of the format PLY (extension `.ply`) with the elements `vertex`, with the
 * property `distance`, and `edge`, with the properties `strength`, `width`, `enclosed`, `source1` and `source2`: its
 * `strength`, `width`, `curvature` and `sources`, see `Cut_locus_edge`.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `write_cut_locus()`; edges are
 *        marked by 1 in the property `marked` of the element `edge`
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_PLY(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  const Cut_loci::internal::Stream_format format(os, np);
  const auto is_marked = Cut_loci::internal::edge_marks(graph, np);
  os << "ply\nformat ascii 1.0\n"
     << "element vertex " << num_vertices(graph)
     << "\nproperty double x\nproperty double y\nproperty double z\nproperty double distance\n"
     << "element edge " << num_edges(graph) << "\nproperty int vertex1\nproperty int vertex2\n";
  Cut_loci::internal::for_each_edge_array(graph, is_marked,
                                          [&](const char* name, const auto& value_of)
                                          {
    using Value = decltype(value_of(*edges(graph).first));
    os << "property " << Cut_loci::internal::name_of_type<Value>({{"double", "int", "uchar"}}) << ' ' << name << '\n';
  });
  os << "end_header\n";
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    Cut_loci::internal::write_point(os, graph[v].point);
    os << ' ' << graph[v].distance << '\n';
  }
  for(auto e : CGAL::make_range(edges(graph)))
  {
    os << source(e, graph) << ' ' << target(e, graph);
    Cut_loci::internal::for_each_edge_array(graph, is_marked,
                                            [&](const char*, const auto& value_of) { os << ' ' << +value_of(e); });
    os << '\n';
  }
  return os.good();
}

/// \ingroup PkgSurfaceMeshCutLocusIO
/// does the same with a file of the name `filename`.
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_PLY(const std::string& filename, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Cut_loci::internal::write_file(filename, [&](std::ostream& os) { return IO::write_PLY(os, cut_locus, np); });
}

} // namespace CGAL::IO

#endif // CGAL_CUT_LOCI_IO_PLY_H
