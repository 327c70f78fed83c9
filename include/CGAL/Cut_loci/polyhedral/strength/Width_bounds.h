// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_WIDTH_BOUNDS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_WIDTH_BOUNDS_H

#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/polyhedral/faces/Ridges.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells how wide an edge is at most, while branches fall off from the leaves inward, from the one that has fallen off
 * before it: what is known to be narrow needs no paths to be followed to the source.
 *
 * Along an edge each of its two paths turns around its image, and sweeps no more than the arc from one end to the other.
 * From one edge to the next an image changes where a branch comes in that has been left out, as its two paths part and
 * meet at small angles. These are one path of the edge before and one of the edge behind, and get no farther apart than
 * `Branch_strength::least_angle()` takes for granted. The sum of all is a bound, as separations are distances.
 */
class Width_bounds
{
public:
  Width_bounds(const Tree_graph& graph, const Ridges& ridges, const Geodesic_results& geodesics)
    : graph_(graph), ridges_(ridges), geodesics_(geodesics), behind_(graph.nodes.size())
  {
  }

  /// of the edge at a leaf; infinite if nothing is known
  double most(Index e, Index leaf) const
  {
    const Behind& behind = behind_[leaf];
    if(behind.number != 1 || !(behind.most < infinity))
      return infinity;
    return behind.most + change(behind.edge, e, leaf) + swept(e);
  }

  /// the same, if the width at one of its ends is known
  double most(Index e, double width) const { return width + swept(e); }

  /// an edge falls off, of which that is known
  void add(Index e, Index leaf, double most)
  {
    Behind& next = behind_[Edges_left::other(graph_.edges[e].nodes, leaf)];
    ++next.number;
    next.edge = e;
    next.most = most;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  /// what has fallen off at a node
  struct Behind
  {
    Index number = 0, edge = null_index; // the last one
    double most = infinity;              // its width there
  };

  /// by the two paths together, from one end of an edge to the other
  double swept(Index e) const
  {
    const Index p = graph_.edges[e].piece;
    double result = 0.;
    for(const Image& image : ridges_.piece(p).images)
    {
      const Plane_point from = ridges_.piece_end(p, 0), to = ridges_.piece_end(p, 1);
      const double ax = from.x - image.x, ay = from.y - image.y, bx = to.x - image.x, by = to.y - image.y;
      result += std::sqrt((std::max)(ax * ax + ay * ay, bx * bx + by * by)) *
                upper_angle(ax * bx + ay * by, std::fabs(ax * by - ay * bx));
    }
    return result;
  }

  /// how far the paths to a node are apart, from those of one edge to those of the other on the same side
  double change(Index e, Index next, Index node) const
  {
    const Tree_graph::Edge &a = graph_.edges[e], &b = graph_.edges[next];
    if(a.face != b.face) // at a crossing, whose labels both of them have
      return graph_.nodes[node].crossing != null_index ? 0. : infinity;
    const std::array<Plane_point, 3> corners = ridges_.layout(a.face);
    const int end = a.nodes[1] == node, begin = b.nodes[1] == node;
    const Plane_point p = ridges_.piece_end(b.piece, begin);
    double result = 0.;
    for(int side = 0; side < 2;
        ++side) // what is on the left of pieces that both come to the node is not on the same side
      result += separation(ridges_.piece(a.piece).images[side],
                           ridges_.piece(b.piece).images[end == begin ? 1 - side : side], p, corners);
    return result;
  }

  double separation(const Image& a, const Image& b, const Plane_point& p,
                    const std::array<Plane_point, 3>& corners) const
  {
    if(is_same_image(a, b))
      return 0.;
    const Parting_angle::Parting where = parting(geodesics_, a, b, p, corners);
    return (std::max)(meeting_angle(a, b, p), where.angle) * (a.distance(p) - where.distance) /
           Branch_strength::share_of_angle;
  }

  const Tree_graph& graph_;
  const Ridges& ridges_;
  const Geodesic_results& geodesics_;
  std::vector<Behind> behind_; // by node
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_WIDTH_BOUNDS_H
