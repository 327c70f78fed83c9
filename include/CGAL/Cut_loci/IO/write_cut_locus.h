// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_IO_WRITE_CUT_LOCUS_H
#define CGAL_CUT_LOCI_IO_WRITE_CUT_LOCUS_H

#include <CGAL/Cut_loci/IO/OBJ.h>
#include <CGAL/Cut_loci/IO/PLY.h>
#include <CGAL/Cut_loci/IO/VTP.h>
#include <CGAL/Cut_loci/IO/polylines.h>

#include <string>

namespace CGAL::IO {

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus to a file in the format that its extension names: `.polylines.txt` (`write_polylines()`), `.obj`
 * (`write_OBJ()`), `.ply` (`write_PLY()`) or `.vtp` (`write_VTP()`).
 *
 * @param filename the name of the file
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{stream_precision}
 *     \cgalParamDescription{the number of significant digits of the numbers}
 *     \cgalParamType{int}
 *     \cgalParamDefault{17, with which every `double` is read back as it was}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map of the edges of the graph that are to be marked, by 1 in a property `marked` of the edges (PLY, VTP) or by comments (OBJ)}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<Cut_locus::Graph>::%edge_descriptor`
 *                    as key type and `bool` as value type}
 *     \cgalParamDefault{none: nothing is written about marks}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return `true` if all has been written, `false` also if the extension is another one
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_cut_locus(const std::string& filename, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto ends_with = [&](const std::string& extension)
  {
    return filename.size() > extension.size() &&
           filename.compare(filename.size() - extension.size(), extension.size(), extension) == 0;
  };
  if(ends_with(".polylines.txt"))
    return IO::write_polylines(filename, cut_locus, np);
  if(ends_with(".obj"))
    return IO::write_OBJ(filename, cut_locus, np);
  if(ends_with(".ply"))
    return IO::write_PLY(filename, cut_locus, np);
  if(ends_with(".vtp"))
    return IO::write_VTP(filename, cut_locus, np);
  return false;
}

} // namespace CGAL::IO

#endif // CGAL_CUT_LOCI_IO_WRITE_CUT_LOCUS_H
