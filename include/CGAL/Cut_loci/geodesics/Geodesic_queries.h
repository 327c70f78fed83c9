// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_QUERIES_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_QUERIES_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is the end of a shortest path: its last straight piece, in the frame of a halfedge of the face in which it ends.
struct Geodesic_arrival
{
  double x = 0., y = 0.;         // the image of the (pseudo-)source
  double sigma = 0., turn = 0.;  // as in `Geodesic_window`
  Index halfedge = null_index;   // of the frame
  Index origin = null_index;     // as in `Geodesic_window`
  bool crosses_halfedge = false; // else the image lies in the face itself
  double rate = 1., error = 0.;  // as in `Geodesic_window`
};

/// is a point with its distance and the last piece of its path, in whose face it is given.
struct Geodesic_query
{
  Indexed_location location;
  double distance;
  Geodesic_arrival arrival;
};

/// holds the points whose distance is asked for in a run of `Exact_geodesic_propagation`, by face.
class Geodesic_queries
{
public:
  bool empty() const { return queries_.empty(); }
  std::size_t size() const { return queries_.size(); }
  const Geodesic_query& operator[](std::size_t i) const { return queries_[i]; }
  std::vector<Geodesic_query>& all() { return queries_; }

  void prepare(const std::vector<Indexed_location>& locations, Index number_of_faces)
  {
    queries_.clear();
    by_face_ = {};
    for(const Indexed_location& location : locations)
      queries_.push_back({location, (std::numeric_limits<double>::infinity)(), Geodesic_arrival()});
    if(queries_.empty())
      return;
    by_face_ = Compressed_rows<Index>(number_of_faces,
                                      [&](const auto& add)
                                      {
      for(Index i = 0; i < queries_.size(); ++i)
        add(queries_[i].location.face, i);
    });
  }

  template <typename Function>
  void for_each_in(Index face, const Function& function)
  {
    for(Index i : by_face_[face])
      function(queries_[i]);
  }

private:
  std::vector<Geodesic_query> queries_;
  Compressed_rows<Index> by_face_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_QUERIES_H
