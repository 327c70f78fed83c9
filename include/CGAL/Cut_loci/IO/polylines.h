// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_IO_POLYLINES_H
#define CGAL_CUT_LOCI_IO_POLYLINES_H

#include <CGAL/Cut_loci/extract_polylines.h>
#include <CGAL/Cut_loci/internal/stream_output.h>
#include <CGAL/Cut_locus.h>

#include <ostream>
#include <string>

namespace CGAL::IO {

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus in CGAL's format for polylines (extension `.polylines.txt`): a line for each maximal chain of
 * edges between vertices of degree other than 2, with the number of its points and their coordinates. A closed chain
 * ends with its first point; a cut locus that is a single point is a line with that one point.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the `stream_precision` of
 *        `write_cut_locus()`
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_polylines(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  const Cut_loci::internal::Stream_format format(os, np);
  for(const auto& polyline : Cut_loci::extract_polylines(cut_locus))
  {
    os << polyline.size();
    for(const Point_3& p : polyline)
    {
      os << ' ';
      Cut_loci::internal::write_point(os, p);
    }
    os << '\n';
  }
  return os.good();
}

/// \ingroup PkgSurfaceMeshCutLocusIO
/// does the same with a file of the name `filename`.
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_polylines(const std::string& filename, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Cut_loci::internal::write_file(filename,
                                        [&](std::ostream& os) { return IO::write_polylines(os, cut_locus, np); });
}

} // namespace CGAL::IO

#endif // CGAL_CUT_LOCI_IO_POLYLINES_H
