// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_DIVIDED_MESH_H
#define CGAL_CUT_LOCI_GRAPH_DIVIDED_MESH_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/insert_vertex.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is a mesh with a vertex more at each of several sources that is at none, and on long edges, and the way back to the mesh
 * without them. Faces are divided in their plane, which changes nothing else. A cell of a source inside a face may be enclosed
 * by others and touch no edge: with all sources at vertices, all paths enter a face through its boundary.
 */
class Divided_mesh
{
public:
  /// The longest edges are halved until none is longer than `longest`, or that has added as many vertices as there were.
  Divided_mesh(const Indexed_triangle_mesh& without, const std::vector<Indexed_source>& sources,
               double longest = HUGE_VAL)
    : without_(without), mesh_(without), face_(without.number_of_faces()), halfedge_(without.number_of_halfedges())
  {
    std::iota(face_.begin(), face_.end(), Index(0));
    std::iota(halfedge_.begin(), halfedge_.end(), Index(0));
    for(const Indexed_source& source : sources)
    {
      vertices_.push_back(source.vertex != null_index ? source.vertex : mesh_.number_of_vertices());
      if(source.vertex == null_index)
        insert(source.location, located(source.location));
    }
    divide_long_edges(longest);
    if(!inserted_.empty() && needs_mollification(mesh_)) // sources that are close to each other, or to an edge
      mesh_.lengths = Mollification(mesh_).lengths;
    parts_ = Compressed_rows<Index>(without_.number_of_halfedges(),
                                    [this](const auto& add)
                                    {
      for(Index h = 0; h < halfedge_.size(); ++h)
        if(halfedge_[h] != null_index)
          add(halfedge_[h], h);
    });
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  /// the vertices of the sources
  const std::vector<Index>& vertices() const { return vertices_; }

  /// tells of a face of the mesh without them whether there are some in it
  bool is_divided(Index f) const { return parts_of_face_.count(f) > 0; }

  /// the parts of a halfedge of the mesh without them
  Compressed_rows<Index>::Row parts(Index h) const { return parts_[h]; }

  /// curves of that mesh as ones of this
  std::vector<Indexed_curve> divided(const std::vector<Indexed_curve>& curves) const
  {
    std::vector<Indexed_curve> result(curves.size());
    for(std::size_t i = 0; i < curves.size(); ++i)
      for(Index h : curves[i].halfedges)
        result[i].halfedges.insert(result[i].halfedges.end(), parts_[h].begin(), parts_[h].end());
    return result;
  }

  /// and points
  std::vector<Indexed_source> divided(std::vector<Indexed_source> points) const
  {
    for(Indexed_source& point : points)
      point.location = located(point.location);
    return points;
  }

  /// a location of the mesh without them in one of the parts of its face, as far inside as there is one
  Indexed_location located(const Indexed_location& at) const
  {
    const auto parts = parts_of_face_.find(at.face);
    if(parts == parts_of_face_.end())
      return at;
    Indexed_location best;
    double most = -1e300;
    for(Index f : parts->second)
    {
      std::array<Coordinates, 3> corners;
      for(std::size_t i = 0; i < 3; ++i)
        corners[i] = coordinates(mesh_.triangles[f][i], at.face);
      const double area = twice_area(corners[0], corners[1], corners[2]);
      Indexed_location here;
      here.face = f;
      for(std::size_t i = 0; i < 3; ++i)
        here.coordinates[i] = twice_area(at.coordinates, corners[(i + 1) % 3], corners[(i + 2) % 3]) / area;
      const double least = *std::min_element(here.coordinates.begin(), here.coordinates.end());
      if(least > most)
      {
        most = least;
        best = here;
      }
    }
    normalize(best.coordinates, rounding); // on an edge, or at a vertex
    return best;
  }

  /// a curve through the faces, and the face of each of its edges, becomes one of the mesh without them
  void to_whole(Indexed_cut_locus& curve, std::vector<Index>& face) const
  {
    for(Indexed_cut_locus::Node& node : curve.nodes)
    {
      node.location = location(node.location);
      if(node.vertex != null_index && node.vertex >= without_.number_of_vertices())
        node.vertex = null_index;
    }
    for(Indexed_cut_locus::Edge& e : curve.edges)
      if(e.halfedge != null_index)
      {
        const Index h = halfedge_[e.halfedge];
        e.halfedge = h != null_index && parts_.size(h) == 1 ? h : null_index;
      }
    for(Index& f : face)
      f = face_[f];
  }

private:
  using Coordinates = std::array<double, 3>;

  /// of a vertex in a face of the mesh without them
  Coordinates coordinates(Index v, Index f) const
  {
    Coordinates result = {{0., 0., 0.}};
    const Indexed_triangle_mesh::Triangle& t = without_.triangles[f];
    if(v < without_.number_of_vertices())
    {
      for(std::size_t i = 0; i < 3; ++i)
        result[i] = t[i] == v ? 1. : 0.;
      return result;
    }
    const Indexed_location& at = inserted_[v - without_.number_of_vertices()];
    if(at.face == f)
      return at.coordinates;
    for(std::size_t i = 0; i < 3; ++i) // on an edge of both
      for(std::size_t j = 0; j < 3; ++j)
        if(without_.triangles[at.face][j] == t[i])
          result[i] = at.coordinates[j];
    return result;
  }

  Indexed_location location(const Indexed_location& with) const
  {
    Indexed_location result;
    result.face = face_[with.face];
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Coordinates corner = coordinates(mesh_.triangles[with.face][i], result.face);
      for(std::size_t j = 0; j < 3; ++j)
        result.coordinates[j] += with.coordinates[i] * corner[j];
    }
    return result;
  }

  void divide_long_edges(double longest)
  {
    std::priority_queue<std::pair<double, Index>> queue;
    const auto push = [&](Index h)
    {
      if(const double length = edge_length(mesh_, h); length > longest)
        queue.push({length, h});
    };
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      push(h);
    while(!queue.empty() && inserted_.size() < without_.number_of_vertices())
    {
      const auto [length, h] = queue.top();
      queue.pop();
      if(edge_length(mesh_, h) == length) // else another one by now
        for(const Face_at_inserted_vertex& f : insert(location(location_on(h, 0.5)), location_on(h, 0.5)))
          for(Index g = 3 * f.face; g < 3 * f.face + 3; ++g)
            push(g);
    }
  }

  /// a vertex at a location of the mesh without them, which is at `place`
  std::vector<Face_at_inserted_vertex> insert(const Indexed_location& at, const Indexed_location& place)
  {
    if(vertex_of(mesh_, place) != null_index)
      throw Invalid_input(Cause::SAME_SOURCES, "two sources in a face are at the same point, up to rounding");
    inserted_.push_back(at);
    // what the faces that are divided, and their halfedges, are part of
    std::array<Index, 2> replaced = {{place.face, null_index}};
    for(Index i = 0; i < 3; ++i)
      if(place.coordinates[(i + 2) % 3] == 0. && mesh_.opposite[3 * place.face + i] != null_index)
        replaced[1] = mesh_.opposite[3 * place.face + i] / 3;
    std::array<Index, 2> whole = {{null_index, null_index}};
    std::array<std::array<Index, 3>, 2> sides;
    for(std::size_t k = 0; k < 2 && replaced[k] != null_index; ++k)
    {
      whole[k] = face_[replaced[k]];
      for(std::size_t i = 0; i < 3; ++i)
        sides[k][i] = halfedge_[3 * replaced[k] + i];
      parts_of_face_[whole[k]].erase(replaced[k]);
    }
    std::vector<Face_at_inserted_vertex> faces = insert_vertex_into(mesh_, place);
    face_.resize(mesh_.number_of_faces());
    halfedge_.resize(mesh_.number_of_halfedges());
    for(const Face_at_inserted_vertex& f : faces)
    {
      const std::size_t k = f.base / 3 == replaced[0] ? 0 : 1;
      face_[f.face] = whole[k];
      parts_of_face_[whole[k]].insert(f.face);
      halfedge_[3 * f.face + 1] = sides[k][f.base % 3];
      // a spoke is along an edge of the mesh if no face is over that edge
      const Index before = (f.base % 3 + 2) % 3, after = (f.base % 3 + 1) % 3;
      const auto is_divided = [&](Index side)
      {
        return std::none_of(faces.begin(), faces.end(),
                            [&](const Face_at_inserted_vertex& g) { return g.base == 3 * replaced[k] + side; });
      };
      halfedge_[3 * f.face] = is_divided(before) ? sides[k][before] : null_index;
      halfedge_[3 * f.face + 2] = is_divided(after) ? sides[k][after] : null_index;
    }
    return faces;
  }

  static constexpr double rounding = 1e-12; // of barycentric coordinates, with some room

  static double twice_area(const Coordinates& a, const Coordinates& b, const Coordinates& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  const Indexed_triangle_mesh& without_;
  Indexed_triangle_mesh mesh_;
  std::vector<Index> vertices_;
  std::vector<Indexed_location> inserted_;                   // of the vertices that come last
  std::vector<Index> face_, halfedge_;                       // that each is part of, the latter may be null
  std::unordered_map<Index, std::set<Index>> parts_of_face_; // of those that are divided
  Compressed_rows<Index> parts_;                             // of each halfedge of the mesh without them
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_DIVIDED_MESH_H
