// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The charts of cells.

#include "cells.h"
#include "charts.h"
#include "seams_around_polygons.h"

#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <set>
#include <utility>

namespace {

namespace loci = CGAL::Cut_loci;
using loci::Index;

// For each halfedge of the cells; none if the faces are split.
std::vector<bool> diagonals_of(const Mesh& mesh, const Cells& cells, const Diagonals& is_diagonal)
{
  std::vector<bool> result(cells.mesh.number_of_halfedges(), false);
  if(is_diagonal.empty() || cells.mesh.number_of_faces() != mesh.number_of_faces())
    return result;
  for(Index f = 0; f < cells.mesh.number_of_faces(); ++f)
  {
    Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(cells.faces[f]));
    for(Index i = 0; i < 3; ++i, h = mesh.next(h))
      result[3 * f + i] = is_diagonal[mesh.edge(h)];
  }
  return result;
}

// Each polygon comes into the cell that has its largest triangle.
void keep_polygons_whole(const std::vector<bool>& is_diagonal, Cells& cells)
{
  using namespace loci::internal; // vectors
  std::vector<bool> is_done(cells.mesh.number_of_faces(), false);
  for(Index seed = 0; seed < cells.mesh.number_of_faces(); ++seed)
  {
    std::vector<Index> polygon;
    const auto add = [&](Index f)
    {
      if(!is_done[f])
        polygon.push_back(f);
      is_done[f] = true;
    };
    add(seed);
    Index largest = seed;
    double most = -1.;
    for(std::size_t i = 0; i < polygon.size(); ++i)
    {
      const auto& t = cells.mesh.triangles[polygon[i]];
      const auto& p = cells.mesh.points;
      const double area = norm(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
      if(area > most)
      {
        most = area;
        largest = polygon[i];
      }
      for(Index h = 3 * polygon[i]; h < 3 * polygon[i] + 3; ++h)
        if(is_diagonal[h])
          add(cells.mesh.opposite[h] / 3);
    }
    for(const Index f : polygon)
      cells.source[f] = cells.source[largest];
  }
}

// The mesh without what joins different cells.
loci::Cut_mesh without_cell_borders(const Cells& cells)
{
  loci::Seams borders(cells.mesh.number_of_halfedges(), 0);
  for(Index h = 0; h < cells.mesh.number_of_halfedges(); ++h)
    if(!cells.mesh.is_border_edge(h) && cells.source[h / 3] != cells.source[cells.mesh.opposite[h] / 3])
      borders[h] = 1;
  return loci::cut_open(cells.mesh, borders);
}

// A connected part of a cell. What is left of its seams is opened, or completed, until it is a disk.
std::unique_ptr<Chart> chart_of(const Mesh& mesh, const loci::Cut_mesh& apart,
                                const loci::internal::Mesh_component& part, const Cells& cells,
                                const std::vector<bool>& is_diagonal)
{
  loci::Seams seams(part.mesh.number_of_halfedges(), 0);
  std::vector<bool> diagonals(seams.size());
  for(Index h = 0; h < part.mesh.number_of_halfedges(); ++h)
  {
    const Index in_cells = 3 * part.faces[h / 3] + h % 3;
    diagonals[h] = is_diagonal[in_cells];
    if(cells.seams[in_cells])
      loci::add_seam(part.mesh, h, seams);
  }
  loci::repair_seams(part.mesh, 0, seams);
  loci::complete_seams(part.mesh, loci::Mesh_connectivity(part.mesh), 0, loci::null_index, seams);
  lead_around_polygons(part.mesh, diagonals, seams);
  const loci::Cut_mesh cut = loci::cut_open(part.mesh, seams);
  std::vector<Index> vertices, faces;
  for(const Index v : cut.vertices)
    vertices.push_back(cells.vertices[apart.vertices[part.vertices[v]]]);
  for(const Index f : part.faces)
    faces.push_back(cells.faces[f]);
  auto chart = make_chart(mesh, cut.mesh, std::move(vertices), std::move(faces));
  for(Index h = 0; h < seams.size(); ++h)
    chart->seams_in_polygons += diagonals[h] && seams[h] && h < part.mesh.opposite[h];
  return chart;
}

} // namespace

Charts charts_of_cells(const Mesh& mesh, const Cut_locus& cut_locus, const Diagonals& is_diagonal)
{
  Cells cells = make_cells(mesh, cut_locus);
  const std::vector<bool> diagonals = diagonals_of(mesh, cells, is_diagonal);
  keep_polygons_whole(diagonals, cells);
  const loci::Cut_mesh apart = without_cell_borders(cells);
  Index number_of_parts = 0;
  const std::vector<Index> part_of_face = loci::internal::face_components(apart.mesh, number_of_parts);
  std::set<Index> parts;
  for(Index f = 0; f < part_of_face.size(); ++f)
    if(cells.source[f] != loci::no_source)
      parts.insert(part_of_face[f]);
  Charts charts;
  for(const Index part : parts)
    charts.push_back(
      chart_of(mesh, apart, loci::internal::extract_component(apart.mesh, part_of_face, part), cells, diagonals));
  return charts;
}
