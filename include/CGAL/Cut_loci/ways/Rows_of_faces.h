// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_ROWS_OF_FACES_H
#define CGAL_CUT_LOCI_WAYS_ROWS_OF_FACES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>
#include <CGAL/Cut_loci/ways/Way_arrival.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Rows of faces that are laid out in the plane, where they may overlap, from the face of a source on, and the shortest ways
// in them.
//
// What the source sees through a row is a funnel: between two chains of corners, which the ways to the ends of the last edge
// bend around. The corner behind that edge is seen past one of them, or straight from where the chains part: the funnel
// algorithm \cgalCite{cgal:lp-espsb-84}, in a tree of triangles.
class Rows_of_faces
{
public:
  // A row of faces, by its last one, and the corner of that opposite to the edge across which it is entered. Or a face at
  // a source, behind which are three triples of points, for each halfedge: what stands for the source, and the ends, which
  // tell the halfedge as `before`.
  struct Row
  {
    Planar_vector position = {{0., 0.}};
    double length = 0.;          // of the shortest way to the corner, if none is slower
    double late = 0.;            // by which waves come later there, as they are slower on the way
    double delay = 0.;           // for which it waits for others
    Index previous = null_index; // the corner around which that bends last, or the source
    // the corners at the ends of that edge, as seen from there, and where the ways to them part
    Index left = null_index, right = null_index, parting = null_index;
    int side = 0;             // of the chain on which `previous` is: -1 left, 1 right, 0 where they part
    Index entry = null_index; // a halfedge of the last face
    Index before = null_index;
    Index source = null_index;
  };

  Rows_of_faces(const Indexed_triangle_mesh& mesh, const std::vector<double>& distance)
    : mesh_(mesh), distance_(distance)
  {
    rows_.reserve(2 * mesh.number_of_halfedges());
  }

  const Row& operator[](Index row) const { return rows_[row]; }
  std::size_t size() const { return rows_.size(); }
  bool is_root(Index row) const { return rows_[row].entry == null_index; }
  Index face(Index row) const { return is_root(row) ? rows_[row].before : rows_[row].entry / 3; }
  Index corner(Index row) const { return mesh_.source(mesh_.previous(rows_[row].entry)); }
  // at the ends of halfedge `h` of a face at a source
  Index row_at_source(Index root, Index h) const { return root + 2 + 3 * (h % 3); }
  Index row_at_target(Index root, Index h) const { return row_at_source(root, h) + 1; }

  Index add(const Row& row)
  {
    rows_.push_back(row);
    return static_cast<Index>(rows_.size() - 1);
  }

  // A face at a source; at a part of the border, if `point` is null.
  Index add_root(Index f, const Indexed_source* point, Index source)
  {
    Row root;
    root.before = f;
    root.source = source;
    const Index result = add(root);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Row from = origin(h, point);
      const Index first = add(from);
      for(const double x : {0., edge_length(mesh_, h)})
      {
        Row end = from;
        end.position = {{x, 0.}};
        end.length += norm(end.position - from.position);
        end.previous = first;
        end.source = source;
        end.before = h;
        add(end);
      }
    }
    return result;
  }

  // What is seen across a halfedge, from inside its face: the corners at its ends, and where the ways to them part.
  struct Window
  {
    Index left, right, parting;
  };
  Window window(Index row, Index h) const
  {
    if(is_root(row))
    {
      const Index right = row_at_source(row, h), first = rows_[right].previous;
      const auto end = [&](Index i) { return norm(rows_[i].position - rows_[first].position) > 0. ? i : first; };
      return {end(row_at_target(row, h)), end(right), first};
    }
    const Row& r = rows_[row];
    if(h == mesh_.previous(r.entry)) // between the corner and the left end
      return {r.left, row, r.side == -1 ? r.previous : r.parting};
    return {row, r.right, r.side == 1 ? r.previous : r.parting};
  }

  // One face more in the row, across the opposite of `entry`.
  Row longer(Index row, Index entry) const
  {
    Row r;
    const Window seen = window(row, mesh_.opposite[entry]);
    r.entry = entry;
    r.before = row;
    r.source = rows_[row].source;
    r.left = seen.left;
    r.right = seen.right;
    r.parting = seen.parting;
    const Planar_vector& a = rows_[r.left].position;
    const Planar_vector base = rows_[r.right].position - a, along = (1. / norm(base)) * base, top = apex(mesh_, entry);
    r.position = {{a[0] + top[0] * along[0] - top[1] * along[1], a[1] + top[0] * along[1] + top[1] * along[0]}};
    r.side = bends(r.left, 1., r) ? -1 : bends(r.right, -1., r) ? 1 : 0;
    if(r.side == 0)
      r.previous = r.parting;
    r.length = rows_[r.previous].length + norm(r.position - rows_[r.previous].position);
    return r;
  }

  // Where the way to the corner crosses the edge across which its face is entered: the length along that.
  double entrance(Index row) const
  {
    const Row& r = rows_[row];
    const Planar_vector &left = rows_[r.left].position, &right = rows_[r.right].position,
                        &from = rows_[r.previous].position;
    const double of_left = cross(left - from, r.position - from), of_right = cross(right - from, r.position - from);
    const double share = of_left != of_right ? of_left / (of_left - of_right) : 0.5;
    return (std::max)(0., (std::min)(1., share)) * edge_length(mesh_, r.entry);
  }

  // how the way of a row arrives at its corner, or at an end of a halfedge at a source, which have the given distance
  Way_arrival arrival(Index row, double distance) const
  {
    const Row& r = rows_[row];
    Way_arrival result;
    Planar_vector along; // the halfedge that leaves the corner
    if(is_root(row))
    {
      const bool is_at_end = row == r.previous + 2;
      result.halfedge = is_at_end ? mesh_.next(r.before) : r.before;
      along = is_at_end ? apex(mesh_, r.before) - r.position : Planar_vector{{1., 0.}};
    }
    else
    {
      result.halfedge = mesh_.previous(r.entry);
      along = rows_[r.left].position - r.position;
    }
    const Index from = start_of_straight_piece(row, distance);
    const Planar_vector back = rows_[from].position - r.position;
    result.length = r.length + r.late;
    result.error = std::abs(rows_[from].length + norm(back) - distance);
    result.angle = (std::max)(0., std::atan2(cross(along, back), dot(along, back)));
    result.straight = norm(back);
    return result;
  }

private:
  // A way may bend around corners only because its row has no other faces. So what it bends around last, or comes from, is
  // that from which it would be as long as the given distance says, laid out straight; the farthest of those that agree but
  // for rounding, as what the way just touches is no bend.
  Index start_of_straight_piece(Index row, double distance) const
  {
    Index result = rows_[row].previous;
    const auto difference = [&](Index from)
    { return std::abs(rows_[from].length + norm(rows_[row].position - rows_[from].position) - distance); };
    double least = difference(result);
    for(Index from = result; from != null_index; from = rows_[from].previous)
      if(const double d = difference(from); d <= least + 1e-9 * distance)
      {
        result = from;
        least = (std::min)(least, d);
      }
    return result;
  }

  // A point in the frame of a halfedge of its face, or what stands for the part of a curve that is seen across it: a point
  // so far away that what comes from it is a line, with the distances of both ends, or the corner behind if both ways come
  // from that.
  Row origin(Index h, const Indexed_source* point) const
  {
    Row result;
    if(point != nullptr)
    {
      result.position = flat_position(mesh_, h, in_face(mesh_, point->location, h / 3).coordinates);
      result.length = distance_at(*point);
      return result;
    }
    const double length = edge_length(mesh_, h), a = distance_[mesh_.source(h)], b = distance_[mesh_.target(h)];
    const Planar_vector top = apex(mesh_, h), from_end = {{top[0] - length, top[1]}};
    const double behind = distance_[mesh_.source(mesh_.previous(h))], rounding = 1e-9 * length;
    if(behind + norm(top) <= a + rounding && behind + norm(from_end) <= b + rounding)
    {
      result.position = top;
      result.length = behind;
      return result;
    }
    const double radius = 1e6 * length, slope = (std::max)(-1., (std::min)(1., (b - a) / length));
    result.position = {{-radius * slope, radius * std::sqrt(1. - slope * slope)}};
    result.length = a - radius;
    return result;
  }

  // As is given for its vertex, or for the corners of its face, to which another source may be nearer.
  double distance_at(const Indexed_source& point) const
  {
    if(point.vertex != null_index)
      return distance_[point.vertex];
    double result = 0.;
    const Vector at = position(mesh_, point.location);
    for(Index v : mesh_.triangles[point.location.face])
      result = (std::max)(result, distance_[v] - norm(mesh_.points[v] - at));
    return result;
  }

  // Whether the way to a corner bends around one of the chain from `u` back to where the chains part, and where last.
  bool bends(Index u, double sign, Row& r) const
  {
    for(; u != r.parting; u = rows_[u].previous)
    {
      const Planar_vector &at = rows_[u].position, &before = rows_[rows_[u].previous].position;
      if(sign * cross(at - before, r.position - at) >= 0.)
      {
        r.previous = u;
        return true;
      }
    }
    return false;
  }

  const Indexed_triangle_mesh& mesh_;
  const std::vector<double>& distance_;
  std::vector<Row> rows_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_WAYS_ROWS_OF_FACES_H
