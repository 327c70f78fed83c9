// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DEFAULT_VISITOR_H
#define CGAL_CUT_LOCI_DEFAULT_VISITOR_H

namespace CGAL::Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the stages of the computation
enum class Stage {
  PREPROCESSING, ///< connectivity and differential operators, once per mesh
  DISTANCE,      ///< the geodesic solver, with its own preprocessing at the first source
  STRENGTH,      ///< gradient and Laplacian of the distance, and the strengths they give
  TREE,          ///< region growing and thinning
  HOMOLOGY,      ///< extension of the tree, generators
  FILTER,        ///< thresholds; the only stage that runs again when these change
  FLATTENING     ///< `flatten_disk()`
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// is a visitor that does nothing; it can be used as a base class.
struct Default_visitor
{
  void start_stage(Stage) {} ///< called before a stage
  void end_stage(Stage) {}   ///< called after it
  /// called within a stage, with the share of it that is done
  void progress(Stage, double) {}
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_DEFAULT_VISITOR_H
