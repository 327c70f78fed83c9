// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_DIFFERENTIAL_OPERATORS_H
#define CGAL_CUT_LOCI_LAPLACIAN_DIFFERENTIAL_OPERATORS_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/laplacian/quadratic_fit.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Cut_loci {

/*
 * holds the Riemannian gradient and the Laplacian of functions sampled at the vertices of a mesh, as sparse matrices.
 *
 * The operators come from a least-squares fit of quadrics to the extended neighborhood of each vertex: its `k`
 * neighbors and, for each triangle around it, the point that a geodesic reaches which leaves the vertex along the
 * bisector for the mean length of its edges, clamped in the triangle on the far side of the opposite edge. The
 * coordinates and the function at such a point are not read off the flat triangle: its equation is the barycentric
 * combination of the equations of the triangle's vertices. So the fit is exact for quadratic functions whatever the
 * triangulation, the gradient converges with order 2 and the Laplacian with order 1 (2 on regular meshes).
 */
struct Differential_operators
{
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

  /// an orthonormal basis of the tangent plane; its first vector lies above the first edge in the vertex' ring
  struct Frame
  {
    std::array<double, 3> e1, e2;
  };

  std::vector<Frame> frames;
  Matrix gradient;  ///< 2 n x n: rows `2 v` and `2 v + 1` are the coordinates of the gradient in the frame of `v`
  Matrix laplacian; ///< n x n, negative semidefinite in the sense that the Laplacian of `x^2` is 2

  Differential_operators(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                         Laplacian_operator type = Laplacian_operator::QUADRATIC_FIT,
                         const internal::Threads& threads = {}, const internal::Progress& progress = {})
  {
    fit(mesh, connectivity, threads, progress);
    if(type == Laplacian_operator::COTANGENT)
      laplacian = cotangent_laplacian(mesh, connectivity);
  }

  /// the gradient at `v` in space, from the vector `gradient * f`
  std::array<double, 3> gradient_in_space(const Eigen::VectorXd& coordinates, Index v) const
  {
    using namespace internal;
    return coordinates[2 * v] * frames[v].e1 + coordinates[2 * v + 1] * frames[v].e2;
  }

  /// the cotangent Laplacian with lumped barycentric areas
  static Matrix cotangent_laplacian(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
  {
    using namespace internal;
    const Index nv = mesh.number_of_vertices();
    std::vector<double> weight(connectivity.number_of_edges(), 0.), area(nv, 0.);
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const Planar_vector top = apex(mesh, h), b = Planar_vector{{edge_length(mesh, h), 0.}} - top;
      const double twice_area = top[1] * edge_length(mesh, h);
      weight[connectivity.edge_of_halfedge[h]] -= 0.5 * dot(top, b) / twice_area;
      area[mesh.source(h)] += twice_area / 6.;
    }

    Matrix result(nv, nv);
    result.reserve(connectivity.ring_vertex.size() + nv);
    std::vector<std::pair<Index, double>> row;
    for(Index v = 0; v < nv; ++v)
    {
      row.clear();
      double sum = 0.;
      for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
      {
        const double w = weight[connectivity.ring_edge(entry)] / area[v];
        row.emplace_back(connectivity.ring_vertex[entry], w);
        sum += w;
      }
      row.emplace_back(v, -sum);
      std::sort(row.begin(), row.end());
      result.startVec(static_cast<int>(v));
      for(std::size_t i = 0; i < row.size(); ++i) // two edges may join the same two vertices
        if(i > 0 && row[i].first == row[i - 1].first)
          result.valuePtr()[result.nonZeros() - 1] += row[i].second;
        else
          result.insertBack(static_cast<int>(v), static_cast<int>(row[i].first)) = row[i].second;
    }
    result.finalize();
    return result;
  }

private:
  using Coefficients = internal::Quadratic_fit::Coefficients;

  // of successive vertices
  struct Rows
  {
    std::vector<Coefficients> entries;
    std::vector<std::size_t> end; // of each vertex
  };

  void fit(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const internal::Threads& threads,
           const internal::Progress& progress)
  {
    const Index nv = mesh.number_of_vertices();
    frames.resize(nv);
    gradient.resize(2 * static_cast<Eigen::Index>(nv), nv);
    laplacian.resize(nv, nv);
    // 2k + 1 entries in a row, and 6 neighbors on average
    gradient.reserve(2 * 13 * static_cast<Eigen::Index>(nv));
    laplacian.reserve(13 * static_cast<Eigen::Index>(nv));

    constexpr std::size_t block = 2048; // vertices, which take some milliseconds
    std::vector<Rows> rows(threads.number_at_once());
    for(std::size_t first = 0; first < nv; first += rows.size() * block)
    {
      progress(static_cast<double>(first) / static_cast<double>(nv));
      const auto begin = [&](std::size_t i)
      { return static_cast<Index>((std::min)(first + i * block, std::size_t(nv))); };
      threads.run(rows.size(), [&](std::size_t i) { fit(mesh, connectivity, begin(i), begin(i + 1), rows[i]); });
      for(std::size_t i = 0; i < rows.size(); ++i)
        append(rows[i], begin(i));
    }
    gradient.finalize();
    laplacian.finalize();
  }

  void fit(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Index begin, Index end, Rows& rows)
  {
    internal::Quadratic_fit quadric(mesh, connectivity);
    rows.entries.clear();
    rows.end.clear();
    for(Index v = begin; v < end; ++v)
    {
      quadric.fit(v);
      frames[v] = {quadric.e1, quadric.e2};
      rows.entries.insert(rows.entries.end(), quadric.row.begin(), quadric.row.end());
      rows.end.push_back(rows.entries.size());
    }
  }

  // `first` is their first vertex
  void append(const Rows& rows, Index first)
  {
    std::size_t begin = 0;
    for(std::size_t i = 0; i < rows.end.size(); begin = rows.end[i++])
    {
      const int v = static_cast<int>(first + i);
      for(int r = 0; r < 2; ++r)
      {
        gradient.startVec(2 * v + r);
        for(std::size_t k = begin; k < rows.end[i]; ++k)
          gradient.insertBack(2 * v + r, static_cast<int>(rows.entries[k].vertex)) = rows.entries[k].gradient[r];
      }
      laplacian.startVec(v);
      for(std::size_t k = begin; k < rows.end[i]; ++k)
        laplacian.insertBack(v, static_cast<int>(rows.entries[k].vertex)) = rows.entries[k].laplacian;
    }
  }
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_LAPLACIAN_DIFFERENTIAL_OPERATORS_H
