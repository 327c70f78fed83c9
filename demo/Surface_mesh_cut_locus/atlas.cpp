// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"
#include "packing.h"

#include <CGAL/Cut_loci/flatten_disk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace {

using CGAL::Cut_loci::null_index;

double length_of_border(const Mesh& mesh)
{
  double result = 0.;
  for(const Mesh::Edge_index e : mesh.edges())
    if(mesh.is_border(e))
      result += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return result;
}

// Moves the charts to their places in the unit square, and finds how good they are there.
void arrange(Atlas& atlas)
{
  for(const auto& chart : atlas.charts)
    place(*chart);
  const Packing packing = pack(atlas.charts);
  double area = 0.;
  for(const auto& chart : atlas.charts)
    area += chart->area;
  atlas.covered = area / (packing.side * packing.side);
  atlas.quality.is_injective = true;
  for(std::size_t i = 0; i < atlas.charts.size(); ++i)
  {
    Chart& chart = *atlas.charts[i];
    for(const Mesh::Vertex_index v : chart.disk.vertices())
    {
      const UV at = packing(chart, packing.places[i], v);
      chart.uv[v] = {at[0], at[1]};
    }
    const auto quality = CGAL::Cut_loci::layout_quality(chart.disk, chart.uv);
    atlas.stretch = (std::max)(atlas.stretch, stretch(quality));
    add_part(quality, chart.area / area, atlas.quality);
  }
}

// What a vertex of the mesh and a corner of a polygon at it have in common: the number in the file of one of them.
std::size_t key(const Input_mesh& input, Mesh::Vertex_index v)
{
  return input.number[v];
}
std::size_t key(const Input_mesh& input, std::size_t number)
{
  return input.number[input.vertex[number]];
}

// Calls `visit` for each corner of each face of each chart, as the halfedges to it from the one before, in the disk and
// in the mesh, with the number of the first vertex of the chart in those of all.
template <typename Visit>
void for_each_corner(const Atlas& atlas, const Mesh& mesh, const Visit& visit)
{
  std::size_t first = 0;
  for(const auto& chart : atlas.charts)
  {
    for(const Mesh::Face_index f : chart->disk.faces())
    {
      Mesh::Halfedge_index in_disk = chart->disk.halfedge(f),
                           in_mesh = mesh.halfedge(Mesh::Face_index(chart->faces[f]));
      for(int i = 0; i < 3; ++i, in_disk = chart->disk.next(in_disk), in_mesh = mesh.next(in_mesh))
        visit(*chart, in_disk, in_mesh, first);
    }
    first += chart->disk.number_of_vertices();
  }
}

} // namespace

double stretch(const CGAL::Cut_loci::Layout_quality& quality)
{
  const double energy = (std::max)(quality.symmetric_dirichlet_energy, 1.); // up to rounding
  return std::sqrt(energy + std::sqrt(energy * energy - 1.));
}

Atlas make_atlas(const Input_mesh& input, const Cut_locus& cut_locus, Charts charts,
                 const std::string& parameterization)
{
  Atlas atlas;
  atlas.parameterization = parameterization;
  atlas.charts = std::move(charts);
  std::vector<bool> is_there(input.mesh.number_of_faces(), false);
  double border = 0.;
  for(const auto& chart : atlas.charts)
  {
    atlas.seams_in_polygons += chart->seams_in_polygons;
    border += length_of_border(chart->disk);
    for(const auto f : chart->faces)
    {
      atlas.splits_faces = atlas.splits_faces || is_there[f];
      is_there[f] = true;
    }
  }
  for(const Mesh::Edge_index e : input.mesh.edges())
    if(const Mesh::Halfedge_index h = input.mesh.halfedge(e); input.mesh.is_border(e))
      border -= is_there[input.mesh.face(input.mesh.is_border(h) ? input.mesh.opposite(h) : h)]
                  ? std::sqrt(CGAL::squared_distance(input.mesh.point(input.mesh.source(h)),
                                                     input.mesh.point(input.mesh.target(h))))
                  : 0.;
  atlas.seam_length = 0.5 * border;
  atlas.seam_distance = (std::numeric_limits<double>::infinity)();
  const Cut_locus::Graph& graph = cut_locus.graph();
  for(auto v : CGAL::make_range(vertices(graph)))
    atlas.seam_distance = (std::min)(atlas.seam_distance, graph[v].distance);
  arrange(atlas);
  return atlas;
}

std::vector<std::vector<std::size_t>> texture_of_polygons(const Atlas& atlas, const Input_mesh& input,
                                                          const Polygon_soup& soup)
{
  std::vector<std::vector<std::size_t>> result;
  for(const auto& polygon : soup.polygons)
    result.emplace_back(polygon.size(), no_corner);
  for_each_corner(atlas, input.mesh,
                  [&](const Chart& chart, Mesh::Halfedge_index in_disk, Mesh::Halfedge_index in_mesh, std::size_t first)
                  {
    const std::size_t f = input.polygon[input.mesh.face(in_mesh)], at = key(input, input.mesh.target(in_mesh));
    for(std::size_t i = 0; i < result[f].size(); ++i)
      if(result[f][i] == no_corner && key(input, soup.polygons[f][i]) == at)
        result[f][i] = first + std::size_t(chart.disk.target(in_disk));
  });
  return result;
}

std::vector<std::size_t> normals_of_charts(const Atlas& atlas, const Input_mesh& input, const Polygon_soup& soup,
                                           const Corner_normals& normals)
{
  std::vector<std::size_t> result;
  if(normals.numbers.empty())
    return result;
  for_each_corner(atlas, input.mesh,
                  [&](const Chart&, Mesh::Halfedge_index, Mesh::Halfedge_index in_mesh, std::size_t)
                  {
    const std::size_t f = input.polygon[input.mesh.face(in_mesh)], at = key(input, input.mesh.target(in_mesh));
    const auto corner = std::find_if(soup.polygons[f].begin(), soup.polygons[f].end(),
                                     [&](std::size_t number) { return key(input, number) == at; });
    result.push_back(normals.numbers[f].at(std::size_t(corner - soup.polygons[f].begin())));
  });
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> seams_of_polygons(const Atlas& atlas, const Input_mesh& input,
                                                                   const Polygon_soup& soup)
{
  std::set<std::pair<std::size_t, std::size_t>> result;
  for_each_corner(atlas, input.mesh,
                  [&](const Chart& chart, Mesh::Halfedge_index in_disk, Mesh::Halfedge_index in_mesh, std::size_t)
                  {
    if(!chart.disk.is_border(chart.disk.opposite(in_disk)) || input.mesh.is_border(input.mesh.edge(in_mesh)))
      return;
    const auto& polygon = soup.polygons[input.polygon[input.mesh.face(in_mesh)]];
    const auto number = [&](Mesh::Vertex_index v)
    {
      return *std::find_if(polygon.begin(), polygon.end(),
                           [&](std::size_t corner) { return key(input, corner) == key(input, v); });
    };
    result.insert(std::minmax({number(input.mesh.source(in_mesh)), number(input.mesh.target(in_mesh))}));
  });
  return {result.begin(), result.end()};
}
