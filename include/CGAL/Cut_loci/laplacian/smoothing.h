// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_H
#define CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_H

#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/laplacian/One_sided_distances.h>
#include <CGAL/Cut_loci/laplacian/Smoothing_limits.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Local_geodesics.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/normals.h>
#include <CGAL/Cut_loci/surface/straightest_geodesic.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

class Cut_locus_smoother
{
public:
  Cut_locus_smoother(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const std::vector<double>& distance, const Indexed_cut_locus& input,
                     const std::vector<Index>& source_of_face)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), input_(input), network_(mesh, connectivity, input),
      sides_(mesh, connectivity, distance), limits_(mesh, connectivity, distance, input, network_, source_of_face)
  {
    for(const Indexed_cut_locus::Node& node : input.nodes)
    {
      location_.push_back(node.location);
      snap(location_.back());
      position_.push_back(position(mesh, location_.back()));
    }
    for(const Curve_network::Chain& chain : network_.chains)
    {
      current_.push_back({});
      for(Index i = 0; i < chain.nodes.size(); ++i)
        current_.back().push_back(i);
    }
  }

  Indexed_cut_locus operator()(const Smoothing_parameters& parameters, const Progress& progress)
  {
    double rest = parameters.damping;
    for(Index k = 0; k < parameters.number_of_iterations; ++k)
    {
      progress(0.8 * k / parameters.number_of_iterations);
      plan_displacements(1. - rest);
      move();
      rest *= 0.5;
    }
    drop_fold_backs();
    for(Index k = 0; k < parameters.number_of_relaxations; ++k)
    {
      plan_relaxation();
      move();
    }
    drop_fold_backs();
    progress(0.8);
    separate_branch_points();
    return within_limits();
  }

private:
  using Chain = Curve_network::Chain;
  using Span = Smoothing_limits::Span;

  // The unit tangent of the curve at place `i` of a chain, from nodes a few places before and after, as neighbors
  // zigzag along the edges of the mesh.
  bool tangent(const std::vector<Index>& nodes, std::size_t i, const Vector& normal, Vector& result) const
  {
    const std::size_t last = nodes.size() - 1;
    // at a leaf, that of its neighbor, transported
    const std::size_t at = i == 0 ? 1 : i == last ? last - 1 : i;
    const std::size_t before = at - (std::min)(at, window), after = (std::min)(last, at + window);
    return unit(tangential(position_[nodes[after]] - position_[nodes[before]], normal), result);
  }

  void plan_displacements(double part)
  {
    displacement_.assign(location_.size(), {{0., 0., 0.}});
    std::array<One_sided_distances::Seeds, 2> seeds;
    for(const Chain& chain : network_.chains)
      for(std::size_t i = 0; i < chain.nodes.size(); ++i)
      {
        const Index node = chain.nodes[i];
        const bool is_end = i == 0 || i + 1 == chain.nodes.size();
        if(is_end && !network_.is_leaf(node))
          continue;
        Vector normal, t;
        if(!unit(normal_at(mesh_, connectivity_, location_[node]), normal) || !tangent(chain.nodes, i, normal, t))
          continue;
        const Vector n = cross(normal, t);
        const Vector to_neighbors = towards_neighbors(chain.nodes, i, t);

        network_.seeds(chain, i - (std::min)(i, window), (std::min)(chain.edges.size(), i + window), seeds);
        sides_.gather(seeds, [&](Index v) { return network_.node_of_vertex(v) != null_index; });
        Balance balance;
        if(sides_.fit(position_[node], t, n))
          balance = balance_of_sides(node);
        const double way = balance.confidence * balance.way + (1. - balance.confidence) * dot(to_neighbors, n);
        displacement_[node] = part * way * n + dot(to_neighbors, t) * t;
      }
    for(Index node = 0; node < location_.size(); ++node)
      if(network_.degree(node) > 2)
        displacement_[node] = part * (centroid_of_neighbors(node) - position_[node]);
  }

  // The way along the normal to where both sides give the same distance, and how far it can be trusted.
  struct Balance
  {
    double way = 0., confidence = 0.;
  };

  Balance balance_of_sides(Index node) const
  {
    const One_sided_distances::Quadric &l = sides_.left(), &r = sides_.right();
    const double slope = r.gradient[1] - l.gradient[1];
    if(!(slope > 0.)) // the sides do not converge
      return {};
    // One half where the error of the distances moves their balance by an edge.
    const double edge = network_.edge_length(node);
    const double noise = (l.error + r.error) / edge;
    const double way = (l.value - r.value) / slope;
    return {(std::max)(-edge, (std::min)(edge, way)), slope * slope / (slope * slope + noise * noise)};
  }

  // Half of the way to the middle of the neighbors; at a leaf, all of the way to the straight continuation of its
  // branch.
  Vector towards_neighbors(const std::vector<Index>& nodes, std::size_t i, const Vector& t) const
  {
    const Vector& p = position_[nodes[i]];
    if(i > 0 && i + 1 < nodes.size())
      return 0.5 * (0.5 * (position_[nodes[i - 1]] + position_[nodes[i + 1]]) - p);
    const Vector to_neighbor = position_[nodes[i == 0 ? 1 : i - 1]] - p;
    return to_neighbor - dot(to_neighbor, t) * t;
  }

  Vector centroid_of_neighbors(Index node) const
  {
    Vector sum = {{0., 0., 0.}};
    double count = 0.;
    for(std::size_t c = 0; c < current_.size(); ++c)
    {
      const Chain& chain = network_.chains[c];
      const std::vector<Index>& kept = current_[c];
      if(chain.nodes.front() == node)
      {
        sum = sum + position_[chain.nodes[kept[1]]];
        ++count;
      }
      if(chain.nodes.back() == node)
      {
        sum = sum + position_[chain.nodes[kept[kept.size() - 2]]];
        ++count;
      }
    }
    return (1. / count) * sum;
  }

  void plan_relaxation()
  {
    displacement_.assign(location_.size(), {{0., 0., 0.}});
    for(std::size_t c = 0; c < current_.size(); ++c)
      for(std::size_t i = 1; i + 1 < current_[c].size(); ++i)
      {
        const std::vector<Index>& nodes = network_.chains[c].nodes;
        const Index node = nodes[current_[c][i]];
        const Vector middle = 0.5 * (position_[nodes[current_[c][i - 1]]] + position_[nodes[current_[c][i + 1]]]);
        displacement_[node] = 0.5 * (middle - position_[node]);
      }
  }

  void move()
  {
    for(Index node = 0; node < location_.size(); ++node)
    {
      if(is_on_border(node))
        continue;
      const Vector normal = normal_at(mesh_, connectivity_, location_[node]);
      const Vector d = tangential(displacement_[node], normal);
      const double length = norm(d);
      if(!(length > 0.))
        continue;
      const Indexed_location moved = straightest_geodesic(mesh_, connectivity_, location_[node], d, length);
      // The smooth curve passes the edges at each vertex: what leads farther away is an error of the fit.
      const Vector p = position(mesh_, moved);
      if(norm(p - mesh_.points[input_.nodes[node].vertex]) > network_.edge_length(node) ||
         !limits_.may_be_at(node, moved))
        continue;
      location_[node] = moved;
      position_[node] = p;
    }
  }

  // A branch that ends at the border stays there, or the border would not be joined to the graph any more.
  bool is_on_border(Index node) const { return connectivity_.is_border(input_.nodes[node].vertex); }

  // A node at which the curve turns back by more than a right angle has overtaken a neighbor.
  void drop_fold_backs()
  {
    for(std::size_t c = 0; c < current_.size(); ++c)
    {
      const std::vector<Index>& nodes = network_.chains[c].nodes;
      std::vector<Index>& kept = current_[c];
      // Two nodes between its ends keep a chain open, and apart from any other with the same ends.
      const std::size_t least = is_only_one(nodes.front(), nodes.back()) ? 2 : 4;
      for(std::size_t i = 1; i + 1 < kept.size() && kept.size() > least;)
      {
        const Vector& p = position_[nodes[kept[i]]];
        if(is_on_border(nodes[kept[i]]) ||
           dot(p - position_[nodes[kept[i - 1]]], position_[nodes[kept[i + 1]]] - p) > 0.)
        {
          ++i;
          continue;
        }
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
        i = (std::max)(i - 1, std::size_t(1));
      }
    }
  }

  // whether one chain joins two nodes that are not the same
  bool is_only_one(Index a, Index b) const
  {
    return a != b && 1 == std::count_if(network_.chains.begin(), network_.chains.end(),
                                        [&](const Chain& chain)
                                        {
      const Index s = chain.nodes.front(), t = chain.nodes.back();
      return (s == a && t == b) || (s == b && t == a);
                     });
  }

  // Ends of a chain that have moved to the same point go back to their vertices.
  void separate_branch_points()
  {
    for(std::size_t c = 0; c < current_.size(); ++c)
    {
      const std::vector<Index>& nodes = network_.chains[c].nodes;
      for(std::size_t i = 1; i < current_[c].size(); ++i)
      {
        const Index a = nodes[current_[c][i - 1]], b = nodes[current_[c][i]];
        if(position_[a] != position_[b])
          continue;
        put_back(a);
        put_back(b);
      }
    }
  }

  double distance_at(const Indexed_location& x) const
  {
    const Indexed_triangle_mesh::Triangle& t = mesh_.triangles[x.face];
    return x.coordinates[0] * distance_[t[0]] + x.coordinates[1] * distance_[t[1]] + x.coordinates[2] * distance_[t[2]];
  }

  // Nodes at edges that are where they must not be go back to their vertices: the edges of the mesh may be anywhere.
  Indexed_cut_locus within_limits()
  {
    Local_geodesics geodesics(mesh_, connectivity_);
    std::vector<bool> is_put_back(location_.size(), false);
    while(true)
    {
      Indexed_cut_locus result = joined(geodesics);
      bool has_changed = false;
      for(Index e : limits_.misplaced(result, spans_, location_))
      {
        const Span& span = spans_[e];
        for(Index place = span.from; place <= span.to; ++place)
        {
          const Index node = network_.chains[span.chain].nodes[place];
          if(is_put_back[node])
            continue;
          is_put_back[node] = has_changed = true;
          put_back(node);
          std::vector<Index>& kept = current_[span.chain];
          const auto next = std::lower_bound(kept.begin(), kept.end(), place);
          if(next == kept.end() || *next != place)
            kept.insert(next, place);
        }
      }
      if(!has_changed)
        return result;
    }
  }

  void put_back(Index node)
  {
    location_[node] = input_.nodes[node].location;
    position_[node] = position(mesh_, location_[node]);
  }

  // The nodes that are left, joined by geodesic segments.
  Indexed_cut_locus joined(Local_geodesics& geodesics)
  {
    Indexed_cut_locus result;
    spans_.clear();
    std::vector<Index> output(location_.size(), null_index);
    const auto add = [&](const Indexed_location& x)
    {
      result.nodes.push_back({x, vertex_of(mesh_, x), distance_at(x)});
      return static_cast<Index>(result.nodes.size() - 1);
    };
    const auto add_node = [&](Index node)
    {
      if(output[node] == null_index)
        output[node] = add(location_[node]);
      return output[node];
    };
    add_node(root());

    std::vector<Indexed_location> path;
    for(std::size_t c = 0; c < current_.size(); ++c)
    {
      const Chain& chain = network_.chains[c];
      for(std::size_t i = 1; i < current_[c].size(); ++i)
      {
        const Index from = current_[c][i - 1], to = current_[c][i];
        path.clear();
        geodesics.append_segment(location_[chain.nodes[from]], location_[chain.nodes[to]], path);
        if(path.empty()) // not the same point, but as near as points can be: the branch must not break
          path.push_back(location_[chain.nodes[to]]);
        Index last = add_node(chain.nodes[from]);
        for(std::size_t k = 0; k < path.size(); ++k)
        {
          const Index next = k + 1 < path.size() ? add(path[k]) : add_node(chain.nodes[to]);
          const Indexed_cut_locus::Edge& origin = input_.edges[chain.edges[from + k * (to - from) / path.size()]];
          result.edges.push_back({last, next, null_index, origin.strength, origin.origin, 0.f, origin.sources});
          spans_.push_back({static_cast<Index>(c), from, to});
          last = next;
        }
      }
    }
    return result;
  }

  // the root, or the next node that is left if it has been dropped
  Index root() const
  {
    for(std::size_t c = 0; c < current_.size(); ++c)
    {
      const std::vector<Index>& nodes = network_.chains[c].nodes;
      const auto found = std::find(nodes.begin(), nodes.end(), Index(0));
      if(found != nodes.end())
        return nodes[*std::lower_bound(current_[c].begin(), current_[c].end(), Index(found - nodes.begin()))];
    }
    return 0;
  }

  // places of a chain to either side that its tangent and its sides are taken from: twice the period of a zigzag,
  // less one
  static constexpr std::size_t window = 3;

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  const Indexed_cut_locus& input_;
  Curve_network network_;
  One_sided_distances sides_;
  Smoothing_limits limits_;
  std::vector<Indexed_location> location_; // of each node
  std::vector<Vector> position_, displacement_;
  std::vector<std::vector<Index>> current_; // the places of each chain that have not been dropped
  std::vector<Span> spans_;                 // of each edge of the result
};

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * moves a cut locus from the edges of the mesh onto the smooth curves it stands for, through the faces.
 *
 * The branches stay as they are and meet as they did; their nodes become points in faces, joined by geodesic segments.
 * Each edge of the result lies in one face and tells the edge of `cut_locus` that it comes from; no edge has length
 * zero, and no node at which a branch turned back by more than a right angle is left. Distances are interpolated in
 * the faces.
 *
 * The scheme is that of Mancinelli, Livesu and Puppo \cgalCite{cgal:mlp-pccld-21}: in each iteration, regular nodes
 * move along straightest geodesics in the direction of the tangential normal of their curve, by no more than the
 * length of an edge, branch points move to the centroid of their neighbors, and a relaxation in the tangent plane
 * comes last. It differs in the length of the step. In the paper it is the component of the gradient along the normal;
 * but a gradient estimated across the cut locus averages both sides, over the width of the estimator. Here, quadrics
 * are fitted to the distances on either side of the curve, and the node moves to where both give the same distance. So
 * the damping leaves 0.5 of the way at first, and half of that with each iteration, where the paper's takes it. Where
 * the sides hardly differ, by the errors of the fits, the node follows its neighbors.
 *
 * At a leaf, the paper displaces in the direction opposite to the transported normal of the neighbor. As a displacement
 * by the component of the gradient along a normal does not depend on the sign of the normal, this is read as: a leaf
 * takes its normal from its neighbor, and moves across the straight continuation of its branch.
 *
 * Each node stays in the faces around its vertex and leaves that only away from the side on which the shortest path to
 * it arrives; where segments would meet, or leave the faces around the vertices of their ends, or these are no disk, the
 * curve goes back to the edges of the mesh. So its complement stays an open disk.
 *
 * @param distance the distance of each vertex to the source
 * @param cut_locus a graph of mesh edges
 * @param source_of_face the source whose faces each one belongs to, which the curve does not enter, or `null_index`; or
 *        empty
 *
 * The time is linear in the size of the mesh, for tables, and in the size of `cut_locus`, for everything else.
 */
inline Indexed_cut_locus smoothed_cut_locus(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                            const std::vector<double>& distance, const Indexed_cut_locus& cut_locus,
                                            const Smoothing_parameters& parameters = Smoothing_parameters(),
                                            const internal::Progress& progress = {},
                                            const std::vector<Index>& source_of_face = {})
{
  return internal::Cut_locus_smoother(mesh, connectivity, distance, cut_locus, source_of_face)(parameters, progress);
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_H
