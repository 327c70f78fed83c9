// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Sources that are curves, and the method of the paper.
//
// What must hold: without the curves, the surface shrinks to the cut locus, as for the other methods; the curve of mesh
// edges has no vertex on a source; edges between two sources name them, and no threshold removes them. Where a corridor
// without a vertex inside leaves no such edges, that is said.

#include "curve_sources_cases.h"

#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>

namespace test_laplacian_curves_as_sources {

namespace {

using namespace curve_sources;

const auto laplacian = by(Laplacian_method());

// -- closed forms ------------------------------------------------------------------------------------------------------

TEST(Laplacian_curves, the_border_of_a_rectangle_has_its_medial_axis)
{
  for(const double width : {1., 2.})
    for(const std::size_t n : {16, 32})
    {
      const Built built(rectangle(width, n, 0.2, 3));
      const double h = mean_edge_length(built.data);
      for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
      {
        const Result result = of_border(built, Laplacian_method(), curve);
        expect_topology(built, border_loops(built), result, "rectangle");
        EXPECT_EQ(number_of_leaves(result), 4u) << "towards the corners";
        // the branches end an edge before the corners
        EXPECT_GT(length(result), width - 1. + 2. * std::sqrt(2.) - 8. * h) << width << ' ' << n;
        for(const auto v : CGAL::make_range(vertices(result.graph())))
          EXPECT_LT(excess_of_second_side(to_point(result.graph()[v].point), width), 2. * longest_edge(built.mesh))
            << width << ' ' << n;
      }
    }
}

TEST(Laplacian_curves, the_borders_of_a_ring_have_the_circle_between_them)
{
  double error = 0.; // of lengths through the faces, in the mean
  for(const std::size_t nu : {40, 60, 80, 91, 100})
    for(const std::size_t nr : {11, 12, 13, 14, 15}) // with the circle along edges, or in a row of faces
      for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
      {
        const Built built(annulus(0.5, 1.5, nu, nr));
        const Result result = of_border(built, Laplacian_method(), curve);
        expect_topology(built, border_loops(built), result, "ring");
        if(nr % 2 == 0)
        {
          EXPECT_NEAR(length(result), 2. * pi, curve == Curve::THROUGH_FACES ? 5. / double(nu) : 0.02)
            << nu << ' ' << nr;
        }
        else // both sides of the row are equally far: rounding says on which one the curve starts
        {
          EXPECT_NEAR(length(result), 2. * pi, curve == Curve::THROUGH_FACES ? 0.25 : 6.5 / double(nr))
            << nu << ' ' << nr;
        }
        if(curve == Curve::THROUGH_FACES)
          error += std::fabs(length(result) - 2. * pi) / 25.;
        for(const auto e : CGAL::make_range(edges(result.graph())))
          EXPECT_EQ(result.graph()[e].sources, (std::array<std::size_t, 2>{{0, 1}}));
        for(const auto v : CGAL::make_range(vertices(result.graph())))
          EXPECT_NEAR(norm(to_point(result.graph()[v].point)), 1., 0.75 / double(nr));
        for(const Mesh::Vertex_index v : built.vertices)
        {
          const double r = norm(to_point(built.mesh.point(v)));
          if(std::fabs(r - 1.) > 1. / double(nr))
          {
            EXPECT_EQ(*result.nearest_source(v), r < 1. ? *result.nearest_source(built.vertices.back())
                                                        : *result.nearest_source(built.vertices.front()));
          }
        }
      }
  EXPECT_LT(error, 0.1);
}

TEST(Laplacian_curves, both_ends_of_a_cylinder_have_the_circle_between_them)
{
  const std::size_t nu = 32, nz = 12;
  const Built built(cylinder(2., nu, nz, 0., 0));
  const Result result = of_border(built, Laplacian_method(), Curve::MESH_EDGES);
  EXPECT_EQ(num_edges(result.graph()), nu);
  double low = 1e9, high = -1e9;
  for(const auto v : CGAL::make_range(vertices(result.graph())))
  {
    low = (std::min)(low, result.graph()[v].point.z());
    high = (std::max)(high, result.graph()[v].point.z());
    EXPECT_NEAR(result.graph()[v].distance, 1., 1e-4);
  }
  EXPECT_EQ(low, high) << "edges of the mesh are there";
}

// All points nearest to the end of a slit in a strip, and to its sides, are beside it: nothing is between them.
TEST(Laplacian_curves, a_slit_in_a_rectangle_alone_leaves_a_point)
{
  const std::size_t n = 16;
  const Built built(rectangle(2., n, 0., 1));
  std::vector<std::size_t> along;
  for(std::size_t i = 4; i <= 12; ++i)
    along.push_back(nearest_vertex(built.data, {{2. * double(i) / double(n), 0.5, 0.}}));
  const std::vector<Edges> curves = {path(built, along)};
  for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
  {
    const Result result = of_curves(built, {}, curves, Laplacian_method(), curve);
    expect_topology(built, curves, result, "slit");
    EXPECT_EQ(num_edges(result.graph()), 0u);
    for(const Mesh::Vertex_index v : built.vertices)
    {
      const Point p = to_point(built.mesh.point(v));
      const double x = (std::max)({0., 0.5 - p[0], p[0] - 1.5});
      EXPECT_NEAR(result.distance(v), std::hypot(x, p[1] - 0.5), 1e-4) << "exact distances to the curve";
    }
  }
}

// -- invariants --------------------------------------------------------------------------------------------------------

template <typename GeodesicSolver>
void expect_topology_of_solver(const GeodesicSolver& geodesics, const std::string& name)
{
  std::size_t number_of_refused = 0, number = 0;
  for(std::size_t i = 0; i < surfaces().size(); ++i)
  {
    const Built built(surfaces()[i]);
    for(const std::size_t k : {1, 2, 5})
      for(unsigned seed = 0; seed < 2; ++seed)
      {
        const std::vector<Edges> curves = random_curves(built, k, 5, unsigned(10 * i + k + 100 * seed));
        const std::string what =
          name + ", surface " + std::to_string(i) + ", " + std::to_string(k) + " curves, seed " + std::to_string(seed);
        Solver solver(built.mesh, laplacian.geodesic_solver(geodesics));
        solver.set_sources(Vertices(), params::source_curves(curves));
        ++number;
        bool is_there = has_mesh_edges(built, solver, curves, params::kept_part(Kept_part::ALL), what);
        number_of_refused += !is_there;
        for(const double angle : {0., 1.5, 3.14})
          for(const Filter_policy policy : {Filter_policy::PRUNING, Filter_policy::GROWING})
            EXPECT_EQ(has_mesh_edges(built, solver, curves,
                                     by(Laplacian_method().gradient_angle_threshold(angle).filter_policy(policy)),
                                     what),
                      is_there)
              << what << ", angle " << angle;
        if(is_there)
          expect_topology(built, curves, solver.cut_locus(), what + ", through faces");
      }
  }
  EXPECT_LE(number_of_refused, number / 4) << "where a curve coils up, there are corridors without a vertex";
}

TEST(Laplacian_curves, leave_what_shrinks_to_the_cut_locus_with_each_solver)
{
  expect_topology_of_solver(CGAL::Exact_geodesic_solver(), "exact");
  expect_topology_of_solver(CGAL::Heat_method_geodesic_solver<>(), "heat");
  expect_topology_of_solver(CGAL::Graph_geodesic_solver(), "graph");
}

TEST(Laplacian_curves, leave_what_shrinks_to_the_cut_locus_whatever_the_distances)
{
  for(std::size_t i = 0; i < surfaces().size(); ++i)
  {
    const Built built(surfaces()[i]);
    const std::vector<Edges> curves = random_curves(built, 2, 5, unsigned(i));
    for(unsigned seed = 0; seed < 3; ++seed)
    {
      std::mt19937 engine(seed);
      std::map<Mesh::Vertex_index, double> distance;
      for(const Mesh::Vertex_index v : built.vertices)
        distance[v] = seed == 0 ? 1. : 1. + random_unit(engine);
      distance[built.vertices[0]] = 0.5; // all equal they would be refused
      Solver solver(built.mesh, laplacian);
      solver.set_sources(Vertices(),
                         params::source_curves(curves).vertex_distance_map(boost::make_assoc_property_map(distance)));
      const std::string what = "surface " + std::to_string(i);
      if(has_mesh_edges(built, solver, curves, params::kept_part(Kept_part::ALL), what))
        expect_topology(built, curves, solver.cut_locus(), what + ", through faces");
    }
  }
}

// Those of the other methods come from vertices that are moved by 1e-5 of an edge or more, up to 1e-4.
TEST(Laplacian_curves, have_exact_distances_and_cells_by_the_descent_of_them)
{
  for(std::size_t i = 0; i < surfaces().size(); ++i)
  {
    const Built built(surfaces()[i]);
    const std::vector<Edges> curves = random_curves(built, 4, 2, unsigned(i));
    const double edge = longest_edge(built.mesh);
    Solver solver(built.mesh, laplacian), exact(built.mesh);
    solver.set_sources(Vertices(), params::source_curves(curves));
    const Result result = solver.cut_locus(by(Laplacian_method().gradient_angle_threshold(3.14)));
    std::vector<Result> alone;
    for(const Edges& curve : curves)
    {
      exact.set_sources(Vertices(), params::source_curves(std::vector<Edges>{curve}));
      alone.push_back(exact.cut_locus());
    }
    for(const Mesh::Vertex_index v : built.vertices)
    {
      double least = alone[0].distance(v);
      for(const Result& r : alone)
        least = (std::min)(least, r.distance(v));
      EXPECT_NEAR(result.distance(v), least, 2e-4 * edge) << "surface " << i;
      ASSERT_TRUE(result.nearest_source(v).has_value());
      // a descent passes faces, and may take the wrong side of what it meets
      EXPECT_LT(alone[*result.nearest_source(v)].distance(v), least + 0.5 * edge) << "surface " << i;
    }
  }
}

TEST(Laplacian_curves, and_points_mix_with_the_points_first)
{
  const Built built(square(16, 0.2, 4));
  const std::vector<Edges> border = border_loops(built);
  const std::size_t center = nearest_vertex(built.data, {{0.5, 0.5, 0.}});
  const Point c = built.data.points[center];
  Solver solver(built.mesh, laplacian);
  solver.set_sources(Vertices{built.vertices[center]}, params::source_border(true));
  const Result result = solver.cut_locus();
  EXPECT_EQ(result.number_of_sources(), 2u);
  EXPECT_EQ(*result.nearest_source(built.vertices[center]), 0u);
  EXPECT_EQ(*result.nearest_source(built.vertices[0]), 1u);
  expect_topology(built, border, result, "square");
  for(const auto e : CGAL::make_range(edges(result.graph())))
    for(const auto v : {source(e, result.graph()), target(e, result.graph())})
    {
      const Point p = to_point(result.graph()[v].point);
      const double d = (std::min)({p[0], 1. - p[0], p[1], 1. - p[1]});
      if(result.graph()[e].sources[0] != result.graph()[e].sources[1])
      {
        EXPECT_NEAR(norm(p - c), d, longest_edge(built.mesh)) << "four parabolas";
      }
    }
  const Result voronoi = solver.cut_locus(params::kept_part(Kept_part::VORONOI)),
               medial = solver.cut_locus(params::kept_part(Kept_part::MEDIAL));
  EXPECT_EQ(num_edges(voronoi.graph()) + num_edges(medial.graph()), num_edges(result.graph()));
  EXPECT_GT(num_edges(voronoi.graph()), 0u);
  const Result strong = solver.cut_locus(
    mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(3.14).minimum_branch_edges(1000)));
  EXPECT_EQ(num_edges(strong.graph()), num_edges(solver.cut_locus(mesh_edges.kept_part(Kept_part::VORONOI)).graph()))
    << "no threshold removes what is between two";
  std::map<Mesh::Edge_index, bool> marks;
  const Result edges_of_mesh =
    solver.cut_locus(mesh_edges.edge_is_constrained_map(boost::make_assoc_property_map(marks)));
  EXPECT_EQ(marks.size(), num_edges(edges_of_mesh.graph()));
}

// Cutting along the curve lengthens no path by much: in units of the mean edge length.
template <typename GeodesicSolver>
double detour(const Built& built, const std::vector<Edges>& curves, const GeodesicSolver& geodesics, Curve curve)
{
  const Result result = compute_cut_locus(
    built.mesh, Vertices(), laplacian.geodesic_solver(geodesics).source_curves(curves).cut_locus_curve(curve));
  return measured(built.mesh, result, curves).max;
}

TEST(Laplacian_curves, lengthen_no_path_by_much)
{
  for(const Mesh_data& data : {ellipsoid(1., 0.8, 0.6, 16, 0.2, 1), torus(1., 0.4, 48, 24, 0.2, 2), square(24, 0.2, 6)})
  {
    const Built built(data);
    std::vector<Edges> curves = random_curves(built, 2, 4, 5);
    for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
    {
      EXPECT_LT(detour(built, curves, CGAL::Exact_geodesic_solver(), curve), 1.);
      EXPECT_LT(detour(built, curves, CGAL::Heat_method_geodesic_solver<>(), curve), 4.);
    }
  }
}

} // namespace

} // namespace test_laplacian_curves_as_sources
