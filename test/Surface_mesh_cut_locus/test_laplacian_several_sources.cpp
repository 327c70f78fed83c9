// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The method LAPLACIAN with sets of points: any distances, and one disk for each source.

#include "result_numbers.h"
#include "several_sources_cases.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>

namespace test_laplacian_several_sources {

namespace {

using namespace several_sources;

const auto laplacian = by(Laplacian_method());

// cells and labels of the edges fit each other, and what is between two sources is one closed part of the graph
void expect_labels(const Built& built, const Result& result, const std::string& what)
{
  const auto& graph = result.graph();
  const std::vector<std::size_t> disk = disks_of_faces(built, result);
  std::map<std::size_t, std::set<std::size_t>> sources_of_disk;
  for(const auto e : CGAL::make_range(edges(graph)))
  {
    ASSERT_LE(graph[e].sources[0], graph[e].sources[1]) << what;
    ASSERT_LT(graph[e].sources[1], result.number_of_sources()) << what;
    const Mesh::Halfedge_index h = graph[e].mesh_halfedge;
    if(built.mesh.is_border(built.mesh.edge(h)))
      continue;
    const std::size_t a = disk[built.mesh.face(h)], b = disk[built.mesh.face(built.mesh.opposite(h))];
    EXPECT_EQ(a == b, graph[e].sources[0] == graph[e].sources[1]) << what;
    if(a == b)
      sources_of_disk[a].insert(graph[e].sources[0]);
  }
  for(const auto& d : sources_of_disk)
    EXPECT_EQ(d.second.size(), 1u) << what;
}

void expect_all(const Built& built, const Solver& solver, const std::string& what)
{
  for(const double angle : {0., 0.7, 3.14})
  {
    const auto np = by(Laplacian_method().gradient_angle_threshold(angle));
    const Result edges = solver.cut_locus(np.cut_locus_curve(Curve::MESH_EDGES));
    ASSERT_EQ(fault_of_mesh_edges(built, edges), "") << what << ", angle " << angle;
    expect_labels(built, edges, what);
  }
  EXPECT_EQ(fault_through_faces(built, solver.cut_locus(through_faces)), "") << what;
}

// `set` is called with the object and the sources; some sets may have too few faces
template <typename Set>
bool is_set(const Set& set, const std::string& what)
{
  try
  {
    set();
    return true;
  }
  catch(const Invalid_input& error)
  {
    EXPECT_NE(std::string(error.what()).find("has no face to itself"), std::string::npos) << what << error.what();
    return false;
  }
}

// random ones that share few faces: most sets of them leave a face to each
std::vector<Source> separate_sources(const Built& built, std::size_t k, unsigned seed)
{
  std::vector<Source> result;
  std::set<Mesh::Face_index> taken;
  for(const Source& source : random_sources(built, (std::min)(3 * k, built.vertices.size()), seed))
    if(result.size() < k &&
       (std::holds_alternative<Mesh::Vertex_index>(source) || taken.insert(std::get<Location>(source).first).second))
      result.push_back(source);
  return result;
}

template <typename GeodesicSolver>
void expect_disks_of_solver(const GeodesicSolver& geodesics, const std::string& name)
{
  std::size_t number_of_refused = 0;
  std::vector<Named_mesh> all = meshes();
  for(Named_mesh& m : all)
    while(m.data.points.size() < 300) // or a hundred sources are too many
      m.data = split_in_plane(m.data);
  for(const Named_mesh& m : all)
  {
    const Built built(m.data);
    unsigned seed = 0;
    for(const std::size_t k : {1, 2, 5, 100})
    {
      Solver solver(built.mesh, laplacian.geodesic_solver(geodesics));
      const std::string what = m.name + ", " + name + ", " + std::to_string(k) + " sources";
      const std::vector<Source> sources = separate_sources(built, k, ++seed);
      EXPECT_EQ(sources.size(), k) << what;
      if(is_set([&] { solver.set_sources(sources); }, what))
        expect_all(built, solver, what);
      else
        ++number_of_refused;
    }
  }
  EXPECT_LE(number_of_refused, 2u) << "where 100 sources are more than a third of the vertices";
}

// as anybody may write it: for one source only
struct Plain_solver
{
  CGAL::Exact_geodesic_solver exact;
  void set_mesh(const Indexed_triangle_mesh& mesh) { exact.set_mesh(mesh); }
  void compute_distances(const Indexed_source& source, std::vector<double>& distances)
  {
    exact.compute_distances(source, distances);
  }
};

TEST(Laplacian_several_sources, have_one_disk_each_with_each_solver)
{
  expect_disks_of_solver(CGAL::Exact_geodesic_solver(), "exact");
  expect_disks_of_solver(CGAL::Heat_method_geodesic_solver<>(), "heat");
  expect_disks_of_solver(CGAL::Graph_geodesic_solver(), "graph");
  expect_disks_of_solver(Plain_solver(), "one after another");
}

TEST(Laplacian_several_sources, have_one_disk_each_whatever_the_distances)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    for(unsigned seed = 0; seed < 4; ++seed)
    {
      std::mt19937 engine(seed);
      std::map<Mesh::Vertex_index, double> distance;
      for(const Mesh::Vertex_index v : built.vertices)
        distance[v] = seed == 0 && v != built.vertices[0] ? 1. : 1. + random_unit(engine); // not all alike
      Solver solver(built.mesh, laplacian);
      const std::vector<Source> sources = random_sources(built, 7, seed);
      const auto np = params::vertex_distance_map(boost::make_assoc_property_map(distance));
      if(is_set([&] { solver.set_sources(sources, np); }, m.name))
        expect_all(built, solver, m.name + ", random distances");
    }
  }
}

// -- places where rules could end --------------------------------------------------------------------------------------

TEST(Laplacian_several_sources, may_be_as_close_as_the_mesh_has_faces)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    for(const Named_sources& c : close_sources(built))
    {
      Solver solver(built.mesh, laplacian);
      if(is_set([&] { solver.set_sources(c.sources); }, m.name + ", " + c.name))
        expect_all(built, solver, m.name + ", " + c.name);
    }
  }
}

TEST(Laplacian_several_sources, may_be_all_vertices)
{
  for(const Mesh_data& data : {icosahedron(), cube(2), square(4), sphere(4)})
  {
    const Built built(data);
    Solver solver(built.mesh, laplacian);
    solver.set_sources(std::vector<Source>(built.vertices.begin(), built.vertices.end()));
    expect_all(built, solver, "all vertices");
  }
}

TEST(Laplacian_several_sources, may_be_on_the_border)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    std::vector<Source> sources;
    for(const Mesh::Vertex_index v : built.vertices)
      if(built.mesh.is_border(v) && sources.size() < 6)
        sources.push_back(v);
    if(sources.empty())
      continue;
    Solver solver(built.mesh, laplacian);
    solver.set_sources(sources);
    expect_all(built, solver, m.name + ", on the border");
  }
}

// -- distances and cells -----------------------------------------------------------------------------------------------

TEST(Laplacian_several_sources, have_the_cells_that_single_sources_say)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    const std::vector<Source> sources = random_sources(built, 8, 3);
    const Result result = compute_cut_locus(built.mesh, sources, laplacian.cut_locus_curve(Curve::MESH_EDGES));
    const Distances d(built, sources, result);
    const double exact = 1e-9 * diagonal(built);
    for(std::size_t v = 0; v < built.vertices.size(); ++v)
    {
      ASSERT_NEAR(result.distance(built.vertices[v]), Distances::least(d.to_vertex, v), exact) << m.name;
      ASSERT_NEAR(d.to_vertex[result.nearest_source(built.vertices[v]).value()][v], Distances::least(d.to_vertex, v),
                  exact)
        << m.name;
    }
  }
}

// by how much the source that a vertex is given is farther away than the nearest one at most, in edges
template <typename GeodesicSolver>
double worst_cell(const Built& built, const std::vector<Source>& sources, const GeodesicSolver& geodesics)
{
  const Result result =
    compute_cut_locus(built.mesh, sources, laplacian.geodesic_solver(geodesics).cut_locus_curve(Curve::MESH_EDGES));
  const Distances d(built, sources, result);
  double worst = 0.;
  for(std::size_t v = 0; v < built.vertices.size(); ++v)
    worst = (std::max)(worst, d.to_vertex[result.nearest_source(built.vertices[v]).value()][v] -
                                Distances::least(d.to_vertex, v));
  return worst / mean_edge_length(built.data);
}

TEST(Laplacian_several_sources, have_cells_by_the_descent_of_other_distances)
{
  for(const Mesh_data& data : {jittered_sphere(16, 0.2, 1), torus(1., 0.4, 48, 24, 0.2, 4)})
  {
    const Built built(data);
    const std::vector<Source> sources = random_sources(built, 8, 3);
    EXPECT_LT(worst_cell(built, sources, CGAL::Exact_geodesic_solver()), 1e-9);
    // linear interpolation, or a distance that is smoothed, moves the border of a cell by part of an edge
    EXPECT_LT(worst_cell(built, sources, Plain_solver()), 1.);
    EXPECT_LT(worst_cell(built, sources, CGAL::Heat_method_geodesic_solver<>()), 1.);
    EXPECT_LT(worst_cell(built, sources, CGAL::Graph_geodesic_solver()), 1.);
  }
}

// of vertices, points in faces, and points of edges, inside and on the border
TEST(Laplacian_several_sources, have_distances_to_the_nearest_with_each_solver)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 4));
  const std::vector<Source> sources = random_sources(built, 12, 2);
  const auto distances = [&](const auto& geodesics)
  {
    const Result result =
      compute_cut_locus(built.mesh, sources, laplacian.geodesic_solver(geodesics).cut_locus_curve(Curve::MESH_EDGES));
    std::vector<double> all;
    for(const Mesh::Vertex_index v : built.vertices)
      all.push_back(result.distance(v));
    return all;
  };
  const std::vector<double> exact = distances(CGAL::Exact_geodesic_solver());
  const auto most = [&](const std::vector<double>& d)
  {
    double worst = 0.;
    for(std::size_t v = 0; v < d.size(); ++v)
      worst = (std::max)(worst, std::fabs(d[v] - exact[v]));
    return worst / mean_edge_length(built.data);
  };
  EXPECT_LT(most(distances(Plain_solver())), 1e-9);
  EXPECT_LT(most(distances(CGAL::Shortest_path_geodesic_solver())), 1e-6);
  EXPECT_LT(most(distances(CGAL::Graph_geodesic_solver())), 1.);
  EXPECT_LT(most(distances(CGAL::Heat_method_geodesic_solver<>())), 2.);
}

// Cutting along the curve makes hardly any way longer: some do become so, since each face is entered in one way, which is not
// that of the shortest path to every vertex behind it.
TEST(Laplacian_several_sources, lengthen_hardly_any_way)
{
  for(const Mesh_data& data : {jittered_sphere(16, 0.2, 1), torus(1., 0.4, 48, 24, 0.2, 4), bumpy_sphere(16, 0.5, 3),
                               split_in_plane(perforated_plate(2, 1, 2, 5))})
    for(const std::size_t k : {1, 5, 20})
    {
      const Built built(data);
      const std::vector<Source> sources = separate_sources(built, k, 3);
      std::vector<double> exact;
      SCOPED_TRACE(k);
      const auto measured = [&](const auto& parameters)
      { return checked_curves::measured(built.mesh, compute_cut_locus(built.mesh, sources, parameters), exact); };
      const auto in_edges = laplacian.cut_locus_curve(Curve::MESH_EDGES);
      const auto edges = measured(in_edges), faces = measured(laplacian.cut_locus_curve(Curve::THROUGH_FACES)),
                 heat = measured(in_edges.geodesic_solver(CGAL::Heat_method_geodesic_solver<>()));
      EXPECT_LT(edges.mean, 5e-4);
      EXPECT_LT(edges.max, 0.5);
      EXPECT_LT(faces.max, 1.);
      EXPECT_LT(heat.max, 2.) << "where one source has 1.2";
    }
}

// -- the interface -----------------------------------------------------------------------------------------------------

bool is_same(const Result& a, const Result& b)
{
  const auto labels = [](const Result& r)
  {
    std::vector<std::pair<std::array<std::size_t, 2>, Mesh::Halfedge_index>> result;
    for(const auto e : CGAL::make_range(edges(r.graph())))
      result.push_back({r.graph()[e].sources, r.graph()[e].mesh_halfedge});
    return result;
  };
  return result_numbers(a) == result_numbers(b) && labels(a) == labels(b);
}

TEST(Laplacian_several_sources, one_of_them_is_a_source_as_ever)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    const Location location(built.faces[40], {{0.2, 0.3, 0.5}});
    for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
    {
      const auto np = laplacian.cut_locus_curve(curve);
      EXPECT_TRUE(is_same(compute_cut_locus(built.mesh, location, np),
                          compute_cut_locus(built.mesh, std::vector<Location>{location}, np)));
      EXPECT_TRUE(is_same(compute_cut_locus(built.mesh, built.vertices[9], np),
                          compute_cut_locus(built.mesh, Vertices{built.vertices[9]}, np)));
    }
  }
}

TEST(Laplacian_several_sources, leave_the_parts_that_are_asked_for)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 4));
  const std::vector<Source> sources = random_sources(built, 3, 1);
  for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
  {
    Solver solver(built.mesh, laplacian);
    solver.set_sources(sources);
    const auto np = params::cut_locus_curve(curve);
    const Result all = solver.cut_locus(np), voronoi = solver.cut_locus(np.kept_part(Kept_part::VORONOI)),
                 medial = solver.cut_locus(np.kept_part(Kept_part::MEDIAL));
    EXPECT_EQ(num_edges(voronoi.graph()) + num_edges(medial.graph()), num_edges(all.graph()));
    EXPECT_GT(num_edges(voronoi.graph()), 0u);
    EXPECT_GT(num_edges(medial.graph()), 0u);
    for(const auto e : CGAL::make_range(edges(voronoi.graph())))
    {
      EXPECT_NE(voronoi.graph()[e].sources[0], voronoi.graph()[e].sources[1]);
      EXPECT_NEAR(voronoi.graph()[e].strength, 2. * pi, 1e-6);
    }
    for(const auto e : CGAL::make_range(edges(medial.graph())))
      EXPECT_EQ(medial.graph()[e].sources[0], medial.graph()[e].sources[1]);
    for(const auto v : CGAL::make_range(vertices(voronoi.graph())))
      EXPECT_GT(out_degree(v, voronoi.graph()), 1u) << "on a closed surface it has no ends";
  }
  const Result none = compute_cut_locus(built.mesh, built.vertices[0],
                                        laplacian.kept_part(Kept_part::VORONOI).cut_locus_curve(Curve::MESH_EDGES));
  EXPECT_EQ(num_edges(none.graph()), 0u);
  EXPECT_EQ(num_vertices(none.graph()), 1u);
}

TEST(Laplacian_several_sources, no_threshold_removes_what_is_between_two)
{
  const Built built(bumpy_sphere(10, 0.5, 3));
  Solver solver(built.mesh, laplacian);
  solver.set_sources(random_sources(built, 6, 3));
  const std::size_t all = num_edges(solver.cut_locus(mesh_edges.kept_part(Kept_part::VORONOI)).graph());
  const Result strong = solver.cut_locus(
    mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(3.14).minimum_branch_edges(1000)));
  EXPECT_EQ(num_edges(strong.graph()), all) << "on a sphere nothing else has to stay";
}

TEST(Laplacian_several_sources, without_a_face_to_themselves_are_refused)
{
  const Built built(sphere(4));
  const Mesh::Face_index f = built.faces[5];
  const std::vector<Location> both = {Location(f, {{0.3, 0.3, 0.4}}), Location(f, {{0.4, 0.3, 0.3}})};
  expect_refused([&] { compute_cut_locus(built.mesh, both, laplacian.cut_locus_curve(Curve::MESH_EDGES)); },
                 Cause::NO_FACE_AT_SOURCE, {"Default_method()"});
}

} // namespace

} // namespace test_laplacian_several_sources
