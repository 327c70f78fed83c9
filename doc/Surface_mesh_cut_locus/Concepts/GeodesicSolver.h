// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

/*!
 * \ingroup PkgSurfaceMeshCutLocusConcepts
 * \cgalConcept
 *
 * The concept `GeodesicSolver` describes what computes the distances from a point to all vertices of a mesh, as
 * `CGAL::Surface_mesh_cut_locus` and `CGAL::compute_cut_locus()` take it in the named parameter `geodesic_solver`.
 *
 * A solver sees one connected component, manifold and orientable, in dense arrays, whatever the type of the user's
 * mesh. Edges that are longer than three in the mean are divided there, and the vertices on them are the last ones.
 * What it can prepare for all sources belongs in `set_mesh()` or in the first call of `compute_distances()`.
 *
 * The cut locus is found by `CGAL::Cut_loci::Laplacian_method` then, whose header `CGAL/Cut_loci/Laplacian_method.h` has to
 * be included.
 *
 * \cgalRefines{CopyConstructible}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Exact_geodesic_solver}
 * \cgalHasModels{CGAL::Heat_method_geodesic_solver}
 * \cgalHasModels{CGAL::Graph_geodesic_solver}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Surface_mesh_cut_locus`
 */
class GeodesicSolver
{
public:
  /*!
   * sets the surface. It is called before `compute_distances()`, once for each component of a mesh, each time on a copy
   * of its own of the solver that the user passed. The mesh stays where it is, unchanged, as long as the copy lives.
   */
  void set_mesh(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh);

  /*!
   * computes the geodesic distance from `source` to each vertex of the mesh.
   *
   * @param source a point of the mesh. If it is at a vertex, `source.vertex` is that vertex; else it is
   *        `CGAL::Cut_loci::null_index`, and `source.location` lies inside a face or, if a coordinate is zero,
   *        on an edge.
   * @param distances is resized to the number of vertices; entry `i` becomes the distance of vertex `i`, a finite
   *        number. Its content before the call is of no meaning.
   */
  void compute_distances(const CGAL::Cut_loci::Indexed_source& source, std::vector<double>& distances);

  /*!
   * computes the geodesic distance from the nearest of several sources to each vertex of the mesh. This function is
   * optional: without it, the distances to each source are computed one after another.
   *
   * @param sources two or more different points of the mesh
   * @param distances as above
   */
  void compute_distances(const std::vector<CGAL::Cut_loci::Indexed_source>& sources, std::vector<double>& distances);

  /*!
   * computes the geodesic distance from the nearest of points and curves to each vertex of the mesh. This function is
   * optional: without it, all vertices of the curves are sources in place of them.
   *
   * @param points different points of the mesh, or none
   * @param curves one or more connected sets of edges of the mesh, which have no point in common
   * @param distances as above
   */
  void compute_distances(const std::vector<CGAL::Cut_loci::Indexed_source>& points,
                         const std::vector<CGAL::Cut_loci::Indexed_curve>& curves, std::vector<double>& distances);

  /*!
   * returns whether lengths of short ways through the faces are closer to the distances on the surface than what this
   * solver computes. Then the latter only lead to the ways, and the lengths take their place. This function is
   * optional: without it, the distances are taken as they are.
   */
  static bool is_approximate();
};
