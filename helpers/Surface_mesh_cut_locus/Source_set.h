// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_SOURCE_SET_H
#define CGAL_CUT_LOCI_HELPERS_SOURCE_SET_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/reading/read_curves.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <set>
#include <vector>

namespace curve_measures {

// the edges of each of some curves
template <typename TriangleMesh>
using Edge_curves = std::vector<std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor>>;

namespace internal {

// The sources of a cut locus in the indices of their component: points, and curves of its edges.
struct Source_set
{
  using Index = CGAL::Cut_loci::Index;
  using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;

  std::vector<CGAL::Cut_loci::Indexed_source> points;
  std::vector<CGAL::Cut_loci::Indexed_curve> curves;

  std::set<Index> vertices_of_curves(const Mesh& mesh) const
  {
    std::set<Index> result;
    for(const CGAL::Cut_loci::Indexed_curve& curve : curves)
      for(Index h : curve.halfedges)
        result.insert({mesh.source(h), mesh.target(h)});
    return result;
  }

  // The halfedges of the curves, and the opposite ones, on a mesh of which each face is a part of that with the number
  // `face_origin`: as many parts of each as its face has on that side.
  std::vector<Index> lines(const Mesh& mesh, const Mesh& refined, const std::vector<Index>& face_origin) const
  {
    std::set<Index> wanted;
    for(const CGAL::Cut_loci::Indexed_curve& curve : curves)
      for(Index h : curve.halfedges)
        for(Index side : {h, mesh.opposite[h]})
          if(side != CGAL::Cut_loci::null_index)
            wanted.insert(side);
    std::set<Index> faces;
    for(Index h : wanted)
      faces.insert(h / 3);
    std::vector<std::vector<Index>> outline(
      mesh.number_of_faces()); // of the parts of a face: its halfedges, in any order
    for(Index h = 0; h < refined.number_of_halfedges() && !wanted.empty(); ++h)
    {
      const Index f = face_origin[h / 3];
      if(faces.count(f) > 0 && (refined.is_border_edge(h) || face_origin[refined.opposite[h] / 3] != f))
        outline[f].push_back(h);
    }
    std::vector<Index> result;
    for(Index h : wanted)
      for(Index v = mesh.source(h); v != mesh.target(h); v = refined.target(result.back()))
        result.push_back(*std::find_if(outline[h / 3].begin(), outline[h / 3].end(),
                                       [&](Index part) { return refined.source(part) == v; }));
    return result;
  }

  // the faces that the points are in, or at
  std::vector<Index> faces_at_points(const Mesh& mesh) const
  {
    std::vector<Index> result;
    std::set<Index> at;
    for(const CGAL::Cut_loci::Indexed_source& source : points)
    {
      result.push_back(source.location.face);
      const Index on_edge = CGAL::Cut_loci::internal::edge_of(source.location);
      if(source.vertex != CGAL::Cut_loci::null_index)
        at.insert(source.vertex);
      else if(on_edge != CGAL::Cut_loci::null_index && !mesh.is_border_edge(on_edge))
        result.push_back(mesh.opposite[on_edge] / 3);
    }
    for(Index h = 0; h < mesh.number_of_halfedges() && !at.empty(); ++h)
      if(at.count(mesh.source(h)) > 0)
        result.push_back(h / 3);
    return result;
  }
};

template <typename TriangleMesh>
Source_set source_set(const TriangleMesh& tm, const CGAL::Cut_loci::internal::Read_triangle_mesh<TriangleMesh>& read,
                      const CGAL::Cut_loci::internal::Curve_on_component& on, const Edge_curves<TriangleMesh>& curves)
{
  using CGAL::Cut_loci::Index;
  Source_set result;
  result.points.assign(on.curve.sources.begin(), on.curve.sources.end() - static_cast<std::ptrdiff_t>(curves.size()));
  result.curves = CGAL::Cut_loci::internal::read_curves(tm, read, curves);
  std::vector<Index> face(read.mesh.number_of_faces(), CGAL::Cut_loci::null_index);
  for(Index f = 0; f < on.component.faces.size(); ++f)
    face[on.component.faces[f]] = f;
  for(CGAL::Cut_loci::Indexed_curve& curve : result.curves)
    for(Index& h : curve.halfedges)
      h = 3 * face[h / 3] + h % 3;
  return result;
}

} // namespace internal
} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_SOURCE_SET_H
