// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_METHOD_PATH_FOREST_H
#define CGAL_CUT_LOCI_LAPLACIAN_METHOD_PATH_FOREST_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/laplacian_method/Path_flow.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Edges across which the faces form a forest, out of those that paths cross. Where paths go around something on both
// sides, not all their crossings have room in one.
//
// Along shortest paths all faces lead to the source, and each has room for one way out: the one for which the paths
// through the face become least longer, all of them together. A path that would leave by another way goes over to those
// of this one; what that costs depends on what becomes of these, so the faces next to the source are decided first.
// Where paths are not known that well, their numbers decide.
class Path_forest
{
public:
  Path_forest(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Path_flow& flow)
    : mesh_(mesh), connectivity_(connectivity), flow_(flow), parts_(mesh.number_of_faces())
  {
    flow_.count_all();
  }

  // Those of the halfedges `roots` come first.
  std::vector<unsigned char> operator()(const std::vector<Index>& roots, const Progress& progress)
  {
    result_.assign(connectivity_.number_of_edges(), 0);
    for(Index h : roots)
      add(h);
    const std::vector<Index> order =
      flow_.has_images() ? exits_by_loss(progress.part(0., 0.7)) : edges_by_number_of_paths();
    progress(0.7);
    const Progress rest = progress.part(0.7, 1.);
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      rest(i, order.size());
      add(order[i]);
    }
    return result_;
  }

private:
  struct Exit
  {
    double loss;
    Index count, halfedge;

    bool operator<(const Exit& other) const
    {
      if(loss != other.loss)
        return loss > other.loss;
      return count != other.count ? count > other.count : halfedge < other.halfedge;
    }
  };
  struct Passage // a face that paths go through
  {
    double distance;
    Index face;

    bool operator<(const Passage& other) const
    {
      return distance != other.distance ? distance < other.distance : face < other.face;
    }
  };

  void add(Index h)
  {
    if(parts_.unite(h / 3, mesh_.opposite[h] / 3))
      result_[connectivity_.edge_of_halfedge[h]] = 1;
  }

  // those that paths cross, most of them first; by counting, as most numbers are small
  std::vector<Index> edges_by_number_of_paths() const
  {
    const Index ne = connectivity_.number_of_edges();
    std::vector<Index> number(ne);
    for(Index e = 0; e < ne; ++e)
      number[e] = flow_.number_of_paths(e);
    const Index most = ne == 0 ? 0 : *std::max_element(number.begin(), number.end());
    std::vector<Index> begin(most + std::size_t(1), 0); // of those with `most - i` paths
    for(Index e = 0; e < ne; ++e)
      if(number[e] > 0)
        ++begin[most - number[e] + std::size_t(1)];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> result(begin.back());
    for(Index e = 0; e < ne; ++e)
      if(number[e] > 0)
        result[begin[most - number[e]]++] = connectivity_.halfedge_of_edge[e];
    return result;
  }

  // One way out of each face, from the source outward, and then the others, those first whose loss is largest.
  std::vector<Index> exits_by_loss(const Progress& progress)
  {
    delay_.assign(flow_.number_of_records(), 0.);
    const std::vector<Passage> passages = passages_by_distance();
    std::vector<Index> result;
    result.reserve(passages.size());
    std::vector<Exit> others;
    for(std::size_t i = 0; i < passages.size(); ++i)
    {
      progress(i, passages.size());
      const Index f = passages[i].face;
      const Exit best = best_exit(f);
      set_delays(f, best.halfedge);
      result.push_back(best.halfedge);
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(h != best.halfedge && flow_.first(h) != null_index)
          others.push_back({best.loss, flow_.number_across(h), h});
    }
    std::sort(others.begin(), others.end());
    for(const Exit& e : others)
      result.push_back(e.halfedge);
    return result;
  }

  // A face comes after those that its paths lead to, but where these have others that leave them farther away.
  std::vector<Passage> passages_by_distance() const
  {
    std::vector<Passage> result;
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
    {
      double farthest = -1.;
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        for(Index r = flow_.first(h); r != null_index; r = flow_.other(r))
          farthest = (std::max)(farthest, flow_.distance(r));
      if(farthest >= 0.)
        result.push_back({farthest, f});
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  Exit best_exit(Index f) const
  {
    Exit best{(std::numeric_limits<double>::infinity)(), 0, null_index};
    const bool is_only_one = has_one_exit(f);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(flow_.first(h) != null_index)
      {
        const Exit exit{is_only_one ? 0. : loss(h), flow_.number_across(h), h};
        if(best.halfedge == null_index || exit.loss < best.loss || (exit.loss == best.loss && exit.count > best.count))
          best = exit;
      }
    return best;
  }

  bool has_one_exit(Index f) const
  {
    int exits = 0;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      exits += flow_.first(h) != null_index;
    return exits == 1;
  }

  // by how much the paths through a face become longer if all leave it across `exit`
  double loss(Index exit) const
  {
    double result = 0.;
    const Index f = exit / 3;
    const std::array<Planar_vector, 3> corners = corners_of(f);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      for(Index r = flow_.first(h); r != null_index; r = flow_.other(r))
        result += flow_.count(r) * (h == exit ? delay(flow_.next(r)) : loss(r, exit, corners));
    return result;
  }

  // the same for record `r`, which leaves the face elsewhere
  double loss(Index r, Index exit, const std::array<Planar_vector, 3>& corners) const
  {
    const Planar_vector p = flow_.entrance(r, corners);
    double best = (std::numeric_limits<double>::infinity)();
    for(Index t = flow_.first(exit); t != null_index; t = flow_.other(t))
      best = (std::min)(best, norm(p - flow_.exit(t, corners)) + flow_.distance(t) + delay(flow_.next(t)));
    const double own = norm(p - flow_.exit(r, corners)) + flow_.distance(r);
    return (std::max)(0., best - own);
  }

  void set_delays(Index f, Index exit)
  {
    for(Index r = flow_.first(exit); r != null_index; r = flow_.other(r))
      delay_[r] = delay(flow_.next(r));
    if(has_one_exit(f))
      return;
    const std::array<Planar_vector, 3> corners = corners_of(f);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      for(Index r = h == exit ? null_index : flow_.first(h); r != null_index; r = flow_.other(r))
        delay_[r] = loss(r, exit, corners);
  }

  // by how much a path that goes on as record `r` becomes longer; none at the source
  double delay(Index r) const { return r == null_index ? 0. : delay_[r]; }

  std::array<Planar_vector, 3> corners_of(Index f) const
  {
    return {{{{0., 0.}}, {{edge_length(mesh_, 3 * f), 0.}}, apex(mesh_, 3 * f)}};
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  Path_flow& flow_;
  Union_find parts_;                  // of the faces
  std::vector<unsigned char> result_; // see `operator()`
  std::vector<double> delay_;         // of each record
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_METHOD_PATH_FOREST_H
