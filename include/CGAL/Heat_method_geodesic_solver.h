// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_HEAT_METHOD_GEODESIC_SOLVER_H
#define CGAL_HEAT_METHOD_GEODESIC_SOLVER_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/Cut_loci/face_graph/intrinsic_flips.h>
#include <CGAL/Cut_loci/face_graph/Mesh_of_points.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * approximates geodesic distances with `CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3`
 * \cgalCite{cgal:cww-ghnac-13}. The matrices are factored once per mesh; each
 * source takes two back substitutions. A source that is not a vertex is inserted into a copy of the mesh, which is
 * factored anew. Where the edge flips of `Heat_method_3::Intrinsic_Delaunay` would not end, the mesh is refused by a
 * `Cut_loci::Invalid_input`.
 *
 * @tparam Mode `Heat_method_3::Direct`, or `Heat_method_3::Intrinsic_Delaunay`, which is more accurate on meshes with
 *         badly shaped faces
 *
 * \cgalModels{GeodesicSolver}
 */
template <typename Mode = Heat_method_3::Intrinsic_Delaunay>
class Heat_method_geodesic_solver
{
public:
  /// heat smooths distances, most of all at the cut locus
  static bool is_approximate() { return true; }

  void set_mesh(const Cut_loci::Indexed_triangle_mesh& mesh)
  {
    input_ = &mesh;
    factored_.reset();
  }

  void compute_distances(const Cut_loci::Indexed_source& source, std::vector<double>& distances)
  {
    compute_distances(std::vector<Cut_loci::Indexed_source>(1, source), distances);
  }

  /// computes the distances to the nearest of several sources, in one run
  void compute_distances(const std::vector<Cut_loci::Indexed_source>& sources, std::vector<double>& distances)
  {
    std::vector<Cut_loci::Index> vertices;
    vertices.reserve(sources.size());
    for(const Cut_loci::Indexed_source& source : sources)
      vertices.push_back(source.vertex);
    if(std::find(vertices.begin(), vertices.end(), Cut_loci::null_index) != vertices.end())
    {
      const Cut_loci::internal::Divided_mesh refined(*input_, sources);
      Factored(refined.mesh()).compute(refined.vertices(), distances);
      distances.resize(input_->number_of_vertices());
      return;
    }
    if(!factored_)
      factored_ = std::make_shared<Factored>(*input_);
    factored_->compute(vertices, distances);
  }

private:
  using Mesh = Cut_loci::internal::Geodesic_mesh;

  struct Factored
  {
    Cut_loci::internal::Mesh_of_points input;
    Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Mode> heat_method;

    explicit Factored(const Cut_loci::Indexed_triangle_mesh& mesh) : input(mesh), heat_method(checked(input.mesh)) {}

    static const Mesh& checked(const Mesh& mesh)
    {
      if constexpr(std::is_same<Mode, Heat_method_3::Intrinsic_Delaunay>::value)
        if(!Cut_loci::internal::Intrinsic_flips(mesh).end())
          throw Cut_loci::Invalid_input(
            Cut_loci::Cause::TOO_INACCURATE,
            "the heat method with Heat_method_3::Intrinsic_Delaunay does not end on this mesh, which has faces so thin "
            "that rounding decides which edges to flip: take Heat_method_geodesic_solver<Heat_method_3::Direct> or the "
            "default solver, or remesh the faces");
      return mesh;
    }

    void compute(const std::vector<Cut_loci::Index>& sources, std::vector<double>& distances)
    {
      using Vertex = Mesh::Vertex_index;
      heat_method.clear_sources();
      for(Cut_loci::Index source : sources)
        heat_method.add_source(input.vertex(source));
      Mesh::Property_map<Vertex, double> distance =
        input.mesh.add_property_map<Vertex, double>("v:heat_distance", 0.).first;
      heat_method.estimate_geodesic_distances(distance);
      input.get_values([&](Vertex v) { return distance[v]; }, distances);
    }
  };

  const Cut_loci::Indexed_triangle_mesh* input_ = nullptr;
  std::shared_ptr<Factored> factored_;
};

} // namespace CGAL

#endif // CGAL_HEAT_METHOD_GEODESIC_SOLVER_H
