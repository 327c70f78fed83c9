// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DIRECTION_GEOMETRY_H
#define CGAL_CUT_LOCI_DIRECTION_GEOMETRY_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/internal/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * is what the direction method reads off a mesh once: angles, lengths and curvatures.
 *
 * The polar angle of a halfedge is measured counterclockwise from the first one in the ring of its source, and scaled
 * so that the angles around an interior vertex sum up to 2 pi.
 */
struct Direction_geometry
{
  std::vector<float> polar;     ///< of each halfedge, scaled
  std::vector<float> corner;    ///< the angle between each halfedge and the next one around its source, not scaled
  std::vector<float> length;    ///< of each halfedge
  std::vector<float> scale;     ///< of the angles around each vertex; 1 on the border
  std::vector<float> deficit;   ///< 2 pi minus the sum of the angles at each vertex; 0 on the border
  std::vector<float> curvature; ///< the Gaussian curvature at each vertex, averaged over its 2-ring
  double mean_edge_length = 0.;
  double deficit_noise = 0.; ///< a robust standard deviation of what the deficits differ by from their surroundings
  double noise_share = 0.;   ///< the part of it that is noise of the vertices and not shape, from 0 to 1

  Direction_geometry(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
    : mean_edge_length(connectivity.mean_edge_length)
  {
    std::vector<double> area(mesh.number_of_vertices(), 0.);
    measure_faces(mesh, area);
    measure_vertices(mesh, connectivity);
    measure_curvature(mesh, connectivity, area);
  }

  /// the scaled polar angle at the source of `h`, and that of the opposite direction at its target
  std::array<float, 2> polar_at_ends(const Indexed_triangle_mesh& mesh, Index h) const
  {
    const Index o = mesh.opposite[h];
    if(o != null_index)
      return {{polar[h], polar[o]}};
    const Index n = Indexed_triangle_mesh::next(h);
    return {{polar[h], polar[n] + scale[mesh.source(n)] * corner[n]}};
  }

  /*!
   * by what factor the noise of the mesh makes branches at `distance` stronger than a smooth mesh would.
   *
   * On a rough mesh, paths are deflected by the deficits of the `n` vertices that they pass, and what they add up to is
   * seen in units of one edge: the strengths of the branches that begin behind the bumps grow with `n` times the noise.
   * Noise so large that it is most of what explains the jumps does not make them stronger. What is left is a random
   * walk of `n` steps: the strongest branch behind the bumps of tori and ellipsoids with noise along the normals of 10
   * and 20 % of the edges is, at all resolutions, about 0.7 and at most 1.1 times the square root of `n`.
   */
  double noise_factor(double distance) const
  {
    const double n = distance / mean_edge_length;
    return (std::max)(1., (std::min)(std::pow(1. + n * noise_share * deficit_noise, 0.7), std::sqrt(n) / 2.5));
  }

  /*!
   * the least strength of a branch that is no noise of the mesh, for distances up to `distance`: on a smooth mesh,
   * strengths of up to 2 occur by chance, and 3 is clear of them.
   */
  double default_strength_threshold(double distance) const { return 3. * noise_factor(distance); }

private:
  static double pi() { return 3.14159265358979323846; }

  void measure_faces(const Indexed_triangle_mesh& mesh, std::vector<double>& area)
  {
    using namespace internal;
    corner.resize(mesh.number_of_halfedges());
    length.resize(mesh.number_of_halfedges());
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
    {
      const Indexed_triangle_mesh::Triangle& t = mesh.triangles[f];
      const std::array<Vector, 3> edge = {{mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[1]],
                                           mesh.points[t[0]] - mesh.points[t[2]]}};
      const double twice_area = norm(cross(edge[0], edge[1]));
      for(Index i = 0; i < 3; ++i)
      {
        length[3 * f + i] = static_cast<float>(norm(edge[i]));
        corner[3 * f + i] = static_cast<float>(std::atan2(twice_area, -dot(edge[i], edge[(i + 2) % 3])));
        area[t[i]] += twice_area / 6.;
      }
    }
  }

  void measure_vertices(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
  {
    polar.resize(mesh.number_of_halfedges());
    scale.assign(mesh.number_of_vertices(), 1.f);
    deficit.assign(mesh.number_of_vertices(), 0.f);
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    {
      double sum = 0.;
      for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
      {
        const Index h = connectivity.ring_halfedge[entry];
        if(mesh.source(h) != v)
          break; // the last edge of a border vertex
        polar[h] = static_cast<float>(sum);
        sum += corner[h];
      }
      if(connectivity.is_border(v))
        continue;
      deficit[v] = static_cast<float>(2. * pi() - sum);
      scale[v] = static_cast<float>(2. * pi() / sum);
      for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
        polar[connectivity.ring_halfedge[entry]] *= scale[v];
    }
  }

  void measure_curvature(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                         const std::vector<double>& area)
  {
    const Index nv = mesh.number_of_vertices();
    std::vector<double> k(nv), a(nv), k_ring(nv), a_ring(nv);
    for(Index v = 0; v < nv; ++v)
    {
      // the deficit of a border vertex is no curvature of the surface, so its area must not count either
      k[v] = deficit[v];
      a[v] = connectivity.is_border(v) ? 0. : area[v];
    }
    std::vector<float> difference;
    for(int round = 0; round < 2; ++round)
    {
      for(Index v = 0; v < nv; ++v)
      {
        k_ring[v] = k[v];
        a_ring[v] = a[v];
        for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
        {
          k_ring[v] += k[connectivity.ring_vertex[entry]];
          a_ring[v] += a[connectivity.ring_vertex[entry]];
        }
      }
      if(round == 0)
        for(Index v = 0; v < nv; ++v)
          if(a[v] > 0.)
            difference.push_back(static_cast<float>(std::fabs(k[v] - k_ring[v] / a_ring[v] * a[v])));
      k.swap(k_ring);
      a.swap(a_ring);
    }
    curvature.resize(nv);
    for(Index v = 0; v < nv; ++v)
      curvature[v] = a[v] > 0. ? static_cast<float>(k[v] / a[v]) : 0.f;
    if(!difference.empty())
    {
      const auto middle = difference.begin() + static_cast<std::ptrdiff_t>(difference.size() / 2);
      std::nth_element(difference.begin(), middle, difference.end());
      deficit_noise = *middle / 0.6745; // the median of the absolute value of a normal variable of deviation 1
    }
    measure_noise_share(mesh, connectivity);
  }

  /*
   * A vertex that is out of place has a deficit of one sign, and its neighbors have more of the other; where the shape
   * is rough, or sampled coarsely, the signs are independent or agree. The mean of the product of the sign at a vertex
   * and that of the sum over its neighbors is -0.39 to -0.48 for noise along the normals of 3 to 20 % of the edges on
   * tori and ellipsoids, of any resolution; 1 without noise; and between -0.05 and 0.8 for scans and sculptures. Down to
   * -0.1 it can be chance, on a hundred vertices with independent signs; halfway from there to noise alone, where noise
   * and shape mix, the noise decides.
   */
  void measure_noise_share(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
  {
    constexpr double no_noise = -0.1, all_noise = -0.25;
    double sum = 0., count = 0.;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    {
      if(connectivity.is_border(v))
        continue;
      double around = 0.;
      for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
        around += deficit[connectivity.ring_vertex[entry]];
      sum += deficit[v] * around > 0. ? 1. : deficit[v] * around < 0. ? -1. : 0.;
      ++count;
    }
    if(count > 0.)
      noise_share = (std::min)((std::max)((sum / count - no_noise) / (all_noise - no_noise), 0.), 1.);
  }
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_DIRECTION_GEOMETRY_H
