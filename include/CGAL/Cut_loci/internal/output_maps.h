// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_OUTPUT_MAPS_H
#define CGAL_CUT_LOCI_INTERNAL_OUTPUT_MAPS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// What tells the elements of the input for those of the output: an output iterator of pairs, a property map of the
// output's elements, or, if neither is given, nothing.
template <typename Map>
auto output_pairs(internal_np::Param_not_found, Map map)
{
  return [map](const auto& input, const auto& output)
  {
    if constexpr(!std::is_same<Map, internal_np::Param_not_found>::value)
      put(map, output, input);
    else
      CGAL_USE(input), CGAL_USE(output);
  };
}

template <typename OutputIterator, typename Map>
auto output_pairs(OutputIterator out, Map)
{
  return [out](const auto& input, const auto& output) mutable { *out++ = std::make_pair(input, output); };
}

template <typename PointMap, typename Vertex, typename Point>
void put_point(PointMap& map, const Vertex& v, const Point& p)
{
  using Target = typename boost::property_traits<PointMap>::value_type;
  if constexpr(std::is_convertible<Point, Target>::value)
    put(map, v, p);
  else
    put(map, v, Target(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_OUTPUT_MAPS_H
