// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "fields.h"

#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/laplacian/Differential_operators.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <cmath>

using CGAL::Cut_loci::Index;

struct Fields::Operators
{
  explicit Operators(const Mesh& mesh)
    : number_of_vertices(mesh.number_of_vertices()),
      read(CGAL::Cut_loci::internal::read_triangle_mesh(mesh, mesh.points())), connectivity(read.mesh),
      differential(read.mesh, connectivity)
  {
  }

  Eigen::VectorXd dense(const std::vector<double>& function) const
  {
    Eigen::VectorXd result(read.vertices.size());
    for(std::size_t i = 0; i < read.vertices.size(); ++i)
      result[i] = function[read.vertices[i].idx()];
    return result;
  }

  std::size_t number_of_vertices;
  CGAL::Cut_loci::internal::Read_triangle_mesh<Mesh> read;
  CGAL::Cut_loci::Mesh_connectivity connectivity;
  CGAL::Cut_loci::Differential_operators differential;
};

Fields::Fields(const Mesh& mesh) : operators_(new Operators(mesh)) {}
Fields::~Fields() = default;

std::vector<float> Fields::laplacian(const std::vector<double>& function) const
{
  std::vector<float> result(operators_->number_of_vertices, 0.f);
  const Eigen::VectorXd laplacian = operators_->differential.laplacian * operators_->dense(function);
  for(std::size_t i = 0; i < operators_->read.vertices.size(); ++i)
    if(std::isfinite(laplacian[i]))
      result[operators_->read.vertices[i].idx()] =
        static_cast<float>(operators_->connectivity.mean_edge_length * laplacian[i]);
  return result;
}

std::vector<float> Fields::gradient(const std::vector<double>& function) const
{
  std::vector<float> result(3 * operators_->number_of_vertices, 0.f);
  const Eigen::VectorXd coordinates = operators_->differential.gradient * operators_->dense(function);
  for(Index i = 0; i < operators_->read.vertices.size(); ++i)
  {
    const std::array<double, 3> g = operators_->differential.gradient_in_space(coordinates, i);
    for(int k = 0; k < 3; ++k)
      if(std::isfinite(g[k]))
        result[3 * operators_->read.vertices[i].idx() + k] = static_cast<float>(g[k]);
  }
  return result;
}
