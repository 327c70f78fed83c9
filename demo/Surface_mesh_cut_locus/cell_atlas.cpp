// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cells of several sources, each cut open to a disk and flattened, side by side.

#include "atlas.h"
#include "cells.h"
#include "flatten.h"

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/flatten_disk.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace {

namespace loci = CGAL::Cut_loci;
using loci::Index;
using UV = std::array<double, 2>;

// A part of the plane, of the area of its part of the surface.
struct Chart
{
  std::vector<UV> points;
  std::vector<std::array<std::size_t, 3>> corners; // in `points`
  std::vector<Index> faces;                        // of the cells
  UV size = {{0., 0.}};                            // `points` are between zero and it
  Mesh disk;
  double area = 0.;      // on the surface
  std::size_t first = 0; // of its texture coordinates
};

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

// Into the first quadrant, counterclockwise.
void place(const loci::Indexed_triangle_mesh& disk, Chart& chart)
{
  double in_plane = 0., on_surface = 0.;
  for(std::size_t f = 0; f < chart.corners.size(); ++f)
  {
    const auto& t = disk.triangles[f];
    const UV &p = chart.points[t[0]], &q = chart.points[t[1]], &r = chart.points[t[2]];
    in_plane += 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
    const auto point = [&](int i)
    { return Kernel::Point_3(disk.points[t[i]][0], disk.points[t[i]][1], disk.points[t[i]][2]); };
    on_surface += std::sqrt(CGAL::squared_area(point(0), point(1), point(2)));
  }
  chart.area = on_surface;
  const double scale = std::sqrt(on_surface / std::abs(in_plane));
  UV low = {{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
  for(UV& p : chart.points)
  {
    p = {{in_plane < 0. ? -scale * p[0] : scale * p[0], scale * p[1]}};
    low = {{(std::min)(low[0], p[0]), (std::min)(low[1], p[1])}};
  }
  for(UV& p : chart.points)
    for(std::size_t i = 0; i < 2; ++i)
      chart.size[i] = (std::max)(chart.size[i], p[i] -= low[i]);
}

Chart flattened(const loci::internal::Mesh_component& part, const Cells& cells, const std::string& parameterization)
{
  const loci::Cut_mesh cut = cut_to_disk(part, cells);
  Flat_disk flat;
  const auto built = loci::internal::build_face_graph(cut.mesh, flat.mesh);
  for(Index v = 0; v < cut.mesh.number_of_vertices(); ++v)
    flat.mesh.point(built.vertices[v]) =
      Kernel::Point_3(cut.mesh.points[v][0], cut.mesh.points[v][1], cut.mesh.points[v][2]);
  flatten(flat, parameterization);
  Chart chart;
  for(Index v = 0; v < cut.mesh.number_of_vertices(); ++v)
    chart.points.push_back({{flat.uv[built.vertices[v]].x(), flat.uv[built.vertices[v]].y()}});
  for(const auto& t : cut.mesh.triangles)
    chart.corners.push_back({{t[0], t[1], t[2]}});
  chart.faces = part.faces;
  place(cut.mesh, chart);
  chart.disk = flat.mesh;
  return chart;
}

// Side by side in rows, the highest ones first, so that the whole is about a square.
std::vector<UV> corners_of_charts(const std::vector<Chart>& charts)
{
  double area = 0., widest = 0.;
  for(const Chart& chart : charts)
  {
    area += chart.size[0] * chart.size[1];
    widest = (std::max)(widest, chart.size[0]);
  }
  const double gap = 0.02 * std::sqrt(area), width = (std::max)(widest, 1.1 * std::sqrt(area));
  std::vector<std::size_t> order(charts.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return charts[i].size[1] > charts[k].size[1]; });
  std::vector<UV> result(charts.size());
  double x = 0., y = 0., height = 0.;
  for(const std::size_t i : order)
  {
    if(x > 0. && x + charts[i].size[0] > width)
    {
      x = 0.;
      y += height + gap;
      height = 0.;
    }
    result[i] = {{x, y}};
    x += charts[i].size[0] + gap;
    height = (std::max)(height, charts[i].size[1]);
  }
  return result;
}

// Of all charts, as they are in the atlas; they do not touch each other.
loci::Layout_quality quality_of_charts(std::vector<Chart>& charts, const Atlas& atlas)
{
  loci::Layout_quality result;
  result.is_injective = true;
  double area = 0.;
  for(const Chart& chart : charts)
    area += chart.area;
  for(Chart& chart : charts)
  {
    auto uv = chart.disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:place").first;
    for(const Mesh::Vertex_index v : chart.disk.vertices())
    {
      const UV& p = atlas.texture_coordinates[chart.first + std::size_t(v)];
      uv[v] = Kernel::Point_2(p[0], p[1]);
    }
    const loci::Layout_quality quality = loci::layout_quality(chart.disk, uv);
    const double part = chart.area / area;
    result.flipped_faces += quality.flipped_faces;
    result.is_injective = result.is_injective && quality.is_injective;
    result.overlapping_faces += quality.overlapping_faces;
    result.overlap += part * quality.overlap;
    result.area_distortion += part * quality.area_distortion;
    result.angle_distortion += part * quality.angle_distortion;
    result.symmetric_dirichlet_energy += part * quality.symmetric_dirichlet_energy;
    result.faces_without_shape += quality.faces_without_shape;
  }
  return result;
}

// The mesh without what joins different cells.
loci::Indexed_triangle_mesh without_cell_borders(const Cells& cells)
{
  loci::Seams borders(cells.mesh.number_of_halfedges(), 0);
  for(Index h = 0; h < cells.mesh.number_of_halfedges(); ++h)
    if(!cells.mesh.is_border_edge(h) && cells.source[h / 3] != cells.source[cells.mesh.opposite[h] / 3])
      borders[h] = 1;
  return loci::cut_open(cells.mesh, borders).mesh;
}

} // namespace

Atlas make_atlas_of_cells(const Mesh& mesh, const Cut_locus& cut_locus, const std::string& parameterization)
{
  const Cells cells = make_cells(mesh, cut_locus);
  const loci::Indexed_triangle_mesh apart = without_cell_borders(cells);
  Index number_of_parts = 0;
  const std::vector<Index> part_of_face = loci::internal::face_components(apart, number_of_parts);
  std::set<Index> parts; // that a source reaches
  for(Index f = 0; f < apart.number_of_faces(); ++f)
    if(cells.source[f] != Cells::none)
      parts.insert(part_of_face[f]);
  std::vector<Chart> charts;
  for(const Index part : parts)
    charts.push_back(flattened(loci::internal::extract_component(apart, part_of_face, part), cells, parameterization));
  const std::vector<UV> corners = corners_of_charts(charts);

  Atlas atlas;
  atlas.parameterization = parameterization;
  for(const auto& p : cells.mesh.points)
    atlas.points.emplace_back(p[0], p[1], p[2]);
  const auto face = [&](Index f)
  {
    const auto& t = cells.mesh.triangles[f];
    return std::array<std::size_t, 3>{{t[0], t[1], t[2]}};
  };
  for(std::size_t i = 0; i < charts.size(); ++i)
  {
    const std::size_t first = charts[i].first = atlas.texture_coordinates.size();
    for(const UV& p : charts[i].points)
      atlas.texture_coordinates.push_back({{corners[i][0] + p[0], corners[i][1] + p[1]}});
    for(std::size_t k = 0; k < charts[i].faces.size(); ++k)
    {
      const auto& t = charts[i].corners[k];
      atlas.faces.push_back(face(charts[i].faces[k]));
      atlas.texture_corners.push_back({{first + t[0], first + t[1], first + t[2]}});
    }
  }
  for(Index f = 0; f < cells.mesh.number_of_faces(); ++f) // other components
    if(cells.source[f] == Cells::none)
      atlas.faces.push_back(face(f));
  finish_atlas(cut_locus, false, atlas);
  atlas.quality = quality_of_charts(charts, atlas);
  return atlas;
}
