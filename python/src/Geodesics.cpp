// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Geodesics.h"

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

Geodesics::Geodesics(std::shared_ptr<const Mesh> mesh, const std::vector<bool>& excluded)
  : mesh_(std::move(mesh)),
    geodesics_(*mesh_, CGAL::parameters::face_is_excluded_map(boost::make_function_property_map<Mesh::Face_index, bool>(
                         [&](Mesh::Face_index f) { return !excluded.empty() && excluded[f.idx()]; })))
{
}

void Geodesics::compute(const Sources& sources, const std::vector<Location>& targets, const Wishes& wishes)
{
  has_result_ = false;
  geodesics_.set_directions(wishes.directions);
  geodesics_.set_isolines(wishes.isolines);
  geodesics_.set_maximum_relative_error(wishes.error);
  geodesics_.set_maximum_distance(wishes.maximum_distance);
  geodesics_.clear_sources();
  for(const Source& source : sources.points)
    std::visit([&](const auto& point) { geodesics_.add_source(point); }, source);
  for(const Source_curve& curve : sources.curves)
    geodesics_.add_source_curve(curve);
  if(sources.border)
    geodesics_.add_source_border();
  geodesics_.clear_queries();
  for(const Location& target : targets)
    geodesics_.add_query(target);
  geodesics_.compute();
  number_of_targets_ = targets.size();
  has_directions_ = wishes.directions;
  has_result_ = true;
}

void Geodesics::require_result() const
{
  if(!has_result_)
    throw std::logic_error("there is no source: compute() comes first");
}

std::vector<double> Geodesics::distances() const
{
  require_result();
  std::vector<double> result;
  result.reserve(mesh_->number_of_vertices());
  for(Mesh::Vertex_index v : mesh_->vertices())
    result.push_back(geodesics_.distance(v));
  return result;
}

std::vector<double> Geodesics::errors() const
{
  require_result();
  std::vector<double> result;
  result.reserve(mesh_->number_of_vertices());
  for(Mesh::Vertex_index v : mesh_->vertices())
    result.push_back(geodesics_.distance_error(v));
  return result;
}

std::vector<std::int64_t> Geodesics::nearest_sources() const
{
  require_result();
  std::vector<std::int64_t> result;
  result.reserve(mesh_->number_of_vertices());
  for(Mesh::Vertex_index v : mesh_->vertices())
    result.push_back(std::isfinite(geodesics_.distance(v)) ? static_cast<std::int64_t>(geodesics_.nearest_source(v))
                                                           : -1);
  return result;
}

std::vector<double> Geodesics::target_distances() const
{
  require_result();
  std::vector<double> result;
  for(std::size_t i = 0; i < number_of_targets_; ++i)
    result.push_back(geodesics_.distance(Query{i}));
  return result;
}

std::vector<std::int64_t> Geodesics::target_nearest_sources() const
{
  require_result();
  std::vector<std::int64_t> result;
  for(std::size_t i = 0; i < number_of_targets_; ++i)
    result.push_back(std::isfinite(geodesics_.distance(Query{i}))
                       ? static_cast<std::int64_t>(geodesics_.nearest_source(Query{i}))
                       : -1);
  return result;
}

std::vector<double> Geodesics::log_map() const
{
  require_result();
  std::vector<double> result;
  result.reserve(2 * std::size_t(mesh_->number_of_vertices()));
  for(Mesh::Vertex_index v : mesh_->vertices())
    for(double x : geodesics_.logarithmic_map(v))
      result.push_back(x);
  return result;
}

std::vector<double> Geodesics::target_log_map() const
{
  require_result();
  std::vector<double> result;
  for(std::size_t i = 0; i < number_of_targets_; ++i)
    for(double x : geodesics_.logarithmic_map(Query{i}))
      result.push_back(x);
  return result;
}

std::vector<double> Geodesics::arrival_directions() const
{
  require_result();
  std::vector<double> result;
  result.reserve(3 * std::size_t(mesh_->number_of_vertices()));
  for(Mesh::Vertex_index v : mesh_->vertices())
  {
    const double d = geodesics_.distance(v);
    if(!(d > 0. && std::isfinite(d)))
    {
      result.insert(result.end(), 3, std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const auto direction = geodesics_.arrival_direction(v);
    const Mesh::Halfedge_index h = direction.first;
    const Kernel::Point_3& p = mesh_->point(mesh_->source(h));
    const Kernel::Vector_3 along = mesh_->point(mesh_->target(h)) - p,
                           other = mesh_->point(mesh_->target(mesh_->next(h))) - p,
                           aside = other - (other * along) / along.squared_length() * along;
    const Kernel::Vector_3 result_vector = std::cos(direction.second) / std::sqrt(along.squared_length()) * along +
                                           std::sin(direction.second) / std::sqrt(aside.squared_length()) * aside;
    result.insert(result.end(), {result_vector.x(), result_vector.y(), result_vector.z()});
  }
  return result;
}

std::vector<std::int64_t> Geodesics::source_axes() const
{
  require_result();
  std::vector<std::int64_t> result;
  for(std::size_t i = 0; i < geodesics_.number_of_sources(); ++i)
  {
    const Mesh::Halfedge_index h = geodesics_.source_halfedge(i);
    result.push_back(mesh_->source(h).idx());
    result.push_back(mesh_->target(h).idx());
  }
  return result;
}

Geodesic_path Geodesics::exponential_map(const std::vector<double>& places, std::size_t source) const
{
  require_result();
  std::vector<Location> locations;
  for(std::size_t i = 0; i + 1 < places.size(); i += 2)
    locations.push_back(geodesics_.exponential_map({{places[i], places[i + 1]}}, source));
  return path(locations);
}

std::vector<Geodesics::Isoline> Geodesics::isolines(const std::vector<double>& levels,
                                                    std::optional<double> maximum_deviation) const
{
  require_result();
  std::vector<CGAL::Surface_mesh_exact_geodesics<Mesh>::Isoline> lines;
  geodesics_.isolines(levels, std::back_inserter(lines), maximum_deviation);
  std::vector<Isoline> result;
  for(const auto& line : lines)
    result.push_back({line.level, path(line.locations), line.is_closed});
  return result;
}

Geodesics::Found Geodesics::find(const std::vector<Location>& points) const
{
  require_result();
  Found result;
  for(const Location& p : points)
  {
    result.distances.push_back(geodesics_.distance(p));
    result.nearest_sources.push_back(
      std::isfinite(result.distances.back()) ? static_cast<std::int64_t>(geodesics_.nearest_source(p)) : -1);
    if(has_directions_)
      for(double x : geodesics_.logarithmic_map(p))
        result.log_map.push_back(x);
  }
  return result;
}

Geodesic_path Geodesics::path_from(const Source& target) const
{
  require_result();
  std::vector<Location> locations;
  std::visit([&](const auto& point) { geodesics_.shortest_path(point, std::back_inserter(locations)); }, target);
  return path(locations);
}

Geodesic_path Geodesics::path_from_target(std::size_t i) const
{
  require_result();
  std::vector<Location> locations;
  geodesics_.shortest_path(Query{i}, std::back_inserter(locations));
  return path(locations);
}

Geodesic_path Geodesics::path(const std::vector<Location>& locations) const
{
  Geodesic_path result;
  for(const auto& [face, coordinates] : locations)
  {
    result.faces.push_back(face.idx());
    Mesh::Halfedge_index h = mesh_->halfedge(face);
    std::array<double, 3> p = {{0., 0., 0.}};
    for(double c : coordinates)
    {
      result.coordinates.push_back(c);
      for(int k = 0; k < 3; ++k)
        p[k] += c * mesh_->point(mesh_->source(h))[k];
      h = mesh_->next(h);
    }
    result.points.insert(result.points.end(), p.begin(), p.end());
  }
  return result;
}
