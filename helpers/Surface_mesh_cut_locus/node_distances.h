// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_NODE_DISTANCES_H
#define CGAL_CUT_LOCI_HELPERS_NODE_DISTANCES_H

#include "Source_set.h"
#include "detour.h"

#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_locus.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace curve_measures {

// in units of the mean edge length; of mesh edges, the nodes are vertices
struct Node_distance_errors
{
  double mean = 0., max = 0.;
};

/*
 * compares the distance of each node of a cut locus with the exact one at its place, which is asked for on its own.
 * Sources that are curves have to be given, in their order. Throws `Cut_loci::Invalid_input` where nothing can be asked.
 */
template <typename TriangleMesh, typename Point_3>
Node_distance_errors node_distance_errors(const TriangleMesh& tm,
                                          const CGAL::Cut_locus<TriangleMesh, Point_3>& cut_locus,
                                          const Edge_curves<TriangleMesh>& source_curves = {})
{
  namespace lib = CGAL::Cut_loci::internal;
  const auto read = lib::read_triangle_mesh(tm, get(CGAL::vertex_point, tm));
  const lib::Curve_on_component on = lib::on_component(read.mesh, lib::curve_on_mesh(read, tm, cut_locus));
  const internal::Source_set set = internal::source_set(tm, read, on, source_curves);
  const auto& nodes = on.curve.graph.nodes;
  std::vector<CGAL::Cut_loci::Indexed_location> places;
  for(const auto& node : nodes)
    places.push_back(node.location);
  const std::vector<double> exact =
    internal::distances_cut_open(set, on, internal::whole(on.component.mesh), places).of_queries;
  const double unit = CGAL::Cut_loci::Mesh_connectivity(on.component.mesh).mean_edge_length;
  Node_distance_errors result;
  for(std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double error = std::fabs(nodes[i].distance - exact[i]) / unit;
    result.mean += error / double(nodes.size());
    result.max = (std::max)(result.max, error);
  }
  return result;
}

} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_NODE_DISTANCES_H
