// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "flatten.h"
#include "arap.h"
#include "logarithmic_layout.h"

#include <CGAL/Cut_loci/flatten_disk.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cmath>
#include <stdexcept>

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
using Point_2 = Kernel::Point_2;

SMP::Error_code parameterize(Mesh& disk, const std::string& name, Chart::UV_map uv)
{
  const Mesh::Halfedge_index border = CGAL::Polygon_mesh_processing::longest_border(disk).first;
  if(name == "convex")
    return SMP::parameterize(disk, SMP::Mean_value_coordinates_parameterizer_3<Mesh>(), border, uv);
  return SMP::parameterize(disk, SMP::LSCM_parameterizer_3<Mesh>(), border, uv); // arap starts from it, too
}

bool make_rigid(const Mesh& disk, Chart::UV_map uv)
{
  constexpr double tolerance = 1e-6; // as CGAL's
  Points_3 points;
  Points_2 plane;
  Triangles faces;
  for(Mesh::Vertex_index v : disk.vertices())
  {
    const Kernel::Point_3& p = disk.point(v);
    points.push_back({{p.x(), p.y(), p.z()}});
    plane.push_back({{uv[v].x(), uv[v].y()}});
  }
  for(Mesh::Face_index f : disk.faces())
  {
    const Mesh::Halfedge_index h = disk.halfedge(f);
    faces.push_back({{disk.source(h), disk.target(h), disk.target(disk.next(h))}});
  }
  if(!flatten_as_rigidly_as_possible(points, faces, plane, tolerance))
    return false;
  for(Mesh::Vertex_index v : disk.vertices())
    uv[v] = Point_2(plane[v][0], plane[v][1]);
  return true;
}

} // namespace

void flatten(Chart& chart, const std::string& parameterization)
{
  Mesh& disk = chart.disk;
  const Chart::UV_map uv = chart.uv;
  if(parameterization == "injective")
  {
    CGAL::Cut_loci::flatten_disk(disk, uv);
    return;
  }
  const SMP::Error_code error = parameterize(disk, parameterization, uv);
  if(error == SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM) // CGAL 5.5 and 6.1 give it the message of another error
    throw std::runtime_error("the surface can not be flattened: the linear system can not be solved");
  if(error != SMP::OK)
    throw std::runtime_error(std::string("the surface can not be flattened: ") + SMP::get_error_message(error));
  if(parameterization == "arap" && !make_rigid(disk, uv))
    throw std::runtime_error("the surface can not be flattened: the linear system can not be solved");
  for(Mesh::Vertex_index v : disk.vertices())
    if(!std::isfinite(uv[v].x()) || !std::isfinite(uv[v].y()))
      throw std::runtime_error("the surface can not be flattened: the solver fails");
}

void flatten(const Mesh& mesh, const Cut_locus& cut_locus, Chart& chart, const std::string& parameterization)
{
  if(parameterization == "logmap")
    lay_out_by_logarithmic_map(mesh, cut_locus, chart);
  else
    flatten(chart, parameterization);
}
