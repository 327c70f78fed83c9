// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TEST_MESHES_H
#define CGAL_CUT_LOCI_TEST_MESHES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <random>
#include <set>
#include <vector>

// The meshes of tests, benchmarks and samples, as plain arrays: compiled once, in the library cut_locus_test_meshes.
namespace test_meshes {

using Point = std::array<double, 3>;
using Triangle = std::array<std::size_t, 3>;

constexpr double pi = 3.14159265358979323846;

struct Mesh_data
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

using CGAL::Cut_loci::internal::operator+;
using CGAL::Cut_loci::internal::operator-;
using CGAL::Cut_loci::internal::operator*;
using CGAL::Cut_loci::internal::cross;
using CGAL::Cut_loci::internal::dot;
using CGAL::Cut_loci::internal::norm;
inline Point normalized(const Point& a)
{
  return (1. / norm(a)) * a;
}

// Two triangles of the square with these corners, counterclockwise, cut from the first corner or from the second.
inline void add_square(Mesh_data& m, const std::array<std::size_t, 4>& q, bool is_cut_from_first = true)
{
  if(is_cut_from_first)
    m.triangles.insert(m.triangles.end(), {{{q[0], q[1], q[2]}}, {{q[0], q[2], q[3]}}});
  else
    m.triangles.insert(m.triangles.end(), {{{q[0], q[1], q[3]}}, {{q[1], q[2], q[3]}}});
}

// -- smooth surfaces, and flat ones -----------------------------------------------------------------------------------

Mesh_data icosahedron();

// each edge divided in `n`, projected to the unit sphere: 20 n^2 faces
Mesh_data sphere(std::size_t n);

Mesh_data jittered_sphere(std::size_t n, double amount, unsigned seed);

Mesh_data ellipsoid(double a, double b, double c, std::size_t n, double amount, unsigned seed);

// Draws random waves on the unit sphere, the same ones on each mesh of it.
Mesh_data bumpy(Mesh_data m, double height, unsigned seed);

Mesh_data bumpy_sphere(std::size_t n, double height, unsigned seed);

// The unit sphere with a bell of some height and width (of its Gaussian, in radians) in the direction of `top`.
Mesh_data sphere_with_bump(std::size_t n, const Point& top, double height, double width);

// Rings of `nu` vertices between two poles.
Mesh_data surface_of_revolution(std::size_t nu, std::size_t nt,
                                const std::function<std::array<double, 2>(double)>& profile);

// Rows of `nu` points for each of the profile's (radius, height); closed by a point at each end of the profile where the
// radius is zero, and open where it is not.
Mesh_data revolution(std::size_t nu, const std::vector<std::array<double, 2>>& profile);

// A bumpy sphere whose faces are slim, of all sizes, and crowded at two poles.
Mesh_data irregular_bumpy_sphere(std::size_t n, double height, unsigned seed);

// a cylinder of radius 1 from z = -half_length to half_length, closed by hemispheres
Mesh_data capsule(double half_length, std::size_t nu, std::size_t nt);

Point torus_point(double R, double r, double u, double w);

// torus of revolution, vertex 0 at (u, w) = (0, 0) on the outer equator; `amount` of the grid step is the jitter
Mesh_data torus(double R, double r, std::size_t nu, std::size_t nw, double amount = 0., unsigned seed = 0);

// radii 1 and `r`; the triangles of the rows are shifted, and so nearly equilateral for nu / nw = 1 / r
Mesh_data torus_with_shifted_rows(std::size_t nu, std::size_t nw, double r = 0.4);

// A torus of eight rings, with so many vertices as given, one after the other: with fans of slim faces between them.
Mesh_data torus_of_rings(const std::vector<std::size_t>& numbers);

// A mesh of two components.
Mesh_data two_tori();

// The faces of a cube as grids of n x n squares, blown up to the radius that `radius` gives in each direction.
Mesh_data star_shape(std::size_t n, const std::function<double(const Point&)>& radius);

Mesh_data sphere_of_squares(std::size_t n);

// with hills, valleys and many saddles
Mesh_data hilly_sphere(std::size_t n);

// a closed surface of triangles a hundred times as long as wide
Mesh_data needles(std::size_t n);

// nx x ny vertices at integer coordinates; squares are cut from their lowest to their highest corner
Mesh_data grid(std::size_t nx, std::size_t ny);

// The unit square in the plane z = 0, triangulated irregularly; its border is kept straight.
Mesh_data square(std::size_t n, double amount = 0., unsigned seed = 0);

// the graph of z = height (x^2 - y^2) over [-1, 1]^2
Mesh_data saddle(std::size_t n, double height, double jitter = 0., unsigned seed = 0);

// an open cylinder of radius 1
Mesh_data cylinder(double height, std::size_t nu, std::size_t nz, double amount, unsigned seed);

// a flat ring, whose inner border bends paths and whose outer one does not
Mesh_data annulus(double inner, double outer, std::size_t nu, std::size_t nr);

// -- polyhedra --------------------------------------------------------------------------------------------------------

using Voxel = std::array<int, 3>;

// of the squares: those of neighbors meet, or none do
enum class Diagonals { ALTERNATING, PARALLEL };

// The boundary of a union of unit cubes, each side divided in `n` x `n` squares. Manifold if no two cubes touch in an
// edge or a vertex alone.
Mesh_data voxel_surface(const std::set<Voxel>& voxels, int n, Diagonals diagonals = Diagonals::ALTERNATING);

Mesh_data box(int x, int y, int z, int n);

// the unit cube: 12 n^2 faces
Mesh_data cube(int n, Diagonals diagonals = Diagonals::ALTERNATING);

Mesh_data cuboid(const Point& size, int n, Diagonals diagonals = Diagonals::ALTERNATING);

// Three unit cubes around the edge x = y = 1, both ends of which are saddles of 450 degrees.
Mesh_data l_shape(int n);

// Two bars of 5 x 1 x 1 cubes across each other: the four edges at which they meet bend paths.
Mesh_data cross_shape(int n);

// Flat, with `holes_x` times `holes_y` square holes: a closed surface whose genus is their number. 7 x 8 holes have
// 1372 n^2 faces.
Mesh_data plate_with_holes(int holes_x, int holes_y, int n, Diagonals diagonals = Diagonals::ALTERNATING);

// The same with its edges rounded off a little, and irregular.
Mesh_data perforated_plate(int holes_x, int holes_y, int n, unsigned seed);

// The same with all edges rounded off.
Mesh_data rounded_plate(int holes_x, int holes_y, int n);

// The square [0, 2 k + 1]^2 without `k` x `k` unit squares: each loop of the border but the outer one bends paths. Each
// unit square is divided in n x n.
Mesh_data square_with_holes(int k, int n);

// how a flat face with many corners is triangulated: by diagonals from one of them, by a zigzag, from its center
enum class Flat_face { FAN, ZIGZAG, STAR };

// a cylinder of `n` flat sides, closed by two flat faces; the vertices of its rims come first, below and above
Mesh_data closed_cylinder(std::size_t n, double height, Flat_face caps);

// -- changes of meshes, and what is read off them ---------------------------------------------------------------------

// uniform in [-1, 1]; std::uniform_real_distribution differs between standard libraries
double random_unit(std::mt19937& engine);

double mean_edge_length(const Mesh_data& m);

// The position of the vertex nearest to `p`.
std::size_t nearest_vertex(const std::vector<Point>& points, const Point& p);
inline std::size_t nearest_vertex(const Mesh_data& m, const Point& p)
{
  return nearest_vertex(m.points, p);
}

// The mesh as the stages of the library take it.
CGAL::Cut_loci::Indexed_triangle_mesh indexed(const Mesh_data& m);

// Sources on it.
inline CGAL::Cut_loci::Indexed_source at_vertex(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh,
                                                CGAL::Cut_loci::Index v)
{
  CGAL::Cut_loci::Index h = 0;
  while(mesh.source(h) != v)
    ++h;
  return {CGAL::Cut_loci::internal::location_on(h), v};
}
inline CGAL::Cut_loci::Indexed_source in_face(CGAL::Cut_loci::Index f, double a, double b, double c)
{
  return {{f, {{a, b, c}}}, CGAL::Cut_loci::null_index};
}

// Moves each vertex by up to `amount` of its shortest edge in each coordinate, then by `project` back to the surface.
Mesh_data jittered(Mesh_data m, double amount, unsigned seed, const std::function<Point(const Point&)>& project);

// The same surface with each vertex moved at random by up to `amount` of the mean edge length, in each coordinate.
Mesh_data rough(Mesh_data m, double amount, unsigned seed);

// Moves each vertex to the mean of its neighbors, some times: rounds off the corners of voxels.
Mesh_data smoothed(Mesh_data m, int times);

Mesh_data scaled(Mesh_data m, const Point& factors);

// Drops the vertices that no face has.
Mesh_data without_isolated_vertices(const Mesh_data& m);

// Takes the faces out whose centroid lies in one of the balls, which must be wide enough apart to leave a manifold.
Mesh_data punctured(const Mesh_data& m, const std::vector<Point>& centers, double radius);

// Takes the faces out that have a corner in the ball.
Mesh_data without_ball(const Mesh_data& m, const Point& center, double radius);

// Both, one after the other, the second one moved.
Mesh_data disjoint_union(Mesh_data a, const Mesh_data& b, const Point& by);

// The same surface with vertices and faces in another order, and each face from another corner. `new_index` tells where
// each vertex went.
Mesh_data shuffled(const Mesh_data& m, unsigned seed, std::vector<std::size_t>& new_index);

// Faces that come in pairs, with a square in common, get the other diagonal of it, each pair by chance.
Mesh_data with_diagonals_at_random(Mesh_data m, unsigned seed);

// Every face becomes four in its plane.
Mesh_data split_in_plane(const Mesh_data& m);

// Both sides of a surface with border, glued along it. No inner edge may join two vertices of the border: `square(n)`
// has none for even n from 4 on.
Mesh_data doubly_covered(const Mesh_data& m);

// -- meshes that algorithms of CGAL make ------------------------------------------------------------------------------

// those of the points that are corners of the hull, in their order
Mesh_data convex_hull(const std::vector<Point>& corners);

// the hull of random points of an ellipsoid: 2 * vertices - 4 faces, no two of them coplanar
Mesh_data random_convex_polyhedron(std::size_t vertices, unsigned seed, const Point& half_axes = {{1., 1., 1.}});

// The same surface with triangles that are nearly equilateral, with edges of about `length`.
Mesh_data remeshed(const Mesh_data& m, double length);

// with edges as long as before, on average
Mesh_data remeshed(const Mesh_data& m);

} // namespace test_meshes

#endif // CGAL_CUT_LOCI_TEST_MESHES_H
