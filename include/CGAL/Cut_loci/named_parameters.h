// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_NAMED_PARAMETERS_H
#define CGAL_CUT_LOCI_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

// Whoever links the CMake target gets the parameters in CGAL's own list, and they chain in any order. With the bare
// headers they are declared here: then they come first in a chain, and CGAL's own after them.
#ifndef CGAL_CUT_LOCI_NAMED_PARAMETERS_IN_CGAL_LIST

namespace CGAL {

namespace internal_np {
#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include <CGAL/Cut_loci/internal/named_parameters_list.h>
#undef CGAL_add_named_parameter
} // namespace internal_np

namespace Cut_loci {
namespace internal {

template <typename T, typename Tag, typename Base = internal_np::No_property>
struct Chained_named_parameters : public Named_function_parameters<T, Tag, Base>
{
  using Pack = Named_function_parameters<T, Tag, Base>;

  Chained_named_parameters(const T& value) : Pack(value) {}
  Chained_named_parameters(const T& value, const Base& rest) : Pack(value, rest) {}

#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Chained_named_parameters<K, internal_np::X, Pack> Z(const K& k) const                                                \
  {                                                                                                                    \
    return Chained_named_parameters<K, internal_np::X, Pack>(k, *this);                                                \
  }
#include <CGAL/Cut_loci/internal/named_parameters_list.h>
#undef CGAL_add_named_parameter
};

} // namespace internal
} // namespace Cut_loci

namespace parameters {
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Cut_loci::internal::Chained_named_parameters<K, internal_np::X> Z(const K& k)                                        \
  {                                                                                                                    \
    return Cut_loci::internal::Chained_named_parameters<K, internal_np::X>(k);                                         \
  }
#include <CGAL/Cut_loci/internal/named_parameters_list.h>
#undef CGAL_add_named_parameter
} // namespace parameters

} // namespace CGAL

#endif // CGAL_CUT_LOCI_NAMED_PARAMETERS_IN_CGAL_LIST

#endif // CGAL_CUT_LOCI_NAMED_PARAMETERS_H
