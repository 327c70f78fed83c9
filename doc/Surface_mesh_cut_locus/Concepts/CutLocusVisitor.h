// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

/*!
 * \ingroup PkgSurfaceMeshCutLocusConcepts
 * \cgalConcept
 *
 * The concept `CutLocusVisitor` describes what is told when the stages of `CGAL::Surface_mesh_cut_locus` start and end,
 * and how far they are, for example to show progress, to take the time, or to cancel: an exception that `start_stage()` or
 * `progress()` throws leaves the computation. The object can be used again then; if it was in `set_source()`, it has no
 * source until the next call.
 *
 * \cgalRefines{CopyConstructible}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Cut_loci::Default_visitor}
 * \cgalHasModelsEnd
 */
class CutLocusVisitor
{
public:
  /// is called before a stage. It may throw.
  void start_stage(CGAL::Cut_loci::Stage stage);

  /// is called after a stage, also if that ended by an exception. It must not throw.
  void end_stage(CGAL::Cut_loci::Stage stage);

  /// is called again and again within the stages, but for distances of solvers other than the package's own exact one.
  /// `share` is the part of the stage that is done, from 0 to 1, and does not get smaller: that of the vertices to which a
  /// path has been found, or of the faces. Distances take longer the farther they are, so it is not that of the time. It
  /// may throw. This function may be missing.
  void progress(CGAL::Cut_loci::Stage stage, double share);
};
