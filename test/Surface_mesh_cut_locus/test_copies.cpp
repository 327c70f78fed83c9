// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Copies of a Surface_mesh_cut_locus share the mesh, also between threads, and nothing else. This is built once more with
// the thread sanitizer.

#include "surface_test.h"
#include "result_numbers.h"

#include <thread>

namespace test_copies {

namespace {

using namespace surface_test;

std::vector<double> solve(Solver& solver, Mesh::Vertex_index source)
{
  solver.set_source(source);
  return result_numbers(solver.cut_locus());
}

constexpr std::array<Method, 3> methods = {{Default_method(), Polyhedral_method(), Laplacian_method()}};

TEST(Copies, Threads_find_what_one_finds_alone)
{
  const Built built(two_tori());
  for(Method method : methods)
    for(bool has_source_before : {false, true})
    {
      Solver original(built.mesh, by(method));
      if(has_source_before)
        original.set_source(built.vertices[0]);
      Vertices sources;
      for(std::size_t v = 3; v < built.vertices.size(); v += built.vertices.size() / 7)
        sources.push_back(built.vertices[v]);

      constexpr std::size_t number = 3;
      std::vector<std::unique_ptr<Solver>> copies;
      for(std::size_t i = 0; i < number; ++i)
        copies.emplace_back(new Solver(original));
      std::vector<std::vector<double>> found(sources.size());
      std::vector<std::thread> threads;
      for(std::size_t i = 0; i < number; ++i)
        threads.emplace_back(
          [&, i]
          {
          for(std::size_t k = i; k < sources.size(); k += number)
            found[k] = solve(*copies[i], sources[k]);
        });
      for(std::thread& t : threads)
        t.join();
      for(std::size_t k = 0; k < sources.size(); ++k)
      {
        EXPECT_EQ(found[k], solve(original, sources[k]));
        EXPECT_FALSE(found[k].empty());
      }
    }
}

TEST(Copies, A_copy_outlives_its_original_and_does_not_change_it)
{
  const Built built(two_tori());
  std::unique_ptr<Solver> original(new Solver(built.mesh));
  const std::vector<double> of_first = solve(*original, built.vertices[5]);
  Solver copy(*original);
  const std::vector<double> of_other = solve(copy, built.vertices[90]);
  EXPECT_EQ(result_numbers(original->cut_locus()), of_first);
  original.reset();
  EXPECT_EQ(result_numbers(copy.cut_locus()), of_other);
  EXPECT_EQ(solve(copy, built.vertices[5]), of_first);
}

TEST(Copies, A_copy_has_the_parameters_of_its_original_and_no_source)
{
  const Built built(two_tori());
  Solver original(built.mesh, by(Laplacian_method()));
  original.set_source(built.vertices[5]);
  Solver copy(original);
  EXPECT_THROW(copy.cut_locus(), Invalid_input);
  copy.set_source(built.vertices[5]);
  EXPECT_TRUE(std::holds_alternative<Laplacian_method>(copy.method()));
}

} // namespace

} // namespace test_copies
