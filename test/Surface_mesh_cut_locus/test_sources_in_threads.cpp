// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cut loci of many sources, and what is computed for one, in one thread and, where TBB is linked, in several.

#include "surface_test.h"
#include "result_numbers.h"

#include <CGAL/Cut_loci/Default_visitor.h>
#include <CGAL/compute_cut_loci.h>

#include <boost/iterator/function_output_iterator.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <atomic>
#include <functional>
#include <stdexcept>

namespace test_sources_in_threads {

namespace {

using namespace surface_test;
using Face_location = Solver::Face_location;
using Source = Solver::Source;

class Many_sources : public testing::Test
{
protected:
  Vertices some_vertices() const
  {
    Vertices result;
    for(std::size_t v = 3; v < built.vertices.size(); v += built.vertices.size() / 23)
      result.push_back(built.vertices[v]);
    return result;
  }

  const Built built{two_tori()};
#ifdef CGAL_LINKED_WITH_TBB
  // also on a machine with one core
  tbb::global_control threads{tbb::global_control::max_allowed_parallelism, 4};
#endif
};

TEST_F(Many_sources, Each_has_the_cut_locus_that_it_has_alone_in_threads_too)
{
  const auto sources = some_vertices();
  for(Method method : {Method(Default_method()), Method(Polyhedral_method()), Method(Laplacian_method())})
    for(Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
    {
      const auto np = by(method).cut_locus_curve(curve);
      std::vector<Cut_locus> one_by_one, in_threads;
      CGAL::compute_cut_loci(built.mesh, sources, std::back_inserter(one_by_one), np);
      CGAL::compute_cut_loci(built.mesh, sources, std::back_inserter(in_threads),
                             np.concurrency_tag(CGAL::Parallel_if_available_tag()));
      ASSERT_EQ(one_by_one.size(), sources.size());
      ASSERT_EQ(in_threads.size(), sources.size());
      for(std::size_t i = 0; i < sources.size(); ++i)
      {
        const std::vector<double> alone = result_numbers(compute_cut_locus(built.mesh, sources[i], np));
        EXPECT_FALSE(alone.empty());
        EXPECT_EQ(result_numbers(one_by_one[i]), alone);
        EXPECT_EQ(result_numbers(in_threads[i]), alone);
        EXPECT_EQ(in_threads[i].source().mesh_vertex, sources[i]);
      }
    }
}

TEST_F(Many_sources, They_may_be_vertices_and_points_of_faces)
{
  const Face_location at(*built.mesh.faces().begin(), {{0.2, 0.3, 0.5}});
  const std::vector<Source> sources = {Source(at), Source(built.vertices[7])};
  std::vector<Cut_locus> found;
  CGAL::compute_cut_loci(built.mesh, sources, std::back_inserter(found),
                         params::concurrency_tag(CGAL::Parallel_if_available_tag()));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(result_numbers(found[0]), result_numbers(compute_cut_locus(built.mesh, at)));
  EXPECT_EQ(result_numbers(found[1]), result_numbers(compute_cut_locus(built.mesh, built.vertices[7])));
}

TEST_F(Many_sources, A_range_of_the_mesh_is_taken_and_an_empty_one_gives_nothing)
{
  std::size_t number = 0;
  const auto count = boost::make_function_output_iterator([&](const Cut_locus&) { ++number; });
  CGAL::compute_cut_loci(built.mesh, Vertices(), count);
  EXPECT_EQ(number, 0u);
  CGAL::compute_cut_loci(built.mesh, built.mesh.vertices(), count,
                         params::concurrency_tag(CGAL::Parallel_if_available_tag()));
  EXPECT_EQ(number, built.mesh.number_of_vertices());
}

TEST_F(Many_sources, A_wrong_one_is_named_before_anything_is_computed)
{
  Vertices sources = some_vertices();
  sources[5] = Mesh::null_vertex();
  std::size_t number = 0;
  const auto count = boost::make_function_output_iterator([&](const Cut_locus&) { ++number; });
  const auto np = params::concurrency_tag(CGAL::Parallel_if_available_tag());
  EXPECT_EQ(message_of([&] { CGAL::compute_cut_loci(built.mesh, sources, count, np); }),
            "source 5: the source is the null vertex");
  EXPECT_EQ(number, 0u);
}

// throws when the eleventh source has its distances
struct Impatient_visitor : public CGAL::Cut_loci::Default_visitor
{
  std::atomic<int> number{0};
  void end_stage(CGAL::Cut_loci::Stage) {}
  void start_stage(CGAL::Cut_loci::Stage stage)
  {
    if(stage == CGAL::Cut_loci::Stage::STRENGTH && ++number == 11)
      throw std::runtime_error("enough");
  }
};

TEST_F(Many_sources, What_is_thrown_for_one_reaches_the_caller)
{
  std::vector<Cut_locus> found;
  Impatient_visitor visitor;
  EXPECT_THROW(
    CGAL::compute_cut_loci(built.mesh, some_vertices(), std::back_inserter(found),
                           params::visitor(std::ref(visitor)).concurrency_tag(CGAL::Parallel_if_available_tag())),
    std::runtime_error);
  EXPECT_LE(found.size(), 20u);
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i].source().mesh_vertex, some_vertices()[i]);
}

TEST_F(Many_sources, The_class_prepares_what_its_copies_share_and_keeps_its_source)
{
  int number = 0;
  struct Counting_visitor : public CGAL::Cut_loci::Default_visitor
  {
    int& number;
    explicit Counting_visitor(int& n) : number(n) {}
    void start_stage(CGAL::Cut_loci::Stage stage) { number += stage == CGAL::Cut_loci::Stage::PREPROCESSING; }
  };
  Solver solver(built.mesh, params::visitor(Counting_visitor(number)));
  solver.set_source(built.vertices[5]);
  const std::vector<double> before = result_numbers(solver.cut_locus());
  const std::size_t last = built.vertices.size() - 1; // on the other torus
  solver.prepare(std::array<Mesh::Vertex_index, 2>{{built.vertices[9], built.vertices[last]}});
  EXPECT_EQ(result_numbers(solver.cut_locus()), before);
  EXPECT_EQ(number, 3); // for the mesh, and for each torus
  for(std::size_t v : {std::size_t(9), last})
  {
    Solver copy(solver);
    copy.set_source(built.vertices[v]);
    EXPECT_EQ(result_numbers(copy.cut_locus()), result_numbers(compute_cut_locus(built.mesh, built.vertices[v])));
  }
  EXPECT_EQ(number, 3);
}

class One_source : public testing::Test
{
protected:
  // in threads, and to the last bit
  template <typename NamedParameters>
  void expect_the_same(const Mesh& mesh, const NamedParameters& np) const
  {
    const auto v = *mesh.vertices().begin();
    EXPECT_EQ(result_numbers(compute_cut_locus(mesh, v, np.concurrency_tag(CGAL::Parallel_if_available_tag()))),
              result_numbers(compute_cut_locus(mesh, v, np)));
  }

#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control threads{tbb::global_control::max_allowed_parallelism, 4};
#endif
};

// of several blocks of faces each
TEST_F(One_source, Has_the_same_cut_locus_in_threads)
{
  const Built torus(test_meshes::torus(1., 0.4, 180, 70, 0.2, 1));
  expect_the_same(torus.mesh, through_faces.cut_locus_method(Default_method()));
  expect_the_same(torus.mesh, through_faces.cut_locus_method(Default_method()).maximum_relative_error(1e-4));
  expect_the_same(torus.mesh, by(Laplacian_method()));
  const Built smaller(test_meshes::torus(1., 0.4, 80, 30, 0.2, 1));
  expect_the_same(smaller.mesh, through_faces.cut_locus_method(Polyhedral_method()));
}

// One run of windows finds the faces that matter, and another one follows it in a thread of its own. On the cube the first
// one finds that the source has to be moved.
TEST_F(One_source, Has_the_same_curves_in_threads_each_time)
{
  for(const test_meshes::Mesh_data& data :
      {test_meshes::irregular_bumpy_sphere(24, 0.2, 3), test_meshes::cube(6), test_meshes::plate_with_holes(2, 1, 4),
       test_meshes::cylinder(1., 30, 12, 0.2, 1), test_meshes::needles(20)})
  {
    const Built_mesh<Mesh> built(data);
    CGAL::Surface_mesh_cut_locus<Mesh> alone(built.mesh),
      in_threads(built.mesh, params::concurrency_tag(CGAL::Parallel_if_available_tag()));
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Mesh::Vertex_index source = built.vertices[k * built.vertices.size() / 3];
      alone.set_source(source);
      for(int run = 0; run < 5; ++run)
      {
        in_threads.set_source(source);
        for(Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
          EXPECT_EQ(result_numbers(in_threads.cut_locus(params::cut_locus_curve(curve))),
                    result_numbers(alone.cut_locus(params::cut_locus_curve(curve))));
      }
    }
  }
}

// throws the next time that it is told how far distances are
struct Canceling_visitor : public CGAL::Cut_loci::Default_visitor
{
  bool is_canceled = false;
  void progress(CGAL::Cut_loci::Stage stage, double share)
  {
    if(is_canceled && stage == CGAL::Cut_loci::Stage::DISTANCE && share > 0.)
      throw std::runtime_error("canceled");
  }
};

TEST_F(One_source, Is_left_by_what_a_visitor_throws_in_threads_too)
{
  const Built_mesh<Mesh> torus(test_meshes::torus(1., 0.4, 180, 70, 0.2, 1));
  Canceling_visitor visitor;
  CGAL::Surface_mesh_cut_locus<Mesh> solver(
    torus.mesh, params::visitor(std::ref(visitor)).concurrency_tag(CGAL::Parallel_if_available_tag()));
  for(int run = 0; run < 5; ++run)
  {
    visitor.is_canceled = true;
    EXPECT_THROW(solver.set_source(torus.vertices[3]), std::runtime_error);
    visitor.is_canceled = false;
    solver.set_source(torus.vertices[run]);
    EXPECT_EQ(result_numbers(solver.cut_locus()),
              result_numbers(CGAL::compute_cut_locus(torus.mesh, torus.vertices[run])));
  }
}

TEST_F(One_source, Has_the_same_errors_in_threads)
{
  Mesh_data flat = test_meshes::torus(1., 0.4, 20, 10, 0.2, 1);
  for(auto& p : flat.points) // no face has an area
    p[1] = p[2] = 0.;
  const Built built(flat);
  const auto np = params::concurrency_tag(CGAL::Parallel_if_available_tag());
  for(int run = 0; run < 20; ++run)
    expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[3], np); }, Cause::FACE_WITHOUT_AREA,
                   {"remove_degenerate_faces"});
}

} // namespace

} // namespace test_sources_in_threads
