// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXTRACT_POLYLINES_H
#define CGAL_CUT_LOCI_EXTRACT_POLYLINES_H

#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_locus.h>

#include <vector>

namespace CGAL::Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * returns the points of each maximal chain of edges between vertices of degree other than 2. A closed chain ends with
 * its first point; a cut locus that is a single point gives one polyline with that one point.
 */
template <typename TriangleMesh, typename Point_3>
std::vector<std::vector<Point_3>> extract_polylines(const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  std::vector<std::vector<Point_3>> polylines;
  for(const auto& chain : internal::maximal_chains(cut_locus.graph()))
  {
    polylines.emplace_back();
    for(auto v : chain.vertices)
      polylines.back().push_back(cut_locus.graph()[v].point);
  }
  return polylines;
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_EXTRACT_POLYLINES_H
