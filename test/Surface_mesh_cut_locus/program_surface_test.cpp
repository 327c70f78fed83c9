// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Which surface the program takes a file for: flat faces, and vertices that the file has more than once.

#include "program_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Point = std::array<double, 3>;

class Surface : public Program
{
protected:
  struct Soup
  {
    std::vector<Point> points;
    std::vector<std::vector<int>> faces;

    int add(const Point& p)
    {
      points.push_back(p);
      return static_cast<int>(points.size()) - 1;
    }

    // nx * ny squares over the unit square, which `place` brings to space
    void add_grid(int nx, int ny, const std::function<Point(double, double)>& place, bool is_turned = false)
    {
      const int first = static_cast<int>(points.size());
      for(int j = 0; j <= ny; ++j)
        for(int i = 0; i <= nx; ++i)
          points.push_back(place(double(i) / nx, double(j) / ny));
      for(int j = 0; j < ny; ++j)
        for(int i = 0; i < nx; ++i)
        {
          const int v = first + j * (nx + 1) + i;
          faces.push_back({v, v + 1, v + nx + 2, v + nx + 1});
          if(is_turned)
            std::reverse(faces.back().begin(), faces.back().end());
        }
    }
  };

  static std::string off(const Soup& soup)
  {
    std::ostringstream text;
    text.precision(17);
    text << "OFF\n" << soup.points.size() << ' ' << soup.faces.size() << " 0\n";
    for(const Point& p : soup.points)
      text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for(const auto& face : soup.faces)
    {
      text << face.size();
      for(int v : face)
        text << ' ' << v;
      text << '\n';
    }
    return text.str();
  }

  // each corner is a vertex of its own
  static Soup taken_apart(const Soup& soup)
  {
    Soup result;
    for(auto face : soup.faces)
    {
      for(int& v : face)
        v = result.add(soup.points[v]);
      result.faces.push_back(face);
    }
    return result;
  }

  Json report(const std::string& text, const std::string& arguments = "") const
  {
    write("a.off", text);
    return report_on("a.off", arguments);
  }

  Json report(const Soup& soup, const std::string& arguments = "") const { return report(off(soup), arguments); }

  static void expect_closed(const Json& report, std::size_t merged)
  {
    EXPECT_EQ(report.at("components_of_mesh"), 1);
    EXPECT_EQ(report.at("border_loops"), 0);
    EXPECT_EQ(report.at("genus"), 0);
    EXPECT_EQ(report.at("repair").at("merged_vertices"), merged);
    EXPECT_EQ(report.at("repair").at("open_edges"), 0);
    EXPECT_EQ(report.at("repair").at("added_vertices"), 0);
  }

  // All sides have their own vertices.
  static Soup box(int n, const Point& size)
  {
    Soup soup;
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
        soup.add_grid(
          n, n,
          [&](double s, double t)
          {
          Point p;
          p[axis] = side * size[axis];
          p[(axis + 1) % 3] = s * size[(axis + 1) % 3];
          p[(axis + 2) % 3] = t * size[(axis + 2) % 3];
          return p;
          },
          side == 0);
    return soup;
  }

  // The first and the last meridian are at one place, and so are all vertices at a pole, for triangles of their own.
  static Soup ellipsoid_with_seam(int meridians, int parallels)
  {
    Soup soup;
    const double pi = std::acos(-1.);
    soup.add_grid(meridians, parallels,
                  [&](double s, double t)
                  {
      const double r = t == 0. || t == 1. ? 0. : std::sin(pi * t), u = s == 1. ? 0. : 2. * pi * s;
      return Point{{r * std::cos(u), 0.8 * r * std::sin(u), -0.6 * std::cos(pi * t)}};
    });
    std::vector<std::vector<int>> triangles;
    for(std::size_t f = 0; f < soup.faces.size(); ++f)
    {
      const auto& q = soup.faces[f];
      if(f >= std::size_t(meridians))
        triangles.push_back({q[0], q[1], q[2]});
      if(f + meridians < soup.faces.size())
        triangles.push_back({q[0], q[2], q[3]});
    }
    soup.faces = triangles;
    return soup;
  }
};

TEST_F(Surface, Flat_faces_are_taken_as_they_are)
{
  std::array<double, 4> on_line = {{0., 8., 9., 13.}};
  do
    for(bool is_closed : {true, false})
    {
      Soup soup;
      for(double y : on_line)
        soup.add({{0., y, 0.}});
      soup.points.insert(soup.points.end(), {{{-5., 6., 0.}}, {{5., 6., 0.}}});
      soup.faces = {{0, 1, 2}, {2, 1, 3}, {0, 2, 4}, {2, 3, 4}, {3, 1, 5}, {1, 0, 5}};
      if(is_closed)
      {
        soup.add({{0., 6., 7.}});
        soup.faces.insert(soup.faces.end(), {{0, 4, 6}, {4, 3, 6}, {3, 5, 6}, {5, 0, 6}});
      }
      const auto files = [&](const std::string& repair)
      {
        const Json all =
          report(soup, "--source 0 -o " + file("c.obj") + " --cells " + file("k.obj") + " --repair " + repair);
        EXPECT_EQ(all.at("faces"), soup.faces.size());
        EXPECT_EQ(all.at("repair").at("done"), "");
        return read_file(path("c.obj")) + read_file(path("k.obj"));
      };
      EXPECT_EQ(files("weld"), files("none")) << off(soup);
    }
  while(std::next_permutation(on_line.begin(), on_line.end()));
}

TEST_F(Surface, Source_points_on_flat_faces_are_points)
{
  // five vertices on an edge of a tetrahedron, as decimals that are not on a line exactly
  Soup soup;
  soup.points = {{{0., 0., 0.}}, {{3., 0.3, 0.}}, {{1., 3., 0.}}, {{1., 1., 3.}}, {{1., 0.1, 0.}}, {{1.1, 0.11, 0.}}};
  soup.faces = {{0, 2, 1}, {0, 1, 4}, {4, 1, 5}, {0, 4, 3}, {4, 5, 3}, {5, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for(double share = 0.; share <= 1.; share += 0.0625)
  {
    std::ostringstream point;
    point << std::setprecision(17) << 3. * share << "," << 0.3 * share << ",0";
    const Json all = report(soup, "--source-point " + point.str() + " --curve faces");
    const Json at = all.at("source_point");
    EXPECT_NEAR(at.at(0).get<double>(), 3. * share, 1e-9);
    EXPECT_NEAR(at.at(1).get<double>(), 0.3 * share, 1e-9);
  }
}

// Of the surface of a scan, where a flat face is beside a vertex at which sheets touch.
TEST_F(Surface, Flat_faces_and_sheets_that_touch)
{
  const Json all = report(
    "OFF\n19 20 0\n.3 0 0\n1 1 0\n0 .3 0\n.3 .7 0\n.7 .73 0\n.33333333333333331 .33333333333333331 0\n"
    ".7 .7 0\n.7 .7 0\n.7 1 0\n.3 .3 0\n0 .7 0\n.3 1 0\n.4 1 0\n.7 .3 0\n.33333333333333331 .3 0\n.3 .7 0\n0 1 0\n"
    ".3 .96 0\n.7 .3 0\n3 5 13 3\n3 15 9 2\n3 14 2 9\n3 15 1 18\n3 18 9 15\n3 7 17 3\n3 2 5 3\n3 11 17 7\n"
    "3 15 11 12\n3 5 2 14\n3 14 0 5\n3 15 12 8\n3 11 10 17\n3 13 7 3\n3 4 15 8\n3 1 6 4\n3 4 8 1\n3 10 11 16\n"
    "3 6 1 15\n3 15 16 11\n");
  EXPECT_EQ(all.at("faces"), 20);
}

TEST_F(Surface, Vertices_whose_coordinates_differ_by_rounding_are_merged)
{
  std::mt19937 random(1);
  const Soup whole = box(2, {{1., 2., 3.}});
  const Json exact = report(whole, "--source-point 0.3,0.4,0");
  for(double noise : {0., 1e-18, 1e-15, 1e-9, 3e-8})
  {
    Soup soup = taken_apart(whole);
    for(Point& p : soup.points)
      for(double& x : p)
        x += noise * (2. * std::uniform_real_distribution<>()(random) - 1.); // also on both sides of zero
    const Json all = report(soup, "--source-point 0.3,0.4,0");
    expect_closed(all, 4 * 24 - 26);
    EXPECT_NEAR(all.at("farthest_distance").get<double>(), exact.at("farthest_distance").get<double>(), 1e-6);
    EXPECT_EQ(all.at("leaves"), exact.at("leaves"));
  }
}

// Copies at a pole are of triangles that share edges with others.
TEST_F(Surface, Seams_of_textures_are_closed)
{
  const int meridians = 24, parallels = 16, source = 8 * 25 + 6;
  const Soup soup = ellipsoid_with_seam(meridians, parallels);
  const Json all = report(soup, "--source " + std::to_string(source));
  expect_closed(all, 2 * (meridians - 1) + parallels - 1);
  EXPECT_EQ(all.at("source"), source);
  Soup whole = soup;
  for(auto& face : whole.faces)
    for(int& v : face)
      v = static_cast<int>(std::find(soup.points.begin(), soup.points.end(), soup.points[v]) - soup.points.begin());
  const Json expected = report(whole, "--source " + std::to_string(source));
  for(const char* figure : {"injectivity_radius", "farthest", "farthest_distance", "edges", "leaves"})
    EXPECT_EQ(all.at(figure), expected.at(figure)) << figure;

  const Json open = report(soup, "--repair orient --source " + std::to_string(source));
  EXPECT_EQ(open.at("border_loops"), 1);
  EXPECT_EQ(open.at("repair").at("done"), "");
}

TEST_F(Surface, Hard_edges_are_closed)
{
  const Soup soup = box(4, {{1., 1., 1.}});
  expect_closed(report(soup), 6 * 25 - 98);
  EXPECT_EQ(report(soup, "--repair orient").at("components_of_mesh"), 6);
  const Outcome outcome = run(file("a.off") + " --source 0");
  expect_has(outcome.messages, "52 border vertices merged with others at their places");
}

TEST_F(Surface, What_may_be_two_sheets_stays_apart)
{
  const auto sheet = [](double shift, double slope, double height) {
    return [=](double s, double t) { return Point{{shift + s, t, height + slope * s}}; };
  };
  // both sides of a sheet, and one twice
  for(bool is_turned : {false, true})
    for(double height : {0., 1e-9})
    {
      Soup soup;
      soup.add_grid(3, 3, sheet(0., 0., 0.));
      soup.add_grid(3, 3, sheet(0., 0., height), is_turned);
      const Json all = report(soup);
      EXPECT_EQ(all.at("components_of_mesh"), 2);
      EXPECT_EQ(all.at("repair").at("merged_vertices"), 0);
      EXPECT_EQ(all.at("repair").at("open_edges"), 24);
    }
  // three at an edge
  Soup book;
  for(double slope : {-1., 0., 1.})
    book.add_grid(2, 2, sheet(0., slope, 0.));
  EXPECT_EQ(report(book).at("components_of_mesh"), 3);
  EXPECT_EQ(report(book).at("repair").at("open_edges"), 6);
  expect_has(run(file("a.off")).messages, "6 border edges left open that lie on each other");
  // at a vertex
  Soup corner;
  corner.add_grid(2, 2, sheet(0., 0., 0.));
  corner.add_grid(2, 2, [](double s, double t) { return Point{{1. + s, 1. + t, 0.}}; });
  EXPECT_EQ(report(corner).at("components_of_mesh"), 2);
  EXPECT_EQ(report(corner).at("repair").at("open_edges"), 0);
  // a band with a twist
  const double pi = std::acos(-1.);
  Soup band;
  band.add_grid(12, 2,
                [&](double s, double t)
                {
    const double u = s == 1. ? 0. : s, w = s == 1. ? t - 0.5 : 0.5 - t, r = 2. + w * std::cos(pi * u);
    return Point{{r * std::cos(2. * pi * u), r * std::sin(2. * pi * u), w * std::sin(pi * u)}};
  });
  const Json twisted = report(band);
  EXPECT_EQ(twisted.at("repair").at("added_vertices"), 0);
  EXPECT_LE(twisted.at("repair").at("open_edges"), 4);
  EXPECT_GE(twisted.at("repair").at("open_edges"), 2);
}

TEST_F(Surface, Double_triangles_do_not_keep_others_apart)
{
  Soup soup = taken_apart(ellipsoid_with_seam(8, 6));
  const std::size_t number = soup.faces.size();
  for(std::size_t f : {std::size_t(3), std::size_t(3), std::size_t(20)})
  {
    auto face = soup.faces[f];
    for(int& v : face)
      v = soup.add(soup.points[v]);
    if(f == 20)
      std::reverse(face.begin(), face.end());
    soup.faces.push_back(face);
  }
  // between two others, a face whose edge at a pole has no length
  soup.faces.push_back({soup.add(soup.points[soup.faces[0][0]]), soup.add(soup.points[soup.faces[0][0]]),
                        soup.add(soup.points[soup.faces[0][1]])});
  const Json all = report(soup);
  EXPECT_EQ(all.at("faces"), number);
  EXPECT_EQ(all.at("repair").at("removed_faces"), 4);
  EXPECT_EQ(all.at("border_loops"), 0);
  EXPECT_EQ(all.at("repair").at("open_edges"), 0);
}

// A sheet that was turned over belongs to the others all the same.
TEST_F(Surface, Sheets_of_opposite_orientation_are_joined_side_by_side)
{
  Soup soup = box(3, {{1., 2., 1.}});
  for(std::size_t f = 0; f < 18; ++f)
    std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  const Json all = report(soup);
  expect_closed(all, 6 * 16 - 56);
  EXPECT_EQ(all.at("repair").at("reversed_faces").get<int>() % 18, 0);
}

// Ends of an edge are different points, however close they are.
TEST_F(Surface, Short_edges_keep_their_length)
{
  for(double shortest : {1e-8, 1e-12})
  {
    Soup soup;
    soup.add_grid(3, 1, [&](double s, double t) { return Point{{s, shortest * t, 0.}}; });
    soup.add_grid(3, 1, [&](double s, double t) { return Point{{s, shortest * (1. + t), 0.}}; });
    const Json all = report(soup);
    EXPECT_EQ(all.at("faces"), 12);
    EXPECT_EQ(all.at("components_of_mesh"), 1);
    EXPECT_EQ(all.at("repair").at("merged_vertices"), 4);
  }
}

TEST_F(Surface, Polygons_keep_the_order_of_their_vertices)
{
  Soup soup;
  soup.add_grid(5, 4, [](double s, double t) { return Point{{s, t, s * t}}; });
  std::shuffle(soup.faces.begin(), soup.faces.end(), std::mt19937(2));
  report(soup, "--source 14 --uv " + file("u.obj") + " --cells " + file("k.obj"));
  for(const char* name : {"u.obj", "k.obj"})
  {
    std::istringstream is(read_file(path(name)));
    std::size_t v = 0;
    for(std::string line; std::getline(is, line) && v < soup.points.size();)
      if(line.compare(0, 2, "v ") == 0)
      {
        std::istringstream numbers(line.substr(2));
        Point p;
        numbers >> p[0] >> p[1] >> p[2];
        EXPECT_EQ(p, soup.points[v++]) << name;
      }
    EXPECT_EQ(v, soup.points.size()) << name;
  }
}

} // namespace
