// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_PROGRESS_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_PROGRESS_H

#include <pybind11/pybind11.h>

#include <CGAL/Cut_loci/Default_visitor.h>

#include <exception>

// The library's visitor: within stages and between them it takes the GIL, lets Python handle signals such as that of
// Ctrl-C, and between them tells a function, if there is one. What that raises ends the computation.
class Progress
{
public:
  explicit Progress(pybind11::object function);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void start_stage(CGAL::Cut_loci::Stage stage);
  void end_stage(CGAL::Cut_loci::Stage stage) noexcept;
  // lets Python handle signals
  void progress(CGAL::Cut_loci::Stage stage, double share);

  // Calls a function of the library that is given this as its visitor.
  template <typename Function>
  void watch(const Function& function)
  {
    raised_ = nullptr;
    try
    {
      function();
    }
    catch(...)
    {
      rethrow();
      throw;
    }
    rethrow();
  }

private:
  void rethrow();
  void tell(CGAL::Cut_loci::Stage stage, bool ends);

  pybind11::object function_; // or None
  std::exception_ptr raised_; // at the end of a stage, that is in a destructor, which can not let it through
};

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_PROGRESS_H
