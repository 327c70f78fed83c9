// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_CANCELING_VISITOR_H
#define CGAL_CUT_LOCI_CANCELING_VISITOR_H

#include <CGAL/Cut_loci/Default_visitor.h>

#include <cstddef>
#include <stdexcept>

struct Canceled : public std::runtime_error
{
  Canceled() : std::runtime_error("canceled") {}
};

// throws at one of the calls within a stage; at 0, none, it counts them
struct Canceling_visitor
{
  CGAL::Cut_loci::Stage stage;
  std::size_t at, number = 0;

  Canceling_visitor(CGAL::Cut_loci::Stage s, std::size_t i) : stage(s), at(i) {}
  void start_stage(CGAL::Cut_loci::Stage) {}
  void end_stage(CGAL::Cut_loci::Stage) {}
  void progress(CGAL::Cut_loci::Stage s, double)
  {
    if(s == stage && ++number == at)
      throw Canceled();
  }
};

#endif // CGAL_CUT_LOCI_CANCELING_VISITOR_H
