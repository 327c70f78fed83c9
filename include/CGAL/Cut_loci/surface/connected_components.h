// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_CONNECTED_COMPONENTS_H
#define CGAL_CUT_LOCI_SURFACE_CONNECTED_COMPONENTS_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Labels the faces by edge-connected component, in the order of their first faces.
inline std::vector<Index> face_components(const Indexed_triangle_mesh& mesh, Index& number_of_components,
                                          const Progress& progress = {})
{
  std::vector<Index> label(mesh.number_of_faces(), null_index), stack;
  number_of_components = 0;
  std::size_t number = 0;
  for(Index seed = 0; seed < mesh.number_of_faces(); ++seed)
  {
    if(label[seed] != null_index)
      continue;
    label[seed] = number_of_components;
    stack.push_back(seed);
    while(!stack.empty())
    {
      progress(number++, label.size());
      const Index f = stack.back();
      stack.pop_back();
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index o = mesh.opposite[h];
        if(o != null_index && label[o / 3] == null_index)
        {
          label[o / 3] = number_of_components;
          stack.push_back(o / 3);
        }
      }
    }
    ++number_of_components;
  }
  return label;
}

// The border loops, in the order of their first vertices.
inline std::vector<Indexed_curve> border_loops(const Indexed_triangle_mesh& mesh)
{
  std::vector<Indexed_curve> result;
  std::vector<Index> leaving(mesh.number_of_vertices(), null_index); // on the border
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.is_border_edge(h))
      leaving[mesh.source(h)] = h;
  std::vector<unsigned char> is_done(mesh.number_of_vertices(), 0);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if(leaving[v] == null_index || is_done[v])
      continue;
    result.emplace_back();
    for(Index w = v; leaving[w] != null_index && !is_done[w]; w = mesh.target(leaving[w]))
    {
      is_done[w] = 1;
      result.back().halfedges.push_back(leaving[w]);
    }
  }
  return result;
}

// One component of a mesh as a mesh of its own, with the way back to the indices of the whole.
struct Mesh_component
{
  Indexed_triangle_mesh mesh;
  std::vector<Index> vertices; // in order, as the faces
  std::vector<Index> faces;

  // the numbers in the whole
  Index vertex(Index local) const { return vertices[local]; }
  Index face(Index local) const { return faces[local]; }
  Index halfedge(Index local) const { return 3 * faces[local / 3] + local % 3; }
  // the numbers in the component, or null if it does not have them; of null it is null
  Index local_vertex(Index v) const { return position(vertices, v); }
  Index local_face(Index f) const { return position(faces, f); }
  Index local_halfedge(Index h) const
  {
    const Index f = h != null_index ? local_face(h / 3) : null_index;
    return f != null_index ? 3 * f + h % 3 : null_index;
  }
  Indexed_source local(Indexed_source source) const
  {
    source.location.face = local_face(source.location.face);
    source.vertex = local_vertex(source.vertex);
    return source;
  }
  Indexed_curve local(Indexed_curve curve) const
  {
    for(Index& h : curve.halfedges)
      h = local_halfedge(h);
    return curve;
  }

private:
  static Index position(const std::vector<Index>& sorted, Index global)
  {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), global);
    return found != sorted.end() && *found == global ? static_cast<Index>(found - sorted.begin()) : null_index;
  }
};

inline Mesh_component extract_component(const Indexed_triangle_mesh& mesh, const std::vector<Index>& label,
                                        Index component)
{
  Mesh_component result;
  std::vector<Index> new_vertex(mesh.number_of_vertices(), null_index), new_face(mesh.number_of_faces(), null_index);
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    if(label[f] != component)
      continue;
    new_face[f] = static_cast<Index>(result.faces.size());
    result.faces.push_back(f);
    for(Index v : mesh.triangles[f])
      new_vertex[v] = 0;
  }
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if(new_vertex[v] == null_index)
      continue;
    new_vertex[v] = static_cast<Index>(result.vertices.size());
    result.vertices.push_back(v);
    result.mesh.points.push_back(mesh.points[v]);
  }
  result.mesh.is_intrinsic = mesh.is_intrinsic;
  result.mesh.triangles.reserve(result.faces.size());
  result.mesh.opposite.reserve(3 * result.faces.size());
  for(Index f : result.faces)
  {
    const Indexed_triangle_mesh::Triangle& t = mesh.triangles[f];
    result.mesh.triangles.push_back({{new_vertex[t[0]], new_vertex[t[1]], new_vertex[t[2]]}});
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index o = mesh.opposite[h];
      result.mesh.opposite.push_back(o == null_index ? null_index : 3 * new_face[o / 3] + o % 3);
      if(!mesh.lengths.empty())
        result.mesh.lengths.push_back(mesh.lengths[h]);
    }
  }
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_CONNECTED_COMPONENTS_H
