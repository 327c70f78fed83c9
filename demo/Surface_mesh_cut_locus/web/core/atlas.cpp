// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"

#include "../../charts.h"
#include "../../logarithmic_layout.h"
#include "../../packing.h"
#include "report_stage.h"

#include <CGAL/Cut_loci/Default_visitor.h>
#include <CGAL/Cut_loci/flatten_disk.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace {

using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::Layout_quality;
using CGAL::Cut_loci::null_index;
using CGAL::Cut_loci::Stage;

// Tells the page how far the flattening of a chart is, as a part of that of all.
struct Chart_reporter : public CGAL::Cut_loci::Default_visitor
{
  void progress(Stage stage, double share) { report_progress(static_cast<int>(stage), first + share * part); }

  double first = 0., part = 1.;
};

// The part of a chart's area that is moved to other faces.
double area_change(const Chart& chart)
{
  double flat_area = 0., area = 0., result = 0.;
  std::vector<std::array<double, 2>> areas;
  for(const Mesh::Face_index f : chart.disk.faces())
  {
    const Mesh::Halfedge_index h = chart.disk.halfedge(f);
    const Mesh::Vertex_index p = chart.disk.source(h), q = chart.disk.target(h),
                             r = chart.disk.target(chart.disk.next(h));
    areas.push_back({{std::fabs(CGAL::determinant(chart.uv[q] - chart.uv[p], chart.uv[r] - chart.uv[p])) / 2.,
                      std::sqrt(CGAL::squared_area(chart.disk.point(p), chart.disk.point(q), chart.disk.point(r)))}});
    flat_area += areas.back()[0];
    area += areas.back()[1];
  }
  for(const std::array<double, 2>& a : areas)
    result += std::fabs(a[0] / flat_area - a[1] / area);
  return result;
}

// Places the charts, which are flat and of this quality, and tells the numbers of all.
std::vector<double> numbers_of(const Charts& charts, const std::vector<Layout_quality>& qualities)
{
  double area = 0., change = 0.;
  for(const auto& chart : charts)
  {
    place(*chart);
    area += chart->area;
  }
  Layout_quality all;
  all.is_injective = true;
  for(std::size_t i = 0; i < charts.size(); ++i)
  {
    add_part(qualities[i], charts[i]->area / area, all);
    change += charts[i]->area / area * area_change(*charts[i]);
  }
  return {double(all.flipped_faces), double(all.overlapping_faces), all.overlap, change,
          double(all.is_injective),  double(charts.size())};
}

std::vector<Layout_quality> flatten(const Charts& charts)
{
  double faces = 0.;
  for(const auto& chart : charts)
    faces += static_cast<double>(chart->faces.size());
  std::vector<Layout_quality> qualities;
  Chart_reporter reporter;
  for(const auto& chart : charts)
  {
    reporter.part = static_cast<double>(chart->faces.size()) / faces;
    qualities.push_back(
      CGAL::Cut_loci::flatten_disk(chart->disk, chart->uv, CGAL::parameters::visitor(std::ref(reporter))));
    reporter.first += reporter.part;
  }
  return qualities;
}

// Where a vertex of a chart is on the mesh. One that was added is in the face of which the faces at it are parts.
void append_place(const Mesh& mesh, const Chart& chart, Mesh::Vertex_index v, Places& places)
{
  if(chart.vertices[v] != null_index)
    return places.append_vertex(Mesh::Vertex_index(chart.vertices[v]));
  Mesh::Halfedge_index at = chart.disk.halfedge(v);
  if(chart.disk.is_border(at))
    at = chart.disk.opposite(chart.disk.next(at));
  places.append_point(mesh, Mesh::Face_index(chart.faces[chart.disk.face(at)]), chart.disk.point(v));
}

// Moves and scales the charts, side by side, into the square [-1, 1] x [-1, 1].
void append(const Mesh& mesh, const Charts& charts, Atlas& atlas)
{
  const Packing packing = pack(charts);
  for(std::size_t i = 0; i < charts.size(); ++i)
  {
    const Chart& chart = *charts[i];
    const std::uint32_t first = static_cast<std::uint32_t>(atlas.uv.size() / 2);
    for(const Mesh::Vertex_index v : chart.disk.vertices())
    {
      append_place(mesh, chart, v, atlas.places);
      for(const double x : packing(chart, packing.places[i], v))
        atlas.uv.push_back(static_cast<float>(2. * x - 1.));
    }
    for(const Mesh::Face_index f : chart.disk.faces())
    {
      atlas.faces.push_back(chart.faces[f]);
      for(const Mesh::Vertex_index v : chart.disk.vertices_around_face(chart.disk.halfedge(f)))
        atlas.triangles.push_back(first + static_cast<std::uint32_t>(v));
    }
    for(const Mesh::Halfedge_index h : chart.disk.halfedges())
      if(chart.disk.is_border(h))
        for(const Mesh::Vertex_index v : {chart.disk.source(h), chart.disk.target(h)})
          atlas.border.push_back(first + static_cast<std::uint32_t>(v));
  }
}

} // namespace

Atlas make_atlas(const Mesh& mesh, const Cut_locus& cut_locus, Layout layout)
{
  report_stage(cutting_stage, true);
  Charts charts;
  if(layout == Layout::CELLS)
    charts = charts_of_cells(mesh, cut_locus);
  else
    charts.push_back(chart_of_source(mesh, cut_locus));
  report_stage(cutting_stage, false);
  report_stage(static_cast<int>(Stage::FLATTENING), true);
  std::vector<Layout_quality> qualities;
  if(layout == Layout::LOGARITHMIC)
  {
    lay_out_by_logarithmic_map(mesh, cut_locus, *charts.front());
    qualities.push_back(CGAL::Cut_loci::layout_quality(charts.front()->disk, charts.front()->uv));
  }
  else
    qualities = flatten(charts);
  Atlas atlas;
  atlas.numbers = numbers_of(charts, qualities);
  append(mesh, charts, atlas);
  report_stage(static_cast<int>(Stage::FLATTENING), false);
  return atlas;
}
