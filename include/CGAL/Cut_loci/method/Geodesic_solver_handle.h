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

// Calls a function that asks of a model of a concept what it need not have, by `-> decltype(model.function())`. Returns
// whether the model has it.
template <typename Model, typename Function>
constexpr bool call_if_there(Model& model, const Function& function)
{
  constexpr bool is_there = std::is_invocable<const Function&, Model&>::value;
  if constexpr(is_there)
    function(model);
  return is_there;
}

// Holds a model of GeodesicSolver of any type.
class Geodesic_solver_handle
{
public:
  Geodesic_solver_handle() = default;

  template <typename Solver>
  explicit Geodesic_solver_handle(const Solver& solver) : model_(new Model<Solver>(solver))
  {
    call_if_there(solver,
                  [&](const auto& s) -> decltype(void(s.cut_locus_method())) { method_ = s.cut_locus_method(); });
    call_if_there(solver,
                  [&](const auto& s) -> decltype(void(s.is_approximate())) { is_approximate_ = s.is_approximate(); });
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
  const Method& cut_locus_method() const { return method_; }

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

  static constexpr auto use =
    [](auto& solver, const Indexed_triangle_mesh& mesh, const Indexed_source& source,
       std::vector<double>& distances) -> decltype(solver.set_mesh(mesh),
                                                   void(solver.compute_distances(source, distances))) {};

  template <typename Solver>
  struct Model : public Concept
  {
    static_assert(std::is_invocable<decltype(use), Solver&, const Indexed_triangle_mesh&, const Indexed_source&,
                                    std::vector<double>&>::value,
                  "geodesic_solver takes a model of GeodesicSolver: an object with set_mesh() "
                  "and compute_distances()");
    explicit Model(const Solver& s) : solver(s) {}
    std::unique_ptr<Concept> copy() const override { return std::unique_ptr<Concept>(new Model(solver)); }
    void set_mesh(const Indexed_triangle_mesh& mesh) override { solver.set_mesh(mesh); }
    void compute_distances(const std::vector<Indexed_source>& sources, std::vector<double>& distances,
                           std::vector<Index>& nearest) override
    {
      if(sources.size() == 1)
        solver.compute_distances(sources.front(), distances);
      else if(call_if_there(solver,
                            [&](auto& s) -> decltype(void(s.compute_distances(sources, distances)))
                            { s.compute_distances(sources, distances); }))
        call_if_there(solver,
                      [&](auto& s) -> decltype(void(nearest = s.nearest_sources())) { nearest = s.nearest_sources(); });
      else
        compute_one_by_one(sources, distances, nearest);
    }
    bool compute_distances(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves,
                           std::vector<double>& distances) override
    {
      return call_if_there(solver,
                           [&](auto& s) -> decltype(void(s.compute_distances(points, curves, distances)))
                           { s.compute_distances(points, curves, distances); });
    }
    bool set_maximum_relative_error(double error) override
    {
      return call_if_there(solver,
                           [&](auto& s) -> decltype(void(s.set_maximum_relative_error(error)))
                           { s.set_maximum_relative_error(error); });
    }
    void report_to(const Progress& progress) override
    {
      call_if_there(solver, [&](auto& s) -> decltype(void(s.report_to(progress))) { s.report_to(progress); });
    }
    void compute_one_by_one(const std::vector<Indexed_source>& sources, std::vector<double>& distances,
                            std::vector<Index>& nearest)
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
    Solver solver;
  };

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

  std::unique_ptr<Concept> model_;
  const Indexed_triangle_mesh* mesh_ = nullptr; // if it is bound to one
  Method method_ = Laplacian_method();          // which takes any distances, unless the solver names another one
  bool is_approximate_ = false;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_METHOD_GEODESIC_SOLVER_HANDLE_H
