// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "cells.h"

#include "output_file.h"
#include "surface_files.h"

#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <ostream>
#include <utility>

namespace {

namespace lib = CGAL::Cut_loci::internal;
using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::null_index;
using CGAL::Cut_loci::Refined_mesh;
using Read = lib::Read_triangle_mesh<Mesh>;

// Of a point that is new because two segments cross in it after rounding, the mean of the distances around it.
void fill_in_distances(const Refined_mesh& refined, std::vector<double>& distance)
{
  std::vector<std::pair<double, std::size_t>> sum(distance.size());
  for(Index h = 0; h < refined.mesh.number_of_halfedges(); ++h)
    if(const double d = distance[refined.mesh.target(h)];
       std::isnan(distance[refined.mesh.source(h)]) && std::isfinite(d))
    {
      sum[refined.mesh.source(h)].first += d;
      ++sum[refined.mesh.source(h)].second;
    }
  for(std::size_t v = 0; v < distance.size(); ++v)
    if(std::isnan(distance[v]))
      distance[v] = sum[v].second > 0 ? sum[v].first / double(sum[v].second) : 0.;
}

struct Cell_point
{
  const Cells& cells;
  Index vertex;
};

std::ostream& operator<<(std::ostream& os, const Cell_point& p)
{
  const auto& x = p.cells.mesh.points[p.vertex];
  return os << x[0] << ' ' << x[1] << ' ' << x[2];
}

void write_cells_ply(std::ostream& os, const Cells& cells)
{
  os << "ply\nformat ascii 1.0\nelement vertex " << cells.mesh.number_of_vertices()
     << "\nproperty double x\nproperty double y\nproperty double z\nproperty double distance\nelement face "
     << cells.mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\nproperty int source\nend_header\n";
  for(Index v = 0; v < cells.mesh.number_of_vertices(); ++v)
    os << Cell_point{cells, v} << ' ' << finite_distance(cells.distance[v]) << '\n';
  for(Index f = 0; f < cells.mesh.number_of_faces(); ++f)
  {
    const auto& t = cells.mesh.triangles[f];
    os << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << static_cast<std::ptrdiff_t>(cells.source[f]) << '\n';
  }
}

void write_cells_vtp(std::ostream& os, const Cells& cells)
{
  const auto source = [&](Index f) { return static_cast<double>(static_cast<std::ptrdiff_t>(cells.source[f])); };
  write_vtp(os, cells.mesh, {{"distance", false, [&](Index v) { return finite_distance(cells.distance[v]); }}},
            {{"source", true, source}});
}

// a group for each cell
void write_cells_obj(std::ostream& os, const Cells& cells)
{
  for(Index v = 0; v < cells.mesh.number_of_vertices(); ++v)
    os << "v " << Cell_point{cells, v} << '\n';
  std::vector<std::pair<std::size_t, Index>> order; // by sources; those without one come last
  for(Index f = 0; f < cells.mesh.number_of_faces(); ++f)
    order.emplace_back(cells.source[f], f);
  std::sort(order.begin(), order.end());
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    if(i == 0 || order[i].first != order[i - 1].first)
      os << "g "
         << (order[i].first == CGAL::Cut_loci::no_source ? std::string("unreached")
                                                         : "source_" + std::to_string(order[i].first))
         << '\n';
    const auto& t = cells.mesh.triangles[order[i].second];
    os << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
}

} // namespace

Cells make_cells(const Mesh& mesh, const Cut_locus& cut_locus)
{
  constexpr Index resolution = 1 << 12; // a pixel of a face that fills a picture
  const Read read = lib::read_triangle_mesh(mesh, mesh.points());
  const lib::Curve_on_mesh curve = lib::curve_on_mesh(read, mesh, cut_locus);
  const CGAL::Cut_loci::Cut_mesh fans = CGAL::Cut_loci::cut_open(read.mesh); // components may touch in a vertex
  Refined_mesh refined = CGAL::Cut_loci::refine_along_curve(fans.mesh, CGAL::Cut_loci::Mesh_connectivity(fans.mesh),
                                                            curve.graph, resolution);

  Cells cells;
  cells.distance.assign(refined.mesh.number_of_vertices(), std::numeric_limits<double>::quiet_NaN());
  for(std::size_t i = 0; i < refined.nodes.size(); ++i)
    cells.distance[refined.nodes[i]] = curve.graph.nodes[i].distance;
  for(Index v = 0; v < fans.vertices.size(); ++v)
    cells.distance[v] = cut_locus.distance(read.vertices[fans.vertices[v]]);
  fill_in_distances(refined, cells.distance);
  cells.vertices.assign(refined.mesh.number_of_vertices(), null_index);
  for(Index v = 0; v < fans.vertices.size(); ++v)
    cells.vertices[v] = static_cast<Index>(read.vertices[fans.vertices[v]]);
  cells.faces = refined.faces;
  cells.source = lib::cells_of_faces(read, fans.vertices, curve, refined, cut_locus);
  cells.mesh = std::move(refined.mesh);
  cells.seams = std::move(refined.seams);
  return cells;
}

void write_cells(const std::string& filename, const Cells& cells)
{
  const std::string extension = std::filesystem::path(filename).extension().string();
  const auto write = extension == ".ply" ? write_cells_ply : extension == ".vtp" ? write_cells_vtp : write_cells_obj;
  write_file(filename, [&](std::ostream& os) { write(os, cells); });
}
