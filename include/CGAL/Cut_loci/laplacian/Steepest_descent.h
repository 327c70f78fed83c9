// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_STEEPEST_DESCENT_H
#define CGAL_CUT_LOCI_LAPLACIAN_STEEPEST_DESCENT_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Where a distance that is linear in each face falls most.
class Steepest_descent
{
public:
  // The way from a vertex down: through the face of `halfedge`, which leaves the vertex, or along it.
  struct Outflow
  {
    Index halfedge = null_index;
    bool is_along = false;
    double place = 0.; // on the opposite edge, from the target of `halfedge` on
  };

  // The distance in the frame of a halfedge: from its source, with the face at y > 0.
  struct Slope
  {
    double length, apex_x, apex_y;
    double x, y; // downwards
  };

  Steepest_descent(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   const std::vector<double>& distance)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance)
  {
  }

  Slope slope(Index h) const
  {
    const Planar_vector top = apex(mesh_, h);
    Slope result;
    result.length = edge_length(mesh_, h);
    result.apex_x = top[0];
    result.apex_y = top[1];
    const double at_source = distance_[mesh_.source(h)];
    result.x = (at_source - distance_[mesh_.target(h)]) / result.length;
    result.y = (at_source - distance_[mesh_.source(mesh_.previous(h))] - result.x * result.apex_x) / result.apex_y;
    return result;
  }

  Outflow outflow(Index v) const
  {
    Outflow result;
    double steepest = 0.;
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
    {
      const Index h = connectivity_.ring_halfedge[k], w = connectivity_.ring_vertex[k];
      const bool leaves = mesh_.source(h) == v; // all but the last one at a border
      if(distance_[w] < distance_[v])
      {
        const double s = (distance_[v] - distance_[w]) / edge_length(mesh_, h);
        if(s > steepest)
        {
          steepest = s;
          result = {h, true, 0.};
        }
      }
      if(!leaves)
        continue;
      const Slope s = slope(h);
      const double right = s.y, left = s.x * s.apex_y - s.y * s.apex_x; // both positive inside the corner
      if(!(right > 0. && left > 0.))
        continue;
      const double steepness = std::sqrt(s.x * s.x + s.y * s.y);
      if(steepness > steepest)
      {
        steepest = steepness;
        // sides of the ray on which the ends of the opposite edge are
        result = {h, false, right * s.length / (right * s.length + left)};
      }
    }
    return result;
  }

private:
  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_STEEPEST_DESCENT_H
