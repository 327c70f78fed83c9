// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_ARRIVING_PATHS_H
#define CGAL_CUT_LOCI_INTERNAL_ARRIVING_PATHS_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/internal/flat_triangles.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The last leg of the shortest path to a vertex, guessed from the distances of its neighbors: each face around it, laid
// flat, and the distances of its two other corners give an image of the source, and so a distance; where that comes
// nearest to the given one, there the path arrives.
class Arriving_paths
{
public:
  struct Leg
  {
    Index halfedge = null_index; // along this one, to the vertex or from it; or across it, the one opposite to the vertex
    bool is_along = false;
    double place = 0.; // where it is crossed, from its source on, as a part
  };

  Arriving_paths(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                 const std::vector<double>& distance)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance)
  {
  }

  Leg operator()(Index v) const
  {
    Leg best;
    double least = (std::numeric_limits<double>::infinity)();
    const auto offer = [&](const Leg& leg, double distance)
    {
      const double error = std::abs(distance - distance_[v]);
      if(!(error < least))
        return;
      least = error;
      best = leg;
    };
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
    {
      const Index h = connectivity_.ring_halfedge[k];
      offer({h, true, 0.}, distance_[connectivity_.ring_vertex[k]] + edge_length(mesh_, h));
      Leg leg;
      double distance;
      if(mesh_.source(h) == v && image(mesh_.next(h), leg, distance)) // the last halfedge at a border comes in
        offer(leg, distance);
    }
    return best;
  }

private:
  // The distance of the apex of `h` by the image of the source beyond `h`, if it sees the apex through it.
  bool image(Index h, Leg& leg, double& distance) const
  {
    const double a = distance_[mesh_.source(h)], b = distance_[mesh_.target(h)], length = edge_length(mesh_, h);
    const double x = (length * length + a * a - b * b) / (2. * length), y2 = a * a - x * x;
    if(!(y2 > 0.))
      return false;
    const double y = std::sqrt(y2);
    const Planar_vector top = apex(mesh_, h);
    const double place = (x * top[1] + top[0] * y) / (top[1] + y) / length;
    if(!(place > 0. && place < 1.))
      return false;
    leg = {h, false, place};
    distance = std::hypot(top[0] - x, top[1] + y);
    return true;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_ARRIVING_PATHS_H
