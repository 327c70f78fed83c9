// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_TEST_H
#define CGAL_CUT_LOCI_SURFACE_TEST_H

#include "built_mesh.h"
#include "curve_length.h"
#include "refusals.h"
#include "test_meshes.h"

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/compute_cut_locus.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// What most tests on a surface include, and what they call it.
namespace surface_test {

using namespace test_meshes;
using CGAL::Cut_loci::Cause;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Default_method;
using CGAL::Cut_loci::Filter_policy;
using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::Indexed_cut_locus;
using CGAL::Cut_loci::Indexed_location;
using CGAL::Cut_loci::Indexed_source;
using CGAL::Cut_loci::Indexed_triangle_mesh;
using CGAL::Cut_loci::Invalid_input;
using CGAL::Cut_loci::Kept_part;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Mesh_connectivity;
using CGAL::Cut_loci::Method;
using CGAL::Cut_loci::null_index;
using CGAL::Cut_loci::Polyhedral_method;
using curve_length::length;
using refusals::expect_has;
using refusals::expect_refused;
using refusals::expect_words;
using refusals::message_of;
namespace params = CGAL::parameters;

inline auto by(const Method& method)
{
  return params::cut_locus_method(method);
}

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Built = Built_mesh<Mesh>;
using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;
using Cut_locus = Solver::Result;
using Result = Solver::Result;
using Geodesics = CGAL::Surface_mesh_exact_geodesics<Mesh>;
using Location = Solver::Face_location;
using Vertices = std::vector<Mesh::Vertex_index>;
using Edges = std::vector<Mesh::Edge_index>;

struct Named_mesh
{
  std::string name;
  Mesh_data data;
};

// vertex 4 is the top, 5 the bottom
inline Mesh_data octahedron(double height = 1.)
{
  return {{{{1., 0., 0.}}, {{-1., 0., 0.}}, {{0., 1., 0.}}, {{0., -1., 0.}}, {{0., 0., height}}, {{0., 0., -1.}}},
          {{{0, 2, 4}}, {{2, 1, 4}}, {{1, 3, 4}}, {{3, 0, 4}}, {{2, 0, 5}}, {{1, 2, 5}}, {{3, 1, 5}}, {{0, 3, 5}}}};
}

// the faces at vertices that `is_removed` names are gone, too
template <typename Is_removed>
Mesh_data without_vertices(Mesh_data data, const Is_removed& is_removed)
{
  const auto is_at_one = [&](const Triangle& t)
  { return std::any_of(t.begin(), t.end(), [&](std::size_t v) { return is_removed(data.points[v]); }); };
  data.triangles.erase(std::remove_if(data.triangles.begin(), data.triangles.end(), is_at_one), data.triangles.end());
  return without_isolated_vertices(data);
}

// with the numbers of the data
inline Mesh to_surface_mesh(const Mesh_data& data)
{
  return std::move(Built(data).mesh);
}

inline Kernel::Point_3 point(const Mesh& mesh, const Location& location)
{
  return CGAL::Polygon_mesh_processing::construct_point(location, mesh);
}

inline double distance(const Kernel::Point_3& p, const Kernel::Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// of a polyline
inline double length(const Mesh& mesh, const std::vector<Location>& locations)
{
  double sum = 0.;
  for(std::size_t i = 0; i + 1 < locations.size(); ++i)
    sum += distance(point(mesh, locations[i]), point(mesh, locations[i + 1]));
  return sum;
}

template <typename CutLocus>
std::size_t number_of_leaves(const CutLocus& cut_locus)
{
  std::size_t result = 0;
  for(const auto v : CGAL::make_range(vertices(cut_locus.graph())))
    result += degree(v, cut_locus.graph()) == 1;
  return result;
}

// of a connected one
template <typename CutLocus>
std::size_t number_of_cycles(const CutLocus& cut_locus)
{
  return num_edges(cut_locus.graph()) + 1 - num_vertices(cut_locus.graph());
}

inline double longest_edge(const Mesh& mesh)
{
  double result = 0.;
  for(const Mesh::Edge_index e : mesh.edges())
    result = std::max(result, CGAL::Polygon_mesh_processing::edge_length(e, mesh));
  return result;
}

inline double area(const Mesh& mesh, Mesh::Face_index f)
{
  return CGAL::Polygon_mesh_processing::face_area(f, mesh);
}

// in a face, or on an edge
inline Location random_location(const Mesh& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> u(0.05, 1.);
  const std::array<double, 3> c = {{u(random), random() % 3 == 0 ? 0. : u(random), u(random)}};
  return {Mesh::Face_index(static_cast<Mesh::size_type>(random() % mesh.number_of_faces())),
          (1. / (c[0] + c[1] + c[2])) * c};
}

} // namespace surface_test

#endif // CGAL_CUT_LOCI_SURFACE_TEST_H
