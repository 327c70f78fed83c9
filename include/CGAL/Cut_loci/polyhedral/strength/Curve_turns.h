// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_CURVE_TURNS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_CURVE_TURNS_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the angles by which the sides of curves turn at their vertices, towards the surface beside them: by Gauss-Bonnet, two
 * shortest paths that come from a curve meet at the angle by which it turns between their starts, plus the curvature that
 * they enclose.
 */
class Curve_turns
{
public:
  std::vector<std::vector<double>> chains; ///< of each side that goes on from edge to edge, in order
  double length = 0.;                      ///< of all sides

  Curve_turns() = default;
  Curve_turns(const Indexed_triangle_mesh& mesh, const Geodesic_faces& faces, const std::vector<Indexed_curve>& curves)
  {
    std::vector<unsigned char> is_side(mesh.number_of_halfedges(), 0);
    std::vector<Index> sides;
    for(const Indexed_curve& curve : curves)
      for(Index h : curve.halfedges)
        for(Index side : {h, mesh.opposite[h]})
          if(side != null_index && !is_side[side])
          {
            is_side[side] = 1;
            sides.push_back(side);
            length += faces.length(side);
          }
    std::vector<unsigned char> is_done(mesh.number_of_halfedges(), 0);
    for(Index first : sides)
    {
      chains.emplace_back();
      for(Index h = first; h != null_index && !is_done[h];)
      {
        is_done[h] = 1;
        double angle = 0.;
        h = next_side(mesh, faces, is_side, h, angle);
        if(h != null_index)
          chains.back().push_back(geodesic_pi - angle);
      }
    }
  }

  double number() const
  {
    double result = 0.;
    for(const std::vector<double>& chain : chains)
      result += static_cast<double>(chain.size());
    return result;
  }
  double mean_edge_length() const { return length / (std::max)(1., number()); }

  /// leaves those that are more than a hundredth of the others, and no rounding: see `Geodesic_sources::is_seam()`
  void drop_straight()
  {
    double sum = 0.;
    for(const std::vector<double>& chain : chains)
      for(double t : chain)
        sum += std::fabs(t);
    const double straight = (std::max)(2.5e-4, 0.01 * sum / (std::max)(1., number()));
    for(std::vector<double>& chain : chains)
      chain = up_to((std::numeric_limits<double>::infinity)(), chain, straight);
  }

  /*
   * The standard deviation of turns that is noise, without those above `most`. Vertices of curves that are displaced by a,
   * independently of each other, turn by the second difference of that over the length of an edge, which has the variance
   * 6 a^2; that from the mean of both neighbors has 17.5 a^2.
   */
  double noise(double most) const
  {
    std::vector<double> deviations;
    for(const std::vector<double>& chain : chains)
    {
      const std::vector<double> kept = up_to(most, chain);
      for(std::size_t i = 1; i + 1 < kept.size(); ++i)
        deviations.push_back(std::fabs(kept[i] - 0.5 * (kept[i - 1] + kept[i + 1])));
    }
    return deviations.empty() ? 0. : of_median * std::sqrt(6. / 17.5) * median(deviations);
  }

  static constexpr double of_median = 1.4826; // of the sizes of normally distributed numbers: their standard deviation
  static double median(std::vector<double>& values)
  {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

private:
  static std::vector<double> up_to(double most, const std::vector<double>& chain, double above = -1.)
  {
    std::vector<double> result;
    std::copy_if(chain.begin(), chain.end(), std::back_inserter(result),
                 [&](double t) { return std::fabs(t) <= most && std::fabs(t) > above; });
    return result;
  }

  /// the side that follows around the target of `h`, or null if the border comes first; `angle` becomes that between the two
  static Index next_side(const Indexed_triangle_mesh& mesh, const Geodesic_faces& faces,
                         const std::vector<unsigned char>& is_side, Index h, double& angle)
  {
    Index g = Indexed_triangle_mesh::next(h);
    for(angle = faces.angle(g); !is_side[g]; angle += faces.angle(g))
    {
      if(mesh.opposite[g] == null_index)
        return null_index;
      g = Indexed_triangle_mesh::next(mesh.opposite[g]);
    }
    return g;
  }
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_CURVE_TURNS_H
