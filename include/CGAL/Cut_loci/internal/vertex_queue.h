// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_VERTEX_QUEUE_H
#define CGAL_CUT_LOCI_INTERNAL_VERTEX_QUEUE_H

#include <CGAL/Cut_loci/Index.h>

#include <boost/heap/d_ary_heap.hpp>

namespace CGAL::Cut_loci::internal {

// A vertex or face with the key it waits by: the lowest key comes first, ties by index.
struct Queue_item
{
  double key;
  Index vertex;
};

struct Comes_later
{
  bool operator()(const Queue_item& a, const Queue_item& b) const
  {
    return a.key > b.key || (a.key == b.key && a.vertex > b.vertex);
  }
};

using Vertex_queue = boost::heap::d_ary_heap<Queue_item, boost::heap::arity<4>, boost::heap::compare<Comes_later>>;

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_VERTEX_QUEUE_H
