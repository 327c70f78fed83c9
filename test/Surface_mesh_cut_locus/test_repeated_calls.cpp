// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "result_numbers.h"
#include "surface_test.h"

#include <future>

// A cut locus is a function of the surface, the source and the thresholds: neither earlier calls nor other threads change it.

namespace test_repeated_calls {

namespace {

using namespace surface_test;
// widths below the default and above, from none on
const std::vector<double> widths = {0., 0.001, 0.02, 0.3};

std::vector<Mesh_data> tori()
{
  return {torus(1., 0.5, 20, 10), torus(1., 0.4, 24, 12), torus(2., 0.5, 30, 9)};
}

TEST(Repeated_calls, have_the_result_of_the_first_one)
{
  for(const Mesh_data& data : tori())
  {
    const Built built(data);
    Solver solver(built.mesh), first(built.mesh);
    for(std::size_t s = 0; s < data.points.size() / 2; s += 17)
    {
      solver.set_source(built.vertices[s]);
      const std::vector<double> by_default = result_numbers(solver.cut_locus());
      for(double width : widths)
      {
        const auto np = by(Default_method().minimum_branch_width(width));
        first.set_source(built.vertices[s]);
        EXPECT_EQ(result_numbers(first.cut_locus(np)), result_numbers(solver.cut_locus(np))) << width << " from " << s;
        EXPECT_EQ(result_numbers(solver.cut_locus()), by_default) << "after " << width << " from " << s;
      }
      EXPECT_EQ(result_numbers(first.cut_locus()), by_default) << s;
    }
  }
}

TEST(Repeated_calls, may_come_from_several_threads)
{
  const Built built(torus(1., 0.5, 20, 10));
  Solver solver(built.mesh);
  solver.set_source(built.vertices[3]);
  const Solver& shared = solver;
  const auto ask = [&shared]
  {
    std::vector<std::vector<double>> all;
    for(double width : widths)
      all.push_back(result_numbers(shared.cut_locus(by(Default_method().minimum_branch_width(width)))));
    return all;
  };
  auto other = std::async(std::launch::async, ask);
  const auto here = ask();
  EXPECT_EQ(here, other.get());
  EXPECT_EQ(here, ask());
}

} // namespace

} // namespace test_repeated_calls
