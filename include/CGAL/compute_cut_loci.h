// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_COMPUTE_CUT_LOCI_H
#define CGAL_COMPUTE_CUT_LOCI_H

#include <CGAL/Cut_loci/face_graph/concurrency.h>
#include <CGAL/Cut_loci/internal/transform_in_order.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes one cut locus for each of several sources, such as those of all vertices. The mesh is read once. (The cut
 * locus of a set of sources is computed by `compute_cut_locus()`.)
 *
 * With the named parameter `concurrency_tag(Parallel_if_available_tag())` the sources are distributed over threads, if
 * TBB is linked; the results are the same to the last bit, and in the same order. Each thread needs memory
 * of its own for the distances of one source.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam SourceRange a model of `ConstRange` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, a pair of a
 *         face and barycentric coordinates as in `Polygon_mesh_processing`, or `Surface_mesh_cut_locus::Source` as value
 *         type
 * @tparam OutputIterator a model of `OutputIterator` that takes `Surface_mesh_cut_locus::Result`, the return type of
 *         `compute_cut_locus()`
 *
 * @param tm a triangle mesh
 * @param sources the sources, in any of the components of the mesh
 * @param output the iterator that gets the cut locus of each source, in the order of `sources`, and by one thread at a
 *        time. Where a number of each cut locus is all that is wanted, an iterator that calls a function, such as
 *        `boost::function_output_iterator`, saves the memory for the others.
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those that
 *        `compute_cut_locus()` lists, and the one below. A `vertex_distance_map` and an `edge_is_constrained_map` belong to
 *        one source, and are not taken here; there are no `source_curves`, nor is the border one.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{whether several threads are used}
 *     \cgalParamType{`Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`}
 *     \cgalParamDefault{`Sequential_tag`}
 *     \cgalParamExtra{Each thread has its own copy of the geodesic solver and of the visitor; one that is given by
 *                     `std::ref()` is used by several threads at once.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return the iterator behind the last cut locus
 *
 * @throws Cut_loci::Invalid_input before anything is computed, if the mesh, a source, the component of one, or a
 *         parameter can not be used. What is thrown for a source later, as by a visitor, ends the computation; the cut
 *         loci of some sources before it have been written then.
 */
template <typename TriangleMesh, typename SourceRange, typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator compute_cut_loci(const TriangleMesh& tm, const SourceRange& sources, OutputIterator output,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Cut_loci::internal::is_given;
  static_assert(!is_given<CGAL_NP_CLASS, internal_np::vertex_distance_map_t>(),
                "vertex_distance_map is for one source: use Surface_mesh_cut_locus");
  static_assert(!is_given<CGAL_NP_CLASS, internal_np::edge_is_constrained_t>(),
                "edge_is_constrained_map is for one source: use Surface_mesh_cut_locus");
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, CGAL_NP_CLASS>::const_type;
  using Solver = Surface_mesh_cut_locus<TriangleMesh, Vertex_point_map>;
  using Source = typename std::iterator_traits<decltype(sources.begin())>::value_type;

  const std::vector<Source> all(sources.begin(), sources.end());
  Solver original(tm, np);
  if(all.empty())
    return output;
  original.prepare(all, np);
  Cut_loci::internal::Copy_pool<Solver> pool(original);
  Cut_loci::internal::transform_in_order<Cut_loci::internal::is_parallel<CGAL_NP_CLASS>()>(
    all.size(),
    [&](std::size_t i)
    {
    std::unique_ptr<Solver> solver = pool.take();
    solver->set_sources(std::array<Source, 1>{{all[i]}}, np);
    typename Solver::Result result = solver->cut_locus(np);
    pool.give_back(std::move(solver));
    return result;
    },
    [&](typename Solver::Result result) { *output++ = std::move(result); });
  return output;
}

} // namespace CGAL

#endif // CGAL_COMPUTE_CUT_LOCI_H
