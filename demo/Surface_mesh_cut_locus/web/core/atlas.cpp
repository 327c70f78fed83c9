// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"

#include <CGAL/cut_along_cut_locus.h>

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
using UV_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;

// Enough for a picture: the energy falls fast at first.
constexpr unsigned int number_of_iterations = 20;

Mesh::Halfedge_index border_halfedge(const Mesh& disk)
{
  for(Mesh::Halfedge_index h : disk.halfedges())
    if(disk.is_border(h))
      return h;
  throw std::runtime_error("the surface could not be cut to a disk");
}

void flatten(Mesh& disk, UV_map uv)
{
  using Parameterizer = SMP::ARAP_parameterizer_3<Mesh>;
  Parameterizer parameterizer(Parameterizer::Border_parameterizer(), Parameterizer::Solver_traits(), 0.,
                              number_of_iterations, 1e-4);
  const SMP::Error_code code = SMP::parameterize(disk, parameterizer, border_halfedge(disk), uv);
  if(code != SMP::OK)
    throw std::runtime_error(std::string("the cut surface cannot be flattened: ") + SMP::get_error_message(code));
  for(Mesh::Vertex_index v : disk.vertices())
    if(!std::isfinite(uv[v].x()) || !std::isfinite(uv[v].y()))
      throw std::runtime_error("the cut surface cannot be flattened: it has faces that are too thin");
}

// Moves and scales the atlas into the square [-1, 1] x [-1, 1], and returns the factor.
double fit(const Mesh& disk, UV_map uv)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[2] = {infinity, infinity}, high[2] = {-infinity, -infinity};
  for(Mesh::Vertex_index v : disk.vertices())
    for(int i = 0; i < 2; ++i)
    {
      low[i] = (std::min)(low[i], uv[v][i]);
      high[i] = (std::max)(high[i], uv[v][i]);
    }
  const double scale = 2. / (std::max)(high[0] - low[0], high[1] - low[1]);
  for(Mesh::Vertex_index v : disk.vertices())
    uv[v] = Kernel::Point_2(scale * (uv[v].x() - (low[0] + high[0]) / 2.),
                            scale * (uv[v].y() - (low[1] + high[1]) / 2.));
  return scale;
}

} // namespace

Atlas make_atlas(const Mesh& mesh, const Cut_locus& cut_locus, const std::function<void()>& on_flatten)
{
  Mesh disk;
  auto origin = disk.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
  UV_map uv = disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  CGAL::cut_along_cut_locus(mesh, cut_locus, disk, CGAL::parameters::vertex_to_vertex_map(origin));

  on_flatten();
  flatten(disk, uv);
  const double scale = fit(disk, uv);

  Atlas atlas;
  for(Mesh::Vertex_index v : disk.vertices())
  {
    atlas.origin.push_back(origin[v]);
    atlas.uv.push_back(static_cast<float>(uv[v].x()));
    atlas.uv.push_back(static_cast<float>(uv[v].y()));
  }
  double flipped = 0., area = 0., stretch = 0.;
  for(Mesh::Face_index f : disk.faces())
  {
    const Mesh::Halfedge_index h = disk.halfedge(f);
    const Mesh::Vertex_index t[3] = {disk.source(h), disk.target(h), disk.target(disk.next(h))};
    for(Mesh::Vertex_index v : t)
      atlas.triangles.push_back(v);
    const double flat = CGAL::area(uv[t[0]], uv[t[1]], uv[t[2]]) / (scale * scale);
    const double real = std::sqrt(CGAL::squared_area(disk.point(t[0]), disk.point(t[1]), disk.point(t[2])));
    flipped += flat <= 0.;
    area += real;
    stretch += real * (std::max)(std::fabs(flat) / real, real / std::fabs(flat));
  }
  for(Mesh::Halfedge_index h : disk.halfedges())
    if(disk.is_border(h))
      for(Mesh::Vertex_index v : {disk.source(h), disk.target(h)})
        atlas.border.push_back(v);
  atlas.numbers = {flipped, stretch / area,
                   double(disk.number_of_vertices()) - double(disk.number_of_edges()) + double(disk.number_of_faces())};
  return atlas;
}
