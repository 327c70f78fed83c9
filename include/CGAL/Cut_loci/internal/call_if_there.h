// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_CALL_IF_THERE_H
#define CGAL_CUT_LOCI_INTERNAL_CALL_IF_THERE_H

#include <type_traits>

namespace CGAL::Cut_loci::internal {

// Calls a function that asks of a model of a concept what it need not have, by `-> decltype(model.function())`. Returns
// whether the model has it.
template <typename Model, typename Function>
constexpr bool call_if_there(Model& model, const Function& function)
{
  constexpr bool is_there = std::is_invocable<const Function&, Model&>::value;
  if constexpr(is_there)
    function(model);
  return is_there;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_CALL_IF_THERE_H
