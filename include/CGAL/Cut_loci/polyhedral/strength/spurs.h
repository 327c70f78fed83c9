// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SPURS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SPURS_H

#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * removes branches that are not as high as `least`. Where branches meet, the highest one continues and the others end; at
 * cycles, and at the first `terminals` nodes, all of them end. At the root of a tree without these the two highest are one
 * branch; if neither is high, the tree is a point.
 *
 * The height of a branch is by how much a way along it is longer than the distance grows from one end to the other. If
 * noise may lengthen paths by as much, it may have made the branch: near the end of another one, which the polyhedron
 * divides between its vertices, or around the antipode of a part that is nearly a sphere, where all paths meet.
 *
 * @param edges as in `Tree_branches::edges()`
 * @param height of an edge, of which branches sum it up
 * @param is_exempt tells of an edge that no branch through it is a spur, however low
 */
template <typename Height, typename Is_exempt>
void remove_spurs(std::vector<Tree_branches::Edge>& edges, Index number_of_nodes, Index terminals, double least,
                  const Height& height, const Is_exempt& is_exempt)
{
  struct Ways // outward from a node: the two highest
  {
    std::array<double, 2> height = {{0., 0.}};
    std::array<Index, 2> edge = {{null_index, null_index}};
    bool is_in_core = false;
  };
  std::vector<Ways> ways(number_of_nodes);
  for(Index i = 0; i < terminals; ++i)
    ways[i].is_in_core = true;
  const auto is_in_core = [](const Tree_branches::Edge& b)
  { return b.strength == (std::numeric_limits<float>::infinity)(); };
  std::vector<unsigned char> is_high(edges.size(), 1);
  for(std::size_t i = edges.size(); i-- > 0;)
  {
    const Tree_branches::Edge& b = edges[i];
    Ways& at = ways[b.inner];
    if(is_in_core(b))
    {
      at.is_in_core = ways[b.outer].is_in_core = true;
      continue;
    }
    double way = ways[b.outer].height[0] + height(b.edge);
    if(way < least && is_exempt(b))
      way = least;
    is_high[i] = !(way < least);
    if(at.edge[1] == null_index || way > at.height[1])
    {
      at.height[1] = way;
      at.edge[1] = b.edge;
    }
    if(at.edge[0] == null_index || at.height[1] > at.height[0])
    {
      std::swap(at.height[0], at.height[1]);
      std::swap(at.edge[0], at.edge[1]);
    }
  }
  std::vector<unsigned char> is_gone(number_of_nodes, 0), is_root(number_of_nodes, 1);
  for(const Tree_branches::Edge& b : edges)
    is_root[b.outer] = 0;
  std::size_t size = 0;
  for(std::size_t i = 0; i < edges.size(); ++i)
  {
    const Tree_branches::Edge b = edges[i];
    const Ways& at = ways[b.inner];
    const bool continues =
      !at.is_in_core && (is_root[b.inner] ? at.height[0] >= least && (b.edge == at.edge[0] || b.edge == at.edge[1])
                                          : b.edge == at.edge[0]);
    if(is_in_core(b) || (!is_gone[b.inner] && (continues || is_high[i])))
      edges[size++] = b;
    else
      is_gone[b.outer] = 1;
  }
  edges.resize(size);
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SPURS_H
