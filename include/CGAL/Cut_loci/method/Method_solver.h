// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_METHOD_SOLVER_H
#define CGAL_CUT_LOCI_METHOD_METHOD_SOLVER_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <memory>
#include <vector>

namespace CGAL::Cut_loci::internal {

class Divided_mesh;

// What a method does on one connected component, on dense indices. The mesh is read by the constructor; the functions
// are called in this order, those of a stage once per source.
class Method_solver
{
public:
  virtual ~Method_solver() = default;

  // is told the share of the next stage that is done; what it throws leaves the solver for the next source
  virtual void report_to(const Progress& progress) = 0;
  virtual void compute_strengths() = 0;
  virtual void grow_tree() = 0;
  virtual void close_cycles() = 0;

  virtual const std::vector<double>& distance() const = 0;
  virtual Index farthest() const = 0;
  virtual Index genus() const = 0;
  virtual Index number_of_border_loops() const = 0;
  // no point that is nearer has several shortest paths, however weak the branch; 0 if that is not known
  virtual double least_distance() const { return 0.; }
  // the number of the nearest source of each vertex; empty if there is one source
  virtual std::vector<Index> nearest_sources() const { return {}; }
};

// for `Cut_loci::Laplacian_method`
class Laplacian_stages : public Method_solver
{
public:
  // another one for the same mesh, which shares what depends on it alone, also in another thread
  virtual std::unique_ptr<Laplacian_stages> for_other_sources() const = 0;
  // the mesh with long edges divided, its further vertices last; null if there are none; `distance` may have these
  virtual const Divided_mesh* divided() const { return nullptr; }
  // comes first; `distance` is that to the nearest source, of which the points come first, and `nearest` which that is
  // for each vertex; empty if it has to be found. Straightened lengths of ways take the place of approximate distances.
  virtual void set_distance(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves,
                            std::vector<double> distance, std::vector<Index> nearest, bool is_approximate) = 0;
  // the result is made of edges of the mesh if there are no iterations of smoothing
  virtual Indexed_cut_locus filter(const Branch_thresholds& thresholds, const Smoothing_parameters& smoothing,
                                   Kept_part part) = 0;
};

// for the others
class Exact_tree_method : public Method_solver
{
public:
  // another one for the same mesh, which shares what depends on it alone, also in another thread
  virtual std::unique_ptr<Exact_tree_method> for_other_sources() const = 0;
  // of the sources that follow; comes first, as the default depends on them
  virtual void set_curves(const std::vector<Indexed_curve>& curves) = 0;
  // for the cut locus of the surface that the polyhedron stands for
  virtual const Exact_tree_thresholds& default_thresholds() const = 0;
  // What does not pass may be left out; `filter()` computes it if it is asked for.
  virtual void expect(const Branch_strength& least) = 0;
  // of the distances of the sources that follow
  virtual void set_maximum_relative_error(double error) = 0;
  // comes first, or, of the sources, after `expect()`; several sources, of which the points come first, have no point in
  // common
  virtual void compute_distance(const std::vector<Indexed_source>& points,
                                const std::vector<Indexed_curve>& curves) = 0;
  virtual Indexed_cut_locus filter(const Exact_tree_thresholds& thresholds, Curve curve) = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_METHOD_METHOD_SOLVER_H
