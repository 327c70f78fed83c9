// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"
#include "flatten.h"

#include <CGAL/Cut_loci/flatten_disk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace {

using Point_2 = Kernel::Point_2;

// Into the unit square, with a margin, and counterclockwise.
void normalize(std::vector<std::array<double, 2>>& points, bool is_reversed)
{
  constexpr double margin = 0.02;
  std::array<double, 2> low = {{1e300, 1e300}}, high = {{-1e300, -1e300}};
  for(auto& p : points)
    for(int i = 0; i < 2; ++i)
    {
      if(i == 0 && is_reversed)
        p[0] = -p[0];
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  const double size = (std::max)(high[0] - low[0], high[1] - low[1]);
  for(auto& p : points)
    for(int i = 0; i < 2; ++i)
      p[i] = 0.5 + (1. - 2. * margin) * (p[i] - 0.5 * (low[i] + high[i])) / size;
}

} // namespace

Atlas make_atlas(const Mesh& mesh, const Cut_locus& cut_locus, const std::string& parameterization)
{
  Flat_disk flat;
  cut_open(mesh, cut_locus, flat);
  flatten(mesh, cut_locus, flat, parameterization);
  const Mesh& disk = flat.mesh;
  const Flat_disk::Origin_map origin = flat.origin;
  const Flat_disk::Face_origin_map face_origin = flat.face_origin;
  Flat_disk::UV_map uv = flat.uv;

  Atlas atlas;
  atlas.parameterization = parameterization;
  for(Mesh::Vertex_index v : mesh.vertices())
    atlas.points.push_back(mesh.point(v));
  // The copies of a vertex that was added have the same coordinates.
  std::map<Kernel::Point_3, std::size_t> added;
  std::vector<std::size_t> vertex(disk.number_of_vertices());
  for(Mesh::Vertex_index v : disk.vertices())
  {
    atlas.texture_coordinates.push_back({{uv[v].x(), uv[v].y()}});
    if(origin[v] != Mesh::null_vertex())
    {
      vertex[v] = origin[v];
      continue;
    }
    const auto inserted = added.insert({disk.point(v), atlas.points.size()});
    if(inserted.second)
      atlas.points.push_back(disk.point(v));
    vertex[v] = inserted.first->second;
  }
  double signed_area = 0.;
  std::vector<bool> is_flattened(mesh.number_of_faces(), false);
  for(Mesh::Face_index f : disk.faces())
  {
    is_flattened[face_origin[f]] = true;
    const Mesh::Halfedge_index h = disk.halfedge(f);
    const std::array<Mesh::Vertex_index, 3> v = {{disk.source(h), disk.target(h), disk.target(disk.next(h))}};
    atlas.faces.push_back({{vertex[v[0]], vertex[v[1]], vertex[v[2]]}});
    atlas.texture_corners.push_back({{std::size_t(v[0]), std::size_t(v[1]), std::size_t(v[2])}});
    signed_area += CGAL::determinant(uv[v[1]] - uv[v[0]], uv[v[2]] - uv[v[0]]);
  }
  for(Mesh::Face_index f : mesh.faces()) // other components
    if(!is_flattened[f])
    {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      atlas.faces.push_back({{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}});
    }
  finish_atlas(cut_locus, signed_area < 0., atlas);
  for(Mesh::Vertex_index v : disk.vertices()) // rounded to what is written
    uv[v] = Point_2(atlas.texture_coordinates[v][0], atlas.texture_coordinates[v][1]);
  atlas.quality = CGAL::Cut_loci::layout_quality(disk, uv);
  return atlas;
}

void finish_atlas(const Cut_locus& cut_locus, bool is_reversed, Atlas& atlas)
{
  normalize(atlas.texture_coordinates, is_reversed);

  atlas.seam_distance = (std::numeric_limits<double>::infinity)();
  const Cut_locus::Graph& graph = cut_locus.graph();
  for(auto v : CGAL::make_range(vertices(graph)))
    atlas.seam_distance = (std::min)(atlas.seam_distance, graph[v].distance);
}
