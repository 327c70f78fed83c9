// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_CUT_LOCUS_METHOD_H
#define CGAL_CUT_LOCI_CUT_LOCUS_METHOD_H

#include <limits>
#include <optional>
#include <variant>

namespace CGAL::Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the discretization of the Laplace-Beltrami operator
enum class Laplacian_operator {
  QUADRATIC_FIT, ///< from a quadric fitted to the extended neighborhood of each vertex \cgalCite{cgal:wylc-dlbod-13}
  COTANGENT      ///< the cotangent formula \cgalCite{cgal:pp-cdmsc-93} over a third of the area of the faces around
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// how a threshold on the strength of the vertices selects a part of the tree
enum class Filter_policy {
  PRUNING, ///< weak leaves are removed again and again: a branch stays up to its last strong vertex, and on to its tip
  GROWING  ///< the tree is followed from its root as long as the vertices are above the threshold
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the options that all methods have. Each function sets an option, and returns the method.
template <typename Method>
class Branch_options
{
public:
  constexpr explicit Branch_options(long edges) : edges_(edges) {}

  /// branches of fewer edges of the graph are removed: segments through the faces, or edges of the mesh, of which those count
  /// by which a branch leads away from the rest: what runs beside that for long is none. Where branches meet, the longest
  /// continues, and at the root and on cycles all of them end. By default 0, as branches are judged as a whole, and 3 with
  /// `Laplacian_method`, as in the paper. With that one they are always edges of the mesh; with the others, of sources that
  /// are curves, it is for `Curve::MESH_EDGES` only.
  Method& minimum_branch_edges(long number) { return set(edges_, number); }
  /// branches that are shorter are removed; in units of the diagonal of the bounding box of the source's component, 0 by
  /// default, and else as `minimum_branch_edges()`
  Method& minimum_branch_length(double length) { return set(length_, length); }

  long minimum_branch_edges() const { return edges_; }
  double minimum_branch_length() const { return length_; }

protected:
  template <typename T, typename Value>
  Method& set(T& option, const Value& value)
  {
    option = value;
    return static_cast<Method&>(*this);
  }

private:
  long edges_;
  double length_ = 0.;
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the options of the methods that know the shortest paths: how strong a branch must be
template <typename Method>
class Path_options : public Branch_options<Method>
{
public:
  constexpr Path_options() : Branch_options<Method>(0) {}

  /// the least value, over the points of a branch, of the largest separation of the two shortest paths to them: how large
  /// what the branch goes around is. In units of the diagonal of the bounding box of the source's component, and 1 at
  /// most, or, with an `edge_length_map`, of the square root of its area. All branches that pass it are kept; by default,
  /// low ones are left out where they meet others. The default is 0 with `Polyhedral_method` and with a
  /// `minimum_branch_gap()`; else `Surface_mesh_cut_locus::minimum_branch_width()`, about three edges on a smooth mesh, or a
  /// quarter of that where the two paths enclose more curvature than the mesh and its noise do, as in a limb or a corner.
  Method& minimum_branch_width(double width) { return this->set(width_, width); }
  /// the curvature that the two shortest paths to the points of a branch have to enclose, on both sides, for the branch to
  /// be kept at a quarter of the width: in radians in [0, 4 pi]; a limb encloses almost 2 pi, the corner of a box pi / 2.
  /// By default `Surface_mesh_cut_locus::minimum_branch_curvature()`; if there is a width or a gap, these alone count.
  Method& minimum_branch_curvature(double curvature) { return this->set(curvature_, curvature); }
  /// the least angle at the source, or where they part, between the two shortest paths to the points of a branch, in radians
  /// in [0, pi]; it grows from the tips of branches inward. By default 0. With a width, too, a branch must pass both.
  Method& minimum_branch_gap(double gap) { return this->set(gap_, gap); }

  std::optional<double> minimum_branch_width() const { return width_; }
  std::optional<double> minimum_branch_curvature() const { return curvature_; }
  std::optional<double> minimum_branch_gap() const { return gap_; }

  using Branch_options<Method>::minimum_branch_edges;
  using Branch_options<Method>::minimum_branch_length;

private:
  std::optional<double> width_, curvature_, gap_;
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the cut locus of the polyhedron without the branches that come from the mesh or from noise: where shortest paths meet that
/// leave the source in different directions, with any mesh, also with a border. It needs the package's own exact
/// distances, and is the default with them.
class Default_method : public Path_options<Default_method>
{
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the same with all branches: the cut locus of the polyhedron itself, of which every vertex of positive curvature is a part. It
/// is exact up to rounding, but where shortest paths are equally long by symmetry and bend, as in machine parts: there
/// it is that of a surface whose lengths differ by some millionths of them.
class Polyhedral_method : public Path_options<Polyhedral_method>
{
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// where the Laplacian of the distance is low and gradients turn, as Mancinelli, Livesu and Puppo find it
/// \cgalCite{cgal:mlp-pccld-21}: takes any distances, also smoothed ones, and is the default with all but the package's own.
/// It is compiled where `CGAL/Cut_loci/Laplacian_method.h` is included, as the headers of solvers do that have no other one.
class Laplacian_method : public Branch_options<Laplacian_method>
{
public:
  constexpr Laplacian_method() : Branch_options(3) {}

  /// by default `Laplacian_operator::QUADRATIC_FIT`. The constructor of `Surface_mesh_cut_locus` takes it, and
  /// `Surface_mesh_cut_locus::cut_locus()` no other one.
  Laplacian_method& laplacian_operator(Laplacian_operator type) { return set(operator_, type); }
  /// the angle at which shortest paths must meet, in radians in [0, pi]; a larger one removes weaker branches
  Laplacian_method& gradient_angle_threshold(double angle) { return set(angle_, angle); }
  /// the least value of minus the Laplacian of the distance, times the mean edge length; by default minus infinity. A branch
  /// must pass both thresholds.
  Laplacian_method& laplacian_threshold(double value) { return set(laplacian_, value); }
  /// whether weak branches are pruned from the leaves, as by default, or the tree is grown from the root
  Laplacian_method& filter_policy(Filter_policy policy) { return set(policy_, policy); }
  /// the number of steps, at least one, that move a curve from the edges of the mesh onto the cut locus, through the faces.
  /// Each leaves half of the way that the one before has left; 4, the default, are enough.
  Laplacian_method& number_of_iterations(long number) { return set(iterations_, number); }

  std::optional<Laplacian_operator> laplacian_operator() const { return operator_; }
  double gradient_angle_threshold() const { return angle_; }
  double laplacian_threshold() const { return laplacian_; }
  Filter_policy filter_policy() const { return policy_; }
  long number_of_iterations() const { return iterations_; }

private:
  std::optional<Laplacian_operator> operator_;
  // Around the end of a branch, gradients are focused before they cross: a few edges beyond the end they still meet at half
  // a radian. On tori of 7 K to 113 K faces thresholds from 0.5 to 1 put the ends within 2.5 edges.
  double angle_ = 0.7;
  double laplacian_ = -(std::numeric_limits<double>::infinity)();
  Filter_policy policy_ = Filter_policy::PRUNING;
  long iterations_ = 4;
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// a method that is chosen while the program runs. The parameter `cut_locus_method` takes it, too.
using Method = std::variant<Default_method, Polyhedral_method, Laplacian_method>;

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the name of a method, as in `cut_locus_method(Cut_loci::Laplacian_method())`
inline const char* name_of(const Method& method)
{
  constexpr const char* names[] = {"Cut_loci::Default_method", "Cut_loci::Polyhedral_method",
                                   "Cut_loci::Laplacian_method"};
  return names[method.index()];
}

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the curve that represents the cut locus
enum class Curve {
  MESH_EDGES,   ///< edges of the mesh
  THROUGH_FACES ///< segments in the faces, between points that shortest paths reach from both sides
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the part of the cut locus of several sources that is kept
enum class Kept_part {
  ALL,     ///< the geodesic Voronoi diagram, together with the cut locus inside each cell
  VORONOI, ///< the edges between two sources: without the rest, the graph need not be connected, nor a cell a disk. Of one
           ///< source, one vertex is left
  MEDIAL ///< what is inside the cells
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_CUT_LOCUS_METHOD_H
