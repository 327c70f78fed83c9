// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CURVE_SOURCES_CASES_H
#define CURVE_SOURCES_CASES_H

#include "checked_curves.h"
#include "surface_test.h"

// What tests of sources that are curves share: curves, surfaces, and what must hold.
namespace curve_sources {

using namespace surface_test;
using checked_curves::expect_topology;
using checked_curves::measured;

inline Point to_point(const Kernel::Point_3& p)
{
  return {{p.x(), p.y(), p.z()}};
}

inline std::vector<Edges> border_loops(const Built& built)
{
  std::vector<Edges> result;
  std::set<Mesh::Halfedge_index> is_done;
  for(const Mesh::Halfedge_index first : built.mesh.halfedges())
    if(built.mesh.is_border(first) && is_done.count(first) == 0)
    {
      result.emplace_back();
      for(Mesh::Halfedge_index h = first; is_done.insert(h).second; h = built.mesh.next(h))
        result.back().push_back(built.mesh.edge(h));
    }
  return result;
}

// a path of edges of the mesh
inline Edges path(const Built& built, const std::vector<std::size_t>& along)
{
  Edges result;
  for(std::size_t i = 0; i + 1 < along.size(); ++i)
    result.push_back(built.mesh.edge(built.mesh.halfedge(built.vertices[along[i]], built.vertices[along[i + 1]])));
  return result;
}

// -- surfaces and curves ---------------------------------------------------------------------------------------------

// a convex polygon, triangulated irregularly inside: the square, sheared and with its sides on those of the polygon
inline Mesh_data rectangle(double width, std::size_t n, double jitter, unsigned seed)
{
  Mesh_data m = square(n, jitter, seed);
  for(Point& p : m.points)
    p[0] *= width;
  return m;
}

// a sphere with a circle of latitude among its edges, and the number of the first vertex of that
inline Mesh_data sphere_with_circle(std::size_t nu, std::size_t nv)
{
  Mesh_data m;
  m.points.push_back({{0., 0., 1.}});
  for(std::size_t k = 1; k < nv; ++k)
    for(std::size_t u = 0; u < nu; ++u)
    {
      const double t = pi * double(k) / double(nv), phi = 2. * pi * (double(u) + 0.1 * double(k % 3)) / double(nu);
      m.points.push_back({{std::sin(t) * std::cos(phi), std::sin(t) * std::sin(phi), std::cos(t)}});
    }
  m.points.push_back({{0., 0., -1.}});
  const auto at = [&](std::size_t k, std::size_t u) { return 1 + (k - 1) * nu + u % nu; };
  for(std::size_t u = 0; u < nu; ++u)
  {
    m.triangles.push_back({{0, at(1, u), at(1, u + 1)}});
    m.triangles.push_back({{m.points.size() - 1, at(nv - 1, u + 1), at(nv - 1, u)}});
    for(std::size_t k = 1; k + 1 < nv; ++k)
    {
      m.triangles.push_back({{at(k, u), at(k + 1, u), at(k + 1, u + 1)}});
      m.triangles.push_back({{at(k, u), at(k + 1, u + 1), at(k, u + 1)}});
    }
  }
  return m;
}

inline std::vector<std::size_t> circle(std::size_t nu, std::size_t k, std::size_t from, std::size_t number)
{
  std::vector<std::size_t> result;
  for(std::size_t u = from; u <= from + number; ++u)
    result.push_back(1 + (k - 1) * nu + u % nu);
  return result;
}

// of genus 0 to 3, with and without a border
inline std::vector<Mesh_data> surfaces()
{
  return {ellipsoid(1., 0.8, 0.6, 10, 0.2, 1),
          torus(1., 0.4, 28, 14, 0.2, 2),
          perforated_plate(2, 1, 4, 3),
          perforated_plate(3, 1, 4, 4),
          square(14, 0.2, 6),
          cylinder(2., 24, 12, 0.2, 7)};
}

// `k` paths of some edges that have no vertex in common, and none on the border
inline std::vector<Edges> random_curves(const Built& built, std::size_t k, std::size_t number_of_edges, unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<Edges> result;
  std::set<Mesh::Vertex_index> is_taken;
  while(result.size() < k)
  {
    Vertices walk(1, built.vertices[engine() % built.vertices.size()]);
    std::set<Mesh::Vertex_index> seen(walk.begin(), walk.end());
    Edges curve;
    for(std::size_t step = 0; step < 50 * number_of_edges && curve.size() < number_of_edges; ++step)
    {
      std::vector<Mesh::Halfedge_index> ways;
      for(const Mesh::Halfedge_index h : built.mesh.halfedges_around_target(built.mesh.halfedge(walk.back())))
        ways.push_back(built.mesh.opposite(h));
      const Mesh::Halfedge_index way = ways[engine() % ways.size()];
      const Mesh::Vertex_index next = built.mesh.target(way);
      if(!seen.insert(next).second)
        continue;
      curve.push_back(built.mesh.edge(way));
      walk.push_back(next);
    }
    if(curve.empty() ||
       std::any_of(seen.begin(), seen.end(), [&](auto v) { return is_taken.count(v) > 0 || built.mesh.is_border(v); }))
      continue;
    is_taken.insert(seen.begin(), seen.end());
    result.push_back(curve);
  }
  return result;
}

// paths from the border on, and parts of it
inline std::vector<Edges> curves_at_border(const Built& built, std::size_t k, std::size_t number_of_edges,
                                           unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<Edges> result;
  std::set<Mesh::Vertex_index> is_taken;
  const std::vector<Edges> loops = border_loops(built);
  while(result.size() < k)
  {
    const Edges& loop = loops[engine() % loops.size()];
    const std::size_t first = engine() % loop.size();
    Edges curve;
    if(result.size() % 2 == 0)
      for(std::size_t i = 0; i < number_of_edges; ++i)
        curve.push_back(loop[(first + i) % loop.size()]);
    else
    {
      std::set<Mesh::Vertex_index> seen;
      for(Mesh::Vertex_index v = built.mesh.vertex(loop[first], 0); curve.size() < number_of_edges;)
      {
        seen.insert(v);
        std::vector<Mesh::Halfedge_index> ways;
        for(const Mesh::Halfedge_index h : built.mesh.halfedges_around_target(built.mesh.halfedge(v)))
          if(!built.mesh.is_border(built.mesh.source(h)) && seen.count(built.mesh.source(h)) == 0)
            ways.push_back(h);
        if(ways.empty())
          break;
        const Mesh::Halfedge_index way = ways[engine() % ways.size()];
        curve.push_back(built.mesh.edge(way));
        v = built.mesh.source(way);
      }
    }
    std::set<Mesh::Vertex_index> at;
    for(const Mesh::Edge_index e : curve)
      at.insert({built.mesh.vertex(e, 0), built.mesh.vertex(e, 1)});
    if(curve.empty() || std::any_of(at.begin(), at.end(), [&](auto v) { return is_taken.count(v) > 0; }))
      continue;
    is_taken.insert(at.begin(), at.end());
    result.push_back(curve);
  }
  return result;
}

// the lower or the upper side of what `rectangle()` made of `n` by `n` squares
inline Edges side_of_square(const Built& built, std::size_t n, bool is_lower)
{
  std::vector<std::size_t> along;
  for(std::size_t i = 0; i <= n; ++i)
    along.push_back(nearest_vertex(built.data, {{2. * double(i) / double(n), is_lower ? 0. : 1., 0.}}));
  return path(built, along);
}

// Around a torus of rows of `nw` points, along it, and both as one curve.
inline std::vector<std::vector<Edges>> curves_of_torus(const Built& built, std::size_t nu, std::size_t nw)
{
  std::vector<std::size_t> around, along;
  for(std::size_t w = 0; w <= nw; ++w)
    around.push_back(w % nw);
  for(std::size_t u = 0; u <= nu; ++u)
    along.push_back((u % nu) * nw);
  Edges cross = path(built, around);
  for(const Mesh::Edge_index e : path(built, along))
    cross.push_back(e);
  return {{path(built, around)}, {path(built, along)}, {cross}};
}

// the cut locus of the border, and of points and curves
inline Result of_border(const Built& built, Method method, Curve curve = Curve::THROUGH_FACES)
{
  return compute_cut_locus(built.mesh, Vertices(),
                           params::source_border(true).cut_locus_method(method).cut_locus_curve(curve));
}

inline Result of_curves(const Built& built, const Vertices& points, const std::vector<Edges>& curves, Method method,
                        Curve curve = Curve::THROUGH_FACES)
{
  return compute_cut_locus(built.mesh, points,
                           params::source_curves(curves).cut_locus_method(method).cut_locus_curve(curve));
}

// by how much the second nearest side of a rectangle of height 1 is farther away than the nearest
inline double excess_of_second_side(const Point& p, double width)
{
  std::array<double, 4> d = {{p[0], width - p[0], p[1], 1. - p[1]}};
  std::sort(d.begin(), d.end());
  return d[1] - d[0];
}

// -- what a curve of mesh edges must be --------------------------------------------------------------------------------

inline void expect_refusal_of_mesh_edges(const Invalid_input& error, const std::string& what)
{
  EXPECT_EQ(error.cause(), Cause::NO_FACE_AT_SOURCE) << what;
  expect_has(std::string(error.what()), "Curve::THROUGH_FACES");
}

// `parameters` of `cut_locus()`; false if there are corridors that no curve of mesh edges passes, which is said
template <typename NamedParameters>
bool has_mesh_edges(const Built& built, const Solver& solver, const std::vector<Edges>& curves,
                    const NamedParameters& parameters, const std::string& what)
{
  try
  {
    const Result result = solver.cut_locus(parameters.cut_locus_curve(Curve::MESH_EDGES));
    expect_topology(built, curves, result, what);
    std::set<Mesh::Vertex_index> on_sources;
    for(const Edges& curve : curves)
      for(const Mesh::Edge_index e : curve)
        on_sources.insert({built.mesh.vertex(e, 0), built.mesh.vertex(e, 1)});
    for(const auto e : CGAL::make_range(edges(result.graph())))
      EXPECT_NE(result.graph()[e].mesh_halfedge, Mesh::null_halfedge()) << what;
    for(const auto v : CGAL::make_range(vertices(result.graph())))
      EXPECT_EQ(on_sources.count(result.graph()[v].mesh_vertex), 0u) << what;
    return true;
  }
  catch(const Invalid_input& error)
  {
    expect_refusal_of_mesh_edges(error, what);
    return false;
  }
}

inline bool has_mesh_edges(const Built& built, const Vertices& points, const std::vector<Edges>& curves, Method method,
                           const std::string& what)
{
  Solver solver(built.mesh, by(method));
  try
  {
    solver.set_sources(points, params::source_curves(curves));
  }
  catch(const Invalid_input& error) // by the method LAPLACIAN, which starts with edges of the mesh
  {
    expect_refusal_of_mesh_edges(error, what);
    return false;
  }
  const bool result = has_mesh_edges(built, solver, curves, params::kept_part(Kept_part::ALL), what);
  const Method long_branches = std::visit([](auto m) -> Method { return m.minimum_branch_edges(3); }, method);
  EXPECT_EQ(has_mesh_edges(built, solver, curves, by(long_branches), what + ", long branches"), result);
  return result;
}

} // namespace curve_sources

#endif // CURVE_SOURCES_CASES_H
