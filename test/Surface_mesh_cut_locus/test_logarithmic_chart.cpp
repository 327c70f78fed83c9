// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/flatten_disk.h>
#include <CGAL/Cut_loci/logarithmic_chart.h>
#include <CGAL/Cut_loci/surface/location_in_part.h>
#include <CGAL/cut_along_cut_locus.h>

// The logarithmic map as a chart: isometric on convex polyhedra, and with exact distances on all surfaces.

namespace test_logarithmic_chart {

namespace {

using namespace surface_test;
namespace lib = CGAL::Cut_loci::internal;

constexpr double snapping = 1. / (1 << 20); // of the curve, in parts of a face

struct Chart
{
  Mesh disk;
  Mesh::Property_map<Mesh::Vertex_index, Mesh::Vertex_index> origin =
    disk.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv =
    disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  template <typename CutLocus>
  Chart(const Mesh& mesh, const CutLocus& cut_locus)
  {
    const auto face = disk.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:origin").first;
    CGAL::cut_along_cut_locus(mesh, cut_locus, disk,
                              params::snapping_tolerance(snapping).vertex_to_vertex_map(origin).face_to_face_map(face));
    std::vector<Index> faces;
    for(const Mesh::Face_index f : disk.faces())
      faces.push_back(face[f].idx());
    const auto& source = cut_locus.source().location;
    const auto on_disk = lib::location_in_part(lib::read_triangle_mesh(mesh, mesh.points()).mesh,
                                               lib::read_triangle_mesh(disk, disk.points()).mesh, faces,
                                               {source.first.idx(), source.second});
    CGAL::Cut_loci::logarithmic_chart(disk, std::make_pair(Mesh::Face_index(on_disk.face), on_disk.coordinates), uv);
  }
};

double length(const Kernel::Point_2& p)
{
  return std::hypot(p.x(), p.y());
}

/// the source unfolding: no edge changes its length
TEST(Logarithmic_chart, is_isometric_on_convex_polyhedra)
{
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(random_convex_polyhedron(12 + seed, seed));
    const std::pair<Mesh::Face_index, std::array<double, 3>> source(Mesh::Face_index(seed), {{0.2, 0.5, 0.3}});
    const Chart chart(built.mesh, compute_cut_locus(built.mesh, source, by(Polyhedral_method())));
    for(const Mesh::Edge_index e : chart.disk.edges())
    {
      const Mesh::Vertex_index a = chart.disk.vertex(e, 0), b = chart.disk.vertex(e, 1);
      EXPECT_NEAR(length(Kernel::Point_2(chart.uv[a].x() - chart.uv[b].x(), chart.uv[a].y() - chart.uv[b].y())),
                  std::sqrt(CGAL::squared_distance(chart.disk.point(a), chart.disk.point(b))), 1e-5);
    }
    EXPECT_EQ(CGAL::Cut_loci::layout_quality(chart.disk, chart.uv).flipped_faces, 0u);
  }
}

/// all copies of a vertex have its distance
TEST(Logarithmic_chart, has_exact_distances)
{
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(seed % 2 ? torus(2., 0.8, 18, 10, 0.2, seed) : irregular_bumpy_sphere(6, 0.3, seed));
    const Mesh::Vertex_index source = built.vertices[5 * seed];
    Geodesics geodesics(built.mesh);
    geodesics.compute(source);
    const Chart chart(built.mesh, compute_cut_locus(built.mesh, source));
    for(const Mesh::Vertex_index v : chart.disk.vertices())
      if(chart.origin[v] != Mesh::null_vertex())
      {
        EXPECT_NEAR(length(chart.uv[v]), geodesics.distance(chart.origin[v]), 1e-5);
      }
    EXPECT_GT(CGAL::Cut_loci::layout_quality(chart.disk, chart.uv).area_distortion, 1.);
  }
}

} // namespace

} // namespace test_logarithmic_chart
