// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_EXACT_TREE_SOLVER_H
#define CGAL_CUT_LOCI_EXACT_TREE_EXACT_TREE_SOLVER_H

#include <CGAL/Cut_loci/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/exact_tree/Exact_tree.h>
#include <CGAL/Cut_loci/exact_tree/Tree_curve.h>
#include <CGAL/Cut_loci/internal/Component_solver.h>
#include <CGAL/Cut_loci/internal/Exact_geodesic_propagation.h>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

struct Exact_tree_thresholds
{
  double gap = 0.;   // radians
  double width = 0.; // a length
};

// The cut locus of the polyhedron, all of it or pruned, on one connected component.
class Exact_tree_solver
{
public:
  // once per mesh
  explicit Exact_tree_solver(const Indexed_triangle_mesh& mesh)
    : mesh_(mesh), connectivity_(mesh), geodesics_(Component_solver::checked(mesh, connectivity_))
  {
  }

  [[noreturn]] static void refuse_distances()
  {
    throw Invalid_input(
      "the method Cut_loci::Method::POLYHEDRAL needs the paths of the package's own exact solver, and "
      "not distances alone: leave geodesic_solver and vertex_distance_map away, or pass another "
      "cut_locus_method()");
  }

  // once per source, in four parts
  void compute_distance(const Indexed_source& source)
  {
    source_ = source;
    start(source.location);
    distance_ = geodesics_.distances();
    find_farthest();
  }

  void compute_strengths() { tree_->draw_ridges(); }

  /*
   * Where several shortest paths lead to a vertex at which they bend, all points behind it have several, and where such
   * paths run along edges of the mesh, it takes no more than rounding to choose other ones in neighboring faces. Both
   * need a symmetric placement of the source. Then it is moved: by far less than the accuracy of any mesh, and far more
   * than that of the windows.
   */
  void grow_tree()
  {
    tree_->join();
    for(int number = 1; number <= 2 && !tree_->is_sure(); ++number)
    {
      start(moved_source(number));
      tree_->draw_ridges();
      tree_->join();
      tree_->remove_branch_to(source_.vertex);
    }
  }

  void close_cycles() { tree_->order_branches(); }

  // once per threshold
  Indexed_cut_locus filter(const Exact_tree_thresholds& thresholds)
  {
    const std::vector<Tree_branches::Edge> kept = tree_->kept(thresholds.gap, thresholds.width);
    return Tree_curve(mesh_, connectivity_, geodesics_, *tree_)(kept, farthest_);
  }

  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Exact_geodesic_propagation& geodesics() const { return geodesics_; }
  Exact_tree& tree() { return *tree_; }
  const std::vector<double>& distance() const { return distance_; }
  Index farthest() const { return farthest_; }
  Index genus() const { return connectivity_.genus(mesh_); }
  // the farthest vertex: on a closed surface it is on the cut locus
  Index root() const { return farthest_; }

private:
  void start(const Indexed_location& location)
  {
    tree_.reset(new Exact_tree(mesh_, connectivity_, geodesics_));
    tree_->propagate(location);
    for(double d : geodesics_.distances())
      if(!(d < (std::numeric_limits<double>::infinity)()))
        throw Invalid_input("the exact solver does not reach all vertices: some faces may be too thin for it");
  }

  // the source in the interior of its face, 1e-6 of it away, in a direction without any symmetry
  Indexed_location moved_source(int number) const
  {
    constexpr std::array<double, 3> part = {{0.2113, 0.3301, 0.4586}};
    Indexed_location result = source_.location;
    for(std::size_t i = 0; i < 3; ++i)
      result.coordinates[i] = (1. - 1e-6 * number) * result.coordinates[i] + 1e-6 * number * part[i];
    return result;
  }

  void find_farthest()
  {
    farthest_ = source_.vertex == 0 ? 1 : 0;
    for(Index v = farthest_ + 1; v < distance_.size(); ++v) // the source is not it even if all distances are equal
      if(v != source_.vertex && distance_[v] > distance_[farthest_])
        farthest_ = v;
  }

  const Indexed_triangle_mesh& mesh_;
  Mesh_connectivity connectivity_;
  Exact_geodesic_propagation geodesics_;

  Indexed_source source_;
  std::vector<double> distance_;
  Index farthest_ = null_index;
  std::unique_ptr<Exact_tree> tree_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_EXACT_TREE_SOLVER_H
