// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DIRECTION_JUMPS_H
#define CGAL_CUT_LOCI_DIRECTION_JUMPS_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * says for each edge by how much the jump of the paths to its two ends exceeds what neighboring paths explain.
 *
 * Both figures are free of units: about 1 where the distance is smooth, and larger on the cut locus.
 */
struct Direction_jumps
{
  struct Edge
  {
    float direction = 0.f; ///< the gap of the directions at the source, over what the spread explains
    float arrival = 0.f;   ///< the angle between the arrival directions, over what the bend of the front explains
    float angle = 0.f;     ///< that angle, in radians
    float weight = 0.f;    ///< for the spanning tree: zero along shortest paths, so that it follows them
    float strength = 0.f;  ///< of the cut locus where it crosses the edge
  };
  std::vector<Edge> edges;

  /// what a smooth field reaches at most; a jump beyond it is the cut locus
  static constexpr float smooth_limit() { return 1.6f; }
};

namespace internal {

// the halfedges of the edges at the source: those that leave it, or those of the faces around it
inline std::vector<Index> source_star(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                      const Indexed_source& source)
{
  std::vector<Index> result;
  if(source.vertex != null_index)
  {
    const Index end = connectivity.ring_begin[source.vertex + 1];
    for(Index entry = connectivity.ring_begin[source.vertex]; entry < end; ++entry)
      result.push_back(connectivity.ring_halfedge[entry]);
    return result;
  }
  const Index first = 3 * source.location.face;
  for(Index i = 0; i < 3; ++i)
  {
    const Index h = first + i, o = mesh.opposite[h];
    if(source.location.coordinates[(i + 2) % 3] > 0.)
      result.push_back(h);
    else
    {
      // The source is on this edge: it comes first, so that it is in the spanning tree in any case.
      result.insert(result.begin(), h);
      if(o != null_index)
        result.insert(result.end(), {mesh.next(o), mesh.previous(o)});
    }
  }
  return result;
}

/*
 * The strength of the cut locus where it crosses an edge. Both figures must be large, but where the paths meet at a
 * wide angle (of half a radian), that is enough: behind a thin limb their directions at the source are almost the same.
 *
 * Noise of the mesh enlarges the first of these two criteria, and with it the threshold. In the second one the noise is
 * in the figure already: the angles behind bumps are about the square root of the deviation of the deficits, and the
 * square of the angle over the deficits does not depend on the noise. So it must not fall behind the threshold, and
 * where there is noise, a radian keeps it clear.
 */
class Jump_strength
{
public:
  Jump_strength(const Direction_geometry& geometry, const Direction_field& field)
  {
    double farthest = 0.;
    for(const Direction_field::Vertex& v : field.vertices)
      farthest = (std::max)(farthest, v.distance);
    noise_factor_ = static_cast<float>(geometry.noise_factor(farthest));
    wide_angle_ = (std::min)(0.5f * noise_factor_, 1.f);
  }

  float operator()(const Direction_jumps::Edge& e) const
  {
    return (std::max)(std::sqrt(e.direction * e.arrival),
                      noise_factor_ * e.arrival * (std::min)(1.f, e.angle / wide_angle_));
  }

private:
  float noise_factor_, wide_angle_;
};

/*
 * Makes the spanning tree follow the shortest paths wherever no jump speaks against it, since no shortest path crosses
 * the cut locus.
 *
 * Where jumps are small on both sides of a handle - it is as small as an edge, or all paths bend at the same saddle
 * before it - they do not tell which edges cross the cut locus. The paths do: they are homotopic to those of the tree.
 */
class Edges_of_paths
{
public:
  Edges_of_paths(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                 const Direction_geometry& geometry, const Direction_field& field)
    : mesh_(mesh), connectivity_(connectivity), geometry_(geometry), field_(field)
  {
  }

  void operator()(Direction_jumps& jumps) const
  {
    std::vector<Index> chosen(mesh_.number_of_vertices()); // all by the weights as they were
    for(Index v = 0; v < chosen.size(); ++v)
    {
      const std::array<Index, 2> e = beside_path(v);
      chosen[v] = e[cost(jumps, v, e[1]) < cost(jumps, v, e[0]) ? 1 : 0];
    }
    for(Index e : chosen)
      if(jumps.edges[e].weight <= Direction_jumps::smooth_limit())
        jumps.edges[e].weight = 0.f;
  }

private:
  // The edges at `v` that the shortest path to it arrives between, or along one of them.
  std::array<Index, 2> beside_path(Index v) const
  {
    constexpr float two_pi = 6.2831853f;
    const Index begin = connectivity_.ring_begin[v], end = connectivity_.ring_begin[v + 1];
    float arrival = field_.vertices[v].arrival;
    Index last = end - 1;
    if(connectivity_.is_border(v))
      --last; // no face follows the last edge
    else
      arrival -= two_pi * std::floor(arrival / two_pi);
    Index entry = begin;
    while(entry < last && geometry_.polar[connectivity_.ring_halfedge[entry + 1]] <= arrival)
      ++entry;
    return {{connectivity_.ring_edge(entry), connectivity_.ring_edge(entry + 1 < end ? entry + 1 : begin)}};
  }

  // Least where there is no jump, then where the edge leads back, then where the figures are small.
  float cost(const Direction_jumps& jumps, Index v, Index e) const
  {
    const Index h = connectivity_.halfedge_of_edge[e], s = mesh_.source(h), u = s == v ? mesh_.target(h) : s;
    const bool leads_back = field_.vertices[u].distance < field_.vertices[v].distance;
    return jumps.edges[e].weight + (leads_back ? 0.f : Direction_jumps::smooth_limit());
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Direction_geometry& geometry_;
  const Direction_field& field_;
};

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * computes the jumps across all edges. Linear time.
 */
inline Direction_jumps direction_jumps(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                       const Direction_geometry& geometry, const Direction_field& field)
{
  constexpr double two_pi = 6.28318530717958647693;
  const float noise = static_cast<float>(geometry.noise_share * geometry.deficit_noise);
  const internal::Jump_strength strength(geometry, field);
  const Index ne = connectivity.number_of_edges();
  Direction_jumps result;
  result.edges.resize(ne);
  for(Index e = 0; e < ne; ++e)
  {
    const Index h = connectivity.halfedge_of_edge[e];
    const Index a = mesh.source(h), b = mesh.target(h);
    const Direction_field::Vertex &va = field.vertices[a], &vb = field.vertices[b];
    const double l = geometry.length[h];
    // On a saddle the spread is much larger than the distance, and only the latter keeps the figure free of its errors.
    const double da = (std::min)(double(va.spread), va.distance), db = (std::min)(double(vb.spread), vb.distance);
    const double reach = (std::max)((std::min)(da, db), 1e-12 * l);
    const double gap = std::fabs(field.turn(va.direction, vb.direction));

    const std::array<float, 2> polar = geometry.polar_at_ends(mesh, h);
    double angle = std::fabs(double(va.arrival - polar[0]) - double(vb.arrival - polar[1]) - two_pi / 2.);
    while(angle > two_pi / 2.)
      angle = std::fabs(angle - two_pi);
    const double bend_a = (std::max)(std::fabs(va.spread_rate) / (std::max)(double(va.spread), 1e-12 * l),
                                     1. / (std::max)(va.distance, 1e-12 * l));
    const double bend_b = (std::max)(std::fabs(vb.spread_rate) / (std::max)(double(vb.spread), 1e-12 * l),
                                     1. / (std::max)(vb.distance, 1e-12 * l));
    const double expected = l * (std::max)(bend_a, bend_b) + (std::max)(std::fabs(geometry.deficit[a]), noise) +
                            (std::max)(std::fabs(geometry.deficit[b]), noise);

    Direction_jumps::Edge& edge = result.edges[e];
    edge.direction = static_cast<float>(gap * reach / l);
    edge.arrival = static_cast<float>(angle / expected);
    edge.angle = static_cast<float>(angle);
    // Radians beyond the smooth limit count a thousand times, so that the tree crosses the cut locus where it is
    // weakest, and only there where it must.
    edge.strength = strength(edge);
    const double limit = Direction_jumps::smooth_limit();
    const double excess = (std::max)(0., gap - limit * l / reach) + (std::max)(0., angle - limit * expected);
    edge.weight =
      static_cast<float>(1000. * excess + (std::min)((std::max)(double(edge.direction), double(edge.arrival)), limit));
  }
  internal::Edges_of_paths(mesh, connectivity, geometry, field)(result);
  for(Index h : internal::source_star(mesh, connectivity, field.source))
    result.edges[connectivity.edge_of_halfedge[h]] = Direction_jumps::Edge();
  return result;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_DIRECTION_JUMPS_H
