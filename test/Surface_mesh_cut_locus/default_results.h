// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TEST_DEFAULT_RESULTS_H
#define CGAL_CUT_LOCI_TEST_DEFAULT_RESULTS_H

#include "checked_curves.h"
#include "surface_test.h"

#include <CGAL/Cut_loci/polyhedral/solver/Exact_tree_solver.h>

// Cut loci on dense arrays from the exact distances, and what must hold for every result.
namespace default_test {

using namespace surface_test;
using CGAL::Cut_loci::internal::Branch_strength;
using CGAL::Cut_loci::internal::Exact_tree_solver;
using CGAL::Cut_loci::internal::position;
using checked_curves::expect_disk;

inline std::vector<Index> leaves(const Indexed_cut_locus& graph)
{
  std::vector<int> degree(graph.nodes.size(), 0);
  for(const auto& e : graph.edges)
  {
    ++degree[e.source];
    ++degree[e.target];
  }
  std::vector<Index> result;
  for(Index i = 0; i < degree.size(); ++i)
    if(degree[i] == 1)
      result.push_back(i);
  return result;
}

// a point in a face at random
inline Indexed_location random_location(const Indexed_triangle_mesh& mesh, std::mt19937& generator)
{
  std::uniform_real_distribution<double> uniform(0.05, 1.);
  Indexed_location result;
  result.face = static_cast<Index>(generator() % mesh.number_of_faces());
  result.coordinates = {{uniform(generator), uniform(generator), uniform(generator)}};
  const double sum = result.coordinates[0] + result.coordinates[1] + result.coordinates[2];
  for(double& c : result.coordinates)
    c /= sum;
  return result;
}

struct Solved
{
  using Thresholds = CGAL::Cut_loci::internal::Exact_tree_thresholds;

  Indexed_triangle_mesh mesh;
  std::unique_ptr<Exact_tree_solver> solver;

  /// `error`: the maximum relative error of the distances
  Solved(const Indexed_triangle_mesh& m, const Indexed_source& source, double error = 0.)
    : Solved(m, source, Exact_tree_solver(m).default_thresholds(), error)
  {
  }

  // looks for what is that strong alone
  Solved(const Indexed_triangle_mesh& m, const Indexed_source& source, const Branch_strength& least, double error = 0.)
    : mesh(m), solver(new Exact_tree_solver(mesh))
  {
    solver->expect(least);
    solver->set_maximum_relative_error(error);
    solve(source);
  }

  void solve(const Indexed_source& source)
  {
    solver->compute_distance(source);
    solver->compute_strengths();
    solver->grow_tree();
    solver->close_cycles();
  }

  Indexed_cut_locus curve(const Thresholds& thresholds, Curve kind) const { return solver->filter(thresholds, kind); }
  Indexed_cut_locus all() const { return curve({}, Curve::THROUGH_FACES); }
  Indexed_cut_locus mesh_edges() const { return curve(solver->default_thresholds(), Curve::MESH_EDGES); }
  Indexed_cut_locus through_faces() const { return curve(solver->default_thresholds(), Curve::THROUGH_FACES); }
};

using Segment = std::array<CGAL::Cut_loci::internal::Vector, 2>;
using Segments = std::vector<Segment>;

inline Segments segments(const Indexed_triangle_mesh& mesh, const Indexed_cut_locus& curve)
{
  Segments result;
  for(const Indexed_cut_locus::Edge& e : curve.edges)
    result.push_back(
      {{position(mesh, curve.nodes[e.source].location), position(mesh, curve.nodes[e.target].location)}});
  return result;
}

inline double distance(const CGAL::Cut_loci::internal::Vector& p, const Segment& segment)
{
  const auto along = segment[1] - segment[0], to_p = p - segment[0];
  const double square = dot(along, along), s = square > 0. ? dot(along, to_p) / square : 0.;
  return norm(to_p - (std::max)(0., (std::min)(s, 1.)) * along);
}

// the largest distance of an end or a middle in one from the other
inline double farthest(const Segments& from, const Segments& to)
{
  double result = 0.;
  for(const Segment& s : from)
    for(const auto& p : {s[0], s[1], 0.5 * (s[0] + s[1])})
    {
      double least = (std::numeric_limits<double>::infinity)();
      for(const Segment& t : to)
        least = (std::min)(least, distance(p, t));
      result = (std::max)(result, least);
    }
  return result;
}

inline double distance(const Segments& a, const Segments& b)
{
  return (std::max)(farthest(a, b), farthest(b, a));
}

// of a width in mean edge lengths
inline Solved::Thresholds at_least(double width, const Solved& solved)
{
  Solved::Thresholds result;
  result.width = width * solved.solver->connectivity().mean_edge_length;
  return result;
}

// connected, with two cycles for each handle: what is wrong first is that all else is no disk
inline void expect_cycles(const Indexed_triangle_mesh& mesh, const Indexed_cut_locus& curve)
{
  const std::string fault = curve_measures::internal::Curve_topology(mesh, curve).fault();
  EXPECT_TRUE(fault.empty() || fault.find("no disk") != std::string::npos || fault == "the curve crosses itself")
    << fault;
}

// what must hold at any threshold
inline void expect_invariants(const Indexed_triangle_mesh& mesh, const Indexed_source& source, const std::string& name,
                              double error = 0.)
{
  const Solved solved(mesh, source, error);
  for(const Solved::Thresholds& thresholds : {solved.solver->default_thresholds(), at_least(1e9, solved),
                                              at_least(5., solved), at_least(0.5, solved), at_least(0., solved)})
  {
    if(error > 0. && thresholds.is_none())
      continue; // needs exact distances
    SCOPED_TRACE(name + ", width " + std::to_string(thresholds.width) + ", gap " + std::to_string(thresholds.gap));
    const Indexed_cut_locus edges = solved.curve(thresholds, Curve::MESH_EDGES),
                            curve = solved.curve(thresholds, Curve::THROUGH_FACES);
    ASSERT_FALSE(edges.nodes.empty());
    ASSERT_FALSE(curve.nodes.empty());
    expect_disk(mesh, edges);
    // where distances are inexact, branches narrower than a face may meet in another order
    if(error > 0. && thresholds.width < solved.solver->connectivity().mean_edge_length)
      expect_cycles(mesh, curve);
    else
      expect_disk(mesh, curve);
    for(const auto& e : edges.edges)
    {
      ASSERT_NE(e.halfedge, null_index);
      const std::set<Index> ends = {edges.nodes[e.source].vertex, edges.nodes[e.target].vertex};
      EXPECT_EQ(ends, (std::set<Index>{mesh.source(e.halfedge), mesh.target(e.halfedge)}));
    }
    for(const auto& node : edges.nodes)
      EXPECT_NE(node.vertex, source.vertex == null_index ? null_index - 1 : source.vertex);
    for(const auto& node : curve.nodes)
    {
      double sum = 0.;
      for(double x : node.location.coordinates)
      {
        EXPECT_GE(x, 0.);
        sum += x;
      }
      EXPECT_NEAR(sum, 1., 1e-9);
      EXPECT_GT(node.distance, 0.);
    }
    for(const auto& e : curve.edges)
      EXPECT_NE(e.source, e.target);
  }
}

} // namespace default_test

#endif // CGAL_CUT_LOCI_TEST_DEFAULT_RESULTS_H
