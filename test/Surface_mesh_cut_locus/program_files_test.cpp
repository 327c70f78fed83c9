// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What the program writes for other programs is read back.

#include "octahedron_3mf.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using Arrays = std::map<std::string, std::vector<double>>;

std::vector<double> numbers(const std::string& text)
{
  std::istringstream is(text);
  return {std::istream_iterator<double>(is), std::istream_iterator<double>()};
}

// The arrays of a part of a VTP file.
Arrays vtp_arrays(const std::string& text, const std::string& part)
{
  Arrays result;
  std::size_t at = text.find("<" + part);
  const std::size_t end = text.find("</" + part, at);
  while((at = text.find(" Name=\"", at)) < end)
  {
    at += 7;
    const std::size_t begin = text.find('>', at) + 1;
    result[text.substr(at, text.find('"', at) - at)] = numbers(text.substr(begin, text.find('<', begin) - begin));
  }
  return result;
}

// The properties of the edges of a PLY file that has vertices and edges.
Arrays ply_edges(const std::string& text)
{
  Arrays result;
  std::vector<std::string> names;
  std::istringstream is(text);
  std::size_t number_of_vertices = 0, number_of_edges = 0;
  for(std::string word; is >> word && word != "end_header";)
    if(word == "vertex")
      is >> number_of_vertices;
    else if(word == "edge")
      is >> number_of_edges;
    else if(word == "property" && is >> word >> word && number_of_edges > 0)
      names.push_back(word);
  std::string line;
  for(std::size_t i = 0; i <= number_of_vertices; ++i)
    std::getline(is, line);
  for(std::size_t i = 0; i < number_of_edges; ++i)
    for(const std::string& name : names)
    {
      double x = -7.;
      is >> x;
      result[name].push_back(x);
    }
  return result;
}

using Files = Program;
using Place = std::array<double, 2>;

// The place of each vertex of a file with all vertices in faces.
std::vector<Place> log_map(const std::string& text)
{
  const std::vector<double> coordinates = vtp_arrays(text, "PointData")["log_map"];
  std::vector<Place> result;
  for(std::size_t i = 0; i + 1 < coordinates.size(); i += 2)
    result.push_back({{coordinates[i], coordinates[i + 1]}});
  return result;
}

// Seen from a point of the plane, with an x-axis from there to another.
Place seen_from(const Place& source, const Place& on_axis, const Place& p)
{
  const double x = on_axis[0] - source[0], y = on_axis[1] - source[1], length = std::hypot(x, y);
  const double dx = p[0] - source[0], dy = p[1] - source[1];
  return {{(x * dx + y * dy) / length, (x * dy - y * dx) / length}};
}

std::string off(const std::vector<std::array<double, 3>>& points, const std::vector<std::array<int, 3>>& faces)
{
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << points.size() << ' ' << faces.size() << " 0\n";
  for(const auto& p : points)
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const auto& f : faces)
    text << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  return text.str();
}

std::string base_64(const std::string& bytes)
{
  const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    unsigned three = 0;
    for(std::size_t k = 0; k < 3; ++k)
      three = 256 * three + (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for(std::size_t k = 0; k < 4; ++k)
      result += i + k <= bytes.size() ? digits[(three >> (18 - 6 * k)) % 64] : '=';
  }
  return result;
}

// The upper half of an octahedron, placed by nodes: as it is, and mirrored below, both twice as large.
Json octahedron_gltf()
{
  const float points[][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  const std::uint16_t corners[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4};
  const std::string bytes = std::string(reinterpret_cast<const char*>(points), sizeof(points)) +
                            std::string(reinterpret_cast<const char*>(corners), sizeof(corners));
  return {
    {"asset", {{"version", "2.0"}}},
    {"scene", 0},
    {"scenes", {{{"nodes", {0}}}}},
    {"nodes",
     {{{"children", {1, 2}}, {"scale", {2, 2, 2}}, {"translation", {5, 0, 3}}},
      {{"mesh", 0}},
      {{"mesh", 0}, {"scale", {1, 1, -1}}}}},
    {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
    {"accessors",
     {{{"bufferView", 0}, {"componentType", 5126}, {"count", 5}, {"type", "VEC3"}},
      {{"bufferView", 1}, {"componentType", 5123}, {"count", 12}, {"type", "SCALAR"}}}},
    {"bufferViews",
     {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", sizeof(points)}},
      {{"buffer", 0}, {"byteOffset", sizeof(points)}, {"byteLength", sizeof(corners)}}}},
    {"buffers", {{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base_64(bytes)}}}}};
}

} // namespace

TEST_F(Files, The_same_arrays_in_all_formats)
{
  for(const char* sources : {"--source 5", "--source 5 --source 150"})
  {
    std::string outputs;
    for(const char* name : {"a.vtp", "a.ply", "a.json"})
      outputs += " -o " + file(name);
    const Outcome outcome = run_on_torus(sources + std::string(" --quiet") + outputs);
    ASSERT_EQ(outcome.status, 0) << outcome.messages;
    const std::string vtp = read_file(path("a.vtp"));
    Arrays of_vtp = vtp_arrays(vtp, "CellData"), of_ply = ply_edges(read_file(path("a.ply")));
    const Json all = json("a.json");
    ASSERT_EQ(of_vtp.size(), 5u);
    const std::size_t number_of_edges = all.at("edges").at("vertices").size();
    for(const char* name : {"strength", "width", "enclosed", "source1", "source2"})
    {
      EXPECT_EQ(of_vtp[name].size(), number_of_edges) << name;
      EXPECT_EQ(of_vtp[name], of_ply[name]) << name;
      EXPECT_EQ(of_vtp[name], all.at("edges").at(name).get<std::vector<double>>()) << name;
    }
    EXPECT_EQ(of_ply["vertex1"].size(), number_of_edges);
    EXPECT_EQ(vtp_arrays(vtp, "PointData")["distance"], all.at("vertices").at("distance").get<std::vector<double>>());
    std::vector<double> points;
    for(const Json& p : all.at("vertices").at("point"))
      points.insert(points.end(), p.begin(), p.end());
    EXPECT_EQ(vtp_arrays(vtp, "Points")["Points"], points);
    const bool has_two = std::string(sources).size() > 12;
    ASSERT_EQ(all.at("sources").size(), has_two ? 2u : 1u);
    EXPECT_EQ(all.at("sources").at(0).at("vertex"), 5);
    const std::vector<double>& width = of_vtp["width"];
    EXPECT_GT(*std::min_element(width.begin(), width.end()), 0.);
    const std::vector<double>& enclosed = of_vtp["enclosed"];
    EXPECT_GT(*std::max_element(enclosed.begin(), enclosed.end()), 0.);
    EXPECT_EQ(of_vtp["source1"] != of_vtp["source2"], has_two);
  }
}

TEST_F(Files, A_surface_with_distances_and_sources)
{
  const Outcome outcome =
    run_on_torus("--quiet --source 5 --source 150 --surface " + file("s.vtp") + " -o " + file("a.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.messages;
  const std::string text = read_file(path("s.vtp"));
  Arrays of_vertices = vtp_arrays(text, "PointData");
  const std::size_t n = static_cast<std::size_t>(number_of_vertices_) - 1; // one is isolated
  ASSERT_EQ(of_vertices["distance"].size(), n);
  EXPECT_EQ(vtp_arrays(text, "Points")["Points"].size(), 3 * n);
  EXPECT_EQ(vtp_arrays(text, "Polys")["offsets"].size(), triangles_.size());
  EXPECT_EQ(std::set<double>(of_vertices["source"].begin(), of_vertices["source"].end()), (std::set<double>{0., 1.}));
  for(std::size_t v = 0; v < n; ++v)
  {
    const double number = of_vertices["vertex"][v];
    EXPECT_EQ(of_vertices["distance"][v] == 0., number == 5. || number == 150.) << number;
    if(number == 150.)
    {
      EXPECT_EQ(of_vertices["source"][v], 1.);
    }
  }
  // where no path leads
  write("two.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n");
  EXPECT_EQ(run(file("two.off") + " --quiet --source 0 --surface " + file("s.vtp")).status, 0);
  of_vertices = vtp_arrays(read_file(path("s.vtp")), "PointData");
  EXPECT_EQ(of_vertices["distance"], (std::vector<double>{0., 1., 1., -1., -1., -1.}));
  EXPECT_EQ(of_vertices["source"], (std::vector<double>{0., 0., 0., -1., -1., -1.}));
  expect_failure(run_on_torus("--surface " + file("a.ply")), "must be .vtp");
}

// On a plane the logarithmic map is what the plane looks like from the source, wherever that is.
TEST_F(Files, The_logarithmic_map_of_a_plane)
{
  const int n = 12;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<Place> at;
  std::vector<std::array<double, 3>> points;
  std::vector<Triangle> faces;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
    {
      const bool is_inside_x = i > 0 && i<n, is_inside_y = j> 0 && j < n;
      at.push_back({{i + (is_inside_x ? jitter(random) : 0.), j + (is_inside_y ? jitter(random) : 0.)}});
      points.push_back({{at.back()[0], at.back()[1], 0.}});
      const int v = i + (n + 1) * j;
      if(i < n && j < n)
      {
        faces.push_back({{v, v + 1, v + n + 2}});
        faces.push_back({{v, v + n + 2, v + n + 1}});
      }
    }
  std::shuffle(faces.begin(), faces.end(), random);
  write("plane.off", off(points, faces));
  const auto first_face_of = [&](int v)
  {
    return *std::find_if(faces.begin(), faces.end(),
                         [&](const Triangle& f) { return std::count(f.begin(), f.end(), v); });
  };
  const auto check = [&](const std::string& options, const std::vector<std::pair<Place, Place>>& axes)
  {
    const Outcome outcome = run(file("plane.off") + " " + options + " --surface " + file("s.vtp"));
    ASSERT_EQ(outcome.status, 0) << outcome.messages;
    EXPECT_EQ(outcome.messages.find("log_map"), std::string::npos);
    const std::string text = read_file(path("s.vtp"));
    const std::vector<Place> found = log_map(text);
    const std::vector<double> source = vtp_arrays(text, "PointData")["source"];
    ASSERT_EQ(found.size(), at.size());
    for(std::size_t v = 0; v < at.size(); ++v)
    {
      const auto& [from, to] = axes[static_cast<std::size_t>(source[v])];
      const Place expected = seen_from(from, to, at[v]);
      EXPECT_NEAR(found[v][0], expected[0], 1e-9) << options << " " << v;
      EXPECT_NEAR(found[v][1], expected[1], 1e-9) << options << " " << v;
    }
  };
  const auto axis_of = [&](int v)
  {
    const Triangle f = first_face_of(v);
    const auto i = std::find(f.begin(), f.end(), v) - f.begin();
    return std::make_pair(at[v], at[f[(i + 1) % 3]]);
  };
  for(int v : {30, 84, 100, 140})
    check("--source " + std::to_string(v), {axis_of(v)});
  // from the border, with that on the right of the axis: along the side, and at a corner
  check("--source 5", {{at[5], at[6]}});
  check("--source 0", {{at[0], at[1]}});
  check("--source 40 --source 121", {axis_of(40), axis_of(121)});
  // in a face, whose first edge is that in the file with the map, and on an edge of the border
  const std::vector<double> corners = vtp_arrays(read_file(path("s.vtp")), "Polys")["connectivity"];
  for(std::size_t i : {3, 50, 100})
  {
    const Triangle f = {{int(corners[3 * i]), int(corners[3 * i + 1]), int(corners[3 * i + 2])}};
    Place middle = {{0., 0.}};
    for(int v : f)
      for(int k = 0; k < 2; ++k)
        middle[k] += at[v][k] / 3.;
    std::ostringstream option;
    option.precision(17);
    option << "--source-point=" << middle[0] << ',' << middle[1] << ",0";
    const double x = at[f[1]][0] - at[f[0]][0], y = at[f[1]][1] - at[f[0]][1];
    check(option.str(), {{middle, {{middle[0] + x, middle[1] + y}}}});
  }
  check("--source-point=3.5,0,0", {{{{3.5, 0.}}, {{4., 0.}}}});
}

TEST_F(Files, The_logarithmic_map_is_as_long_as_the_distance)
{
  const std::string to_surface = " --surface " + file("s.vtp");
  for(const char* options :
      {"--source 5", "--source 5 --source 150 --source-point 1,0.9,0.2", "--method laplacian --source 9"})
  {
    ASSERT_EQ(run_on_torus(options + to_surface).status, 0) << options;
    const std::string text = read_file(path("s.vtp"));
    const std::vector<double> distance = vtp_arrays(text, "PointData")["distance"];
    const std::vector<Place> found = log_map(text);
    ASSERT_EQ(found.size(), distance.size()) << options;
    for(std::size_t v = 0; v < distance.size(); ++v)
      EXPECT_NEAR(std::hypot(found[v][0], found[v][1]), distance[v], 1e-12) << options << " " << v;
  }
  write("curve.txt", "5 6 7\n");
  const std::map<std::string, std::string> without = {
    {"--source-edges " + file("curve.txt"), "the paths from a curve start at no single point"},
    {"--solver heat", "it takes --solver exact"},
    {"--max-relative-error 1e-5", "it takes distances without --max-relative-error"}};
  for(const auto& [options, cause] : without)
  {
    const Outcome outcome = run_on_torus(options + to_surface);
    EXPECT_EQ(outcome.status, 0) << outcome.messages;
    expect_has(outcome.messages, "note: --surface has no log_map: " + cause);
    EXPECT_TRUE(log_map(read_file(path("s.vtp"))).empty());
  }
}

TEST_F(Files, Standard_output_has_nothing_but_the_result)
{
  const std::map<std::string, std::string> starts = {{"polylines.txt", ""}, {"obj", "v "}, {"vtp", "<?xml"},
                                                     {"ply", "ply\n"},      {"json", "{"}, {"png", "\x89PNG"},
                                                     {"svg", "<?xml"}};
  for(const auto& [format, start] : starts)
  {
    const std::string written = file("a." + format), redirected = " > " + file("out");
    const Outcome outcome = run_on_torus("--source 5 -o - --output-format " + format + " -o " + written + redirected);
    ASSERT_EQ(outcome.status, 0) << outcome.messages;
    EXPECT_NE(outcome.messages.find("genus 1"), std::string::npos) << format; // on stderr
    EXPECT_EQ(read_file(path("out")), read_file(path("a." + format))) << format;
    EXPECT_EQ(read_file(path("out")).compare(0, start.size(), start), 0) << format;
  }
  ASSERT_EQ(run_on_torus("--source 5 -o - > " + file("out")).status, 0);
  EXPECT_EQ(read_file(path("out")), read_file(path("a.polylines.txt")));
  for(const char* option : {"--edges", "--report", "--surface"})
  {
    ASSERT_EQ(run_on_torus(option + std::string(" - > ") + file("out")).status, 0) << option;
    EXPECT_FALSE(read_file(path("out")).empty()) << option;
  }
  EXPECT_EQ(Json::parse(run_on_torus("--quiet --report -").messages).at("genus"), 1);
  EXPECT_FALSE(fs::exists("-")) << "a file of that name";
  if(fs::exists("/dev/full"))
    expect_failure(run_on_torus("--quiet -o - > /dev/full"), "cannot write to 'standard output'");
}

TEST_F(Files, Standard_input_in_all_formats)
{
  const std::string points[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  const int faces[][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  std::string off = "# a comment\nOFF\n4 4 0\n", obj = "# a comment\nmtllib a.mtl\n", stl = "solid a\n", corners, lines,
              ts = "GOCAD TSurf 1\nHEADER {\nname:a\n}\nTFACE\n",
              ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  std::string binary_stl(80, ' ');
  binary_stl += std::string("\4\0\0\0", 4);
  for(int i = 0; i < 4; ++i)
  {
    lines += points[i] + "\n";
    obj += "v " + points[i] + "\n";
    ts += "VRTX " + std::to_string(i + 1) + " " + points[i] + "\n";
  }
  for(const auto& f : faces)
  {
    stl += "facet normal 0 0 0\nouter loop\n";
    binary_stl += std::string(12, '\0');
    for(int corner : f)
    {
      stl += "vertex " + points[corner] + "\n";
      for(double x : numbers(points[corner]))
        binary_stl += x == 0. ? std::string(4, '\0') : std::string("\0\0\x80\x3f", 4);
    }
    binary_stl += std::string(2, '\0');
    stl += "endloop\nendfacet\n";
    corners += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
    const std::string from_1 =
      std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " " + std::to_string(f[2] + 1);
    obj += "f " + from_1 + "\n";
    ts += "TRGL " + from_1 + "\n";
  }
  const std::map<std::string, std::string> meshes = {{"off", off + lines + corners}, {"obj", obj},
                                                     {"ply", ply + lines + corners}, {"stl", stl + "endsolid a\n"},
                                                     {"ts", ts + "END\n"},           {"", binary_stl}};
  for(const auto& [format, text] : meshes)
    for(const std::string& option : {std::string(), " --input-format " + (format.empty() ? "stl" : format)})
    {
      write("mesh", text);
      const Outcome outcome = run("- --quiet --report -" + option + " < " + file("mesh"));
      ASSERT_EQ(outcome.status, 0) << format << outcome.messages;
      EXPECT_EQ(Json::parse(outcome.messages).at("faces"), 4) << format;
      const Outcome named = run(file("mesh") + " --quiet --report -" + option);
      if(option.empty())
        expect_failure(named, "unless there is an --input-format");
      else
        EXPECT_EQ(named.status, 0) << named.messages;
    }
  // other beginnings of the same, and other ends of lines
  std::string with_returns;
  for(char c : meshes.at("stl"))
    with_returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for(const std::string& text : {"solid\ta" + stl.substr(7) + "endsolid\n", "solid" + stl.substr(7) + "endsolid\n",
                                 " \n\tsolid\ta" + stl.substr(7) + "endsolid a\n", with_returns})
  {
    write("mesh.stl", text);
    const Outcome outcome = run(file("mesh.stl") + " --quiet --report -");
    ASSERT_EQ(outcome.status, 0) << text << outcome.messages;
    EXPECT_EQ(Json::parse(outcome.messages).at("faces"), 4) << text;
  }
  for(const std::string& format : {std::string("ascii"), std::string("binary_little_endian")})
  {
    write("points.ply", "ply\nformat " + format +
                          " 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n" +
                          "property float psz\nend_header\n" + (format == "ascii" ? "0 0 0 0" : std::string(16, '\1')));
    expect_failure(run(file("points.ply") + " --quiet"), "there are no faces in it");
  }
  expect_failure(run("- --quiet"), "cannot read 'standard input': it is empty");
  write("text", "1 2 3\n");
  expect_failure(run("- --quiet < " + file("text")), "say --input-format");
  expect_failure(run("- --quiet --input-format ply < " + file("text")), "does not start with 'ply'");
  expect_failure(run("- --quiet --input-format obj < " + file("text")), "standard input");
  expect_failure(run_on_torus("--input-format xyz"),
                 "--input-format takes off, obj, stl, ply, ts, vtp, gltf, glb, fbx, dae, 3ds or 3mf, not 'xyz'");
}

TEST_F(Files, Parts_that_are_printed_are_read_where_they_stand)
{
  write("a.3mf", octahedron_3mf());
  for(const std::string& mesh : {file("a.3mf"), "- < " + file("a.3mf")})
  {
    const Outcome outcome = run(mesh + " --quiet --report -");
    if(outcome.messages.find("built without libassimp") != std::string::npos)
      GTEST_SKIP() << "without libassimp";
    ASSERT_EQ(outcome.status, 0) << outcome.messages;
    const Json found = Json::parse(outcome.messages);
    EXPECT_EQ(found.at("faces"), 8);
    EXPECT_EQ(found.at("source_point"), Json::parse("[12.0, 0.0, 5.0]"));
    EXPECT_NEAR(found.at("mean_edge_length").get<double>(), std::sqrt(8.), 1e-6);
  }
  write("a.3mf", "PK\3\4");
  expect_failure(run(file("a.3mf") + " --quiet"), "it is damaged, not of the format 3mf");
}

TEST_F(Files, Scenes_are_read_with_their_nodes)
{
  const std::string mesh = file("a.gltf");
  const Json scene = octahedron_gltf();
  write("a.gltf", scene.dump());
  const Outcome outcome = run(mesh + " --quiet --report -");
  if(outcome.messages.find("built without libassimp") != std::string::npos)
  {
    expect_failure(outcome, "install it (Debian: libassimp-dev)");
    GTEST_SKIP() << "without libassimp";
  }
  ASSERT_EQ(outcome.status, 0) << outcome.messages;
  const Json found = Json::parse(outcome.messages);
  EXPECT_EQ(found.at("faces"), 8);
  EXPECT_EQ(found.at("genus"), 0);
  EXPECT_NEAR(found.at("farthest_distance").get<double>(), 2. * std::sqrt(6.),
              1e-5); // of a vertex from the opposite one
  write("A.GLTF", scene.dump());
  for(const std::string& other : {file("A.GLTF"), "- --input-format gltf < " + mesh})
    EXPECT_EQ(Json::parse(run(other + " --quiet --report -").messages).at("faces"), 8) << other;

  const auto fail = [&](const std::string& text, const std::string& message)
  {
    write("a.gltf", text);
    expect_failure(run(mesh + " --quiet"), message);
  };
  const std::string damaged = "it is damaged, not of the format gltf, or has parts in other files that are not there";
  Json changed = scene;
  changed["buffers"][0]["uri"] = "missing.bin";
  fail(changed.dump(), damaged);
  changed = scene;
  changed["meshes"][0]["primitives"][0]["mode"] = 1; // lines
  fail(changed.dump(), "there is no mesh in the scene");
  changed = scene;
  changed["nodes"][1]["children"] = Json::array({0});
  fail(changed.dump(), damaged);
  fail(std::string(1000000, '['), damaged); // what crashes the library
  fail("text\n", damaged);
  std::mt19937 random(3);
  const std::string text = scene.dump();
  const std::string pieces[] = {"", "9", "99999999", "-1", "{", "}", "[", "\"", ",", "1e300"};
  for(int i = 0; i < 100; ++i)
  {
    std::string other = text;
    const std::size_t at = random() % other.size();
    if(i % 4 == 0)
      other.resize(at);
    else
      other.replace(at, 1, pieces[random() % std::size(pieces)]);
    write("a.gltf", other);
    const Outcome result = run(mesh + " --quiet --repair weld -o " + file("a.vtp"));
    if(result.status != 0)
      expect_failure(result, "cut_locus: ");
  }
}

TEST_F(Files, A_surface_that_was_written_is_read)
{
  const auto report = [&](const std::string& mesh)
  {
    const Outcome outcome = run(mesh + " --quiet --source 4 --report -");
    EXPECT_EQ(outcome.status, 0) << outcome.messages;
    return Json::parse(outcome.messages);
  };
  ASSERT_EQ(run_on_torus("--quiet --cells " + file("cells.vtp") + " --surface " + file("s.vtp")).status, 0);
  const Json expected = Json::parse(run_on_torus("--quiet --source 5 --report -").messages); // vertex 0 is isolated
  for(const std::string& mesh : {file("s.vtp"), "- < " + file("s.vtp")})
  {
    const Json found = report(mesh);
    for(const char* figure : {"faces", "genus", "length", "farthest_distance", "injectivity_radius"})
      EXPECT_NEAR(found.at(figure).get<double>(), expected.at(figure).get<double>(), 1e-12) << figure;
  }
  EXPECT_GE(report(file("cells.vtp")).at("faces"), expected.at("faces"));

  const std::string text = read_file(path("s.vtp"));
  const auto fail = [&](const std::string& what, const std::string& other, const std::string& message)
  {
    std::string changed = text;
    changed.replace(changed.find(what, changed.find("<Points>")), what.size(), other);
    write("changed.vtp", changed);
    expect_failure(run(file("changed.vtp") + " --quiet"), message);
  };
  fail("format=\"ascii\"", "format=\"appended\"", "its arrays are not of the format 'ascii': write it as text");
  fail("\n3\n6\n", "\n3\n999999\n", "its offsets do not fit");
  fail("</Polys>", "", "it is damaged: ");
  fail("\n0 ", "\n288 ", "a polygon has a vertex that does not exist");
  fail("Name=\"connectivity\" format=\"ascii\">", "Name=\"connectivity\" format=\"ascii\">x",
       "something else than numbers");
  write("grid.vtp", "<VTKFile type=\"ImageData\"/>");
  expect_failure(run(file("grid.vtp") + " --quiet"), "no data of the type PolyData");
  std::string deep;
  for(int i = 0; i < 100000; ++i)
    deep += "<a>";
  write("deep.vtp", deep);
  expect_failure(run(file("deep.vtp") + " --quiet"), "too many elements");
  ASSERT_EQ(run_on_torus("--quiet -o " + file("curve.vtp")).status, 0);
  expect_failure(run(file("curve.vtp") + " --quiet"), "there are no faces in it");
}
