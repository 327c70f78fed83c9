// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "border_loops.h"

#include <cstddef>
#include <map>
#include <stdexcept>

std::vector<Edge_curve> border_loops(const Mesh& mesh, const std::vector<std::uint32_t>& component_of_face,
                                     Mesh::Face_index face)
{
  const auto component_of = [&](Mesh::Face_index f)
  { return component_of_face.empty() ? std::uint32_t(0) : component_of_face[f]; };
  std::map<std::uint32_t, std::vector<Edge_curve>> loops; // of each component
  std::vector<bool> is_done(mesh.num_halfedges(), false);
  for(const Mesh::Halfedge_index start : mesh.halfedges())
  {
    if(!mesh.is_border(start) || is_done[start])
      continue;
    Edge_curve loop;
    for(Mesh::Halfedge_index h = start; !is_done[h]; h = mesh.next(h))
    {
      is_done[h] = true;
      loop.push_back(mesh.edge(h));
    }
    loops[component_of(mesh.face(mesh.opposite(start)))].push_back(loop);
  }
  std::map<std::uint32_t, std::size_t> sizes;
  for(const Mesh::Face_index f : mesh.faces())
    ++sizes[component_of(f)];
  auto found = face == Mesh::null_face() ? loops.begin() : loops.find(component_of(face));
  if(face == Mesh::null_face())
    for(auto it = loops.begin(); it != loops.end(); ++it)
      if(sizes[it->first] > sizes[found->first])
        found = it;
  if(found == loops.end())
    throw std::runtime_error("there is no border that could be a source: the surface is closed");
  return found->second;
}
