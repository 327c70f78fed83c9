// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The exact cut locus depends on the surface and the source alone: an independent oracle finds two shortest paths to its
// points and one to others, and it stays where it is if the mesh is renumbered, moved, scaled or refined in its planes.

#include "surface_test.h"
#include "detour.h"
#include "polyhedral_oracle.h"

#include <CGAL/Cut_loci/polyhedral/solver/Exact_tree_solver.h>
#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/cut_along_cut_locus.h>

namespace test_exact_tree_invariance {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::internal::Exact_tree_solver;
using CGAL::Cut_loci::internal::Vector;
using Point = CGAL::Simple_cartesian<double>::Point_3;

// in no symmetric position
std::vector<Named_mesh> generic_meshes()
{
  return {{"convex", test_meshes::random_convex_polyhedron(60, 1)},
          {"nonconvex", test_meshes::irregular_bumpy_sphere(6, 0.3, 2)},
          {"torus", test_meshes::torus(1., 0.4, 16, 10, 0.15, 5)},
          {"open cylinder", test_meshes::cylinder(1., 14, 5, 0.1, 4)}};
}

Indexed_cut_locus curve_of(const Indexed_triangle_mesh& mesh, const Indexed_source& source, double gap = 0.)
{
  Exact_tree_solver solver(mesh);
  solver.compute_distance(source);
  solver.compute_strengths();
  solver.grow_tree();
  solver.close_cycles();
  CGAL::Cut_loci::internal::Exact_tree_thresholds thresholds;
  thresholds.gap = gap;
  return solver.filter(thresholds, CGAL::Cut_loci::Curve::THROUGH_FACES);
}

Indexed_location random_location(const Indexed_triangle_mesh& mesh, std::mt19937& generator)
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

// tips and points on the border have one path
std::vector<std::size_t> inner_nodes(const Indexed_cut_locus& curve)
{
  std::vector<int> degree(curve.nodes.size(), 0);
  for(const Indexed_cut_locus::Edge& e : curve.edges)
    for(Index i : {e.source, e.target})
      ++degree[i];
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < degree.size(); ++i)
    if(degree[i] > 1)
      result.push_back(i);
  return result;
}

TEST(Exact_tree_oracle, two_paths_lead_to_a_thousand_points_of_it_and_one_to_a_thousand_others)
{
  for(const Named_mesh& m : generic_meshes())
  {
    const Indexed_triangle_mesh mesh = indexed(m.data);
    std::mt19937 generator(3);
    for(Index v : {mesh.number_of_vertices() / 3, mesh.number_of_vertices() / 2})
    {
      SCOPED_TRACE(m.name + ", source " + std::to_string(v));
      const Indexed_source source = at_vertex(mesh, v);
      const Indexed_cut_locus curve = curve_of(mesh, source);
      const polyhedral_oracle::Polyhedral_oracle oracle(mesh, source.location);
      const std::vector<std::size_t> inner = inner_nodes(curve);
      ASSERT_GT(inner.size(), 100u);
      for(int i = 0; i < 125; ++i)
      {
        const Indexed_cut_locus::Node& node = curve.nodes[inner[generator() % inner.size()]];
        const double rounding = 1e-9 * node.distance;
        const auto arrivals = oracle.shortest_arrivals(node.location, rounding);
        EXPECT_GE(arrivals.size(), 2u);
        EXPECT_NEAR(arrivals.front().distance, node.distance, rounding);
        const Indexed_location other = random_location(mesh, generator);
        EXPECT_EQ(oracle.shortest_arrivals(other, 1e-9 * node.distance).size(), 1u);
      }
    }
  }
}

// -- the curve stays where it is ---------------------------------------------------------------------------------------

using Segments = std::vector<std::array<Vector, 2>>;

// Behind a saddle the angle at which paths part is that of a node where pieces meet, to some 1e-7: whether what is narrower
// belongs to one path is a matter of rounding.
Segments segments_of(const Mesh_data& data, std::size_t source)
{
  const Indexed_triangle_mesh mesh = indexed(data);
  const Indexed_cut_locus curve = curve_of(mesh, at_vertex(mesh, static_cast<Index>(source)), 1e-6);
  Segments result;
  const auto point = [&](Index i)
  {
    using namespace CGAL::Cut_loci::internal;
    const Indexed_location& l = curve.nodes[i].location;
    Vector p = {{0., 0., 0.}};
    for(std::size_t k = 0; k < 3; ++k)
      p = p + l.coordinates[k] * mesh.points[mesh.triangles[l.face][k]];
    return p;
  };
  for(const Indexed_cut_locus::Edge& e : curve.edges)
    result.push_back({{point(e.source), point(e.target)}});
  return result;
}

double distance(const Vector& p, const std::array<Vector, 2>& segment)
{
  using namespace CGAL::Cut_loci::internal;
  const Vector along = segment[1] - segment[0], to_p = p - segment[0];
  const double square = dot(along, along), s = square > 0. ? dot(along, to_p) / square : 0.;
  return norm(to_p - (std::max)(0., (std::min)(s, 1.)) * along);
}

// the largest distance from an end or a middle in one to the other, both ways
double hausdorff(const Segments& a, const Segments& b)
{
  using namespace CGAL::Cut_loci::internal;
  double result = 0.;
  for(const auto& [from, to] : {std::make_pair(&a, &b), std::make_pair(&b, &a)})
    for(const std::array<Vector, 2>& s : *from)
      for(const Vector& p : {s[0], s[1], 0.5 * (s[0] + s[1])})
      {
        double least = norm(p - (*to)[0][0]);
        for(const std::array<Vector, 2>& t : *to)
          least = (std::min)(least, distance(p, t));
        result = (std::max)(result, least);
      }
  return result;
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
    tolerance_ = 2e-4 * test_meshes::mean_edge_length(data_);
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
    EXPECT_LE(hausdorff(curve_, segments_of(shuffled, new_index[source_])), tolerance_) << name_;
  }
}

TEST_P(Exact_tree_invariance, of_rigid_motions)
{
  EXPECT_LE(hausdorff(mapped(curve_, rotated), segments_of(mapped(data_, rotated), source_)), tolerance_) << name_;
}

TEST_P(Exact_tree_invariance, of_the_unit_of_length)
{
  for(double s : {1e-3, 1e5})
  {
    const auto scale = [s](const Vector& p) { return Vector{{s * p[0], s * p[1], s * p[2]}}; };
    EXPECT_LE(hausdorff(mapped(curve_, scale), segments_of(mapped(data_, scale), source_)), s * tolerance_) << name_;
  }
}

TEST_P(Exact_tree_invariance, of_the_faces_in_a_plane)
{
  EXPECT_LE(hausdorff(curve_, segments_of(test_meshes::split_in_plane(data_), source_)), tolerance_) << name_;
}

INSTANTIATE_TEST_SUITE_P(generic, Exact_tree_invariance, ::testing::Range(std::size_t(0), generic_meshes().size()));

// -- the two curves that are made of it --------------------------------------------------------------------------------

// Every sharp vertex of a polyhedron has a branch: on a rough one they are closer to each other than faces are wide.
TEST(Exact_tree_corridors, are_counted_where_a_curve_of_mesh_edges_closes_them)
{
  using CGAL::Cut_loci::Curve;
  for(const bool is_rough : {true, false})
  {
    const Mesh mesh = to_surface_mesh(is_rough ? test_meshes::torus(1., 0.5, 20, 12, 0.3, 7)
                                               : test_meshes::torus(1., 0.4, 48, 32, 0.1, 7));
    CGAL::Surface_mesh_cut_locus<Mesh> solver(
      mesh, params::cut_locus_method(is_rough ? CGAL::Cut_loci::Method(CGAL::Cut_loci::Polyhedral_method())
                                              : CGAL::Cut_loci::Default_method()));
    for(Mesh::size_type v : {0u, 17u, 100u})
    {
      solver.set_source(Mesh::Vertex_index(v));
      const auto edges = solver.cut_locus(params::cut_locus_curve(Curve::MESH_EDGES));
      const auto faces = solver.cut_locus(params::cut_locus_curve(Curve::THROUGH_FACES));
      const std::size_t number = CGAL::Cut_loci::compute_statistics(edges).narrow_corridors;
      EXPECT_EQ(number > 0, is_rough);
      EXPECT_EQ(CGAL::Cut_loci::compute_statistics(faces).narrow_corridors, 0u);
      // what is behind them is opened beside them
      const curve_measures::Measures measures = curve_measures::measure(mesh, edges);
      EXPECT_EQ(measures.topology_fault, "");
      EXPECT_LT(measures.max, is_rough ? 3. : 1.);
      EXPECT_LT(curve_measures::measure(mesh, faces).max, 1e-3);
    }
  }
}

// From all vertices there are shortest paths through others, on one line: which of these they are said to come from may
// be different on two edges of a face.
TEST(Exact_tree_of_squares, is_right_whatever_their_diagonals)
{
  for(unsigned seed = 1; seed <= 20; ++seed)
  {
    const Mesh mesh = to_surface_mesh(test_meshes::with_diagonals_at_random(test_meshes::cross_shape(1), seed));
    CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method()));
    for(const auto v : mesh.vertices())
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", from " + std::to_string(v));
      solver.set_source(v);
      const curve_measures::Measures measures =
        curve_measures::measure(mesh, solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES)));
      EXPECT_EQ(measures.topology_fault, "");
      EXPECT_LT(measures.max, 1e-6);
    }
  }
}

// On symmetric polyhedra the curve through the faces follows edges of the mesh.
TEST(Exact_tree_along_edges, the_surface_is_cut_open_to_a_disk)
{
  for(const auto method : {CGAL::Cut_loci::Method(CGAL::Cut_loci::Default_method()),
                           CGAL::Cut_loci::Method(CGAL::Cut_loci::Polyhedral_method())})
  {
    std::size_t along = 0;
    for(const Mesh_data& data : {test_meshes::cube(1), test_meshes::cube(2), test_meshes::cube(4), octahedron()})
    {
      const Mesh mesh = to_surface_mesh(data);
      CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, params::cut_locus_method(method));
      for(const auto v : mesh.vertices())
      {
        SCOPED_TRACE(std::to_string(mesh.number_of_faces()) + " faces, vertex " + std::to_string(v));
        solver.set_source(v);
        const auto curve = solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES));
        for(const auto e : CGAL::make_range(edges(curve.graph())))
          along += curve.graph()[e].mesh_halfedge != Mesh::null_halfedge();
        Mesh disk;
        ASSERT_NO_THROW(CGAL::cut_along_cut_locus(mesh, curve, disk));
        EXPECT_TRUE(disk.is_valid());
        EXPECT_EQ(disk.number_of_vertices() + disk.number_of_faces(), disk.number_of_edges() + 1);
        const curve_measures::Measures measures = curve_measures::measure(mesh, curve);
        EXPECT_EQ(measures.measuring_failed, "");
        EXPECT_EQ(measures.topology_fault, "");
        EXPECT_LT(measures.max, 1e-3);
      }
    }
    EXPECT_GT(along, 100u);
  }
}

} // namespace

} // namespace test_exact_tree_invariance
