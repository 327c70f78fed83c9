// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Input.h"

#include <CGAL/Cut_loci/Invalid_input.h>

#include <string>

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
      throw Invalid_input(face_name(last) + " has vertex #" + std::to_string(v) + " twice");
    const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(v), Mesh::Vertex_index(w));
    if(h != Mesh::null_halfedge() && !mesh.is_border(h))
      throw Invalid_input(face_name(mesh.face(h)) + " and " + face_name(last) + " run along the edge from vertex #" +
                          std::to_string(v) + " to vertex #" + std::to_string(w) +
                          " in the same direction: the edge has more than two faces, or they are not oriented alike");
  }
  throw Invalid_input("a vertex of " + face_name(last) + " is not manifold: its faces form several fans");
}

} // namespace

std::shared_ptr<const Mesh> make_mesh(const Arrays& arrays)
{
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

std::vector<Source> read_sources(const Mesh& mesh, const std::vector<Source_numbers>& numbers)
{
  std::vector<Source> result;
  result.reserve(numbers.size());
  const auto check = [](std::int64_t i, std::size_t size, const std::string& kind, const std::string& plural)
  {
    if(i < 0 || static_cast<std::uint64_t>(i) >= size)
      throw Invalid_input("there is no " + kind + " #" + std::to_string(i) + ": the mesh has " + std::to_string(size) +
                          " " + plural);
  };
  for(const Source_numbers& source : numbers)
    if(const std::int64_t* v = std::get_if<std::int64_t>(&source))
    {
      check(*v, mesh.number_of_vertices(), "vertex", "vertices");
      result.emplace_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(*v)));
    }
    else
    {
      const auto& location = std::get<1>(source);
      check(location.first, mesh.number_of_faces(), "face", "faces");
      result.emplace_back(Location(Mesh::Face_index(static_cast<Mesh::size_type>(location.first)), location.second));
    }
  return result;
}
