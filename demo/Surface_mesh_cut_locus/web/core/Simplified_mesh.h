// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_SIMPLIFIED_MESH_H
#define SURFACE_MESH_CUT_LOCUS_WEB_SIMPLIFIED_MESH_H

#include "../../Mesh.h"

#include <CGAL/Cut_loci/internal/Compressed_rows.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// A mesh of the same topology with fewer faces, to compute on while a source moves, and the way between both. Places are
// taken over along the edges that were collapsed: where two sheets of the surface are close, none is taken for the other.
class Simplified_mesh
{
public:
  // Of positions within the unit ball, and the component of each face, which may be left out if there is one.
  Simplified_mesh(std::vector<float> positions, std::vector<std::uint32_t> triangles,
                  std::vector<std::uint32_t> component);

  // Collapses edges until there are as few faces, or as few as there can be. Without a smaller mesh of the same topology
  // that is an error.
  void simplify(std::size_t faces);

  const Mesh& mesh() const { return mesh_; }
  std::vector<std::size_t> components() const; // of its faces

  // a place of the whole mesh on the simplified one
  Location locate(std::size_t face, const std::array<double, 3>& coordinates) const;
  // a curve on the simplified mesh, on the whole one: two points each
  std::vector<float> project(const Cut_locus& cut_locus) const;
  // at the vertices of the whole mesh, from those of the simplified one
  std::vector<float> interpolate(const std::vector<float>& values) const;
  std::vector<std::uint32_t> transfer(const std::vector<std::uint32_t>& values) const;

private:
  using Point = Kernel::Point_3;
  using Rows = CGAL::Cut_loci::internal::Compressed_rows<std::uint32_t>;
  using Near = std::vector<std::uint32_t>; // vertices of the simplified mesh

  Point point(std::size_t v) const;
  std::array<Point, 3> corners(std::size_t face) const;
  void collapse(std::size_t faces);
  void link();
  Location closest(const Point& p, Near near) const;
  Point on_whole(const Point& p, const Near& near) const;
  void append_projected(const std::array<Point, 2>& ends, const std::array<Point, 2>& projected, const Near& near,
                        std::vector<float>& to) const;

  std::vector<float> positions_; // of the whole mesh, as are the next three
  std::vector<std::uint32_t> triangles_, component_;
  Rows faces_of_;
  double edge_length_ = 0.; // the mean
  Mesh mesh_;
  std::vector<std::uint32_t>
    merged_into_;                   // of each vertex of the whole mesh: that of the simplified one, if it has one
  Rows merged_;                     // the reverse
  std::vector<Location> locations_; // of each vertex of the whole mesh
};

#endif // SURFACE_MESH_CUT_LOCUS_WEB_SIMPLIFIED_MESH_H
