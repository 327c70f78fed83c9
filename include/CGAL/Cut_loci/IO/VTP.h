// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_IO_VTP_H
#define CGAL_CUT_LOCI_IO_VTP_H

#include <CGAL/Cut_loci/internal/edge_arrays.h>
#include <CGAL/Cut_loci/internal/stream_output.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus in the XML format of VTK for polygonal data (extension `.vtp`), as ASCII: a line for each edge,
 * with the array `distance` of the points, and `strength`, `width`, `enclosed`, `source1` and `source2` of the cells: its
 * `strength`, `width`, `curvature` and `sources`, see `Cut_locus_edge`. A vertex without edges, as of a cut locus that is
 * a single point, is a cell `Verts` for which these are 0.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `write_cut_locus()`; edges are
 *        marked by 1 in the array `marked` of the cells
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_VTP(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  const Cut_loci::internal::Stream_format format(os, np);
  const auto is_marked = Cut_loci::internal::edge_marks(graph, np);
  std::vector<std::size_t> isolated;
  for(auto v : CGAL::make_range(vertices(graph)))
    if(degree(v, graph) == 0)
      isolated.push_back(v);

  const auto start_array = [&](const char* type, const char* name)
  { os << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n"; };
  const auto end_array = [&]() { os << "</DataArray>\n"; };
  const auto write_offsets = [&](std::size_t number_of_cells, std::size_t size_of_cell)
  {
    start_array("Int64", "offsets");
    for(std::size_t i = 1; i <= number_of_cells; ++i)
      os << i * size_of_cell << '\n';
    end_array();
  };

  os << "<?xml version=\"1.0\"?>\n"
     << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
     << "<Piece NumberOfPoints=\"" << num_vertices(graph) << "\" NumberOfVerts=\"" << isolated.size()
     << "\" NumberOfLines=\"" << num_edges(graph) << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
     << "<PointData Scalars=\"distance\">\n";
  start_array("Float64", "distance");
  for(auto v : CGAL::make_range(vertices(graph)))
    os << graph[v].distance << '\n';
  end_array();
  os << "</PointData>\n<CellData Scalars=\"strength\">\n";
  Cut_loci::internal::for_each_edge_array(graph, is_marked,
                                          [&](const char* name, const auto& value_of)
                                          {
    using Value = decltype(value_of(*edges(graph).first));
    start_array(Cut_loci::internal::name_of_type<Value>({{"Float64", "Int32", "UInt8"}}), name);
    for(std::size_t i = 0; i < isolated.size(); ++i)
      os << "0\n";
    for(auto e : CGAL::make_range(edges(graph)))
      os << +value_of(e) << '\n';
    end_array();
  });
  os << "</CellData>\n<Points>\n"
     << "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    Cut_loci::internal::write_point(os, graph[v].point);
    os << '\n';
  }
  end_array();
  os << "</Points>\n<Verts>\n";
  start_array("Int64", "connectivity");
  for(std::size_t v : isolated)
    os << v << '\n';
  end_array();
  write_offsets(isolated.size(), 1);
  os << "</Verts>\n<Lines>\n";
  start_array("Int64", "connectivity");
  for(auto e : CGAL::make_range(edges(graph)))
    os << source(e, graph) << ' ' << target(e, graph) << '\n';
  end_array();
  write_offsets(num_edges(graph), 2);
  os << "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return os.good();
}

/// \ingroup PkgSurfaceMeshCutLocusIO
/// does the same with a file of the name `filename`.
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_VTP(const std::string& filename, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Cut_loci::internal::write_file(filename, [&](std::ostream& os) { return IO::write_VTP(os, cut_locus, np); });
}

} // namespace CGAL::IO

#endif // CGAL_CUT_LOCI_IO_VTP_H
