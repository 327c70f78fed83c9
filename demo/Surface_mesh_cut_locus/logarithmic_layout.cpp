// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "logarithmic_layout.h"

#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/logarithmic_chart.h>
#include <CGAL/Cut_loci/surface/location_in_part.h>

namespace {

// Where the source is on the disk.
Location source_on(const Chart& chart, const Mesh& mesh, const Cut_locus& cut_locus)
{
  namespace lib = CGAL::Cut_loci::internal;
  const Location& source = cut_locus.source().location;
  const CGAL::Cut_loci::Indexed_location at{source.first.idx(), source.second};
  const auto on_disk =
    lib::location_in_part(lib::read_triangle_mesh(mesh, mesh.points()).mesh,
                          lib::read_triangle_mesh(chart.disk, chart.disk.points()).mesh, chart.faces, at);
  return {Mesh::Face_index(on_disk.face), on_disk.coordinates};
}

} // namespace

void lay_out_by_logarithmic_map(const Mesh& mesh, const Cut_locus& cut_locus, Chart& chart)
{
  CGAL::Cut_loci::logarithmic_chart(chart.disk, source_on(chart, mesh, cut_locus), chart.uv);
}
