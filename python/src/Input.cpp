// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Input.h"

#include "../../demo/Surface_mesh_cut_locus/Input_mesh.h"
#include "../../demo/Surface_mesh_cut_locus/weld.h"

#include <CGAL/Cut_loci/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using CGAL::Cut_loci::Cause;
using CGAL::Cut_loci::Invalid_input;

namespace {

std::string face_name(std::size_t f)
{
  return "face #" + std::to_string(f);
}

// Why the mesh does not take face `last` after those before it.
[[noreturn]] void throw_cause(const Mesh& mesh, const Arrays& arrays, std::size_t last)
{
  const std::array<std::uint32_t, 3>& face = arrays.faces[last];
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::uint32_t v = face[i], w = face[(i + 1) % 3];
    if(v == w)
      throw Invalid_input(Cause::NO_TRIANGLE, face_name(last) + " has vertex #" + std::to_string(v) + " twice");
    const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(v), Mesh::Vertex_index(w));
    if(h != Mesh::null_halfedge() && !mesh.is_border(h))
      throw Invalid_input(Cause::NON_MANIFOLD,
                          face_name(mesh.face(h)) + " and " + face_name(last) + " run along the edge from vertex #" +
                            std::to_string(v) + " to vertex #" + std::to_string(w) +
                            " in the same direction: the edge has more than two faces, or they are not oriented alike");
  }
  throw Invalid_input(Cause::NON_MANIFOLD,
                      "a vertex of " + face_name(last) + " is not manifold: its faces form several fans");
}

void check_index(std::int64_t i, std::size_t size, const std::string& kind, const std::string& plural)
{
  if(i < 0 || static_cast<std::uint64_t>(i) >= size)
    throw Invalid_input(Cause::INVALID_SOURCE, "there is no " + kind + " #" + std::to_string(i) + ": the mesh has " +
                                                 std::to_string(size) + " " + plural);
}

template <typename Faces>
Polygon_soup polygon_soup(std::vector<Kernel::Point_3> points, const Faces& faces)
{
  Polygon_soup soup;
  soup.points = std::move(points);
  soup.polygons.reserve(faces.size());
  for(const auto& face : faces)
    soup.polygons.emplace_back(face.begin(), face.end());
  return soup;
}

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// The opposite of each halfedge, 3 f + i being the one of face f that leaves its vertex i, or `none` at the border. Nothing if
// that is not so of all edges.
std::vector<std::uint32_t> opposites(const Arrays& arrays)
{
  const std::size_t n = 3 * arrays.faces.size();
  // those of a vertex, the smaller one of both ends, are in a list; the larger one, doubled, has a bit for the direction
  std::vector<std::uint32_t> result(n, none), last(arrays.points.size(), none), previous(n), key(n);
  std::uint32_t h = 0;
  for(const std::array<std::uint32_t, 3>& face : arrays.faces)
    for(std::size_t i = 0; i < 3; ++i, ++h)
    {
      const std::uint32_t v = face[i], w = face[i == 2 ? 0 : i + 1];
      if(v == w)
        return {};
      std::uint32_t& newest = last[std::min(v, w)];
      key[h] = 2 * std::max(v, w) + (v < w);
      for(std::uint32_t g = newest; g != none; g = previous[g])
        if((key[g] | 1) == (key[h] | 1))
        {
          if(key[g] == key[h] || result[g] != none)
            return {};
          result[g] = h;
          result[h] = g;
        }
      previous[h] = newest;
      newest = h;
    }
  return result;
}

// Whether the faces at each vertex form one fan: all halfedges that lead there come one after the other.
bool has_one_fan_each(const Mesh& mesh)
{
  std::size_t number = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(const Mesh::Halfedge_index first = mesh.halfedge(v); first != Mesh::null_halfedge())
    {
      Mesh::Halfedge_index h = first;
      do
      {
        h = mesh.opposite(mesh.next(h));
        ++number;
      } while(h != first);
    }
  return number == mesh.number_of_halfedges();
}

// The mesh with the numbers that adding face after face gives, in half of the time; null if one of them can not be added, or
// one vertex has several fans: which is told, or taken, face by face.
std::shared_ptr<Mesh> make_mesh_at_once(const Arrays& arrays)
{
  const std::vector<std::uint32_t> opposite = opposites(arrays);
  const auto n = static_cast<std::uint32_t>(opposite.size());
  if(n != 3 * arrays.faces.size())
    return nullptr;
  std::vector<Mesh::Halfedge_index> halfedge(n);
  Mesh::size_type edges = 0;
  for(std::uint32_t h = 0; h < n; ++h)
    halfedge[h] =
      opposite[h] < h ? Mesh::Halfedge_index(halfedge[opposite[h]].idx() + 1) : Mesh::Halfedge_index(2 * edges++);
  auto mesh = std::make_shared<Mesh>();
  mesh->resize(static_cast<Mesh::size_type>(arrays.points.size()), edges, n / 3);
  for(Mesh::size_type v = 0; v < arrays.points.size(); ++v)
    mesh->point(Mesh::Vertex_index(v)) = arrays.points[v];
  std::vector<Mesh::Halfedge_index> along_border(arrays.points.size(), Mesh::null_halfedge()); // by where they start
  for(std::uint32_t f = 0, h = 0; f < arrays.faces.size(); ++f)
  {
    mesh->set_halfedge(Mesh::Face_index(f), halfedge[h]);
    for(std::uint32_t i = 0; i < 3; ++i, ++h)
    {
      const std::uint32_t next = i == 2 ? 0 : i + 1;
      const Mesh::Vertex_index v(arrays.faces[f][i]), w(arrays.faces[f][next]);
      mesh->set_target(halfedge[h], w);
      mesh->set_face(halfedge[h], Mesh::Face_index(f));
      mesh->set_next(halfedge[h], halfedge[3 * f + next]);
      if(opposite[h] != none)
      {
        if(mesh->halfedge(w) == Mesh::null_halfedge())
          mesh->set_halfedge(w, halfedge[h]);
        continue;
      }
      const Mesh::Halfedge_index border = mesh->opposite(halfedge[h]);
      mesh->set_target(border, v);
      mesh->set_face(border, Mesh::null_face());
      mesh->set_halfedge(v, border);
      if(along_border[w] != Mesh::null_halfedge())
        return nullptr;
      along_border[w] = border;
    }
  }
  for(const Mesh::Halfedge_index h : along_border)
    if(h != Mesh::null_halfedge())
      mesh->set_next(h, along_border[mesh->target(h)]);
  return has_one_fan_each(*mesh) ? mesh : nullptr;
}

Mesh::Vertex_index vertex_at(const Mesh& mesh, std::int64_t v)
{
  check_index(v, mesh.number_of_vertices(), "vertex", "vertices");
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(v));
}

} // namespace

std::shared_ptr<const Mesh> make_mesh(const Arrays& arrays)
{
  if(std::shared_ptr<Mesh> mesh = make_mesh_at_once(arrays))
    return mesh;
  const auto mesh = std::make_shared<Mesh>();
  mesh->reserve(static_cast<Mesh::size_type>(arrays.points.size()),
                static_cast<Mesh::size_type>(arrays.points.size() + arrays.faces.size()),
                static_cast<Mesh::size_type>(arrays.faces.size()));
  for(const Kernel::Point_3& p : arrays.points)
    mesh->add_vertex(p);
  for(std::size_t f = 0; f < arrays.faces.size(); ++f)
  {
    const std::array<std::uint32_t, 3>& t = arrays.faces[f];
    const bool is_triangle = t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    const Mesh::Face_index face =
      is_triangle ? mesh->add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]))
                  : Mesh::null_face();
    if(face == Mesh::null_face())
      throw_cause(*mesh, arrays, f);
    Mesh::Halfedge_index h = mesh->halfedge(face);
    while(mesh->source(h) != Mesh::Vertex_index(t[0]))
      h = mesh->next(h);
    mesh->set_halfedge(face, h);
  }
  return mesh;
}

Welded weld(const Arrays& arrays)
{
  Welded result;
  try
  {
    const Input_mesh input = make_mesh(polygon_soup(arrays.points, arrays.faces), Repair::WELD, "the faces");
    const Mesh& mesh = input.mesh;
    std::vector<std::int64_t> number(mesh.number_of_vertices(), -1); // without vertices of no face
    for(const Mesh::Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
      {
        number[v] = static_cast<std::int64_t>(result.arrays.points.size());
        result.arrays.points.push_back(mesh.point(v));
      }
    for(const Mesh::Vertex_index v : input.vertex)
      result.vertex.push_back(v == Mesh::null_vertex() ? -1 : number[v]);
    for(const Mesh::Face_index f : mesh.faces())
    {
      std::array<std::uint32_t, 3> face;
      std::size_t corners = 0;
      for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        face[corners++] = static_cast<std::uint32_t>(number[v]);
      result.arrays.faces.push_back(face);
    }
  }
  catch(const Invalid_input&)
  {
    throw;
  }
  catch(const std::runtime_error& error) // in the program's words: "'the faces': ..."
  {
    throw Invalid_input(Cause::OTHER, error.what());
  }
  return result;
}

std::size_t number_of_weldable_vertices(const Mesh& mesh)
{
  const auto is_at_border = [&](Mesh::Halfedge_index h) { return mesh.is_border(h); };
  const auto is_finite = [](const Kernel::Point_3& p)
  { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); };
  if(std::none_of(mesh.halfedges().begin(), mesh.halfedges().end(), is_at_border) ||
     !std::all_of(mesh.points().begin(), mesh.points().end(), is_finite)) // which is refused later
    return 0;
  std::vector<std::array<std::size_t, 3>> faces;
  faces.reserve(mesh.number_of_faces());
  for(const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    faces.push_back({{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}});
  }
  return weld(polygon_soup({mesh.points().begin(), mesh.points().end()}, faces)).merged_vertices;
}

std::vector<Source> read_sources(const Mesh& mesh, const std::vector<Source_numbers>& numbers)
{
  std::vector<Source> result;
  result.reserve(numbers.size());
  for(const Source_numbers& source : numbers)
    if(const std::int64_t* v = std::get_if<std::int64_t>(&source))
      result.emplace_back(vertex_at(mesh, *v));
    else
    {
      const auto& location = std::get<1>(source);
      check_index(location.first, mesh.number_of_faces(), "face", "faces");
      result.emplace_back(Location(Mesh::Face_index(static_cast<Mesh::size_type>(location.first)), location.second));
    }
  return result;
}

std::vector<Source_curve> read_curves(const Mesh& mesh, const std::vector<Curve_numbers>& numbers)
{
  std::vector<Source_curve> result;
  result.reserve(numbers.size());
  for(const Curve_numbers& curve : numbers)
  {
    result.emplace_back();
    for(const std::array<std::int64_t, 2>& ends : curve)
    {
      const Mesh::Vertex_index v = vertex_at(mesh, ends[0]), w = vertex_at(mesh, ends[1]);
      const Mesh::Halfedge_index h = mesh.halfedge(v, w);
      if(h == Mesh::null_halfedge())
        throw Invalid_input(Cause::INVALID_SOURCE, "source curve " + std::to_string(result.size() - 1) +
                                                     ": the mesh has no edge from vertex #" + std::to_string(ends[0]) +
                                                     " to vertex #" + std::to_string(ends[1]));
      result.back().push_back(mesh.edge(h));
    }
  }
  return result;
}

std::vector<double> lengths_of_edges(const Mesh& mesh, const std::vector<double>& of_faces)
{
  constexpr double rounding = 1e-9; // of whoever computed a length in each face: as far above that as below a use
  constexpr double unknown = -1.;
  std::vector<double> result(mesh.number_of_edges(), unknown);
  for(const Mesh::Face_index f : mesh.faces())
  {
    Mesh::Halfedge_index h = mesh.halfedge(f);
    for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
    {
      double& length = result[mesh.edge(h)];
      const double here = of_faces[3 * f + i];
      if(!(here >= 0.) || !std::isfinite(here))
        throw Invalid_input(Cause::INVALID_DISTANCE,
                            face_name(f) + " has an edge whose length is " + std::to_string(here));
      if(length == unknown)
        length = here;
      else if(std::abs(length - here) > rounding * length)
        throw Invalid_input(Cause::INVALID_DISTANCE, face_name(f) + " and " + face_name(mesh.face(mesh.opposite(h))) +
                                                       " have different lengths for their edge: " +
                                                       std::to_string(here) + " and " + std::to_string(length));
    }
  }
  return result;
}
