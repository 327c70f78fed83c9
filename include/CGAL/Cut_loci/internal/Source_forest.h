// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_SOURCE_FOREST_H
#define CGAL_CUT_LOCI_INTERNAL_SOURCE_FOREST_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/internal/Union_find.h>

#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A forest that grows link by link, with no more than one source in each tree.
class Source_forest
{
public:
  explicit Source_forest(std::size_t number_of_nodes) : trees_(number_of_nodes) {}

  void plant(Index node, Index source)
  {
    if(source_.empty())
      source_.assign(trees_.size(), null_index);
    source_[trees_.find(node)] = source;
  }

  // that of the tree of a node, or null
  Index source(Index node) { return source_.empty() ? null_index : source_[trees_.find(node)]; }

  // whether `a` and `b` were not linked before, and may be
  bool link(Index a, Index b)
  {
    const Index of_a = source(a), of_b = source(b);
    if((of_a != null_index && of_b != null_index) || !trees_.unite(a, b))
      return false;
    if(!source_.empty())
      source_[trees_.find(a)] = of_a != null_index ? of_a : of_b;
    return true;
  }

private:
  Union_find trees_;
  std::vector<Index> source_; // of each representative
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_SOURCE_FOREST_H
