// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_PATH_FLOW_H
#define CGAL_CUT_LOCI_LAPLACIAN_PATH_FLOW_H

#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Source_forest.h>
#include <CGAL/Cut_loci/laplacian/Source_roots.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// How many paths to the source cross each edge.
//
// A path is the sequence of the halfedges that it crosses. One that comes to a halfedge of an older path goes on as
// that does: so each halfedge is recorded once.
class Path_flow
{
public:
  Path_flow(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
    : mesh_(mesh), connectivity_(connectivity), next_(mesh.number_of_halfedges(), null_index),
      is_recorded_(mesh.number_of_halfedges(), 0), count_(mesh.number_of_halfedges(), 0)
  {
  }

  bool is_recorded(Index h) const { return is_recorded_[h] != 0; }

  // The last halfedge, and no other, may be recorded.
  void add(const std::vector<Index>& path)
  {
    ++count_[path.front()];
    for(std::size_t i = path.size(); i-- > 0;)
    {
      if(is_recorded_[path[i]])
        continue;
      is_recorded_[path[i]] = 1;
      order_.push_back(path[i]);
      if(i + 1 < path.size())
        next_[path[i]] = path[i + 1];
    }
  }

  // Edges across which the faces form a forest: first those at the sources, then those that most paths cross. Where paths
  // go around something on both sides, not all their crossings have room in a forest. Of several sources, none is in the
  // tree of another one.
  std::vector<unsigned char> forest(const Source_roots& roots, const Progress& progress)
  {
    for(std::size_t i = order_.size(); i-- > 0;) // the youngest path first, and each from its start
      if(next_[order_[i]] != null_index)
        count_[next_[order_[i]]] += count_[order_[i]];
    progress(0.2);
    Index most = 0;
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
      most = (std::max)(most, number_of_paths(e));
    const Compressed_rows<Index> edges(most,
                                       [&](const auto& add_edge)
                                       {
      for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
        if(const Index n = number_of_paths(e); n > 0)
          add_edge(most - n, e);
    });
    progress(0.5);
    std::vector<unsigned char> result(connectivity_.number_of_edges(), 0);
    Source_forest parts(mesh_.number_of_faces());
    for(Index i = 0; i < roots.number_of_sources() && roots.number_of_sources() > 1; ++i)
      parts.plant(roots.face(i), i);
    const auto add = [&](Index h)
    {
      if(parts.link(h / 3, mesh_.opposite[h] / 3))
        result[connectivity_.edge_of_halfedge[h]] = 1;
    };
    std::for_each(roots.crossings().begin(), roots.crossings().end(), add);
    const Progress rest = progress.part(0.5, 1.);
    for(Index i = 0; i < most; ++i)
    {
      rest(i, most);
      for(Index e : edges[i])
        add(connectivity_.halfedge_of_edge[e]);
    }
    return result;
  }

private:
  Index number_of_paths(Index e) const
  {
    const Index h = connectivity_.halfedge_of_edge[e];
    return mesh_.is_border_edge(h) ? 0 : count_[h] + count_[mesh_.opposite[h]];
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  std::vector<Index> next_;
  std::vector<unsigned char> is_recorded_;
  std::vector<Index> count_; // of the paths that start across a halfedge, then of all that cross it
  std::vector<Index> order_; // recorded halfedges, each path from its end
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_PATH_FLOW_H
