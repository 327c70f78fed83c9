// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_INTRINSIC_FLIPS_H
#define CGAL_CUT_LOCI_FACE_GRAPH_INTRINSIC_FLIPS_H

#include <CGAL/Cut_loci/face_graph/Mesh_of_points.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells whether the edge flips of `Heat_method_3::Intrinsic_Delaunay` end.
 *
 * They need not: where rounding makes both diagonals of two faces look wrong, they are flipped back and forth. The flips
 * of CGAL's class are done on a copy, in the same order and with the same arithmetic, but no more than many.
 */
class Intrinsic_flips
{
  using Edge = Geodesic_mesh::Edge_index;
  using Halfedge = Geodesic_mesh::Halfedge_index;

public:
  explicit Intrinsic_flips(const Geodesic_mesh& input)
  {
    CGAL::copy_face_graph(input, mesh_);
    for(const Edge e : mesh_.edges())
    {
      const auto &p = mesh_.point(mesh_.vertex(e, 0)), &q = mesh_.point(mesh_.vertex(e, 1));
      length_.push_back(std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q))));
      stack_.push_back(e);
    }
  }

  bool end()
  {
    // Flips that end are about as many as edges. On a mesh of needles they may be more, by about what these are longer
    // than wide; this is far beyond both.
    const std::size_t most = 1000 * (length_.size() + 1000);
    std::vector<unsigned char> is_waiting(length_.size(), 1);
    for(std::size_t flips = 0; !stack_.empty();)
    {
      const Edge e = stack_.back();
      stack_.pop_back();
      is_waiting[e] = 0;
      if(cotangents(e) >= 0. || mesh_.is_border(e))
        continue;
      if(++flips > most)
        return false;
      const Halfedge h = mesh_.halfedge(e);
      length_[e] = length_of_other_diagonal(h);
      CGAL::Euler::flip_edge(h, mesh_);
      const Halfedge o = mesh_.opposite(h);
      for(const Halfedge g : {mesh_.next(h), mesh_.prev(h), mesh_.next(o), mesh_.prev(o)})
        if(!is_waiting[mesh_.edge(g)])
        {
          stack_.push_back(mesh_.edge(g));
          is_waiting[mesh_.edge(g)] = 1;
        }
    }
    return true;
  }

private:
  double length(Halfedge h) const { return length_[mesh_.edge(h)]; }

  // of the angle opposite to `h`
  double cotangent(Halfedge h) const
  {
    const double a = length(h), b = length(mesh_.next(h)), c = length(mesh_.prev(h));
    const double tan2 = std::sqrt(std::fabs(((a - b + c) * (a + b - c)) / ((a + b + c) * (-a + b + c))));
    return (1 - (tan2 * tan2)) / (2 * tan2);
  }

  double cotangents(Edge e) const
  {
    const Halfedge h = mesh_.halfedge(e);
    double result = 0;
    result += cotangent(h);
    result += cotangent(mesh_.opposite(h));
    return result;
  }

  double length_of_other_diagonal(Halfedge h) const
  {
    const Halfedge o = mesh_.opposite(h);
    const double a = length(h), b1 = length(mesh_.next(h)), c1 = length(mesh_.prev(h)), b2 = length(mesh_.next(o)),
                 c2 = length(mesh_.prev(o));
    const double tan2a = std::sqrt(std::fabs(((c1 - a + b1) * (-b1 + a + c1)) / ((a + b1 + c1) * (b1 + a - c1))));
    const double tan2d = std::sqrt(std::fabs(((-a + b2 + c2) * (a + b2 - c2)) / ((a + b2 + c2) * (a - b2 + c2))));
    const double tan2ad = (tan2a + tan2d) / (1 - tan2a * tan2d);
    const double cosad = (1 - tan2ad * tan2ad) / (1 + tan2ad * tan2ad);
    return std::sqrt(std::fabs(b1 * b1 + c2 * c2 - 2 * b1 * c2 * cosad));
  }

  Geodesic_mesh mesh_;
  std::vector<double> length_; // by edge
  std::vector<Edge> stack_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_INTRINSIC_FLIPS_H
