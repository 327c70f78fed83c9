// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What the program makes of files: of those that are no triangle meshes, and of those that are broken.

#include "program_fixture.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

class Input : public Program
{
protected:
  struct Edge_lines
  {
    std::set<std::pair<int, int>> all, marked;
  };

  Outcome run_on(const std::string& name, const std::string& arguments = "--quiet") const
  {
    return run(file(name) + " " + arguments);
  }

  Outcome run_on_text(const std::string& text, const std::string& arguments = "--quiet") const
  {
    write("a.off", text);
    return run_on("a.off", arguments);
  }

  Json report_on_text(const std::string& text, const std::string& arguments = "") const
  {
    write("a.off", text);
    return report_on("a.off", arguments);
  }

  Edge_lines edge_lines(const std::string& name) const
  {
    Edge_lines edges;
    std::istringstream lines(read_file(path(name)));
    for(std::string line; std::getline(lines, line);)
    {
      std::istringstream words(line);
      int a = -1, b = -1;
      std::string mark;
      words >> a >> b >> mark;
      EXPECT_TRUE(mark.empty() || mark == "marked") << line;
      edges.all.insert(std::minmax(a, b));
      if(!mark.empty())
        edges.marked.insert(std::minmax(a, b));
    }
    return edges;
  }

  // The torus of the fixture, of quads; its first vertex is unused.
  std::string quad_torus() const
  {
    std::istringstream torus(read_file(path("torus.off")));
    std::ostringstream text;
    std::string line;
    for(int i = 0; i < 2 + number_of_vertices_ && std::getline(torus, line); ++i)
      if(i == 1)
        text << number_of_vertices_ << ' ' << triangles_.size() / 2 << " 0\n";
      else
        text << line << '\n';
    for(std::size_t f = 0; f < triangles_.size(); f += 2)
      text << "4 " << triangles_[f][0] << ' ' << triangles_[f][1] << ' ' << triangles_[f][2] << ' '
           << triangles_[f + 1][2] << '\n';
    return text.str();
  }
};

// an octahedron, the corners of its faces in any order
const char* const octahedron = "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                               "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";

} // namespace

TEST_F(Input, Polygons_are_triangulated_and_their_diagonals_marked)
{
  write("quads.off", quad_torus());
  const Json report = report_on("quads.off", "--source 5 --curve edges --check --edges " + file("e.txt") + " -o " +
                                               file("e.ply") + " -o " + file("e.vtp") + " -o " + file("e.obj"));
  EXPECT_EQ(report.at("source"), 5);
  EXPECT_EQ(report.at("faces"), triangles_.size());
  EXPECT_EQ(report.at("cycles"), 2);
  EXPECT_EQ(report.at("topology"), "right");
  EXPECT_EQ(report.at("repair").at("triangulated_polygons"), triangles_.size() / 2);
  EXPECT_EQ(report.at("repair").at("unused_vertices"), 1);

  std::set<std::pair<int, int>> sides;
  for(std::size_t f = 0; f < triangles_.size(); f += 2)
  {
    const int corners[] = {triangles_[f][0], triangles_[f][1], triangles_[f][2], triangles_[f + 1][2]};
    for(int i = 0; i < 4; ++i)
      sides.insert(std::minmax(corners[i], corners[(i + 1) % 4]));
  }
  const Edge_lines edges = edge_lines("e.txt");
  EXPECT_EQ(edges.all.size(), report.at("edges"));
  EXPECT_EQ(edges.marked.size(), report.at("edges_not_in_file"));
  EXPECT_GT(edges.marked.size(), 0u);
  for(const auto& e : edges.all)
    EXPECT_NE(sides.count(e), edges.marked.count(e)) << e.first << ' ' << e.second;

  expect_has(read_file(path("e.ply")), "property uchar marked\n");
  expect_has(read_file(path("e.vtp")), "Name=\"marked\"");
  EXPECT_EQ(number_of("# marked ", read_file(path("e.obj"))), edges.marked.size());

  const Outcome outcome = run_on("quads.off", "");
  expect_has(outcome.messages, "repaired: 288 polygons triangulated, 1 unused vertex dropped\n");
  expect_failure(run_on("quads.off", "--quiet --repair none"), "face #0 has 4 sides; all must be triangles (--repair");
}

TEST_F(Input, A_triangle_mesh_is_left_as_it_is)
{
  const Json all = report_on("torus.off", "--edges " + file("auto.txt"));
  report_on("torus.off", "--repair none --edges " + file("none.txt"));
  EXPECT_EQ(all.at("repair").at("done"), "");
  EXPECT_EQ(all.at("vertices"), number_of_vertices_);
  EXPECT_EQ(read_file(path("auto.txt")), read_file(path("none.txt")));
  EXPECT_TRUE(edge_lines("auto.txt").marked.empty());
}

TEST_F(Input, Soups_are_oriented)
{
  std::string soup = octahedron;
  soup.replace(soup.find("3 2 1 4"), 7, "3 1 2 4");
  const Json report = report_on_text(soup);
  EXPECT_EQ(report.at("repair").at("reversed_faces"), 1);
  EXPECT_EQ(report.at("border_loops"), 0);
  expect_failure(run_on_text(soup, "--quiet --repair none"), "opposite orientation");
}

TEST_F(Input, Vertices_repeated_for_each_face_are_merged)
{
  std::istringstream lines(octahedron);
  std::string line;
  std::vector<std::string> points, faces;
  for(int i = 0; std::getline(lines, line); ++i)
    (i < 2 ? faces : i < 8 ? points : faces).push_back(line);
  std::ostringstream soup;
  soup << "OFF\n24 8 0\n";
  for(std::size_t f = 2; f < faces.size(); ++f)
    for(std::size_t i : {2, 4, 6})
      soup << points[std::size_t(faces[f][i] - '0')] << '\n';
  for(int f = 0; f < 8; ++f)
    soup << "3 " << 3 * f << ' ' << 3 * f + 1 << ' ' << 3 * f + 2 << '\n';
  const Json report = report_on_text(soup.str(), "--source 23");
  EXPECT_EQ(report.at("repair").at("merged_vertices"), 18);
  EXPECT_EQ(report.at("border_loops"), 0);
  EXPECT_EQ(report.at("components_of_mesh"), 1);
}

TEST_F(Input, Repairs_keep_the_coordinates_and_the_order_of_the_file)
{
  const std::string points = "OFF\n4 4 0\n0 0 0\n0 3 0\n3 3 0\n0 0 3\n";
  const Json oriented = report_on_text(points + "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n");
  const Json repaired = report_on_text(points + "3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
  EXPECT_EQ(oriented.at("repair").at("reversed_faces"), 0);
  EXPECT_GT(repaired.at("repair").at("reversed_faces"), 0);
  EXPECT_EQ(oriented.at("source"), 0);
  EXPECT_NEAR(oriented.at("farthest_distance").get<double>(), 3. * std::sqrt(2.), 1e-12);
  for(const char* what : {"source", "source_point", "farthest", "farthest_distance"})
    EXPECT_EQ(repaired.at(what), oriented.at(what)) << what;
}

TEST_F(Input, What_is_not_manifold_is_separated)
{
  const Json book = report_on_text("OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
  EXPECT_EQ(book.at("components_of_mesh"), 3);
  EXPECT_EQ(book.at("faces_of_component"), 1);
  EXPECT_EQ(book.at("repair").at("added_vertices"), 4);

  const Json hourglass = report_on_text("OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
  EXPECT_EQ(hourglass.at("components_of_mesh"), 2);
  EXPECT_EQ(hourglass.at("repair").at("added_vertices"), 1);
}

TEST_F(Input, Double_faces_are_removed_and_flat_ones_are_not)
{
  // vertex 2 lies on the edge of the others
  const Json cap =
    report_on_text("OFF\n5 4 0\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n1 -1 0\n3 0 2 3\n3 2 1 3\n3 0 1 2\n3 1 0 4\n");
  EXPECT_EQ(cap.at("repair").at("done"), "");
  EXPECT_EQ(cap.at("faces"), 4);

  const Json twice = report_on_text("OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n3 2 1 0\n3 1 2 0\n");
  EXPECT_EQ(twice.at("repair").at("removed_faces"), 2);
  EXPECT_EQ(twice.at("faces"), 1);

  expect_failure(run_on_text("OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"), "no face of it has an area");
}

TEST_F(Input, A_polygon_with_two_sides_stays_closed)
{
  const Json report = report_on_text("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n4 3 2 1 0\n",
                                     "--check --source-point 0.3,0.4,0");
  EXPECT_EQ(report.at("border_loops"), 0);
  EXPECT_EQ(report.at("faces"), 4);
}

TEST_F(Input, A_source_that_has_vanished_is_an_error)
{
  const std::string quad = "OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 2\n4 0 1 2 3\n";
  expect_failure(run_on_text(quad, "--quiet --source 4"), "is not in the repaired mesh");
  expect_failure(run_on_text(quad, "--quiet --source 5"), "out of range");
  EXPECT_EQ(run_on_text(quad, "--quiet --source 3").status, 0);
  expect_failure(run("--quiet --source 0 " + file("torus.off")), "isolated");
}

TEST_F(Input, Several_components)
{
  write("two.off", "OFF\n7 5 0\n9 0 0\n9 1 0\n9 0 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n"
                   "3 3 5 4\n3 3 4 6\n3 4 5 6\n3 3 6 5\n");
  EXPECT_EQ(report_on("two.off").at("source"), 3);
  EXPECT_EQ(report_on("two.off").at("faces_of_component"), 4);
  EXPECT_EQ(report_on("two.off", "--source 0").at("faces_of_component"), 1);
  expect_has(run_on("two.off", "").messages, "2 components; this is about the one with the largest area, 4 of 5");
  expect_has(run_on("two.off", "--source 0").messages, "this is about the one of the source, 1 of 5");
  // a component is large by its area, whatever the number of its faces
  write("large.off", "OFF\n7 5 0\n90 0 0\n90 10 0\n90 0 10\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n"
                     "3 3 5 4\n3 3 4 6\n3 4 5 6\n3 3 6 5\n");
  EXPECT_EQ(report_on("large.off").at("faces_of_component"), 1);
}

TEST_F(Input, How_far_a_source_point_is_moved)
{
  const std::string corners = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  expect_has(run_on_text(corners, "--source-point .25,.5,.9 --source-point .5,.25,8").messages,
             "note: --source-point 0.5,0.25,8 is not on the surface: the source is 8 away, at 0.5,0.25,0;");
  EXPECT_EQ(run_on_text(corners, "--source-point .25,.5,.9").messages.find("not on the surface"), std::string::npos);
}

TEST_F(Input, Binary_OFF_in_both_byte_orders)
{
  const auto binary = [](bool is_little, int colors)
  {
    std::string text = "OFF BINARY\n";
    const auto word = [&](std::uint32_t w)
    {
      for(int i = 0; i < 4; ++i)
        text += static_cast<char>(w >> 8 * (is_little ? i : 3 - i) & 255u);
    };
    const auto number = [&](float x)
    {
      std::uint32_t w = 0;
      std::memcpy(&w, &x, sizeof(w));
      word(w);
    };
    for(std::uint32_t count : {4u, 4u, 0u})
      word(count);
    for(float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f})
      number(x);
    for(const std::array<std::uint32_t, 3>& t :
        {std::array<std::uint32_t, 3>{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}})
    {
      word(3);
      for(std::uint32_t v : t)
        word(v);
      if(colors >= 0)
        word(static_cast<std::uint32_t>(colors));
      for(int i = 0; i < colors; ++i)
        number(0.5f);
    }
    return text;
  };
  for(bool is_little : {false, true})
    for(int colors : {0, 3, -1}) // OpenMesh and PMP leave their number away
    {
      const Json report = report_on_text(binary(is_little, colors));
      EXPECT_EQ(report.at("faces"), 4);
      EXPECT_EQ(report.at("border_loops"), 0);
      EXPECT_NEAR(report.at("mean_edge_length").get<double>(), (3. + 3. * std::sqrt(2.)) / 6., 1e-6);
      expect_failure(run_on_text(binary(is_little, colors).substr(0, 90)), "damaged");
    }
}

TEST_F(Input, OBJ_with_lines_tabs_and_continued_lines)
{
  write("a.obj", "o name\nv\t0 0 0\nv 1 0 0 .5 .5 .5\n v 0 1 0\nvt 0 0\nl 1 2\nunknown\nf 1/1 \\\n2//1 3/1/1");
  EXPECT_EQ(report_on("a.obj").at("faces"), 1);
}

// The first of each kind is read without streams, the others by CGAL, which has to find the same numbers.
TEST_F(Input, A_mesh_is_read_to_the_same_bits_however_its_file_is_written)
{
  const std::vector<std::string> points = {"0.1 1e-3 -.30000000000000004 ",
                                           "1.7976931348623157 2.2250738585072014e-8 7",
                                           "0.3333333333333333 100000000000000008e-17 5", "3 -4.35 0.1e1"};
  std::string lines, obj, obj_faces = "f 1 2 3\nf 1//1 4/2 2/3/4\nf -3 -1 3\nf 1 3 4\n";
  for(const std::string& p : points)
  {
    lines += p + "\n";
    obj += "v " + p + "\n";
  }
  const std::string faces = "3 0 1 2\n3 0 3 1\n3 1 3 2 255 0 0\n3 0 2 3\n";
  write("plain.off", "OFF\n4 4 6\n" + lines + faces);
  write("windows.off", "# text\nOFF\r\n\r\n4 4 0\r\n" + lines + "# text\n" + faces);
  write("one_line.off", "OFF 4 4 0\n" + lines + faces);
  write("with_comments.off", "OFF\n4 4 0 # counts\n" + lines + faces);
  write("plain.obj", obj + obj_faces);
  write("continued.obj", obj + "vn 0 0 \\\n1\n" + obj_faces);
  const auto lengths = [&](const std::string& name)
  {
    const Json report = report_on(name);
    return std::vector<double>{report.at("mean_edge_length").get<double>(), report.at("length").get<double>(),
                               report.at("farthest_distance").get<double>()};
  };
  const std::vector<double> expected = lengths("plain.off");
  for(const char* name : {"windows.off", "one_line.off", "with_comments.off", "plain.obj", "continued.obj"})
    EXPECT_EQ(lengths(name), expected) << name;
}

TEST_F(Input, Broken_files)
{
  const auto run_on_ply = [&](const std::string& text)
  {
    write("a.ply", "ply\nformat ascii 1.0\n" + text);
    return run_on("a.ply");
  };
  expect_failure(run_on("missing.off"), "cannot read");
  expect_failure(run_on("."), "directory");
  write("a.xyz", "1 2 3\n");
  expect_failure(run_on("a.xyz"), "extension");
  expect_failure(run_on_text(""), "empty");
  // a face over several lines, and one that lacks a corner
  const std::string corners = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  EXPECT_EQ(run_on_text(corners + "3 0\n2\n1\n\n3 0 1 3\n3 1\n2 3\n3 2 0 3\n").status, 0);
  expect_failure(run_on_text(corners + "3 0 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"), "cannot read");
  expect_failure(run_on_text("OFF\n3 1 0\n0 0 0\n1 0"), "cannot read");
  expect_failure(run_on_text("OFF\n0 0 0\n"), "no vertices");
  expect_failure(run_on_text("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "no faces");
  write("points.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  expect_failure(run_on("points.obj"), "no faces");
  expect_failure(run_on_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"), "cannot read");
  expect_failure(run_on_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"), "damaged");
  expect_failure(run_on_text("OFF\n2000000000 1 0\n0 0 0\n"), "2000000000 vertices, more than its");
  expect_failure(run_on_text("nOFF\n3\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "nOFF");
  // fewer numbers than the header has letters for
  expect_failure(run_on_text("COFF\n3 1"), "damaged");
  EXPECT_EQ(run_on_text("STCNOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").status, 0);

  const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n",
                    points = "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(
    run_on_ply(vertices + "element face 1\nproperty list int int vertex_indices\n" + points + "3 0 1 2\n").status, 0);
  expect_failure(run_on_ply("property float x\n" + vertices), "property before the first element");
  expect_failure(run_on_ply(vertices), "does not end");
  expect_failure(
    run_on_ply("element vertex 99999999999\nproperty float x\nproperty float y\nproperty float z\n" + points),
    "99999999999 items of 'vertex'");
  expect_failure(
    run_on_ply(vertices + "element face 1\nproperty list uint int vertex_indices\n" + points + "4000000000 0 1 2\n"),
    "a list that is longer than the file");
  expect_failure(
    run_on_ply(vertices + "element tristrips 1\nproperty list int int vertex_indices\n" + points + "3 0 1 2\n"),
    "triangle strips");
}

// Coordinates and corners may be numbers of any type of PLY, and lines may end as on the Mac of old.
TEST_F(Input, PLY_files_with_numbers_of_any_type)
{
  const auto header = [](const std::string& format, const std::string& coordinate, const std::string& corner)
  {
    const std::string property = "property " + coordinate + " ";
    return "ply\nformat " + format + " 1.0\nelement vertex 4\nproperty list uchar uchar weights\n" + property + "x\n" +
           property + "y\nproperty uchar red\n" + property + "z\nelement face 4\nproperty list uchar " + corner +
           " vertex_indices\nend_header\n";
  };
  const auto text = [&](const std::string& coordinate, const std::string& corner)
  {
    return header("ascii", coordinate, corner) + "1 7 0 0 9 0\n0 3 0 9 0\n2 1 1 0 3 9 0\n0 0 0 9 3\n"
                                                 "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  };
  // each number of two bytes, given the place of the one of higher value
  const auto binary = [&](const std::string& format, int high)
  {
    std::string result = header(format, "short", "ushort");
    const auto put = [&](int number)
    {
      for(int place : {0, 1})
        result += static_cast<char>(number >> (place == high ? 8 : 0) & 255);
    };
    for(const auto& [x, y, z] : std::vector<std::array<int, 3>>{{-2, 300, 0}, {1, 300, 0}, {-2, 303, 0}, {-2, 300, 3}})
    {
      result += std::string("\2\7\7", 3);
      put(x);
      put(y);
      result += '\11';
      put(z);
    }
    for(const auto& [i, j, k] : std::vector<std::array<int, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    {
      result += '\3';
      put(i);
      put(j);
      put(k);
    }
    return result;
  };
  const auto expect_tetrahedron = [&](const std::string& file)
  {
    write("a.ply", file);
    const Json report = report_on("a.ply");
    EXPECT_EQ(report.at("faces").get<int>(), 4);
    EXPECT_NEAR(report.at("mean_edge_length").get<double>(), 1.5 + 1.5 * std::sqrt(2.), 1e-12) << file.substr(0, 200);
  };
  for(const char* coordinate : {"char", "uint8", "short", "ushort", "int", "uint32", "float", "double"})
    for(const char* corner : {"char", "uchar", "int16", "uint16", "int", "uint"})
      expect_tetrahedron(text(coordinate, corner));
  expect_tetrahedron(binary("binary_little_endian", 1));
  expect_tetrahedron(binary("binary_big_endian", 0));
  std::string with_returns = text("float", "int");
  std::replace(with_returns.begin(), with_returns.end(), '\n', '\r');
  expect_tetrahedron(with_returns);

  // of an early end, and numbers that are none, the program tells
  for(const char* end : {"", "1 7 0 0 9", "1 7 0 0 9 zero\n"})
  {
    write("a.ply", header("ascii", "int", "int") + end);
    expect_failure(run_on("a.ply"), "damaged");
  }
}

// Nothing may be waited for, even if somebody writes.
TEST_F(Input, Pipes_and_devices_are_refused_at_once)
{
  ASSERT_EQ(mkfifo(path("pipe.off").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", path("zero.off"));
  const auto start = std::chrono::steady_clock::now();
  expect_failure(run_on("pipe.off"), "pipe");
  expect_failure(run_on("zero.off"), "device");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}
