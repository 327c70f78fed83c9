// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_SESSION_H
#define SURFACE_MESH_CUT_LOCUS_WEB_SESSION_H

#include "atlas.h"
#include "cell_surface.h"
#include "fields.h"
#include "paths.h"
#include "solvers.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// What the page works with: one mesh, one solver on it, its sources, and the curves for the last thresholds.
class Session
{
public:
  enum Curve_index { MESH_EDGES, THROUGH_FACES };

  // A curve as the page draws it.
  struct Curve
  {
    std::vector<float> segments; // two points each
    std::vector<float> width;    // of each segment, as a part of the diagonal
    std::vector<float> gap;      // of each segment: the angle between its shortest paths
    std::vector<float> distance; // of each segment: of its middle to the nearest source
    std::vector<double> numbers; // see `statistics_of`
  };

  // The component of each face may be left out if there is one.
  void load(Mesh mesh, const std::vector<std::size_t>& component_of_face = {}, std::string repairs = {});
  void prepare(const std::string& solver, const std::string& method);
  // The points, and, if that is wished, each border loop of their component, or of the largest one that has a border.
  // Distances may be longer by `relative_error`, where solver and method can make use of that.
  void set_sources(const std::vector<Location>& points, bool with_border, double relative_error);
  void compute_curve(Curve_index index, const Thresholds& thresholds);
  const Cut_locus& result(Curve_index index) const { return *results_[index]; } // the last one
  double default_width() const; // what the mesh resolves, as a part of the diagonal; 0 if nothing depends on it
  void compute_laplacian();
  void compute_gradient();
  // Along one of the curves; if the border is a source, only the one through the faces is there.
  void cut_open(Curve_index index, const Thresholds& thresholds, bool by_logarithmic_map);
  // The surface in the cells of several sources, apart where one of the curves runs.
  void divide_into_cells(Curve_index index, const Thresholds& thresholds);
  void find_paths(const Location& end);
  std::string write_curve(Curve_index index, const std::string& format) const;

  std::vector<float> positions;         // of the vertices, moved and scaled to fill the unit ball
  std::vector<std::uint32_t> triangles; // in the order of barycentric coordinates
  std::vector<float> distance, laplacian, gradient;
  std::vector<std::uint32_t> component; // of each face
  std::vector<double> mesh_numbers;     // center (3), radius
  std::string repairs;                  // what has been done to the file to have a mesh, or nothing
  // farthest vertex (3), its distance, border loops, genus, default angle, width and gap, number of sources, then the
  // points among them (3 each)
  std::vector<double> source_numbers;
  std::vector<float> border_segments;        // of the border loops that are sources: two points each
  std::vector<std::uint32_t> nearest_source; // of each vertex; empty if there is one
  // shortest paths: the points of all of them, and for each how many it has, and its length
  std::vector<float> path_points;
  std::vector<double> path_numbers;
  Curve curves[2];
  Atlas atlas;
  Cell_surface cells;

private:
  void check(const Location& location) const;
  Cut_locus part_of_cut_locus(Curve_index index, Thresholds thresholds, Kept_part kept) const;
  void read_source(const Cut_locus& cut_locus);
  void append_point(const Kernel::Point_3& p, std::vector<float>& to) const;
  const Fields& fields();

  // The solver and the results refer to the mesh, which must not move.
  std::unique_ptr<Mesh> mesh_;
  Kernel::Point_3 center_;
  double radius_ = 1.;
  std::string solver_name_, method_name_;
  std::unique_ptr<Solver> solver_;
  std::unique_ptr<Fields> fields_;
  bool has_sources_ = false; // the solver has those below
  std::vector<Location> points_;
  std::vector<Edge_curve> curves_;
  std::unique_ptr<Paths> paths_;
  double diagonal_ = 1.; // of the bounding box of the source's component
  std::vector<double> exact_distance_;
  std::optional<Cut_locus> results_[2];
};

#endif // SURFACE_MESH_CUT_LOCUS_WEB_SESSION_H
