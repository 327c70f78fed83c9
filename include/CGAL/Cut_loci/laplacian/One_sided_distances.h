// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_ONE_SIDED_DISTANCES_H
#define CGAL_CUT_LOCI_LAPLACIAN_ONE_SIDED_DISTANCES_H

#include <CGAL/Cut_loci/internal/small_systems.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Near the cut locus the distance is the smaller one of two smooth functions, those of the shortest paths that arrive
// from either side. This class finds both around a point, as quadrics in the tangent plane there, fitted to the
// distances at the vertices of each side, up to a few rings from the curve. At first the sides are those of the curve;
// then each vertex goes to the side whose function is lower there, as the curve may run a vertex beside the cut locus.
class One_sided_distances
{
public:
  using Seeds = std::vector<Index>;

  struct Quadric
  {
    double value = 0., error = 0.; // at the point; the most that residuals as large can amount to there
    std::array<double, 2> gradient = {{0., 0.}};
  };

  struct Candidate
  {
    Index vertex;
    int side; // 0 left, 1 right
    unsigned char depth;
    double u, v, weight, distance;
  };

  One_sided_distances(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                      const std::vector<double>& distance)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance), visit_of_(mesh.number_of_vertices(), 0),
      slot_(mesh.number_of_vertices(), 0)
  {
  }

  // Collects the vertices around the curve: `seeds[0]` are next to it on the left, `seeds[1]` on the right, `on_curve`
  // tells the vertices that no ring may cross. What both sides reach at once is left out.
  template <typename IsOnCurve>
  void gather(const std::array<Seeds, 2>& seeds, const IsOnCurve& is_on_curve)
  {
    ++visit_;
    candidates_.clear();
    const auto reach = [&](Index v, int side, unsigned char depth)
    {
      if(is_on_curve(v))
        return;
      if(visit_of_[v] == visit_)
      {
        Candidate& c = candidates_[slot_[v]];
        if(c.depth == depth && c.side != side)
          c.side = neither;
        return;
      }
      visit_of_[v] = visit_;
      slot_[v] = static_cast<Index>(candidates_.size());
      candidates_.push_back({v, side, depth, 0., 0., 0., distance_[v]});
    };
    for(int side = 0; side < 2; ++side)
      for(Index v : seeds[side])
        reach(v, side, 1);
    for(std::size_t i = 0; i < candidates_.size(); ++i)
    {
      const Candidate c = candidates_[i];
      if(c.depth == rings || c.side == neither)
        continue;
      for(Index entry = connectivity_.ring_begin[c.vertex]; entry < connectivity_.ring_begin[c.vertex + 1]; ++entry)
        reach(connectivity_.ring_vertex[entry], c.side, static_cast<unsigned char>(c.depth + 1));
    }
    candidates_.erase(
      std::remove_if(candidates_.begin(), candidates_.end(), [](const Candidate& c) { return c.side == neither; }),
      candidates_.end());
  }

  // Fits both sides around `center`, in the plane spanned by the orthonormal `e1` and `e2`; false if a side has too
  // few vertices.
  bool fit(const Vector& center, const Vector& e1, const Vector& e2)
  {
    double radius = 0.;
    for(Candidate& c : candidates_)
    {
      const Vector d = mesh_.points[c.vertex] - center;
      c.u = dot(d, e1);
      c.v = dot(d, e2);
      // Behind a fold the plane does not see the surface: it is far away by this measure, and weighs little.
      c.weight = dot(d, d);
      radius = (std::max)(radius, c.weight);
    }
    radius = std::sqrt(radius);
    if(!(radius > 0.))
      return false;
    for(Candidate& c : candidates_)
    {
      const double t = 1. - c.weight / (radius * radius);
      c.weight = t * t + 1e-3; // the farthest count little, but enough for the fit to exist
    }
    radius_ = radius;
    for(int round = 0; round < rounds; ++round)
    {
      if(!fit_side(0, round) || !fit_side(1, round))
        return false;
      if(round + 1 < rounds)
        for(Candidate& c : candidates_)
          c.side = evaluate(0, c) <= evaluate(1, c) ? 0 : 1;
    }
    return true;
  }

  const Quadric& left() const { return quadric_[0]; }
  const Quadric& right() const { return quadric_[1]; }

private:
  static constexpr int neither = 2;
  // A quadric has six coefficients, and a ring of one side about six vertices: four of them leave enough if those next
  // to the curve are on its wrong side.
  static constexpr unsigned char rings = 4;
  static constexpr int rounds = 3;

  using Row = Small_vector<6>;

  Row monomials(const Candidate& c) const
  {
    const double u = c.u / radius_, v = c.v / radius_;
    return {{1., u, v, u * u, u * v, v * v}};
  }

  double evaluate(int side, const Candidate& c) const { return dot_product(coefficients_[side], monomials(c)); }

  bool fit_side(int side, int round)
  {
    Small_matrix<6> a = {};
    Row b = {};
    int count = 0;
    for(const Candidate& c : candidates_)
    {
      // at first without the vertices next to the curve, which may be on its wrong side
      if(c.side != side || (round == 0 && c.depth == 1))
        continue;
      const Row m = monomials(c);
      add_square(c.weight, m, a);
      add_multiple(c.weight * c.distance, m, b);
      ++count;
    }
    if(count < 9) // half as many again as there are coefficients
      return false;
    // far below the weight of any vertex: only decides what the vertices leave open
    double trace = 0.;
    for(int i = 0; i < 6; ++i)
      trace += a[i][i];
    for(int i = 0; i < 6; ++i)
      a[i][i] += 1e-10 * trace;
    const Cholesky_factor<6> factor(a);
    if(!(factor.least_diagonal() > 0.))
      return false;
    const Row x = factor.solve(b);
    if(!std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); }))
      return false;
    coefficients_[side] = x;
    double sum = 0.;
    for(const Candidate& c : candidates_)
      if(c.side == side)
      {
        const double r = dot_product(x, monomials(c)) - c.distance;
        sum += c.weight * r * r;
      }
    // The value is a linear function of the distances: the inequality of Cauchy and Schwarz.
    const double leverage = factor.solve({{1., 0., 0., 0., 0., 0.}})[0];
    quadric_[side] = {x[0], std::sqrt((std::max)(0., sum * leverage)), {{x[1] / radius_, x[2] / radius_}}};
    return true;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  std::vector<Index> visit_of_, slot_; // the visit that reached a vertex, and its candidate
  Index visit_ = 0;
  std::vector<Candidate> candidates_;
  double radius_ = 1.;
  Row coefficients_[2];
  Quadric quadric_[2];
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_ONE_SIDED_DISTANCES_H
