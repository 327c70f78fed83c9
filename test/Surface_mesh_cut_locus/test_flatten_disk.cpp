// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <CGAL/Cut_loci/flatten_disk.h>
#include <CGAL/cut_along_cut_locus.h>

#include <stdexcept>

namespace test_flatten_disk {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::flatten_disk;
using CGAL::Cut_loci::Layout_quality;
using Point_2 = Kernel::Point_2;
using UV_map = Mesh::Property_map<Mesh::Vertex_index, Point_2>;

UV_map add_uv_map(Mesh& disk)
{
  return disk.add_property_map<Mesh::Vertex_index, Point_2>("v:uv", Point_2(0., 0.)).first;
}

double twice_area(const Mesh& disk, const UV_map& uv, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = disk.halfedge(f);
  return CGAL::determinant(uv[disk.target(h)] - uv[disk.source(h)], uv[disk.target(disk.next(h))] - uv[disk.source(h)]);
}

// What holds of each layout, checked without the functions that have made it where that is easy.
Layout_quality expect_injective(Mesh& disk)
{
  UV_map uv = add_uv_map(disk);
  const Layout_quality start = flatten_disk(disk, uv, params::number_of_iterations(0));
  const Layout_quality result = flatten_disk(disk, uv);
  for(Mesh::Face_index f : disk.faces())
    EXPECT_GT(twice_area(disk, uv, f), 0.) << f;
  EXPECT_EQ(result.flipped_faces, 0u);
  EXPECT_TRUE(result.is_injective);
  EXPECT_LE(result.symmetric_dirichlet_energy, start.symmetric_dirichlet_energy);
  for(double mean : {result.area_distortion, result.angle_distortion, result.symmetric_dirichlet_energy})
    EXPECT_GE(mean, 1. - 1e-12);
  const Layout_quality again = CGAL::Cut_loci::layout_quality(disk, uv);
  EXPECT_EQ(again.is_injective, result.is_injective);
  EXPECT_NEAR(again.symmetric_dirichlet_energy, result.symmetric_dirichlet_energy, 1e-9);
  return result;
}

Mesh cut_open(const Mesh_data& data, std::size_t source)
{
  Mesh mesh = to_surface_mesh(data), disk;
  CGAL::cut_along_cut_locus(mesh, compute_cut_locus(mesh, Mesh::Vertex_index(Mesh::size_type(source)), mesh_edges),
                            disk);
  return disk;
}

Mesh_data genus_3()
{
  return perforated_plate(3, 1, 2, 1);
}

// a strip along an arc of so many turns, flat, or as a ramp
Mesh_data strip(double turns, std::size_t columns, double climb)
{
  Mesh_data m;
  for(std::size_t i = 0; i <= columns; ++i)
    for(double radius : {1., 1.15, 1.3})
    {
      const double angle = 2. * CGAL_PI * turns * double(i) / double(columns);
      m.points.push_back({{radius * std::cos(angle), radius * std::sin(angle), climb * angle}});
    }
  for(std::size_t i = 0; i < columns; ++i)
    for(std::size_t a : {3 * i, 3 * i + 1})
      add_square(m, {{a, a + 1, a + 4, a + 3}});
  return m;
}

TEST(Flatten_disk, Surfaces_cut_open)
{
  const std::map<std::string, Mesh_data> surfaces = {
    {"sphere", bumpy_sphere(6, 0.1, 1)},           {"long", capsule(4., 12, 30)},
    {"torus", torus(1., 0.4, 40, 20, 0.1, 1)},     {"genus 3", genus_3()},
    {"cylinder", cylinder(2., 20, 10, 0.1, 1)},    {"square", square(8, 0.2, 1)},
    {"plate", smoothed(rounded_plate(2, 1, 2), 3)}};
  for(const auto& [name, surface] : surfaces)
  {
    SCOPED_TRACE(name);
    Mesh disk = cut_open(surface, 0);
    expect_injective(disk);
  }
}

// These have several times as many vertices as seams of mesh edges.
TEST(Flatten_disk, Seams_through_the_faces)
{
  const std::map<std::string, Mesh_data> surfaces = {{"sphere", bumpy_sphere(24, 0.1, 1)},
                                                     {"torus", torus(1., 0.4, 80, 40, 0.2, 1)},
                                                     {"plate", smoothed(rounded_plate(2, 2, 2), 3)}};
  for(const auto& [name, surface] : surfaces)
  {
    SCOPED_TRACE(name);
    Mesh mesh = to_surface_mesh(surface), along_edges = cut_open(surface, 0), along_curve;
    CGAL::cut_along_cut_locus(mesh, compute_cut_locus(mesh, *mesh.vertices().begin(), through_faces), along_curve);
    const double energy = expect_injective(along_edges).symmetric_dirichlet_energy;
    EXPECT_NEAR(expect_injective(along_curve).symmetric_dirichlet_energy, energy, 0.02 * energy);
  }
}

// What can lie flat does, and keeps its size and its orientation.
TEST(Flatten_disk, Developable_surfaces_keep_their_shape)
{
  for(double unit : {1., 1e-90, 1e90})
  {
    Mesh_data roll = square(10, 0.2, 1);
    for(Point& p : roll.points)
      p = {{unit * std::sin(p[0]), unit * std::cos(p[0]), unit * p[1]}};
    Mesh disk = to_surface_mesh(roll);
    // the chords of the roll turn at edges: it is flat up to the squares of their lengths
    const Layout_quality quality = expect_injective(disk);
    EXPECT_LT(quality.symmetric_dirichlet_energy, 1.001);
    const UV_map uv = add_uv_map(disk);
    for(Mesh::Edge_index e : disk.edges())
    {
      const double length =
        std::sqrt(CGAL::squared_distance(disk.point(disk.vertex(e, 0)), disk.point(disk.vertex(e, 1)))) / unit;
      const Kernel::Vector_2 image = (uv[disk.vertex(e, 0)] - uv[disk.vertex(e, 1)]) / unit;
      EXPECT_NEAR(std::sqrt(image.squared_length()), length, 0.05 * length);
    }
  }
}

// A ramp of one turn and a half can not lie flat as it is without lying on itself: seen from above, half of the ring is
// covered twice.
TEST(Flatten_disk, Overlap_is_measured_and_avoided)
{
  Mesh disk = to_surface_mesh(strip(1.5, 90, 0.02));
  UV_map uv = add_uv_map(disk);
  for(Mesh::Vertex_index v : disk.vertices())
    uv[v] = Point_2(disk.point(v).x(), disk.point(v).y());
  const Layout_quality above = CGAL::Cut_loci::layout_quality(disk, uv);
  EXPECT_EQ(above.flipped_faces, 0u);
  EXPECT_FALSE(above.is_injective);
  EXPECT_NEAR(above.overlap, 0.5, 0.01);
  // all of the first half turn and of the last
  EXPECT_NEAR(double(above.overlapping_faces), 2. / 3. * double(disk.number_of_faces()), 8.);
  disk.remove_property_map(uv);
  expect_injective(disk);
}

// One that does not reach itself, and one that overlaps by less than the grid can see.
TEST(Flatten_disk, Overlap_is_found_exactly)
{
  Mesh disk = to_surface_mesh(strip(0.99, 90, 0.));
  UV_map uv = add_uv_map(disk);
  const auto look_from_above = [&]
  {
    for(Mesh::Vertex_index v : disk.vertices())
      uv[v] = Point_2(disk.point(v).x(), disk.point(v).y());
    return CGAL::Cut_loci::layout_quality(disk, uv);
  };
  EXPECT_TRUE(look_from_above().is_injective);
  // the last row of points comes to lie just beyond the first
  for(int j = 0; j < 3; ++j)
  {
    const Kernel::Point_3& p = disk.point(Mesh::Vertex_index(j));
    disk.point(Mesh::Vertex_index(3 * 90 + j)) = Kernel::Point_3(p.x(), p.y() + 1e-9, 0.);
  }
  const Layout_quality quality = look_from_above();
  EXPECT_EQ(quality.flipped_faces, 0u);
  EXPECT_FALSE(quality.is_injective);
  EXPECT_GE(quality.overlapping_faces, 4u);
  EXPECT_LE(quality.overlapping_faces, 8u);
  EXPECT_LT(quality.overlap, 1e-3);
}

TEST(Flatten_disk, Flipped_faces_are_counted)
{
  Mesh disk = to_surface_mesh(square(4));
  UV_map uv = add_uv_map(disk);
  for(Mesh::Vertex_index v : disk.vertices())
    uv[v] = Point_2(disk.point(v).x(), -disk.point(v).y());
  const Layout_quality mirrored = CGAL::Cut_loci::layout_quality(disk, uv);
  EXPECT_EQ(mirrored.flipped_faces, disk.number_of_faces());
  EXPECT_FALSE(mirrored.is_injective);
  EXPECT_NEAR(mirrored.angle_distortion, 1., 1e-9);
  EXPECT_TRUE(std::isinf(mirrored.symmetric_dirichlet_energy));
}

// Distortion is infinite then, and not a number.
TEST(Flatten_disk, Images_without_area)
{
  Mesh disk = to_surface_mesh(square(4));
  UV_map uv = add_uv_map(disk);
  for(bool is_partly : {false, true})
  {
    if(is_partly)
      uv[*disk.vertices().begin()] = Point_2(-1., 1.);
    const Layout_quality quality = CGAL::Cut_loci::layout_quality(disk, uv);
    EXPECT_GT(quality.flipped_faces, 0u);
    EXPECT_FALSE(quality.is_injective);
    EXPECT_EQ(quality.overlap, 0.);
    for(double mean : {quality.area_distortion, quality.angle_distortion, quality.symmetric_dirichlet_energy})
      EXPECT_TRUE(std::isinf(mean)) << mean;
  }
}

// Needles and faces without area have no shape; the others have theirs.
TEST(Flatten_disk, Faces_without_area)
{
  for(double height : {0., 1e-300, 1e-12, 1e-3})
  {
    SCOPED_TRACE(height);
    Mesh disk = to_surface_mesh(square(8));
    Mesh::size_type inner = 0;
    for(Mesh::Vertex_index v : disk.vertices())
      if(!disk.is_border(v) && inner++ % 5 == 0)
      {
        const Kernel::Point_3 p = disk.point(v), q = disk.point(disk.source(disk.halfedge(v)));
        disk.point(v) = q + height * (p - q);
      }
    const Layout_quality quality = expect_injective(disk);
    EXPECT_EQ(quality.faces_without_shape > 0, height < 1e-4);
    EXPECT_TRUE(std::isfinite(quality.symmetric_dirichlet_energy));
  }
  Mesh point = to_surface_mesh(square(3));
  for(Mesh::Vertex_index v : point.vertices())
    point.point(v) = Kernel::Point_3(1., 2., 3.);
  UV_map uv = add_uv_map(point);
  EXPECT_THROW(flatten_disk(point, uv), Invalid_input);
}

// A long pocket whose only opening is the border: in the convex layout its end shrinks to about e^-24 of the disk.
TEST(Flatten_disk, Deep_pocket)
{
  Mesh disk = to_surface_mesh(punctured(capsule(12., 16, 120), {Point{{0., 0., 13.}}}, 1.));
  const Layout_quality quality = expect_injective(disk);
  EXPECT_LT(quality.symmetric_dirichlet_energy, 1e3);
}

// A tube of 40 radii that is open at an end alone, and so a disk: faces at the other end shrink to nothing in a convex
// layout of all of them.
TEST(Flatten_disk, Long_tube)
{
  Mesh disk = to_surface_mesh(punctured(capsule(40., 12, 120), {Point{{0., 0., 41.}}}, 1.));
  UV_map uv = add_uv_map(disk);
  const Layout_quality quality = flatten_disk(disk, uv);
  EXPECT_EQ(quality.flipped_faces, 0u);
  EXPECT_TRUE(quality.is_injective);
}

struct Progress_log : public CGAL::Cut_loci::Default_visitor
{
  void progress(CGAL::Cut_loci::Stage stage, double share)
  {
    EXPECT_EQ(stage, CGAL::Cut_loci::Stage::FLATTENING);
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.);
    last = share;
    if(share > limit)
      throw std::runtime_error("canceled");
  }
  double last = 0., limit = 2.;
};

TEST(Flatten_disk, Progress_is_told_and_can_cancel)
{
  Mesh disk = to_surface_mesh(smoothed(square(20, 0.2, 1), 1));
  UV_map uv = add_uv_map(disk);
  Progress_log log;
  flatten_disk(disk, uv, params::visitor(std::ref(log)));
  EXPECT_GT(log.last, 0.5);
  Progress_log canceling;
  canceling.limit = 0.5;
  EXPECT_THROW(flatten_disk(disk, uv, params::visitor(std::ref(canceling))), std::runtime_error);
}

TEST(Flatten_disk, Bad_input)
{
  Mesh sphere = to_surface_mesh(icosahedron()), cylindrical = to_surface_mesh(cylinder(1., 8, 3, 0., 0)),
       two = to_surface_mesh(disjoint_union(square(2), square(2), {{5., 0., 0.}}));
  for(Mesh* mesh : {&sphere, &cylindrical, &two})
  {
    UV_map uv = add_uv_map(*mesh);
    expect_refused([&] { flatten_disk(*mesh, uv); }, Cause::NO_DISK, {"cut_along_cut_locus"});
  }
  Mesh disk = to_surface_mesh(square(2));
  UV_map uv = add_uv_map(disk);
  uv[Mesh::Vertex_index(1)] = Point_2(std::nan(""), 0.);
  EXPECT_THROW(CGAL::Cut_loci::layout_quality(disk, uv), Invalid_input);
}

} // namespace

} // namespace test_flatten_disk
