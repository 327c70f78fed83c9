// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_UNION_FIND_H
#define CGAL_CUT_LOCI_INTERNAL_UNION_FIND_H

#include <CGAL/Cut_loci/Index.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Disjoint sets of the indices from 0 on: those of Boost, with their storage.
class Union_find
{
public:
  explicit Union_find(std::size_t n) : rank_(n, 0), parent_(n) { std::iota(parent_.begin(), parent_.end(), Index(0)); }

  std::size_t size() const { return parent_.size(); }

  Index find(Index i) { return sets().find_set(i); }

  // whether they were not in one set before
  bool unite(Index i, Index k)
  {
    auto s = sets();
    i = s.find_set(i);
    k = s.find_set(k);
    if(i == k)
      return false;
    s.link(i, k);
    return true;
  }

private:
  // Property maps of Boost, and no pointers: what is in front of the header may hide the functions for these.
  template <typename T>
  using Values = boost::iterator_property_map<T*, boost::typed_identity_property_map<Index>>;

  boost::disjoint_sets<Values<unsigned char>, Values<Index>> sets()
  {
    return {Values<unsigned char>(rank_.data()), Values<Index>(parent_.data())};
  }

  std::vector<unsigned char> rank_;
  std::vector<Index> parent_;
};

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

#endif // CGAL_CUT_LOCI_INTERNAL_UNION_FIND_H
