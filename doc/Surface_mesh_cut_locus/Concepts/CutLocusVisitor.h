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
 * for example to show progress or to take the time. An exception that it throws leaves the computation, which is a way
 * to cancel it: the object then has no source until `set_source()` is called again.
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
  /// is called before a stage.
  void start_stage(CGAL::Cut_loci::Stage stage);

  /// is called after a stage, also if it ended by an exception.
  void end_stage(CGAL::Cut_loci::Stage stage);
};
