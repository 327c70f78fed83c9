// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "charts.h"
#include "seams_around_polygons.h"

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ch_graham_andrew.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace {

namespace loci = CGAL::Cut_loci;
namespace lib = CGAL::Cut_loci::internal;
using loci::Index;
using Vector_2 = Kernel::Vector_2;

struct Box
{
  UV low, high;
  double area() const { return (high[0] - low[0]) * (high[1] - low[1]); }
};

// Around points, in a frame whose first axis is this one.
template <typename Points>
Box box_of(const Points& points, const Vector_2& axis)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box = {{{infinity, infinity}}, {{-infinity, -infinity}}};
  for(const auto& p : points)
  {
    const UV at = {{p.x() * axis.x() + p.y() * axis.y(), p.y() * axis.x() - p.x() * axis.y()}};
    for(int i = 0; i < 2; ++i)
    {
      box.low[i] = (std::min)(box.low[i], at[i]);
      box.high[i] = (std::max)(box.high[i], at[i]);
    }
  }
  return box;
}

// The first axis of the least box around a chart, which has a side on the convex hull; the box stands upright.
Vector_2 axis_of_least_box(const Chart& chart)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point> points, hull;
  for(const Mesh::Vertex_index v : chart.disk.vertices())
    points.emplace_back(chart.uv[v].x(), chart.uv[v].y());
  CGAL::ch_graham_andrew(points.begin(), points.end(), std::back_inserter(hull));
  Vector_2 best(1., 0.);
  double least = box_of(points, best).area();
  for(std::size_t i = 0; i < hull.size(); ++i)
  {
    const Point &p = hull[i], &q = hull[(i + 1) % hull.size()];
    const double length = std::hypot(q.x() - p.x(), q.y() - p.y());
    const Vector_2 axis((q.x() - p.x()) / length, (q.y() - p.y()) / length);
    if(const double area = box_of(hull, axis).area(); area < least)
    {
      least = area;
      best = axis;
    }
  }
  const Box box = box_of(points, best);
  return box.high[0] - box.low[0] > box.high[1] - box.low[1] ? Vector_2(-best.y(), best.x()) : best;
}

// For each halfedge of a part of the mesh.
std::vector<bool> diagonals_of(const lib::Read_triangle_mesh<Mesh>& read, const Mesh& mesh,
                               const std::vector<Index>& faces, const Diagonals& is_diagonal)
{
  std::vector<bool> result(3 * faces.size(), false);
  for(std::size_t h = 0; h < result.size() && !is_diagonal.empty(); ++h)
    result[h] = is_diagonal[mesh.edge(read.halfedges[3 * std::size_t(faces[h / 3]) + h % 3])];
  return result;
}

} // namespace

Chart::Chart() : uv(disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv", Kernel::Point_2(0., 0.)).first)
{
}

std::unique_ptr<Chart> make_chart(const Mesh& mesh, const loci::Indexed_triangle_mesh& cut, std::vector<Index> vertices,
                                  std::vector<Index> faces)
{
  auto chart = std::make_unique<Chart>();
  const auto built = lib::build_face_graph(cut, chart->disk);
  for(Index v = 0; v < cut.number_of_vertices(); ++v)
  {
    const auto& p = cut.points[v];
    chart->disk.point(built.vertices[v]) =
      vertices[v] == loci::null_index ? Kernel::Point_3(p[0], p[1], p[2]) : mesh.point(Mesh::Vertex_index(vertices[v]));
  }
  chart->vertices = std::move(vertices);
  chart->faces = std::move(faces);
  for(const Mesh::Face_index f : chart->disk.faces())
  {
    const Mesh::Halfedge_index h = chart->disk.halfedge(f);
    chart->area +=
      std::sqrt(CGAL::squared_area(chart->disk.point(chart->disk.source(h)), chart->disk.point(chart->disk.target(h)),
                                   chart->disk.point(chart->disk.target(chart->disk.next(h)))));
  }
  return chart;
}

std::unique_ptr<Chart> chart_of_source(const Mesh& mesh, const Cut_locus& cut_locus, const Diagonals& is_diagonal)
{
  const auto read = lib::read_triangle_mesh(mesh, mesh.points());
  lib::Curve_on_mesh curve = lib::curve_on_mesh(read, mesh, cut_locus);
  lib::throw_unless_of_one_source(curve);
  const auto of_surface = [&](const loci::Cut_mesh& cut, const std::vector<Index>& vertices, std::vector<Index> faces)
  {
    std::vector<Index> origin;
    for(const Index v : cut.vertices)
      origin.push_back(v < vertices.size() ? Index(read.vertices[vertices[v]]) : loci::null_index);
    return make_chart(mesh, cut.mesh, std::move(origin), std::move(faces));
  };
  if(!curve.is_of_mesh_edges)
  {
    lib::Disk_of_curve disk =
      lib::cut_along(read.mesh, std::move(curve), lib::resolution_of(lib::default_snapping_of_curves));
    for(Index& f : disk.refined.faces)
      f = disk.on.component.faces[f];
    return of_surface(disk.cut, disk.on.component.vertices, std::move(disk.refined.faces));
  }
  lib::Curve_on_component on = lib::on_component(read.mesh, std::move(curve));
  const loci::Indexed_triangle_mesh& part = on.component.mesh;
  loci::Seams seams = lib::seams_of_mesh_edges(part, lib::manifold_connectivity(part), on.curve);
  const std::vector<bool> diagonals = diagonals_of(read, mesh, on.component.faces, is_diagonal);
  lead_around_polygons(part, diagonals, seams);
  auto chart = of_surface(lib::cut_open_to_disk(part, seams), on.component.vertices, std::move(on.component.faces));
  for(Index h = 0; h < seams.size(); ++h)
    chart->seams_in_polygons += diagonals[h] && seams[h] && h < part.opposite[h];
  return chart;
}

void place(Chart& chart)
{
  double in_plane = 0.;
  for(const Mesh::Face_index f : chart.disk.faces())
  {
    const Mesh::Halfedge_index h = chart.disk.halfedge(f);
    const Kernel::Point_2& p = chart.uv[chart.disk.source(h)];
    in_plane +=
      0.5 * CGAL::determinant(chart.uv[chart.disk.target(h)] - p, chart.uv[chart.disk.target(chart.disk.next(h))] - p);
  }
  const double scale = in_plane == 0. ? 1. : std::sqrt(chart.area / std::abs(in_plane));
  for(const Mesh::Vertex_index v : chart.disk.vertices())
    chart.uv[v] = {in_plane < 0. ? -scale * chart.uv[v].x() : scale * chart.uv[v].x(), scale * chart.uv[v].y()};
  const Vector_2 axis = axis_of_least_box(chart);
  const Box box = box_of(std::vector<Kernel::Point_2>(chart.uv.begin(), chart.uv.end()), axis);
  for(const Mesh::Vertex_index v : chart.disk.vertices())
  {
    const Kernel::Point_2 p = chart.uv[v];
    chart.uv[v] = {p.x() * axis.x() + p.y() * axis.y() - box.low[0], p.y() * axis.x() - p.x() * axis.y() - box.low[1]};
  }
  chart.size = {{box.high[0] - box.low[0], box.high[1] - box.low[1]}};
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
