// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "component_charts.h"
#include "atlas.h"
#include "flatten.h"
#include "set_source.h"
#include "thresholds.h"

#include <CGAL/Cut_loci/flatten_disk.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

namespace {

Charts flat_charts(const Options& options, const Input_mesh& input, const Cut_locus& cut_locus)
{
  const bool has_cells = cut_locus.number_of_sources() > 1 || has_curves(options);
  if(has_cells && options.parameterization == "logmap")
    throw std::runtime_error(
      "the logarithmic map is that of one point: give one source, or another --parameterization");
  Charts charts;
  if(has_cells)
    charts = charts_of_cells(input.mesh, cut_locus, input.is_added);
  else
    charts.push_back(chart_of_source(input.mesh, cut_locus, input.is_added));
  for(const auto& chart : charts)
    flatten(input.mesh, cut_locus, *chart, options.parameterization);
  return charts;
}

double stretch_of(const Charts& charts)
{
  double result = 1.;
  for(const auto& chart : charts)
    result = (std::max)(result, stretch(CGAL::Cut_loci::layout_quality(chart->disk, chart->uv)));
  return result;
}

// Whether the detail is for the program to choose. Other parameterizations may flip faces, whatever the detail.
bool may_refine(const Options& options)
{
  return std::holds_alternative<CGAL::Cut_loci::Default_method>(options.method) &&
         options.parameterization == "injective" && !options.minimum_branch_width && !options.minimum_branch_gap &&
         !options.minimum_branch_curvature;
}

// Each width is half of the one before, and the last one zero, where branches would be as narrow as an edge is long.
Charts charts_of_component(Options options, const Input_mesh& input, const Cut_locus_solver& solver,
                           const Cut_locus& cut_locus)
{
  Charts best = flat_charts(options, input, cut_locus);
  if(!may_refine(options))
    return best;
  double least = stretch_of(best);
  const Mesh& disk = best.front()->disk;
  const CGAL::Bbox_3 box = CGAL::bbox_3(disk.points().begin(), disk.points().end());
  const double edge =
    mean_edge_length(disk) / std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                                       CGAL::square(box.zmax() - box.zmin()));
  for(double width = solver.minimum_branch_width(); width > 0. && least > options.maximum_stretch;)
  {
    width = width > 2. * edge ? 0.5 * width : 0.;
    options.minimum_branch_width = width;
    Charts charts = flat_charts(options, input, apply_thresholds(options, solver));
    if(const double stretch = stretch_of(charts); stretch < least)
    {
      least = stretch;
      best = std::move(charts);
      best.front()->finer_width = width;
    }
  }
  return best;
}

} // namespace

Charts charts_of_components(const std::vector<Options>& options, const Input_mesh& input,
                            const Cut_locus_solver& solver, const Cut_locus& cut_locus)
{
  Charts result = charts_of_component(options.front(), input, solver, cut_locus);
  std::unique_ptr<Cut_locus_solver> other;
  for(std::size_t i = 1; i < options.size(); ++i)
  {
    if(!other)
      other = make_solver(options[i].solver, options[i].method, input.mesh, nullptr, options[i].threads > 1);
    set_source(options[i], input, *other);
    Charts charts = charts_of_component(options[i], input, *other, apply_thresholds(options[i], *other));
    std::move(charts.begin(), charts.end(), std::back_inserter(result));
  }
  return result;
}
