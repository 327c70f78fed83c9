// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Progress.h"

#include <utility>

namespace py = pybind11;
using CGAL::Cut_loci::Stage;

namespace {

const char* name_of(Stage stage)
{
  switch(stage)
  {
  case Stage::PREPROCESSING:
    return "preprocessing";
  case Stage::DISTANCE:
    return "distance";
  case Stage::STRENGTH:
    return "strength";
  case Stage::TREE:
    return "tree";
  case Stage::HOMOLOGY:
    return "homology";
  case Stage::FILTER:
    return "filter";
  case Stage::FLATTENING:
    return "flattening";
  }
  return "other";
}

} // namespace

Progress::Progress(py::object function) : function_(std::move(function)) {}

Progress::~Progress()
{
  const py::gil_scoped_acquire gil; // for what is raised and not handed on
  raised_ = nullptr;
  function_ = py::object();
}

void Progress::tell(Stage stage, bool ends)
{
  const py::gil_scoped_acquire gil;
  if(PyErr_CheckSignals() != 0)
    throw py::error_already_set();
  if(!function_.is_none())
    function_(name_of(stage), ends);
}

void Progress::start_stage(Stage stage)
{
  rethrow();
  tell(stage, false);
}

void Progress::progress(Stage, double)
{
  const py::gil_scoped_acquire gil;
  if(PyErr_CheckSignals() != 0)
    throw py::error_already_set();
}

void Progress::end_stage(Stage stage) noexcept
{
  if(raised_ || std::uncaught_exceptions() > 0)
    return;
  try
  {
    tell(stage, true);
  }
  catch(...)
  {
    raised_ = std::current_exception();
  }
}

void Progress::rethrow()
{
  if(raised_)
    std::rethrow_exception(std::exchange(raised_, nullptr));
}
