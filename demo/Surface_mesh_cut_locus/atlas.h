// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_ATLAS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_ATLAS_H

#include "Input_mesh.h"
#include "charts.h"

#include <CGAL/Cut_loci/Layout_quality.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// All components of a surface, cut open to disks and laid flat.
struct Atlas
{
  std::string parameterization;
  Charts charts;             // with `uv` in the unit square
  bool splits_faces = false; // as seams that are straight do
  std::size_t seams_in_polygons = 0;
  double seam_length = 0.;
  double seam_distance = 0.; // of the seams to the source of the first component
  double covered = 0.;       // the part of the unit square
  double stretch = 0.;       // of the chart that has most, see `stretch()`
  CGAL::Cut_loci::Layout_quality quality;
};

// The stretch of a disk that is as far from an isometry all over as one is in the mean, by the symmetric Dirichlet energy:
// 2 where all lengths are doubled, or halved.
double stretch(const CGAL::Cut_loci::Layout_quality& quality);

// Packs charts that are flattened. `cut_locus` is that of the first source.
Atlas make_atlas(const Input_mesh& input, const Cut_locus& cut_locus, Charts charts,
                 const std::string& parameterization);

// Normals, and the number of the one at each corner of each polygon of a file; none unless all corners have one.
struct Corner_normals
{
  std::vector<Kernel::Vector_3> normals;
  std::vector<std::vector<std::size_t>> numbers;
};

// The number of the normal at each corner of the faces of all charts, in their order, if there are any. No face may be split.
std::vector<std::size_t> normals_of_charts(const Atlas& atlas, const Input_mesh& input, const Polygon_soup& soup,
                                           const Corner_normals& normals);

// For each corner of each polygon of the file its number in the vertices of all charts, one after the other, or
// `no_corner`. No face may be split.
constexpr std::size_t no_corner = std::size_t(-1);
std::vector<std::vector<std::size_t>> texture_of_polygons(const Atlas& atlas, const Input_mesh& input,
                                                          const Polygon_soup& soup);

// The seams, as vertices of the file. No face may be split.
std::vector<std::pair<std::size_t, std::size_t>> seams_of_polygons(const Atlas& atlas, const Input_mesh& input,
                                                                   const Polygon_soup& soup);

// Writes an OBJ file, or glTF in one file (.glb). An OBJ file that is read stays as it is, but for texture coordinates;
// else there is a texture, in the file, or, with a material, beside it. Throws `std::runtime_error` if that fails.
void write_atlas(const std::string& filename, const Atlas& atlas, const Input_mesh& input, const File_content& content);

// Writes the seams: as lines (.obj), as pairs of vertices (.json), or as a script for Blender (.py).
void write_seams(const std::string& filename, const Atlas& atlas, const Input_mesh& input, const Polygon_soup& soup);

// The distance of the source to the cut graph that is short: the shortest system of loops over edges from a vertex, the
// best of several vertices [Erickson, Whittlesey: Greedy optimal homotopy and homology generators, 2005]. Nothing if
// the surface is a sphere or has a border.
std::optional<double> distance_to_short_cut_graph(const Mesh& mesh, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_ATLAS_H
