// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SUB_EDGE_PLACEMENT_H
#define CGAL_CUT_LOCI_SUB_EDGE_PLACEMENT_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_field.h>
#include <CGAL/Cut_loci/direction_pruning.h>
#include <CGAL/Cut_loci/internal/Geodesic_fronts.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * is a curve through the faces, with the face of each segment.
 */
struct Sub_edge_curve
{
  Indexed_cut_locus graph;
  std::vector<Index> face;
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * draws the kept edges of the graph of the faces as a polyline through the faces: a node on each edge, where the paths
 * to both of its ends are equally long, and one in each face with three of them, where the three fronts meet. Node `i`
 * is on edge `i` of `branches`. Time is proportional to the number of edges, but for a sort.
 */
inline Sub_edge_curve place_sub_edges(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                      const Direction_geometry& geometry, const Direction_field& field,
                                      const std::vector<Direction_branches::Edge>& branches)
{
  using Fronts = internal::Geodesic_fronts;
  const Fronts fronts(mesh, connectivity, geometry, field);
  Sub_edge_curve curve;
  Indexed_cut_locus& result = curve.graph;
  std::vector<Fronts::Crossing> crossings;
  std::vector<std::pair<Index, Index>> by_node;
  for(const Direction_branches::Edge& e : branches)
  {
    for(Index f : {e.outer, e.inner})
      if(f < mesh.number_of_faces())
        by_node.push_back({f, static_cast<Index>(crossings.size())});
    crossings.push_back(fronts.crossing(e.edge));
    result.nodes.push_back({fronts.location(crossings.back()), null_index, crossings.back().distance});
  }
  std::sort(by_node.begin(), by_node.end());
  for(std::size_t i = 0; i < by_node.size();)
  {
    const Index f = by_node[i].first;
    std::size_t end = i;
    while(end < by_node.size() && by_node[end].first == f)
      ++end;
    const auto strength = [&](std::size_t k) { return branches[by_node[k].second].strength; };
    if(end - i == 2)
      result.edges.push_back(
        {by_node[i].second, by_node[i + 1].second, null_index, (std::min)(strength(i), strength(i + 1)), null_index});
    else if(end - i == 3)
    {
      const Fronts::Face_points points = fronts.layout(f);
      std::array<double, 3> middle = {{0., 0., 0.}};
      double distance = 0.;
      for(std::size_t k = i; k < end; ++k)
      {
        const std::array<double, 3> c = fronts.coordinates(crossings[by_node[k].second], f);
        for(int j = 0; j < 3; ++j)
          middle[j] += c[j] / 3.;
      }
      const Fronts::Point_2 p = fronts.triple_point(f, Fronts::point(points, middle));
      for(Index j = 0; j < 3; ++j)
        distance += fronts.front(f, j, points)(p) / 3.;
      const Index node = static_cast<Index>(result.nodes.size());
      Indexed_location location;
      location.face = f;
      location.coordinates = Fronts::coordinates(points, p);
      result.nodes.push_back({location, null_index, distance});
      for(std::size_t k = i; k < end; ++k)
        result.edges.push_back({by_node[k].second, node, null_index, strength(k), null_index});
    }
    curve.face.resize(result.edges.size(), f);
    i = end;
  }
  return curve;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SUB_EDGE_PLACEMENT_H
