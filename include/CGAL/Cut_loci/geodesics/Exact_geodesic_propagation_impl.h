// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H
#define CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>

#include <vector>

namespace CGAL::Cut_loci::internal {

CGAL_CUT_LOCI_INLINE void Exact_geodesic_propagation::run(const std::vector<Indexed_location>& sources,
                                                          const Exact_geodesic_options& options,
                                                          Geodesic_window_observer* observer)
{
  start(sources, options);
  observer_ = observer;
  if(observer_ != nullptr && !is_approximate() && !has_lines())
    count_paths();
  if(has_directions_ && is_approximate())
    propagate<9>();
  else if(has_directions_ || sources_.size() > 1)
    propagate<7>();
  else if(is_approximate())
    propagate<6>();
  else
    propagate<5>();
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H
