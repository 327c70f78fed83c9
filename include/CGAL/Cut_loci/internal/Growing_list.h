// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_GROWING_LIST_H
#define CGAL_CUT_LOCI_INTERNAL_GROWING_LIST_H

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is a list that grows without being copied, which would take long at once, and twice the memory.
 *
 * `std::deque` does so, too, but in blocks of a few elements, and `boost::container::deque` lets choose their size only
 * since Boost 1.71.
 */
template <typename Element>
class Growing_list
{
public:
  std::size_t size() const { return size_; }

  Element& operator[](std::size_t i) { return blocks_[i / block][i % block]; }
  const Element& operator[](std::size_t i) const { return blocks_[i / block][i % block]; }

  void push_back(const Element& element)
  {
    resize(size_ + 1);
    (*this)[size_ - 1] = element;
  }

  /// @pre `size` is not less than before; new elements have their default values
  void resize(std::size_t size)
  {
    while(blocks_.size() * block < size)
      blocks_.emplace_back(new Element[block]());
    size_ = size;
  }

  /// removes all elements for which `predicate()` does not hold
  template <typename Predicate>
  void keep_if(const Predicate& predicate)
  {
    std::size_t n = 0;
    for(std::size_t i = 0; i < size_; ++i)
      if(predicate((*this)[i]))
        (*this)[n++] = (*this)[i];
    for(std::size_t i = n; i < size_; ++i)
      (*this)[i] = Element();
    size_ = n;
  }

private:
  static constexpr std::size_t block = 1024;

  std::vector<std::unique_ptr<Element[]>> blocks_;
  std::size_t size_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_GROWING_LIST_H
