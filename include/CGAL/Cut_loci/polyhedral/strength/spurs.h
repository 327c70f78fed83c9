// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SPURS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SPURS_H

#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

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
 * @param length of an edge
 * @param least_length of a branch through an edge that is no spur, however low; infinite if there is none
 */
template <typename Height, typename Length, typename Least_length>
void remove_spurs(std::vector<Tree_branches::Edge>& edges, Index number_of_nodes, Index terminals, double least,
                  const Height& height, const Length& length, const Least_length& least_length)
{
  struct Way // outward
  {
    double height = 0., length = 0., least_length = (std::numeric_limits<double>::infinity)();
    Index edge = null_index;
  };
  struct Ways // from a node: the two highest
  {
    std::array<Way, 2> way;
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
    Way way = ways[b.outer].way[0];
    way.edge = b.edge;
    way.height += height(b.edge);
    way.length += length(b.edge);
    if(way.height < least)
    {
      way.least_length = (std::min)(way.least_length, least_length(b.edge));
      if(way.length >= way.least_length)
        way.height = least;
    }
    is_high[i] = !(way.height < least);
    if(at.way[1].edge == null_index || way.height > at.way[1].height)
      at.way[1] = way;
    if(at.way[0].edge == null_index || at.way[1].height > at.way[0].height)
      std::swap(at.way[0], at.way[1]);
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
      !at.is_in_core &&
      (is_root[b.inner] ? at.way[0].height >= least && (b.edge == at.way[0].edge || b.edge == at.way[1].edge)
                        : b.edge == at.way[0].edge);
    if(is_in_core(b) || (!is_gone[b.inner] && (continues || is_high[i])))
      edges[size++] = b;
    else
      is_gone[b.outer] = 1;
  }
  edges.resize(size);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SPURS_H
