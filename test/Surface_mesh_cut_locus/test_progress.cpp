// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// A visitor is told how far a stage is, and what it throws there leaves the computation, not the object.

#include "surface_test.h"
#include "canceling_visitor.h"
#include "result_numbers.h"

#include <CGAL/Cut_loci/Default_visitor.h>

namespace test_progress {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::Stage;

struct Recording_visitor : public CGAL::Cut_loci::Default_visitor
{
  std::map<Stage, std::vector<double>> shares; // of the last run of each stage
  std::vector<Stage> open;

  void start_stage(Stage stage)
  {
    shares[stage].clear();
    open.push_back(stage);
  }
  void end_stage(Stage) { open.pop_back(); }
  void progress(Stage stage, double share)
  {
    EXPECT_FALSE(open.empty() || open.back() != stage);
    shares[stage].push_back(share);
  }
};

class Progress_of_stages : public testing::Test
{
protected:
  const Built built{torus(1., 0.4, 120, 48, 0.2, 1)};
  const Mesh::Vertex_index source = built.vertices[7], other = built.vertices[5000];
};

TEST_F(Progress_of_stages, It_grows_from_zero_to_one)
{
  for(Method method : {Method(Default_method()), Method(Polyhedral_method()), Method(Laplacian_method())})
  {
    Recording_visitor visitor;
    Solver solver(built.mesh, by(method).visitor(std::ref(visitor)));
    solver.set_source(source);
    EXPECT_GE(visitor.shares[Stage::DISTANCE].size(), 4u);
    EXPECT_LT(visitor.shares[Stage::DISTANCE].front(), 0.1);
    EXPECT_GT(visitor.shares[Stage::DISTANCE].back(), 0.9);
    for(Stage stage : {Stage::PREPROCESSING, Stage::STRENGTH, Stage::TREE})
      EXPECT_FALSE(visitor.shares[stage].empty());
    EXPECT_EQ(visitor.shares[Stage::HOMOLOGY].empty(), !std::holds_alternative<Laplacian_method>(method));
    solver.cut_locus(through_faces);
    EXPECT_FALSE(visitor.shares[Stage::FILTER].empty());
    for(const auto& [stage, shares] : visitor.shares)
      for(std::size_t i = 0; i < shares.size(); ++i)
      {
        EXPECT_GE(shares[i], i == 0 ? 0. : shares[i - 1]);
        EXPECT_LE(shares[i], 1.);
      }
  }
}

TEST_F(Progress_of_stages, What_is_thrown_leaves_no_source_and_an_object_that_can_be_used)
{
  for(Method method : {Method(Default_method()), Method(Polyhedral_method()), Method(Laplacian_method())})
  {
    Solver untouched(built.mesh, by(method));
    untouched.set_source(source);
    const std::vector<double> expected = result_numbers(untouched.cut_locus());
    std::vector<Stage> stages = {Stage::DISTANCE, Stage::STRENGTH, Stage::TREE};
    if(std::holds_alternative<Laplacian_method>(method))
      stages.push_back(Stage::HOMOLOGY);
    Canceling_visitor visitor(Stage::DISTANCE, 0);
    Solver solver(built.mesh, by(method).visitor(std::ref(visitor)));
    solver.set_source(other);
    for(Stage stage : stages)
    {
      visitor = Canceling_visitor(stage, 0); // at none: the calls are counted
      solver.set_source(source);
      const std::size_t last = visitor.number;
      for(std::size_t at : {std::size_t(1), (last + 1) / 2, last})
      {
        visitor = Canceling_visitor(stage, at);
        EXPECT_THROW(solver.set_source(source), Canceled);
        EXPECT_THROW(solver.cut_locus(), Invalid_input);
      }
      solver.set_source(source);
      EXPECT_EQ(result_numbers(solver.cut_locus()), expected);
    }
  }
}

TEST_F(Progress_of_stages, What_is_done_once_for_a_mesh_can_be_canceled_and_done_again)
{
  for(Method method : {Method(Default_method()), Method(Laplacian_method())})
  {
    const auto parameters = by(method);
    Solver untouched(built.mesh, parameters);
    untouched.set_source(source);
    Canceling_visitor visitor(Stage::PREPROCESSING, 1);
    EXPECT_THROW(Solver(built.mesh, parameters.visitor(std::ref(visitor))), Canceled);
    Solver solver(built.mesh, parameters.visitor(std::ref(visitor)));
    for(std::size_t at : {1, 2, 5})
    {
      visitor.at = at;
      visitor.number = 0;
      EXPECT_THROW(solver.set_source(source), Canceled);
    }
    solver.set_source(source);
    EXPECT_EQ(result_numbers(solver.cut_locus()), result_numbers(untouched.cut_locus()));
    visitor.stage = Stage::FILTER;
    for(std::size_t at : {1, 2, 5})
    {
      visitor.at = at;
      visitor.number = 0;
      EXPECT_THROW(solver.cut_locus(through_faces), Canceled);
    }
    EXPECT_EQ(result_numbers(solver.cut_locus(through_faces)), result_numbers(untouched.cut_locus(through_faces)));
  }
}

TEST_F(Progress_of_stages, A_threshold_that_needs_more_can_be_canceled_too)
{
  Canceling_visitor visitor(Stage::FILTER, 3);
  Solver solver(built.mesh, params::visitor(std::ref(visitor)));
  solver.set_source(source);
  visitor.number = visitor.at; // not yet
  const std::vector<double> by_default = result_numbers(solver.cut_locus());
  const auto all = by(Default_method().minimum_branch_width(0.));
  for(std::size_t at : {1, 3, 20})
  {
    visitor.at = at;
    visitor.number = 0;
    EXPECT_THROW(solver.cut_locus(all), Canceled);
    EXPECT_EQ(result_numbers(solver.cut_locus()), by_default);
  }
  Solver untouched(built.mesh);
  untouched.set_source(source);
  EXPECT_EQ(result_numbers(solver.cut_locus(all)), result_numbers(untouched.cut_locus(all)));
}

// knows nothing of shares
struct Plain_visitor
{
  int number = 0;
  void start_stage(Stage) { ++number; }
  void end_stage(Stage) {}
};

TEST_F(Progress_of_stages, A_visitor_needs_no_function_for_it)
{
  Plain_visitor visitor;
  Solver solver(built.mesh, params::visitor(std::ref(visitor)));
  solver.set_source(source);
  EXPECT_EQ(visitor.number, 6); // twice for the mesh
  EXPECT_FALSE(result_numbers(solver.cut_locus()).empty());
}

} // namespace

} // namespace test_progress
