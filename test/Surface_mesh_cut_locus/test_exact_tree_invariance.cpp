// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The exact cut locus depends on the surface and the source alone: it stays where it is if the mesh is renumbered, moved,
// scaled or refined in its planes.

#include "surface_test.h"
#include "default_results.h"

#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/cut_along_cut_locus.h>

namespace test_exact_tree_invariance {

namespace {

using namespace surface_test;
using namespace default_test;
using CGAL::Cut_loci::internal::Vector;
using checked_curves::measured;

// in no symmetric position
std::vector<Named_mesh> generic_meshes()
{
  return {{"convex", random_convex_polyhedron(60, 1)},
          {"flat convex", random_convex_polyhedron(50, 2, {{1., 0.8, 0.1}})},
          {"nonconvex", irregular_bumpy_sphere(6, 0.3, 2)},
          {"torus", torus(1., 0.4, 16, 10, 0.15, 5)},
          {"open cylinder", cylinder(1., 14, 5, 0.1, 4)}};
}

// Behind a saddle the angle at which paths part is that of a node where pieces meet, to some 1e-7: whether what is narrower
// belongs to one path is a matter of rounding.
Segments segments_of(const Mesh_data& data, std::size_t source)
{
  const Indexed_triangle_mesh mesh = indexed(data);
  const Solved solved(mesh, at_vertex(mesh, static_cast<Index>(source)), Branch_strength());
  Solved::Thresholds thresholds;
  thresholds.gap = 1e-6;
  return segments(mesh, solved.curve(thresholds, Curve::THROUGH_FACES));
}

template <typename Map>
Mesh_data mapped(Mesh_data data, const Map& map)
{
  for(auto& p : data.points)
    p = map(p);
  return data;
}

template <typename Map>
Segments mapped(Segments segments, const Map& map)
{
  for(auto& s : segments)
    s = {{map(s[0]), map(s[1])}};
  return segments;
}

Vector rotated(const Vector& p) // by the unit quaternion (1, 2, 3, 4) / sqrt(30), and moved
{
  return {{(-20. * p[0] + 4. * p[1] + 22. * p[2]) / 30. + 0.3, (20. * p[0] - 10. * p[1] + 20. * p[2]) / 30. - 2.,
           (10. * p[0] + 28. * p[1] + 4. * p[2]) / 30. + 7.}};
}

class Exact_tree_invariance : public ::testing::TestWithParam<std::size_t>
{
protected:
  void SetUp() override
  {
    const Named_mesh m = generic_meshes()[GetParam()];
    name_ = m.name;
    data_ = m.data;
    source_ = data_.points.size() / 3;
    curve_ = segments_of(data_, source_);
    ASSERT_GT(curve_.size(), 100u);
    // chords leave curved pieces by 1e-4 of an edge at most, in both
    tolerance_ = 2e-4 * mean_edge_length(data_);
  }

  std::string name_;
  Mesh_data data_;
  std::size_t source_ = 0;
  Segments curve_;
  double tolerance_ = 0.;
};

TEST_P(Exact_tree_invariance, of_the_numbering)
{
  for(unsigned seed : {1u, 2u})
  {
    std::vector<std::size_t> new_index;
    const Mesh_data shuffled = test_meshes::shuffled(data_, seed, new_index);
    EXPECT_LE(distance(curve_, segments_of(shuffled, new_index[source_])), tolerance_) << name_;
  }
}

TEST_P(Exact_tree_invariance, of_rigid_motions)
{
  EXPECT_LE(distance(mapped(curve_, rotated), segments_of(mapped(data_, rotated), source_)), tolerance_) << name_;
}

TEST_P(Exact_tree_invariance, of_the_unit_of_length)
{
  for(double s : {1e-3, 1e5})
  {
    const auto scale = [s](const Vector& p) { return Vector{{s * p[0], s * p[1], s * p[2]}}; };
    EXPECT_LE(distance(mapped(curve_, scale), segments_of(mapped(data_, scale), source_)), s * tolerance_) << name_;
  }
}

TEST_P(Exact_tree_invariance, of_the_faces_in_a_plane)
{
  EXPECT_LE(distance(curve_, segments_of(split_in_plane(data_), source_)), tolerance_) << name_;
}

INSTANTIATE_TEST_SUITE_P(generic, Exact_tree_invariance, ::testing::Range(std::size_t(0), generic_meshes().size()));

// -- the two curves that are made of it --------------------------------------------------------------------------------

// Every sharp vertex of a polyhedron has a branch: on a rough one they are closer to each other than faces are wide.
TEST(Exact_tree_corridors, are_counted_where_a_curve_of_mesh_edges_closes_them)
{
  for(const bool is_rough : {true, false})
  {
    const Mesh mesh = to_surface_mesh(is_rough ? torus(1., 0.5, 20, 12, 0.3, 7) : torus(1., 0.4, 48, 32, 0.1, 7));
    Solver solver(mesh, by(is_rough ? Method(Polyhedral_method()) : Default_method()));
    for(Mesh::size_type v : {0u, 17u, 100u})
    {
      solver.set_source(Mesh::Vertex_index(v));
      const auto edges = solver.cut_locus(mesh_edges);
      const auto faces = solver.cut_locus(through_faces);
      const std::size_t number = CGAL::Cut_loci::compute_statistics(edges).narrow_corridors;
      EXPECT_EQ(number > 0, is_rough);
      EXPECT_EQ(CGAL::Cut_loci::compute_statistics(faces).narrow_corridors, 0u);
      // what is behind them is opened beside them
      EXPECT_LT(measured(mesh, edges).max, is_rough ? 3. : 1.);
      EXPECT_LT(measured(mesh, faces).max, 1e-3);
    }
  }
}

// From all vertices there are shortest paths through others, on one line: which of these they are said to come from may
// be different on two edges of a face.
TEST(Exact_tree_of_squares, is_right_whatever_their_diagonals)
{
  for(unsigned seed = 1; seed <= 20; ++seed)
  {
    const Mesh mesh = to_surface_mesh(with_diagonals_at_random(cross_shape(1), seed));
    Solver solver(mesh, by(Polyhedral_method()));
    for(const auto v : mesh.vertices())
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", from " + std::to_string(v));
      solver.set_source(v);
      EXPECT_LT(measured(mesh, solver.cut_locus(through_faces)).max, 1e-6);
    }
  }
}

// On symmetric polyhedra the curve through the faces follows edges of the mesh.
TEST(Exact_tree_along_edges, the_surface_is_cut_open_to_a_disk)
{
  for(const auto method : {Method(Default_method()), Method(Polyhedral_method())})
  {
    std::size_t along = 0;
    for(const Mesh_data& data : {cube(1), cube(2), cube(4), octahedron()})
    {
      const Mesh mesh = to_surface_mesh(data);
      Solver solver(mesh, by(method));
      for(const auto v : mesh.vertices())
      {
        SCOPED_TRACE(std::to_string(mesh.number_of_faces()) + " faces, vertex " + std::to_string(v));
        solver.set_source(v);
        const auto curve = solver.cut_locus(through_faces);
        for(const auto e : CGAL::make_range(edges(curve.graph())))
          along += curve.graph()[e].mesh_halfedge != Mesh::null_halfedge();
        Mesh disk;
        ASSERT_NO_THROW(CGAL::cut_along_cut_locus(mesh, curve, disk));
        EXPECT_TRUE(disk.is_valid());
        EXPECT_EQ(disk.number_of_vertices() + disk.number_of_faces(), disk.number_of_edges() + 1);
        EXPECT_LT(measured(mesh, curve).max, 1e-3);
      }
    }
    EXPECT_GT(along, 100u);
  }
}

} // namespace

} // namespace test_exact_tree_invariance
