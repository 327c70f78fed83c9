// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_CURVE_REFINEMENT_H
#define CGAL_CUT_LOCI_GRAPH_CURVE_REFINEMENT_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci {

// is a mesh whose faces have been split along a curve.
struct Refined_mesh
{
  Indexed_triangle_mesh mesh; ///< its first vertices are those of the mesh before, with the same indices
  std::vector<Index> faces;   ///< for each face the one that it is a part of
  std::vector<Index> nodes;   ///< for each node of the curve its vertex
  Seams seams;                ///< the edges that the curve consists of
};

namespace internal {

// A curve through the faces is known to some hundredths of an edge: a grid of 256 moves it by less.
constexpr double default_snapping_of_curves = 1. / 256.;
constexpr Index finest_resolution = 1 << 20; // its square is far below what rounding errors spoil

inline Index resolution_of(double tolerance)
{
  if(!(tolerance >= 1. / finest_resolution && tolerance <= 0.5))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the snapping tolerance must be from 2^-20 to 0.5");
  return static_cast<Index>(std::lround(1. / tolerance));
}

class Curve_refinement
{
public:
  Curve_refinement(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   const Indexed_cut_locus& curve, Index resolution)
    : mesh_(mesh), connectivity_(connectivity), n_(static_cast<int>(resolution))
  {
    result_.mesh.points = mesh.points;
    for(const Indexed_cut_locus::Node& node : curve.nodes)
      result_.nodes.push_back(add_node(node.location));
    for(const Indexed_cut_locus::Edge& e : curve.edges)
      add_segment(e);
  }

  Refined_mesh operator()()
  {
    for(auto& segments : segments_)
      part_crossing_segments(segments.first, segments.second);
    split_faces();
    complete_sides();
    return std::move(result_);
  }

private:
  using Coordinates = std::array<int, 3>; // barycentric, with the sum n_

  // A vertex of the result where the curve is not at a vertex of the mesh.
  struct Place
  {
    Index edge = null_index; // the edge of the mesh it is on, or
    Index face = null_index; // the face it is in
    Coordinates coordinates; // in the face, or in that of the edge's halfedge
  };

  struct Segment
  {
    Index source, target; // vertices
  };

  // A halfedge of the result that waits for the one on the other side.
  struct Half_glued
  {
    Index halfedge = null_index;
  };

  // ---- rounding

  // Sums of the rounded numbers other than n_ are mended where rounding has changed most.
  Coordinates rounded(const std::array<double, 3>& x) const
  {
    Coordinates result;
    int sum = 0;
    for(int i = 0; i < 3; ++i)
      sum += result[i] = static_cast<int>(std::lround((std::max)(0., (std::min)(1., x[i])) * n_));
    for(; sum != n_; sum += sum < n_ ? 1 : -1)
    {
      int best = -1;
      const int step = sum < n_ ? 1 : -1;
      for(int i = 0; i < 3; ++i)
        if(x[i] > 0. && result[i] + step >= 0 &&
           (best < 0 || step * (x[i] * n_ - result[i]) > step * (x[best] * n_ - result[best])))
          best = i;
      result[best] += step;
    }
    return result;
  }

  Index add_node(const Indexed_location& location)
  {
    const Index f = location.face;
    const Coordinates c = rounded(location.coordinates);
    for(Index i = 0; i < 3; ++i)
      if(c[i] == n_)
        return mesh_.triangles[f][i];
    for(Index i = 0; i < 3; ++i)
      if(c[(i + 2) % 3] == 0)
        return vertex_on_edge(3 * f + i, c[(i + 1) % 3]);
    return new_vertex(f, {null_index, f, c}, {f, c});
  }

  // `part`: of n_, from the source of `h`
  Index vertex_on_edge(Index h, int part)
  {
    const Index edge = connectivity_.edge_of_halfedge[h];
    const Index first = connectivity_.halfedge_of_edge[edge];
    if(h != first)
      part = n_ - part;
    Coordinates c = {{0, 0, 0}};
    c[first % 3] = n_ - part;
    c[(first % 3 + 1) % 3] = part;
    const Index v = new_vertex(first / 3, {edge, null_index, c}, {mesh_.number_of_faces() + edge, c});
    std::vector<std::pair<int, Index>>& on_edge = on_edge_[edge];
    const auto at = std::lower_bound(on_edge.begin(), on_edge.end(), std::make_pair(part, v));
    if(at == on_edge.end() || *at != std::make_pair(part, v))
      on_edge.insert(at, {part, v});
    return v;
  }

  Index new_vertex(Index f, const Place& place, const std::pair<Index, Coordinates>& key)
  {
    const auto inserted = vertex_at_.insert({key, static_cast<Index>(result_.mesh.points.size())});
    if(inserted.second)
    {
      places_.push_back(place);
      result_.mesh.points.push_back(point_in(f, place.coordinates[0], place.coordinates[1], place.coordinates[2]));
      if(place.face != null_index)
        in_face_[f].push_back(inserted.first->second);
    }
    return inserted.first->second;
  }

  Vector point_in(Index f, double a, double b, double c) const
  {
    const Indexed_triangle_mesh::Triangle& t = mesh_.triangles[f];
    return (1. / (a + b + c)) * (a * mesh_.points[t[0]] + (b * mesh_.points[t[1]] + c * mesh_.points[t[2]]));
  }

  // ---- the faces of segments

  // the coordinates of a vertex of the result in face `f`, if it is there
  bool coordinates_in(Index f, Index v, Coordinates& result) const
  {
    result = {{0, 0, 0}};
    const Indexed_triangle_mesh::Triangle& t = mesh_.triangles[f];
    if(v < mesh_.number_of_vertices())
    {
      for(int i = 0; i < 3; ++i)
        if(t[i] == v)
        {
          result[i] = n_;
          return true;
        }
      return false;
    }
    const Place& place = places_[v - mesh_.number_of_vertices()];
    if(place.face != null_index)
    {
      result = place.coordinates;
      return place.face == f;
    }
    const Index first = connectivity_.halfedge_of_edge[place.edge];
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(connectivity_.edge_of_halfedge[h] == place.edge)
      {
        const int at_source = place.coordinates[first % 3];
        result[h % 3] = h == first ? at_source : n_ - at_source;
        result[(h % 3 + 1) % 3] = n_ - result[h % 3];
        return true;
      }
    return false;
  }

  // the faces that a vertex of the result is in, or on the border of
  std::vector<Index> faces_at(Index v) const
  {
    std::vector<Index> result;
    if(v < mesh_.number_of_vertices())
    {
      for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
        if(mesh_.source(connectivity_.ring_halfedge[k]) == v)
          result.push_back(connectivity_.ring_halfedge[k] / 3);
      return result;
    }
    const Place& place = places_[v - mesh_.number_of_vertices()];
    if(place.face != null_index)
      return {place.face};
    const Index h = connectivity_.halfedge_of_edge[place.edge];
    result.push_back(h / 3);
    if(!mesh_.is_border_edge(h))
      result.push_back(mesh_.opposite[h] / 3);
    return result;
  }

  void add_segment(const Indexed_cut_locus::Edge& e)
  {
    const Segment segment = {result_.nodes[e.source], result_.nodes[e.target]};
    if(segment.source == segment.target)
      return;
    if(e.halfedge != null_index)
    {
      segments_[e.halfedge / 3].push_back(segment);
      return;
    }
    // Along an edge of the mesh it belongs to both faces: either will do, as they are glued afterwards.
    Coordinates ignored;
    for(Index f : faces_at(segment.source))
      if(coordinates_in(f, segment.target, ignored))
      {
        segments_[f].push_back(segment);
        return;
      }
    throw Invalid_input(Cause::INVALID_CUT_LOCUS,
                        "the cut locus does not belong to the mesh: an edge of it is in no face");
  }

  // ---- crossings

  // Rounding may make segments cross each other. The point where they do is rounded, too, and becomes an end of their
  // parts. It is in the bounding boxes of both: so the sums of the extents of parts stay the same, and this ends.
  void part_crossing_segments(Index f, std::vector<Segment>& segments)
  {
    for(bool is_done = false; !is_done;)
    {
      is_done = true;
      for(std::size_t i = 1; i < segments.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
        {
          Coordinates crossing;
          if(!cross_each_other(f, segments[i], segments[j], crossing))
            continue;
          is_done = false;
          const double n = n_;
          const Index v = add_node({f, {{crossing[0] / n, crossing[1] / n, crossing[2] / n}}});
          for(std::size_t k : {i, j})
          {
            const Segment s = segments[k];
            if(v == s.source || v == s.target)
              continue;
            segments[k] = {s.source, v};
            segments.push_back({v, s.target});
          }
        }
    }
  }

  // whether two segments of a face have a point in common that is no end of either
  bool cross_each_other(Index f, const Segment& s, const Segment& t, Coordinates& crossing) const
  {
    Coordinates a, b, c, d;
    coordinates_in(f, s.source, a);
    coordinates_in(f, s.target, b);
    coordinates_in(f, t.source, c);
    coordinates_in(f, t.target, d);
    const auto side = [](const Coordinates& p, const Coordinates& q, const Coordinates& r)
    {
      return static_cast<std::int64_t>(q[1] - p[1]) * (r[2] - p[2]) -
             static_cast<std::int64_t>(q[2] - p[2]) * (r[1] - p[1]);
    };
    const std::int64_t at_c = side(a, b, c), at_d = side(a, b, d), at_a = side(c, d, a), at_b = side(c, d, b);
    if((at_c > 0) == (at_d > 0) || (at_a > 0) == (at_b > 0) || at_c == 0 || at_d == 0 || at_a == 0 || at_b == 0)
      return false;
    const double part = double(at_a) / (double(at_a) - double(at_b));
    for(int i = 1; i < 3; ++i)
    {
      const int low = (std::max)((std::min)(a[i], b[i]), (std::min)(c[i], d[i]));
      const int high = (std::min)((std::max)(a[i], b[i]), (std::max)(c[i], d[i]));
      const double x = a[i] + part * (b[i] - a[i]);
      // the first coordinate, what is left, gets no less than 0 if one of the others is rounded down
      const int most = i == 1 ? n_ : n_ - crossing[1];
      crossing[i] = (std::max)(low, (std::min)({high, most, static_cast<int>(std::lround(x))}));
    }
    crossing[0] = n_ - crossing[1] - crossing[2];
    return true;
  }

  // ---- splitting

  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Face_base =
    CGAL::Triangulation_face_base_with_info_2<Index, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
                                               CGAL::Exact_predicates_tag>;

  void split_faces()
  {
    first_parts_.resize(connectivity_.number_of_edges());
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
    {
      bool is_split = in_face_.count(f) > 0 || segments_.count(f) > 0;
      for(Index h = 3 * f; h < 3 * f + 3 && !is_split; ++h)
        is_split = on_edge_.count(connectivity_.edge_of_halfedge[h]) > 0;
      if(is_split)
      {
        split_face(f);
        continue;
      }
      add_face(f, mesh_.triangles[f]);
      // A split face that has all of the edge finds it at place 0.
      for(Index i = 0; i < 3; ++i)
        glue(3 * result_.mesh.number_of_faces() - 3 + i, half_glued(connectivity_.edge_of_halfedge[3 * f + i], 0));
    }
  }

  void add_face(Index f, const Indexed_triangle_mesh::Triangle& t)
  {
    result_.mesh.triangles.push_back(t);
    result_.faces.push_back(f);
    result_.seams.resize(result_.seams.size() + 3, 0);
    result_.mesh.opposite.resize(result_.mesh.opposite.size() + 3, null_index);
  }

  // The face is triangulated in its barycentric coordinates, where all points have integer coordinates: so points on an
  // edge are exactly on it.
  void split_face(Index f)
  {
    const Indexed_triangle_mesh::Triangle& t = mesh_.triangles[f];
    if(t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw Invalid_input(Cause::NON_MANIFOLD,
                          "a face that the cut locus runs through has the same vertex at two corners");
    Triangulation cdt;
    std::map<Index, Triangulation::Vertex_handle> handle;
    const auto insert = [&](Index v, const Coordinates& c)
    {
      const auto vh = cdt.insert(Kernel::Point_2(c[1], c[2]));
      vh->info() = v;
      handle[v] = vh;
    };
    for(int i = 0; i < 3; ++i)
    {
      Coordinates c = {{0, 0, 0}};
      c[i] = n_;
      insert(t[i], c);
    }
    std::vector<Index> others;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const auto found = on_edge_.find(connectivity_.edge_of_halfedge[h]);
      if(found != on_edge_.end())
        for(const auto& p : found->second)
          others.push_back(p.second);
    }
    const auto inside = in_face_.find(f);
    if(inside != in_face_.end())
      others.insert(others.end(), inside->second.begin(), inside->second.end());
    for(Index v : others)
    {
      Coordinates c;
      coordinates_in(f, v, c);
      insert(v, c);
    }
    const auto constraints = segments_.find(f);
    if(constraints != segments_.end())
      for(const Segment& s : constraints->second)
        cdt.insert_constraint(handle.at(s.source), handle.at(s.target));

    for(const Triangulation::Face_handle fh : cdt.finite_face_handles())
    {
      fh->info() = static_cast<Index>(result_.mesh.triangles.size());
      add_face(f, {{fh->vertex(0)->info(), fh->vertex(1)->info(), fh->vertex(2)->info()}});
    }
    for(const Triangulation::Face_handle fh : cdt.finite_face_handles())
      for(int i = 0; i < 3; ++i) // edge i is opposite to vertex i
      {
        const Index h = 3 * fh->info() + static_cast<Index>(i + 1) % 3;
        result_.seams[h] = fh->is_constrained(i);
        const auto neighbor = fh->neighbor(i);
        if(cdt.is_infinite(neighbor))
          glue_part(f, h);
        else
          result_.mesh.opposite[h] = 3 * neighbor->info() + static_cast<Index>(neighbor->index(fh) + 1) % 3;
      }
  }

  // ---- gluing along the edges of the mesh

  // `h` is a part of an edge of face `f`.
  void glue_part(Index f, Index h)
  {
    Coordinates a, b;
    coordinates_in(f, result_.mesh.source(h), a);
    coordinates_in(f, result_.mesh.target(h), b);
    for(Index i = 0; i < 3; ++i)
      if(a[(i + 2) % 3] == 0 && b[(i + 2) % 3] == 0)
      {
        const Index edge = connectivity_.edge_of_halfedge[3 * f + i];
        const bool is_first = 3 * f + i == connectivity_.halfedge_of_edge[edge];
        glue(h, half_glued(edge, is_first ? n_ - a[i] : b[i]));
      }
  }

  // the part of an edge of the mesh that starts at `place` from the source of its first halfedge
  Half_glued& half_glued(Index edge, int place)
  {
    return place == 0 ? first_parts_[edge] : other_parts_[{edge, place}];
  }

  // `other`: the first of the two sides, if it is there already
  void glue(Index h, Half_glued& other)
  {
    if(other.halfedge == null_index)
    {
      other.halfedge = h;
      return;
    }
    result_.mesh.opposite[h] = other.halfedge;
    result_.mesh.opposite[other.halfedge] = h;
  }

  // Both sides of an edge know that it is a seam, and the border is none.
  void complete_sides()
  {
    for(Index h = 0; h < result_.mesh.number_of_halfedges(); ++h)
    {
      const Index o = result_.mesh.opposite[h];
      if(o == null_index)
        result_.seams[h] = 0;
      else if(result_.seams[h])
        result_.seams[o] = 1;
    }
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const int n_;
  Refined_mesh result_;
  std::vector<Place> places_;                                   // of each new vertex
  std::map<std::pair<Index, Coordinates>, Index> vertex_at_;    // by face, or number of faces + edge
  std::map<Index, std::vector<std::pair<int, Index>>> on_edge_; // the vertices on an edge, by place
  std::map<Index, std::vector<Index>> in_face_;
  std::map<Index, std::vector<Segment>> segments_; // of a face
  std::vector<Half_glued> first_parts_;            // of each edge of the mesh
  std::map<std::pair<Index, int>, Half_glued> other_parts_;
};

} // namespace internal

/*
 * splits the faces that a curve runs through, so that it consists of edges. Each edge of the curve must lie in one
 * face.
 *
 * The nodes of the curve are first rounded to barycentric coordinates that are multiples of 1 / `resolution`, from 2 to
 * 2^20. So nodes that are very near a vertex or an edge come to lie on it, those that are very near each other become
 * one, and all faces keep at least 1 / `resolution`^2 of the area of the face that they are a part of. Segments that
 * cross each other are split where they do. Parts of the curve that come to touch each other may enclose faces; see
 * `repair_seams()`.
 *
 * The parts of a face are those of the constrained Delaunay triangulation of its barycentric coordinates. Time is
 * linear in the size of the mesh and O(k log k) for a curve of k edges.
 *
 * @throws Invalid_input if an edge of the curve is in no face
 */
inline Refined_mesh refine_along_curve(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                       const Indexed_cut_locus& curve, Index resolution)
{
  return internal::Curve_refinement(mesh, connectivity, curve, resolution)();
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_GRAPH_CURVE_REFINEMENT_H
