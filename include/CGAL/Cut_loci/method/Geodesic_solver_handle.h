// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_GEODESIC_SOLVER_HANDLE_H
#define CGAL_CUT_LOCI_METHOD_GEODESIC_SOLVER_HANDLE_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Holds a model of GeodesicSolver of any type.
class Geodesic_solver_handle
{
public:
  Geodesic_solver_handle() = default;

  template <typename Solver>
  explicit Geodesic_solver_handle(const Solver& solver)
    : model_(new Model<Solver>(solver)), method_(own_method<Solver>(0)), is_approximate_(own_approximation<Solver>(0))
  {
  }

  Geodesic_solver_handle(Geodesic_solver_handle&&) = default;
  Geodesic_solver_handle& operator=(Geodesic_solver_handle&&) = default;
  Geodesic_solver_handle(const Geodesic_solver_handle& other)
    : model_(other.model_ ? other.model_->copy() : nullptr), mesh_(other.mesh_), method_(other.method_),
      is_approximate_(other.is_approximate_)
  {
  }

  bool empty() const { return !model_; }

  // the method for distances of this solver
  Method cut_locus_method() const { return method_; }

  // whether the solver says that its distances are
  bool is_approximate() const { return is_approximate_; }

  // a solver of the same kind for another mesh, which must stay where it is; the progress is that of distances
  Geodesic_solver_handle bound_to(const Indexed_triangle_mesh& mesh, const Progress& progress) const
  {
    Geodesic_solver_handle result;
    result.mesh_ = &mesh;
    result.model_ = model_->copy();
    result.model_->report_to(progress);
    result.model_->set_mesh(mesh);
    return result;
  }

  // To the nearest source. Solvers that take no curves are given all vertices of these. `nearest` becomes which of several
  // points that is, for each vertex, if the solver tells, as those do that take one source at a time; else it is empty.
  void compute_distances(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves,
                         std::vector<double>& distances, std::vector<Index>& nearest)
  {
    nearest.clear();
    if(curves.empty())
      model_->compute_distances(points, distances, nearest);
    else if(std::vector<Index> vertices; !model_->compute_distances(points, curves, distances))
      model_->compute_distances(with_vertices(points, curves), distances, vertices);
  }

  // of the distances that follow; returns whether the solver knows such an error
  bool set_maximum_relative_error(double error) { return model_->set_maximum_relative_error(error); }

  // is told the share of the next distances that is done, if the solver knows it
  void report_to(const Progress& progress) { model_->report_to(progress); }

private:
  struct Concept
  {
    virtual ~Concept() = default;
    virtual std::unique_ptr<Concept> copy() const = 0;
    virtual void set_mesh(const Indexed_triangle_mesh& mesh) = 0;
    virtual void compute_distances(const std::vector<Indexed_source>& sources, std::vector<double>& distances,
                                   std::vector<Index>& nearest) = 0;
    // whether it takes curves
    virtual bool compute_distances(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves,
                                   std::vector<double>& distances) = 0;
    virtual bool set_maximum_relative_error(double error) = 0;
    virtual void report_to(const Progress& progress) = 0;
  };

  template <typename Solver, typename = void>
  struct Is_solver : std::false_type
  {
  };
  template <typename Solver>
  struct Is_solver<Solver,
                   std::void_t<decltype(std::declval<Solver&>().set_mesh(std::declval<const Indexed_triangle_mesh&>())),
                               decltype(std::declval<Solver&>().compute_distances(
                                 std::declval<const Indexed_source&>(), std::declval<std::vector<double>&>()))>>
    : std::true_type
  {
  };

  template <typename Solver>
  struct Model : public Concept
  {
    static_assert(Is_solver<Solver>::value,
                  "geodesic_solver takes a model of GeodesicSolver: an object with set_mesh() "
                  "and compute_distances()");
    explicit Model(const Solver& s) : solver(s) {}
    std::unique_ptr<Concept> copy() const override { return std::unique_ptr<Concept>(new Model(solver)); }
    void set_mesh(const Indexed_triangle_mesh& mesh) override { solver.set_mesh(mesh); }
    void compute_distances(const std::vector<Indexed_source>& sources, std::vector<double>& distances,
                           std::vector<Index>& nearest) override
    {
      if(sources.size() > 1)
        compute_own_distances(solver, sources, distances, nearest, 0);
      else
        solver.compute_distances(sources.front(), distances);
    }
    bool compute_distances(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves,
                           std::vector<double>& distances) override
    {
      return compute_own_distances(solver, points, curves, distances, 0);
    }
    bool set_maximum_relative_error(double error) override { return set_own_error(solver, error, 0); }
    void report_to(const Progress& progress) override { set_own_progress(solver, progress, 0); }
    Solver solver;
  };

  template <typename Solver>
  static auto compute_own_distances(Solver& solver, const std::vector<Indexed_source>& sources,
                                    std::vector<double>& distances, std::vector<Index>& nearest, int)
    -> decltype(solver.compute_distances(sources, distances), void()) // if it takes several
  {
    solver.compute_distances(sources, distances);
    set_own_nearest_sources(solver, nearest, 0);
  }
  template <typename Solver>
  static void compute_own_distances(Solver& solver, const std::vector<Indexed_source>& sources,
                                    std::vector<double>& distances, std::vector<Index>& nearest, long)
  {
    std::vector<double> to_one;
    for(std::size_t i = 0; i < sources.size(); ++i)
    {
      solver.compute_distances(sources[i], to_one);
      if(i == 0 || to_one.size() != distances.size()) // the latter is an error, which is seen by the last size
      {
        distances = to_one;
        nearest.assign(distances.size(), static_cast<Index>(i));
      }
      for(std::size_t v = 0; v < to_one.size(); ++v)
        if(to_one[v] < distances[v] || std::isnan(to_one[v]))
        {
          distances[v] = to_one[v];
          nearest[v] = static_cast<Index>(i);
        }
    }
  }

  template <typename Solver>
  static auto compute_own_distances(Solver& solver, const std::vector<Indexed_source>& points,
                                    const std::vector<Indexed_curve>& curves, std::vector<double>& distances, int)
    -> decltype(solver.compute_distances(points, curves, distances), bool()) // if it takes curves
  {
    solver.compute_distances(points, curves, distances);
    return true;
  }
  template <typename Solver>
  static bool compute_own_distances(Solver&, const std::vector<Indexed_source>&, const std::vector<Indexed_curve>&,
                                    std::vector<double>&, long)
  {
    return false;
  }

  // the points, and each vertex of a curve once
  std::vector<Indexed_source> with_vertices(std::vector<Indexed_source> points,
                                            const std::vector<Indexed_curve>& curves) const
  {
    std::vector<unsigned char> is_taken(mesh_->number_of_vertices(), 0);
    for(const Indexed_curve& curve : curves)
      for(Index h : curve.halfedges)
        for(Index end : {h, Indexed_triangle_mesh::next(h)})
          if(!is_taken[mesh_->source(end)])
          {
            is_taken[mesh_->source(end)] = 1;
            points.push_back({location_on(end), mesh_->source(end)});
          }
    return points;
  }

  template <typename Solver>
  static auto own_method(int) -> decltype(Method(Solver::cut_locus_method())) // if it has that
  {
    return Solver::cut_locus_method();
  }
  template <typename Solver>
  static Method own_method(long)
  {
    return Method::LAPLACIAN;
  } // takes any distances

  template <typename Solver>
  static auto own_approximation(int) -> decltype(bool(Solver::is_approximate())) // if it has that
  {
    return Solver::is_approximate();
  }
  template <typename Solver>
  static bool own_approximation(long)
  {
    return false;
  }

  template <typename Solver>
  static auto set_own_error(Solver& solver, double error, int)
    -> decltype(solver.set_maximum_relative_error(error), bool()) // if it has that
  {
    solver.set_maximum_relative_error(error);
    return true;
  }
  template <typename Solver>
  static bool set_own_error(Solver&, double, long)
  {
    return false;
  }

  template <typename Solver>
  static auto set_own_progress(Solver& solver, const Progress& progress, int)
    -> decltype(solver.report_to(progress)) // if it has that
  {
    solver.report_to(progress);
  }
  template <typename Solver>
  static void set_own_progress(Solver&, const Progress&, long)
  {
  }

  template <typename Solver>
  static auto set_own_nearest_sources(const Solver& solver, std::vector<Index>& nearest, int)
    -> decltype(nearest = solver.nearest_sources(), void()) // if it has them
  {
    nearest = solver.nearest_sources();
  }
  template <typename Solver>
  static void set_own_nearest_sources(const Solver&, std::vector<Index>&, long)
  {
  }

  std::unique_ptr<Concept> model_;
  const Indexed_triangle_mesh* mesh_ = nullptr; // if it is bound to one
  Method method_ = Method::LAPLACIAN;
  bool is_approximate_ = false;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_METHOD_GEODESIC_SOLVER_HANDLE_H
