// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_GEODESICS_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_GEODESICS_H

#include "Input.h"

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

// From its end to the source; no points if there is no path.
struct Geodesic_path
{
  std::vector<std::int64_t> faces;
  std::vector<double> coordinates, points; // three for each face
};

// Exact geodesics on a mesh that it keeps.
class Geodesics
{
public:
  // With a flag for each face that no path may cross, or none at all.
  Geodesics(std::shared_ptr<const Mesh> mesh, const std::vector<bool>& excluded);

  struct Sources
  {
    std::vector<Source> points;
    std::vector<Source_curve> curves;
    bool border;
  };
  struct Wishes
  {
    double error, maximum_distance;
    bool directions, isolines;
  };
  void compute(const Sources& sources, const std::vector<Location>& targets, const Wishes& wishes);

  // By vertex. They throw std::logic_error if nothing has been computed.
  std::vector<double> distances() const;
  std::vector<double> errors() const;
  std::vector<std::int64_t> nearest_sources() const; // -1 where no path leads
  std::vector<double> target_distances() const;      // of the locations
  std::vector<std::int64_t> target_nearest_sources() const;
  std::vector<double> log_map() const; // two coordinates by vertex
  std::vector<double> target_log_map() const;

  // Of points that need not have been targets; coordinates if directions have been wished for.
  struct Found
  {
    std::vector<double> distances;
    std::vector<std::int64_t> nearest_sources;
    std::vector<double> log_map;
  };
  Found find(const std::vector<Location>& points) const;
  std::vector<double>
  arrival_directions() const; // three coordinates by vertex; NaN for sources, and what is not reached
  std::vector<std::int64_t> source_axes() const; // by source, the two vertices of an edge along which its x-axis runs

  // From source number `source` on; two coordinates for each place. They throw Invalid_input if there is no such source.
  Geodesic_path exponential_map(const std::vector<double>& places, std::size_t source) const;

  struct Isoline
  {
    double level;
    Geodesic_path path;
    bool is_closed;
  };
  std::vector<Isoline> isolines(const std::vector<double>& levels, std::optional<double> maximum_deviation) const;

  Geodesic_path path_from(const Source& target) const;
  Geodesic_path path_from_target(std::size_t i) const;

  const Mesh& mesh() const { return *mesh_; }

private:
  void require_result() const;
  Geodesic_path path(const std::vector<Location>& locations) const;

  using Query = CGAL::Surface_mesh_exact_geodesics<Mesh>::Query;

  std::shared_ptr<const Mesh> mesh_;
  CGAL::Surface_mesh_exact_geodesics<Mesh> geodesics_;
  std::size_t number_of_targets_ = 0;
  bool has_result_ = false, has_directions_ = false;
};

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_GEODESICS_H
