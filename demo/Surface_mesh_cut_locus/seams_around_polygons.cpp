// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "seams_around_polygons.h"

#include <CGAL/Cut_loci/surface/vector_3.h>

namespace {

namespace loci = CGAL::Cut_loci;
using loci::Index;

// The edges of the polygon's part on the left of a diagonal, from its target to its source.
std::vector<Index> way_around(const loci::Indexed_triangle_mesh& mesh, const std::vector<bool>& is_diagonal, Index h)
{
  std::vector<Index> way;
  for(Index g = mesh.next(h); g != h; g = mesh.next(g))
  {
    while(is_diagonal[g] && g != h)
      g = mesh.next(mesh.opposite[g]);
    if(g == h)
      break;
    way.push_back(g);
  }
  return way;
}

// What has to be cut that is not cut already.
double new_length(const loci::Indexed_triangle_mesh& mesh, const loci::Seams& seams, const std::vector<Index>& way)
{
  using namespace loci::internal; // vectors
  double result = 0.;
  for(const Index h : way)
    if(!seams[h] && !mesh.is_border_edge(h))
      result += norm(mesh.points[mesh.target(h)] - mesh.points[mesh.source(h)]);
  return result;
}

// The number of seams at each vertex; a border counts as two, as no seam ends there.
std::vector<Index> seams_at_vertices(const loci::Indexed_triangle_mesh& mesh, const loci::Seams& seams)
{
  std::vector<Index> result(mesh.number_of_vertices(), 0);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    result[mesh.source(h)] += seams[h];
    if(mesh.is_border_edge(h))
      result[mesh.source(h)] += 2, result[mesh.target(h)] += 2;
  }
  return result;
}

// Where two ways have a piece in common, its end is none of the seams that there were.
void drop_new_ends(const loci::Indexed_triangle_mesh& mesh, const std::vector<Index>& before, loci::Seams& seams)
{
  std::vector<Index> degree = seams_at_vertices(mesh, seams);
  std::vector<std::vector<Index>> from(mesh.number_of_vertices());
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(seams[h])
      from[mesh.source(h)].push_back(h);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(Index end = v; degree[end] == 1 && before[end] != 1;)
      for(const Index h : from[end])
        if(seams[h])
        {
          seams[h] = seams[mesh.opposite[h]] = 0;
          --degree[end];
          end = mesh.target(h);
          --degree[end];
          break;
        }
}

} // namespace

void lead_around_polygons(const loci::Indexed_triangle_mesh& mesh, const std::vector<bool>& is_diagonal,
                          loci::Seams& seams)
{
  const std::vector<Index> before = seams_at_vertices(mesh, seams);
  bool has_changed = false;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    if(!seams[h] || !is_diagonal[h] || h > mesh.opposite[h])
      continue;
    const std::vector<Index> left = way_around(mesh, is_diagonal, h),
                             right = way_around(mesh, is_diagonal, mesh.opposite[h]);
    seams[h] = seams[mesh.opposite[h]] = 0;
    has_changed = true;
    for(const Index g : new_length(mesh, seams, right) < new_length(mesh, seams, left) ? right : left)
      loci::add_seam(mesh, g, seams);
  }
  if(!has_changed)
    return;
  loci::repair_seams(mesh, 0, seams); // opens what lies between two ways
  drop_new_ends(mesh, before, seams);
}
