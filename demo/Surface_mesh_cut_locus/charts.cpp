// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "charts.h"

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace {

namespace loci = CGAL::Cut_loci;
using loci::Index;

// A connected part of a cell. What is left of its seams is opened, or completed, until it is a disk.
loci::Cut_mesh cut_to_disk(const loci::internal::Mesh_component& part, const Cells& cells)
{
  loci::Seams seams(part.mesh.number_of_halfedges(), 0);
  for(Index h = 0; h < part.mesh.number_of_halfedges(); ++h)
    if(cells.seams[3 * part.faces[h / 3] + h % 3])
      loci::add_seam(part.mesh, h, seams);
  loci::repair_seams(part.mesh, 0, seams);
  loci::complete_seams(part.mesh, loci::Mesh_connectivity(part.mesh), 0, loci::null_index, seams);
  return loci::cut_open(part.mesh, seams);
}

// The mesh without what joins different cells.
loci::Cut_mesh without_cell_borders(const Cells& cells)
{
  loci::Seams borders(cells.mesh.number_of_halfedges(), 0);
  for(Index h = 0; h < cells.mesh.number_of_halfedges(); ++h)
    if(!cells.mesh.is_border_edge(h) && cells.source[h / 3] != cells.source[cells.mesh.opposite[h] / 3])
      borders[h] = 1;
  return loci::cut_open(cells.mesh, borders);
}

std::unique_ptr<Chart> chart_of(const loci::Cut_mesh& apart, const loci::internal::Mesh_component& part,
                                const Cells& cells)
{
  const loci::Cut_mesh cut = cut_to_disk(part, cells);
  auto chart = std::make_unique<Chart>();
  const auto built = loci::internal::build_face_graph(cut.mesh, chart->disk);
  for(Index v = 0; v < cut.mesh.number_of_vertices(); ++v)
  {
    const auto& p = cut.mesh.points[v];
    chart->disk.point(built.vertices[v]) = Kernel::Point_3(p[0], p[1], p[2]);
    chart->vertices.push_back(apart.vertices[part.vertices[cut.vertices[v]]]);
  }
  chart->faces = part.faces;
  return chart;
}

struct Rows
{
  std::map<const Chart*, UV> corners; // the lower left ones
  double side = 0.;                   // of the square around all
};

// Charts in rows of at most this width, one above the other.
Rows rows_of(const std::vector<const Chart*>& charts, double width, double gap)
{
  Rows rows;
  double x = 0., y = 0., height = 0.;
  for(const Chart* chart : charts)
  {
    if(x > 0. && x + chart->size[0] > (1. + 1e-9) * width)
    {
      x = 0.;
      y += height + gap;
      height = 0.;
    }
    rows.corners[chart] = {{x, y}};
    rows.side = (std::max)({rows.side, x + chart->size[0], y + chart->size[1]});
    x += chart->size[0] + gap;
    height = (std::max)(height, chart->size[1]);
  }
  return rows;
}

} // namespace

Chart::Chart() : uv(disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv", Kernel::Point_2(0., 0.)).first)
{
}

std::vector<std::unique_ptr<Chart>> charts_of(const Cells& cells)
{
  const loci::Cut_mesh apart = without_cell_borders(cells);
  Index number_of_parts = 0;
  const std::vector<Index> part_of_face = loci::internal::face_components(apart.mesh, number_of_parts);
  std::set<Index> parts;
  for(Index f = 0; f < apart.mesh.number_of_faces(); ++f)
    if(cells.source[f] != CGAL::Cut_loci::no_source)
      parts.insert(part_of_face[f]);
  std::vector<std::unique_ptr<Chart>> charts;
  for(const Index part : parts)
    charts.push_back(chart_of(apart, loci::internal::extract_component(apart.mesh, part_of_face, part), cells));
  return charts;
}

void place(Chart& chart)
{
  double in_plane = 0., on_surface = 0.;
  for(const Mesh::Face_index f : chart.disk.faces())
  {
    const Mesh::Halfedge_index h = chart.disk.halfedge(f);
    const std::array<Mesh::Vertex_index, 3> v = {
      {chart.disk.source(h), chart.disk.target(h), chart.disk.target(chart.disk.next(h))}};
    in_plane += 0.5 * CGAL::determinant(chart.uv[v[1]] - chart.uv[v[0]], chart.uv[v[2]] - chart.uv[v[0]]);
    on_surface += std::sqrt(CGAL::squared_area(chart.disk.point(v[0]), chart.disk.point(v[1]), chart.disk.point(v[2])));
  }
  chart.area = on_surface;
  const double scale = std::sqrt(on_surface / std::abs(in_plane));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  UV low = {{infinity, infinity}}, high = {{-infinity, -infinity}};
  for(const Mesh::Vertex_index v : chart.disk.vertices())
  {
    chart.uv[v] = {in_plane < 0. ? -scale * chart.uv[v].x() : scale * chart.uv[v].x(), scale * chart.uv[v].y()};
    for(int i = 0; i < 2; ++i)
    {
      low[i] = (std::min)(low[i], chart.uv[v][i]);
      high[i] = (std::max)(high[i], chart.uv[v][i]);
    }
  }
  for(const Mesh::Vertex_index v : chart.disk.vertices())
    chart.uv[v] = {chart.uv[v].x() - low[0], chart.uv[v].y() - low[1]};
  chart.size = {{high[0] - low[0], high[1] - low[1]}};
}

std::vector<UV> corners_of(const std::vector<std::unique_ptr<Chart>>& charts)
{
  if(charts.empty())
    return {};
  double area = 0., widest = 0.;
  for(const auto& chart : charts)
  {
    area += chart->size[0] * chart->size[1];
    widest = (std::max)(widest, chart->size[0]);
  }
  std::vector<const Chart*> order;
  for(const auto& chart : charts)
    order.push_back(chart.get());
  std::stable_sort(order.begin(), order.end(), [](const Chart* a, const Chart* b) { return a->size[1] > b->size[1]; });
  const double gap = 0.02 * std::sqrt(area), most = 2. * (std::max)(widest, std::sqrt(area));
  Rows best = rows_of(order, widest, gap);
  // as wide as the first charts together
  double width = order.front()->size[0];
  for(std::size_t i = 1; i < order.size() && width < most; ++i)
  {
    width += gap + order[i]->size[0];
    if(width < widest)
      continue;
    Rows rows = rows_of(order, width, gap);
    if(rows.side < best.side)
      best = std::move(rows);
  }
  std::vector<UV> result;
  for(const auto& chart : charts)
    result.push_back(best.corners.at(chart.get()));
  return result;
}

void add_part(const loci::Layout_quality& quality, double part, loci::Layout_quality& sum)
{
  sum.flipped_faces += quality.flipped_faces;
  sum.is_injective = sum.is_injective && quality.is_injective;
  sum.overlapping_faces += quality.overlapping_faces;
  sum.overlap += part * quality.overlap;
  sum.area_distortion += part * quality.area_distortion;
  sum.angle_distortion += part * quality.angle_distortion;
  sum.symmetric_dirichlet_energy += part * quality.symmetric_dirichlet_energy;
  sum.faces_without_shape += quality.faces_without_shape;
}
