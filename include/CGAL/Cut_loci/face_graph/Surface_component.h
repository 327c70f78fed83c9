// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_COMPONENT_H
#define CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_COMPONENT_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/face_graph/make_solver.h>
#include <CGAL/Cut_loci/face_graph/reading/method_parameters.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/method/Geodesic_solver_handle.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/checked_mesh.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/extent.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A component of a mesh with what is computed once for it: it gets the solver of a method with the first source that
// needs it.
struct Surface_component
{
  const Indexed_triangle_mesh* mesh = nullptr;            // of the whole if there is just one component
  std::shared_ptr<const Mesh_component> part;             // else
  std::shared_ptr<const Indexed_triangle_mesh> mollified; // if a face has no area
  double least_width = 0.; // of branches: those that are narrower come from faces without area
  double diagonal = 0.;    // or what it is of lengths alone, see `extent()`
  std::unique_ptr<Laplacian_stages> laplacian;
  std::unique_ptr<Exact_tree_method> exact_tree;
  Geodesic_solver_handle geodesic_solver;
  std::mutex in_use; // by a function that is const

  // Component `id` of the mesh whose faces have the components `component_of_face`.
  Surface_component(const Indexed_triangle_mesh& whole, const std::vector<Index>& component_of_face, Index id,
                    Index number_of_components)
    : mesh(&whole)
  {
    if(number_of_components > 1)
    {
      part = std::make_shared<const Mesh_component>(extract_component(whole, component_of_face, id));
      mesh = &part->mesh;
    }
    diagonal = extent(*mesh);
    if(needs_mollification(*mesh))
    {
      const auto thick = std::make_shared<Indexed_triangle_mesh>(*mesh);
      const Mollification mollification(*mesh);
      thick->lengths = mollification.lengths;
      least_width = mollification.most_gained;
      mollified = thick;
    }
  }

  // shares what depends on the mesh alone
  Surface_component(const Surface_component& other)
    : mesh(other.mesh), part(other.part), mollified(other.mollified), least_width(other.least_width),
      diagonal(other.diagonal), laplacian(other.laplacian ? other.laplacian->for_other_sources() : nullptr),
      exact_tree(other.exact_tree ? other.exact_tree->for_other_sources() : nullptr)
  {
  }
  Surface_component& operator=(const Surface_component&) = delete;

  bool is_whole() const { return !part; }
  // with lengths if some faces have no area
  const Indexed_triangle_mesh& measured() const { return mollified ? *mollified : *mesh; }
  // the indices in the whole mesh
  Index vertex(Index local) const { return is_whole() ? local : part->vertex(local); }
  // of messages; one behind those of the mesh is on an edge that has been divided
  std::string name_of(Index local, const std::vector<Index>& positions) const
  {
    return local < mesh->number_of_vertices() ? vertex_name(positions[vertex(local)]) : "a point of a long edge";
  }
  Index face(Index local) const { return is_whole() ? local : part->face(local); }
  Index halfedge(Index local) const { return is_whole() ? local : part->halfedge(local); }

  // edges inside count twice
  double sum_of_edge_lengths() const
  {
    double sum = 0.;
    for(const Indexed_triangle_mesh::Triangle& t : mesh->triangles)
      for(int i = 0; i < 3; ++i)
        sum += norm(mesh->points[t[(i + 1) % 3]] - mesh->points[t[i]]);
    return sum;
  }

  // Values by vertex, those of the whole mesh. No values stay none.
  template <typename T>
  std::vector<T> in_whole(const std::vector<T>& values, std::size_t n, const T& elsewhere) const
  {
    if(is_whole() || values.empty())
      return values;
    std::vector<T> result(n, elsewhere);
    for(std::size_t i = 0; i < part->vertices.size(); ++i)
      result[part->vertices[i]] = values[i];
    return result;
  }

  // A source of the whole mesh, a point or a curve, in this component.
  template <typename Source>
  Source local(const Source& source) const
  {
    return is_whole() ? source : part->local(source);
  }

  // null if it has not been needed yet
  Method_solver* solver(const Method& method) const
  {
    return is_laplacian(method) ? static_cast<Method_solver*>(laplacian.get()) : exact_tree.get();
  }

  // of branches, for a method that knows the paths
  Exact_tree_thresholds default_thresholds(const Method& method) const
  {
    return std::holds_alternative<Polyhedral_method>(method) ? Exact_tree_thresholds()
                                                             : exact_tree->default_thresholds();
  }
  Exact_tree_thresholds thresholds(const Method& options) const
  {
    const auto read = [&](const auto& method)
    { return read_exact_tree_thresholds(method, default_thresholds(options), diagonal, mesh->is_intrinsic); };
    const auto* polyhedral = std::get_if<Polyhedral_method>(&options);
    Exact_tree_thresholds result = polyhedral != nullptr ? read(*polyhedral) : read(std::get<Default_method>(options));
    result.width = (std::max)(result.width, least_width);
    result.narrow = (std::max)(result.narrow, least_width);
    return result;
  }

  // `positions` of the vertices of the whole mesh, for messages.
  void make_solver(const Method& method, decltype(&make_laplacian_solver) make_laplacian, const Threads& threads,
                   const Indexed_triangle_mesh& whole, const std::vector<Index>& positions, const Progress& progress)
  {
    name_faults(whole, positions,
                [&]
                {
      if(const Laplacian_method* options = std::get_if<Laplacian_method>(&method))
        laplacian = make_laplacian(measured(), operator_of(*options), threads, progress);
      else
        exact_tree = make_exact_tree_solver(measured(), threads, progress);
    });
  }

  // what `read_mesh` throws, in the numbers of the whole mesh
  template <typename Function>
  void name_faults(const Indexed_triangle_mesh& whole, const std::vector<Index>& positions,
                   const Function& read_mesh) const
  {
    try
    {
      read_mesh();
    }
    catch(const Face_without_area& error)
    {
      const Index f = face(error.face);
      std::string name = face_name(f) + " (vertices";
      for(Index v : whole.triangles[f])
        name += " " + std::to_string(positions[v]);
      throw Invalid_input(Cause::FACE_WITHOUT_AREA,
                          name + ") has no area, or in this unit of length one that is not a normal number: it must be "
                                 "removed or repaired first "
                                 "(CGAL::Polygon_mesh_processing::remove_degenerate_faces() does)");
    }
    catch(const Non_manifold_vertex& error)
    {
      throw Invalid_input(Cause::NON_MANIFOLD,
                          vertex_name(positions[vertex(error.vertex)]) +
                            " is not manifold: its faces form several "
                            "fans (CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices() splits it)");
    }
  }
};

/// Throws if these are not finite distances, one for each vertex of a component of a mesh. `positions` are
/// those of its vertices in the range of all, for the message, and `who` tells where the distances come from. `number`
/// is that of the vertices if there are more than those.
inline void check_distances(const std::vector<double>& distance, const Surface_component& component,
                            const std::vector<Index>& positions, const std::string& who, Index number)
{
  if(distance.size() != number)
    throw Invalid_input(Cause::INVALID_DISTANCE, who + " " + std::to_string(distance.size()) + " distances for " +
                                                   std::to_string(number) + " vertices");
  for(Index v = 0; v < distance.size(); ++v)
    if(!std::isfinite(distance[v]))
      throw Invalid_input(Cause::INVALID_DISTANCE,
                          who + " a distance that is not a finite number for " + component.name_of(v, positions));
}

/// Throws if one of the distances cannot be that of a shortest path: none is longer than one of edges, which passes each of
/// them once at most. What is longer may also be too large to compute with. `what_to_do` ends the message.
inline void check_range(const std::vector<double>& distance, const Surface_component& component,
                        const std::vector<Index>& positions, const std::string& who, const std::string& what_to_do)
{
  const double longest = component.sum_of_edge_lengths();
  for(Index v = 0; v < distance.size(); ++v)
    if(distance[v] < 0. || distance[v] > longest)
    {
      std::string message = who;
      message += " a distance that is ";
      message += distance[v] < 0. ? "negative" : "longer than all edges together";
      message += " for " + component.name_of(v, positions) + ": " + what_to_do;
      throw Invalid_input(Cause::INVALID_DISTANCE, message);
    }
}

/// Throws if all distances in a `vertex_distance_map` are the same, though not all vertices are on sources.
inline void check_is_not_constant(const std::vector<double>& distance, const Indexed_triangle_mesh& mesh,
                                  const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves)
{
  if(!std::equal(distance.begin() + 1, distance.end(), distance.begin()))
    return;
  std::vector<unsigned char> is_source(distance.size(), 0);
  for(const Indexed_source& point : points)
    if(point.vertex != null_index)
      is_source[point.vertex] = 1;
  for(const Indexed_curve& curve : curves)
    for(Index h : curve.halfedges)
      is_source[mesh.source(h)] = is_source[mesh.target(h)] = 1;
  if(std::count(is_source.begin(), is_source.end(), 0) > 0)
    throw Invalid_input(Cause::INVALID_DISTANCE,
                        "the vertex distance map holds the same distance for all vertices: it must hold the geodesic "
                        "distances to the source");
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_COMPONENT_H
