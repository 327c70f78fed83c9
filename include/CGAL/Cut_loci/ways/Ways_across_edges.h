// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_WAYS_ACROSS_EDGES_H
#define CGAL_CUT_LOCI_WAYS_WAYS_ACROSS_EDGES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/ways/Way_arrival.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Where ways to the vertices behind an edge cross that. Near the cut locus, they are few.
class Ways_across_edges
{
public:
  // `crossed` are the edges that the ways to all vertices cross.
  Ways_across_edges(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                    const std::vector<Way_arrival>& ways, const std::vector<unsigned char>& crossed)
    : mesh_(mesh), connectivity_(connectivity), ways_(ways), crossed_(crossed)
  {
  }

  // the place of the first one along a halfedge, as a share of it; 1 if there is none
  double first(Index h) const
  {
    const Index o = mesh_.opposite[h];
    const double length = edge_length(mesh_, h);
    double first = length, last = 0.;
    if(is_entered(h))
    {
      look_behind(h, length, first, last);
      return first / length;
    }
    if(o == null_index || !is_entered(o))
      return 1.;
    look_behind(o, length, first, last);
    return 1. - last / length;
  }

private:
  // A face and the edge across which ways enter it, laid out above the edge that is looked across.
  struct Face
  {
    Index entry;
    Planar_vector left, right;
  };

  bool is_entered(Index entry) const
  {
    const Index edge = connectivity_.edge_of_halfedge[entry];
    return crossed_[edge] == (connectivity_.halfedge_of_edge[edge] == entry ? 1 : 2);
  }

  void look_behind(Index entry, double length, double& first, double& last) const
  {
    std::vector<Face> faces(1, {entry, {{0., 0.}}, {{length, 0.}}});
    while(!faces.empty())
    {
      const Face f = faces.back();
      faces.pop_back();
      const Planar_vector top = apex(mesh_, f.entry), base = f.right - f.left, along = (1. / norm(base)) * base;
      const Planar_vector corner = {
        {f.left[0] + top[0] * along[0] - top[1] * along[1], f.left[1] + top[0] * along[1] + top[1] * along[0]}};
      const Index to_left = mesh_.previous(f.entry), to_right = mesh_.next(f.entry);
      const Index v = mesh_.source(to_left);
      const Way_arrival& way = ways_[v];
      if(way.halfedge == to_left)
        add_way(way, corner, f.left - corner, length, first, last);
      if(const Index o = mesh_.opposite[to_left]; o != null_index && is_entered(o))
        faces.push_back({o, f.left, corner});
      if(const Index o = mesh_.opposite[to_right]; o != null_index && is_entered(o))
        faces.push_back({o, corner, f.right});
    }
  }

  // If it bends before, what it bends around is a vertex that has a way, too.
  static void add_way(const Way_arrival& way, const Planar_vector& from, const Planar_vector& to_left, double length,
                      double& first, double& last)
  {
    const double c = std::cos(way.angle), s = std::sin(way.angle), scale = 1. / norm(to_left);
    const Planar_vector back = {{scale * (c * to_left[0] - s * to_left[1]), scale * (s * to_left[0] + c * to_left[1])}};
    if(!(back[1] < 0.) || from[1] > -(1. + 1e-9) * way.straight * back[1])
      return;
    const double place = (std::max)(0., (std::min)(length, from[0] - back[0] * from[1] / back[1]));
    first = (std::min)(first, place);
    last = (std::max)(last, place);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<Way_arrival>& ways_; // by vertex
  const std::vector<unsigned char>& crossed_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_WAYS_WAYS_ACROSS_EDGES_H
