// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Session.h"

#include <CGAL/Cut_loci/IO/write_cut_locus.h>
#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/statistics.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// edges, cycles, leaves, branchings, length, injectivity radius, where it is reached (3), status, narrow corridors,
// the radius with all weak branches
std::vector<double> statistics_of(const Cut_locus& cut_locus)
{
  const CGAL::Cut_loci::Cut_locus_statistics s = CGAL::Cut_loci::compute_statistics(cut_locus);
  const auto nearest = CGAL::Cut_loci::injectivity_radius(cut_locus);
  return {double(s.edges),   double(s.cycles), double(s.leaves),           double(s.branchings),
          s.length,          nearest.distance, nearest.point.x(),          nearest.point.y(),
          nearest.point.z(), double(s.status), double(s.narrow_corridors), nearest.lower_bound};
}

CGAL::Cut_loci::Method method_of(const std::string& name)
{
  if(name == "default")
    return CGAL::Cut_loci::Default_method();
  if(name == "polyhedral")
    return CGAL::Cut_loci::Polyhedral_method();
  return CGAL::Cut_loci::Laplacian_method();
}

} // namespace

void Session::load(Mesh mesh, const std::vector<std::size_t>& component_of_face, std::string done)
{
  solver_.reset();
  fields_.reset();
  paths_.reset();
  repairs = std::move(done);
  component.assign(component_of_face.begin(), component_of_face.end());
  results_[0].reset();
  results_[1].reset();
  has_sources_ = false;
  mesh_ = std::make_unique<Mesh>(std::move(mesh));

  std::array<double, 3> low = {{infinity, infinity, infinity}}, high = {{-infinity, -infinity, -infinity}};
  for(Mesh::Vertex_index v : mesh_->vertices())
    for(int i = 0; i < 3; ++i)
    {
      const double c = mesh_->point(v)[i];
      if(!std::isfinite(c))
        throw std::runtime_error("vertex #" + std::to_string(v.idx()) +
                                 " has a coordinate that is not a finite number");
      low[i] = (std::min)(low[i], c);
      high[i] = (std::max)(high[i], c);
    }
  center_ = Kernel::Point_3((low[0] + high[0]) / 2., (low[1] + high[1]) / 2., (low[2] + high[2]) / 2.);
  radius_ = 0.;
  for(Mesh::Vertex_index v : mesh_->vertices())
    radius_ = (std::max)(radius_, std::sqrt(CGAL::squared_distance(center_, mesh_->point(v))));
  if(!(radius_ > 0.))
    throw std::runtime_error("all vertices are at the same point");
  mesh_numbers = {center_.x(), center_.y(), center_.z(), radius_};

  positions.clear();
  positions.reserve(3 * mesh_->number_of_vertices());
  for(Mesh::Vertex_index v : mesh_->vertices())
    append_point(mesh_->point(v), positions);
  triangles.clear();
  triangles.reserve(3 * mesh_->number_of_faces());
  for(Mesh::Face_index f : mesh_->faces())
  {
    const Mesh::Halfedge_index h = mesh_->halfedge(f);
    for(Mesh::Vertex_index v : {mesh_->source(h), mesh_->target(h), mesh_->target(mesh_->next(h))})
      triangles.push_back(v);
  }
}

void Session::prepare(const std::string& solver, const std::string& method)
{
  if(!mesh_)
    throw std::runtime_error("there is no mesh yet");
  if(solver_ && solver == solver_name_ && method == method_name_)
    return;
  if(method != "laplacian" && solver != "exact")
    throw std::runtime_error("the method " + method + " needs exact distances");
  results_[0].reset();
  results_[1].reset();
  solver_.reset(); // its memory is free for the next one
  has_sources_ = false;
  if(solver == "heat")
    solver_ = make_heat_solver(*mesh_);
  else if(solver == "graph")
    solver_ = make_graph_solver(*mesh_);
  else
    solver_ = make_exact_solver(*mesh_, method_of(method));
  solver_name_ = solver;
  method_name_ = method;
}

void Session::set_sources(const std::vector<Location>& points, bool with_border, double relative_error)
{
  if(!solver_)
    throw std::runtime_error("there is no solver yet");
  for(const Location& point : points)
    check(point);
  has_sources_ = false;
  exact_distance_.clear();
  points_ = points;
  curves_.clear();
  if(with_border)
    curves_ = border_loops(*mesh_, component, points.empty() ? Mesh::null_face() : points.front().first);
  const bool can_be_inexact = solver_name_ == "exact" && method_name_ != "polyhedral" && curves_.empty();
  ::set_sources(*solver_, points_, curves_, can_be_inexact ? relative_error : 0.);
  has_sources_ = true;
  border_segments.clear();
  for(const Edge_curve& curve : curves_)
    for(const Mesh::Edge_index e : curve)
      for(int end : {0, 1})
        append_point(mesh_->point(mesh_->vertex(e, end)), border_segments);
}

void Session::check(const Location& location) const
{
  if(location.first >= mesh_->number_of_faces())
    throw std::runtime_error("the mesh has no face #" + std::to_string(location.first));
}

void Session::compute_curve(Curve_index index, const Thresholds& thresholds)
{
  if(!has_sources_)
    throw std::runtime_error("there is no source yet");
  using CGAL::Cut_loci::Curve;
  const Curve kind = index == MESH_EDGES ? Curve::MESH_EDGES : Curve::THROUGH_FACES;
  results_[index].emplace(::cut_locus(*solver_, thresholds, kind));
  const Cut_locus& cut_locus = *results_[index];
  const Cut_locus::Graph& graph = cut_locus.graph();
  if(exact_distance_.empty())
    read_source(cut_locus);
  Session::Curve& curve = curves[index];
  curve.segments.clear();
  curve.width.clear();
  curve.gap.clear();
  curve.distance.clear();
  curve.segments.reserve(6 * num_edges(graph));
  for(const auto e : CGAL::make_range(edges(graph)))
  {
    append_point(graph[source(e, graph)].point, curve.segments);
    append_point(graph[target(e, graph)].point, curve.segments);
    curve.width.push_back(static_cast<float>(graph[e].width / diagonal_));
    curve.gap.push_back(static_cast<float>(graph[e].strength));
    curve.distance.push_back(
      static_cast<float>((graph[source(e, graph)].distance + graph[target(e, graph)].distance) / 2.));
  }
  curve.numbers = statistics_of(cut_locus);
}

double Session::default_width() const
{
  if(!has_sources_)
    throw std::runtime_error("there is no source yet");
  // of a plain polyhedron, all of whose tree is shown for what it encloses, it is one that no branch has
  const double width = method_name_ == "laplacian" ? 0. : solver_->minimum_branch_width();
  return width < 1. ? width : 0.;
}

// What all curves for a source have in common.
void Session::read_source(const Cut_locus& cut_locus)
{
  exact_distance_.reserve(mesh_->number_of_vertices());
  distance.clear();
  nearest_source.clear();
  CGAL::Bbox_3 box;
  for(Mesh::Vertex_index v : mesh_->vertices())
  {
    exact_distance_.push_back(cut_locus.distance(v));
    distance.push_back(static_cast<float>(exact_distance_.back()));
    if(std::isfinite(exact_distance_.back()))
      box += mesh_->point(v).bbox();
    if(cut_locus.number_of_sources() > 1)
      nearest_source.push_back(static_cast<std::uint32_t>(cut_locus.nearest_source(v).value_or(0)));
  }
  diagonal_ = std::sqrt(CGAL::squared_distance(Kernel::Point_3(box.xmin(), box.ymin(), box.zmin()),
                                               Kernel::Point_3(box.xmax(), box.ymax(), box.zmax())));
  const Mesh::Vertex_index farthest = cut_locus.farthest_vertex();
  const Kernel::Point_3& f = mesh_->point(farthest);
  source_numbers = {f.x(),
                    f.y(),
                    f.z(),
                    cut_locus.distance(farthest),
                    double(cut_locus.number_of_border_loops()),
                    double(cut_locus.genus()),
                    CGAL::Cut_loci::Laplacian_method().gradient_angle_threshold(),
                    default_width(),
                    double(cut_locus.number_of_sources())};
  for(std::size_t i = 0; i < points_.size(); ++i)
    for(int k = 0; k < 3; ++k)
      source_numbers.push_back(cut_locus.source(i).point[k]);
}

void Session::compute_laplacian()
{
  laplacian = fields().laplacian(exact_distance_);
}

void Session::compute_gradient()
{
  gradient = fields().gradient(exact_distance_);
}

void Session::cut_open(Curve_index index, const Thresholds& thresholds, bool by_logarithmic_map)
{
  const bool has_cells = !curves_.empty() || points_.size() > 1;
  if(has_cells && by_logarithmic_map)
    throw std::runtime_error("the logarithmic map is that of one point");
  compute_curve(index, thresholds);
  const Layout layout = by_logarithmic_map ? Layout::LOGARITHMIC : has_cells ? Layout::CELLS : Layout::INJECTIVE;
  if(thresholds.keeps == Kept_part::ALL)
  {
    atlas = make_atlas(*mesh_, *results_[index], layout);
    return;
  }
  // what is not shown is needed as well, to have disks
  atlas = make_atlas(*mesh_, part_of_cut_locus(index, thresholds, Kept_part::ALL), layout);
}

void Session::divide_into_cells(Curve_index index, const Thresholds& thresholds)
{
  if(!has_sources_)
    throw std::runtime_error("there is no source yet");
  cells = make_cell_surface(*mesh_, part_of_cut_locus(index, thresholds, Kept_part::VORONOI));
}

Cut_locus Session::part_of_cut_locus(Curve_index index, Thresholds thresholds, Kept_part kept) const
{
  using CGAL::Cut_loci::Curve;
  thresholds.keeps = kept;
  return ::cut_locus(*solver_, thresholds, index == MESH_EDGES ? Curve::MESH_EDGES : Curve::THROUGH_FACES);
}

const Fields& Session::fields()
{
  if(exact_distance_.empty())
    throw std::runtime_error("there are no distances yet");
  if(!fields_)
    fields_ = std::make_unique<Fields>(*mesh_);
  return *fields_;
}

void Session::find_paths(const Location& end)
{
  if(!has_sources_)
    throw std::runtime_error("there is no source yet");
  if(!curves_.empty())
    throw std::runtime_error("shortest paths are shown to points; here the border is a source, too");
  check(end);
  if(!paths_)
    paths_ = std::make_unique<Paths>(*mesh_);
  // the curve that is drawn is off the cut locus by a small part of a face
  double shortest = infinity;
  const Mesh::Halfedge_index h = mesh_->halfedge(end.first);
  for(Mesh::Halfedge_index side : {h, mesh_->next(h), mesh_->prev(h)})
    shortest = (std::min)(shortest, std::sqrt(CGAL::squared_distance(mesh_->point(mesh_->source(side)),
                                                                     mesh_->point(mesh_->target(side)))));
  path_points.clear();
  path_numbers.clear();
  for(const Paths::Path& path : paths_->find(points_, end, .05 * shortest))
  {
    for(const Kernel::Point_3& p : path.points)
      append_point(p, path_points);
    path_numbers.push_back(double(path.points.size()));
    path_numbers.push_back(path.length);
  }
}

std::string Session::write_curve(Curve_index index, const std::string& format) const
{
  if(!results_[index])
    throw std::runtime_error("there is no cut locus yet");
  std::ostringstream os;
  if(format == "obj")
    CGAL::IO::write_OBJ(os, *results_[index]);
  else if(format == "ply")
    CGAL::IO::write_PLY(os, *results_[index]);
  else if(format == "vtp")
    CGAL::IO::write_VTP(os, *results_[index]);
  else
    CGAL::IO::write_polylines(os, *results_[index]);
  return os.str();
}

void Session::append_point(const Kernel::Point_3& p, std::vector<float>& to) const
{
  for(int i = 0; i < 3; ++i)
    to.push_back(static_cast<float>((p[i] - center_[i]) / radius_));
}
