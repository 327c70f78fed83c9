// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CURVE_SOURCES_CASES_H
#define CURVE_SOURCES_CASES_H

#include "surface_test.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

// What tests of sources that are curves share: curves, surfaces, and what must hold.
namespace curve_sources {

using namespace surface_test;

inline Point to_point(const Kernel::Point_3& p)
{
  return {{p.x(), p.y(), p.z()}};
}

inline std::size_t number_of_leaves(const Result& result)
{
  std::size_t n = 0;
  for(const auto v : CGAL::make_range(vertices(result.graph())))
    n += degree(v, result.graph()) == 1;
  return n;
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

// -- the topology ------------------------------------------------------------------------------------------------------

/*
 * The surface, with all border loops closed that are no sources, without its sources shrinks to the graph: so both have
 * the same components and the same Euler characteristic. That of the graph is the one of the surface minus those of the
 * sources: 1 for a point or an arc, 0 for a loop.
 */
struct Topology
{
  Topology(const Built& built, const std::vector<Edges>& curves, const Result& result)
    : mesh(built.mesh), nodes(num_vertices(result.graph()) + border_loops(built).size()), faces(mesh.number_of_faces())
  {
    for(const Edges& curve : curves)
      on_curve.insert(curve.begin(), curve.end());
    measure_graph(built, result);
    measure_surface(built, curves, result.number_of_sources() - curves.size());
  }

  long graph_components = 0, graph_characteristic = 0, surface_components = 0, surface_characteristic = 0;

private:
  bool is_source(const Edges& loop) const
  {
    return std::all_of(loop.begin(), loop.end(), [&](Mesh::Edge_index e) { return on_curve.count(e) > 0; });
  }

  // what a curve of mesh edges has along a border loop, which is one node
  bool is_along_border(const Result::Vertex& a, const Result::Vertex& b) const
  {
    if(a.mesh_vertex == Mesh::null_vertex() || b.mesh_vertex == Mesh::null_vertex())
      return false;
    const Mesh::Halfedge_index h = mesh.halfedge(a.mesh_vertex, b.mesh_vertex);
    return h != Mesh::null_halfedge() && mesh.is_border(mesh.edge(h));
  }

  void measure_graph(const Built& built, const Result& result)
  {
    const auto& graph = result.graph();
    const std::size_t n = num_vertices(graph);
    std::map<Mesh::Edge_index, std::size_t> loop_at;
    std::map<Mesh::Vertex_index, std::size_t> loop_at_vertex;
    const std::vector<Edges> loops = border_loops(built);
    std::vector<unsigned char> is_met(loops.size(), 0);
    for(std::size_t i = 0; i < loops.size(); ++i)
      for(const Mesh::Edge_index e : loops[i])
        if(on_curve.count(e) == 0)
        {
          loop_at[e] = i;
          loop_at_vertex[mesh.vertex(e, 0)] = loop_at_vertex[mesh.vertex(e, 1)] = i;
        }
    for(const Mesh::Edge_index e : on_curve) // where a source has corners, curves may end in them
      for(const Mesh::Vertex_index v : {mesh.vertex(e, 0), mesh.vertex(e, 1)})
        loop_at_vertex.erase(v);
    for(const auto e : CGAL::make_range(edges(graph)))
    {
      nodes.unite(source(e, graph), target(e, graph));
      if(!is_along_border(graph[source(e, graph)], graph[target(e, graph)]))
        --graph_characteristic;
    }
    for(const auto v : CGAL::make_range(vertices(graph)))
    {
      ++graph_characteristic;
      const std::size_t loop = loop_of(graph[v], loop_at, loop_at_vertex);
      if(loop == loops.size() || loop == none)
        continue;
      is_met[loop] = 1;
      nodes.unite(v, n + loop);
      --graph_characteristic;
    }
    std::set<std::size_t> parts;
    for(std::size_t i = 0; i < n; ++i)
      parts.insert(nodes.find(i));
    for(std::size_t i = 0; i < loops.size(); ++i)
      if(is_met[i])
        ++graph_characteristic;
    graph_components = long(parts.size());
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::size_t loop_of(const Result::Vertex& x, const std::map<Mesh::Edge_index, std::size_t>& loop_at,
                      const std::map<Mesh::Vertex_index, std::size_t>& loop_at_vertex) const
  {
    if(x.mesh_vertex != Mesh::null_vertex())
    {
      const auto found = loop_at_vertex.find(x.mesh_vertex);
      return found != loop_at_vertex.end() ? found->second : none;
    }
    Mesh::Halfedge_index h = mesh.halfedge(x.location.first);
    for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h))
      if(x.location.second[(k + 2) % 3] == 0.)
      {
        const auto found = loop_at.find(mesh.edge(h));
        return found != loop_at.end() ? found->second : none;
      }
    return none;
  }

  void measure_surface(const Built& built, const std::vector<Edges>& curves, std::size_t number_of_points)
  {
    surface_characteristic = long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) +
                             long(mesh.number_of_faces()) - long(number_of_points);
    for(const Edges& loop : border_loops(built))
      surface_characteristic += !is_source(loop);
    for(const Edges& curve : curves)
    {
      std::set<Mesh::Vertex_index> at;
      for(const Mesh::Edge_index e : curve)
        at.insert({mesh.vertex(e, 0), mesh.vertex(e, 1)});
      surface_characteristic -= long(at.size()) - long(std::set<Mesh::Edge_index>(curve.begin(), curve.end()).size());
    }
    for(const Mesh::Edge_index e : mesh.edges())
      if(!mesh.is_border(e) && on_curve.count(e) == 0)
        faces.unite(mesh.face(mesh.halfedge(e, 0)), mesh.face(mesh.halfedge(e, 1)));
    for(const Edges& loop : border_loops(built)) // a disk that closes it joins the faces at it
      if(!is_source(loop))
        for(const Mesh::Edge_index e : loop)
          faces.unite(face_at(e), face_at(loop.front()));
    std::set<std::size_t> parts;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      parts.insert(faces.find(f));
    surface_components = long(parts.size());
  }

  std::size_t face_at(Mesh::Edge_index e) const
  {
    const Mesh::Halfedge_index h = mesh.halfedge(e, 0);
    return mesh.is_border(h) ? mesh.face(mesh.opposite(h)) : mesh.face(h);
  }

  const Mesh& mesh;
  std::set<Mesh::Edge_index> on_curve;
  topology_checker::Union_find nodes, faces;
};

inline void expect_topology(const Built& built, const std::vector<Edges>& curves, const Result& result,
                            const std::string& what)
{
  const Topology topology(built, curves, result);
  EXPECT_EQ(topology.graph_components, topology.surface_components) << what;
  EXPECT_EQ(topology.graph_characteristic, topology.surface_characteristic) << what;
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
    std::vector<Mesh::Vertex_index> walk(1, built.vertices[engine() % built.vertices.size()]);
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

// -- what a curve of mesh edges must be --------------------------------------------------------------------------------

inline void expect_refusal_of_mesh_edges(const Invalid_input& error, const std::string& what)
{
  EXPECT_EQ(error.cause(), Cause::NO_FACE_AT_SOURCE) << what;
  EXPECT_NE(std::string(error.what()).find("Curve::THROUGH_FACES"), std::string::npos) << error.what();
}

// `parameters` of `cut_locus()`; false if there are corridors that no curve of mesh edges passes, which is said
template <typename NamedParameters>
bool has_mesh_edges(const Built& built, const Solver& solver, const std::vector<Edges>& curves,
                    const NamedParameters& parameters, const std::string& what)
{
  try
  {
    const Result result = solver.cut_locus(parameters.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
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
  Solver solver(built.mesh, params::cut_locus_method(method));
  try
  {
    solver.set_sources(points, params::source_curves(curves));
  }
  catch(const Invalid_input& error) // by the method LAPLACIAN, which starts with edges of the mesh
  {
    expect_refusal_of_mesh_edges(error, what);
    return false;
  }
  const bool result = has_mesh_edges(built, solver, curves, params::kept_part(CGAL::Cut_loci::Kept_part::ALL), what);
  const Method long_branches = std::visit([](auto m) -> Method { return m.minimum_branch_edges(3); }, method);
  EXPECT_EQ(has_mesh_edges(built, solver, curves, params::cut_locus_method(long_branches), what + ", long branches"),
            result);
  return result;
}

} // namespace curve_sources

#endif // CURVE_SOURCES_CASES_H
