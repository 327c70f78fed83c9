// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"
#include "flatten.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace {

using Point_2 = Kernel::Point_2;

// The singular values of the map from a face to its image.
std::array<double, 2> stretches(const std::array<Kernel::Point_3, 3>& p, const std::array<Point_2, 3>& q, double& area,
                                double& signed_area)
{
  const Kernel::Vector_3 u = p[1] - p[0], v = p[2] - p[0];
  const double length = std::sqrt(u.squared_length());
  const double x = (u * v) / length, y = std::sqrt((std::max)(0., v.squared_length() - x * x));
  area = 0.5 * length * y;
  // the columns of the Jacobian, in a frame of the face with the first axis along u
  const Kernel::Vector_2 a = (q[1] - q[0]) / length, b = ((q[2] - q[0]) - x * a) / y;
  const double determinant = a.x() * b.y() - a.y() * b.x();
  signed_area = area * determinant;
  const double sum = a.squared_length() + b.squared_length();
  const double difference = std::sqrt((std::max)(0., sum * sum - 4. * determinant * determinant));
  return {{std::sqrt(0.5 * (sum + difference)), std::sqrt((std::max)(0., 0.5 * (sum - difference)))}};
}

void measure(Atlas& atlas)
{
  double area_3 = 0., area_2 = 0.;
  std::vector<std::array<double, 4>> faces; // area, signed area in the plane, stretches
  for(std::size_t f = 0; f < atlas.texture_corners.size(); ++f)
  {
    std::array<Kernel::Point_3, 3> p;
    std::array<Point_2, 3> q;
    for(int i = 0; i < 3; ++i)
    {
      const auto& t = atlas.texture_coordinates[atlas.texture_corners[f][i]];
      p[i] = atlas.points[atlas.faces[f][i]];
      q[i] = Point_2(t[0], t[1]);
    }
    double area, signed_area;
    const std::array<double, 2> s = stretches(p, q, area, signed_area);
    faces.push_back({{area, signed_area, s[0], s[1]}});
    area_3 += area;
    area_2 += std::abs(signed_area);
    atlas.flipped_faces += !(signed_area > 0.);
  }
  const double scale = area_3 / area_2; // of areas
  for(const auto& f : faces)
  {
    const double areas = scale * f[2] * f[3], angles = f[2] / f[3];
    atlas.area_distortion += f[0] / area_3 * 0.5 * (areas + 1. / areas);
    atlas.angle_distortion += f[0] / area_3 * 0.5 * (angles + 1. / angles);
  }
}

// The part of the covered texels, by their centers, that several faces cover.
double overlap(const Atlas& atlas)
{
  constexpr int size = 1024;
  std::vector<unsigned char> count(size * size, 0);
  for(const auto& corners : atlas.texture_corners)
  {
    std::array<std::array<double, 2>, 3> p;
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 2; ++k)
        p[i][k] = size * atlas.texture_coordinates[corners[i]][k] - 0.5; // texel (x, y) has its center at (x, y)
    const auto side = [](const auto& a, const auto& b, double x, double y)
    { return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]); };
    if(side(p[0], p[1], p[2][0], p[2][1]) < 0.)
      std::swap(p[1], p[2]);
    const auto x = std::minmax({p[0][0], p[1][0], p[2][0]}), y = std::minmax({p[0][1], p[1][1], p[2][1]});
    for(int j = static_cast<int>(std::ceil(y.first)); j <= y.second; ++j)
      for(int i = static_cast<int>(std::ceil(x.first)); i <= x.second; ++i)
        // a center on an edge belongs to no face rather than to two
        if(side(p[0], p[1], i, j) > 0. && side(p[1], p[2], i, j) > 0. && side(p[2], p[0], i, j) > 0.)
        {
          unsigned char& c = count[j * size + i];
          c = (std::min)(c + 1, 2);
        }
  }
  const auto covered = count.size() - std::count(count.begin(), count.end(), 0);
  return covered == 0 ? 0. : double(std::count(count.begin(), count.end(), 2)) / double(covered);
}

// Into the unit square, with a margin.
void normalize(std::vector<std::array<double, 2>>& points)
{
  constexpr double margin = 0.02;
  std::array<double, 2> low = {{1e300, 1e300}}, high = {{-1e300, -1e300}};
  for(auto& p : points)
    for(int i = 0; i < 2; ++i)
    {
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
  flatten(flat, parameterization);
  const Mesh& disk = flat.mesh;
  const Flat_disk::Origin_map origin = flat.origin;
  const Flat_disk::Face_origin_map face_origin = flat.face_origin;
  const Flat_disk::UV_map uv = flat.uv;

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
  if(signed_area < 0.)
    for(auto& p : atlas.texture_coordinates)
      p[0] = -p[0];
  finish_atlas(cut_locus, atlas);
  return atlas;
}

void finish_atlas(const Cut_locus& cut_locus, Atlas& atlas)
{
  normalize(atlas.texture_coordinates);
  measure(atlas);
  atlas.overlap = overlap(atlas);

  atlas.seam_distance = (std::numeric_limits<double>::infinity)();
  const Cut_locus::Graph& graph = cut_locus.graph();
  for(auto v : CGAL::make_range(vertices(graph)))
    atlas.seam_distance = (std::min)(atlas.seam_distance, graph[v].distance);
}
