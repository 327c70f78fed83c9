// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What the program makes of a model of quads in several parts: texture coordinates for all of it, and seams on its edges.

#include "Union_find.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Edge = std::pair<std::size_t, std::size_t>;
using UV = std::array<double, 2>;

struct Obj
{
  std::string other; // all lines but those of texture coordinates and faces
  std::vector<UV> uv;
  std::vector<std::vector<std::array<std::string, 3>>> faces; // v, vt, vn as written
  std::size_t vertices = 0;

  std::size_t vertex(std::size_t f, std::size_t i) const
  {
    const int v = std::stoi(faces[f][i][0]);
    return std::size_t(v > 0 ? v - 1 : int(vertices) + v); // what is negative comes last here
  }
  std::size_t texture(std::size_t f, std::size_t i) const { return std::stoul(faces[f][i][1]) - 1; }
};

Obj parse(const std::string& text)
{
  Obj obj;
  std::istringstream lines(text);
  for(std::string line, word; std::getline(lines, line);)
  {
    std::istringstream words(line);
    words >> word;
    if(word == "vt")
    {
      obj.uv.emplace_back();
      words >> obj.uv.back()[0] >> obj.uv.back()[1];
    }
    else if(word == "f")
    {
      obj.faces.emplace_back();
      while(words >> word)
      {
        obj.faces.back().emplace_back();
        std::istringstream parts(word);
        for(std::string& part : obj.faces.back().back())
          std::getline(parts, part, '/');
      }
    }
    else
      obj.other += line + "\n";
    obj.vertices += word == "v" || line.compare(0, 2, "v ") == 0;
  }
  return obj;
}

double distance_to_segment(const UV& p, const UV& a, const UV& b)
{
  const double x = b[0] - a[0], y = b[1] - a[1], l = x * x + y * y;
  const double t = l > 0. ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / l, 0., 1.) : 0.;
  return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

class Model : public Program
{
protected:
  // Two rounded boxes of quads, apart from each other; the second one has negative numbers and no texture coordinates.
  void SetUp() override
  {
    Program::SetUp();
    std::ostringstream os;
    os.precision(17);
    os << "# a model\nmtllib model.mtl\nvt 0 0\nvt 1 0\nvn 0 0 1\nvn 2 0 0\no first\n";
    const std::size_t first =
      add_box(os, 6, 0., [](std::size_t v, std::size_t) { return std::to_string(v + 1) + "/2/1"; });
    os << "o second\r\n";
    add_box(os, 4, 5., [](std::size_t v, std::size_t n) { return std::to_string(int(v) - int(n)) + "//2"; });
    os << "# the end";
    first_vertices_ = first;
    write("model.obj", os.str());
  }

  template <typename Corner>
  std::size_t add_box(std::ostream& os, int n, double x, const Corner& corner) const
  {
    std::map<std::array<int, 3>, std::size_t> number;
    std::ostringstream faces;
    std::vector<std::vector<std::size_t>> quads;
    for(int axis = 0; axis < 3; ++axis)
      for(int side : {0, n})
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j)
          {
            std::vector<std::size_t> quad;
            for(const auto& [a, b] : {Edge(0, 0), Edge(1, 0), Edge(1, 1), Edge(0, 1)})
            {
              std::array<int, 3> p;
              p[axis] = side;
              p[(axis + 1) % 3] = i + int(a);
              p[(axis + 2) % 3] = j + int(b);
              const auto inserted = number.insert({p, number.size()});
              if(inserted.second)
              {
                std::array<double, 3> q;
                for(int k = 0; k < 3; ++k)
                  q[k] = 2. * p[k] / n - 1.;
                const double r = std::hypot(q[0], q[1], q[2]);
                os << "v " << 2. * q[0] / std::sqrt(r) + x << ' ' << q[1] / std::sqrt(r) << ' ' << q[2] / std::sqrt(r)
                   << '\n';
              }
              quad.push_back(inserted.first->second);
            }
            if(side == 0)
              std::reverse(quad.begin(), quad.end());
            quads.push_back(quad);
          }
    for(std::size_t f = 0; f < quads.size(); ++f)
    {
      if(f % 20 == 7)
        os << "g part" << f << "\nusemtl red\ns " << f << '\n';
      os << 'f';
      for(const std::size_t v : quads[f])
        os << ' ' << corner(v, number.size());
      os << '\n';
    }
    return number.size();
  }

  Json run_model(const std::string& arguments) const { return report_on("model.obj", arguments); }

  std::size_t first_vertices_ = 0;
};

// pairs of vertices whose faces have different texture corners there
std::set<Edge> seams_of(const Obj& obj)
{
  std::map<Edge, std::set<Edge>> corners;
  for(std::size_t f = 0; f < obj.faces.size(); ++f)
    for(std::size_t i = 0; i < obj.faces[f].size(); ++i)
    {
      const std::size_t j = (i + 1) % obj.faces[f].size();
      corners[std::minmax(obj.vertex(f, i), obj.vertex(f, j))].insert(
        std::minmax(obj.texture(f, i), obj.texture(f, j)));
    }
  std::set<Edge> result;
  for(const auto& edge : corners)
    if(edge.second.size() > 1)
      result.insert(edge.first);
  return result;
}

} // namespace

TEST_F(Model, is_kept_but_for_its_texture_coordinates)
{
  const Json report = run_model("--uv " + file("uv.obj") + " --seams " + file("seams.json"));
  const Obj given = parse(read_file(path("model.obj"))), obj = parse(read_file(path("uv.obj")));
  EXPECT_EQ(given.other, obj.other);
  EXPECT_FALSE(fs::exists(path("uv.png")) || fs::exists(path("uv.mtl")));
  ASSERT_EQ(given.faces.size(), obj.faces.size());
  ASSERT_EQ(report.at("seams").at("charts"), 2);
  EXPECT_EQ(report.at("seams").at("edges_not_in_file"), 0);
  for(std::size_t f = 0; f < obj.faces.size(); ++f)
  {
    ASSERT_EQ(given.faces[f].size(), obj.faces[f].size());
    double area = 0.;
    for(std::size_t i = 0; i < obj.faces[f].size(); ++i)
    {
      EXPECT_EQ(given.faces[f][i][0], obj.faces[f][i][0]);
      EXPECT_EQ(given.faces[f][i][2], obj.faces[f][i][2]);
      const UV &p = obj.uv.at(obj.texture(f, i)), &q = obj.uv.at(obj.texture(f, (i + 1) % obj.faces[f].size()));
      area += p[0] * q[1] - p[1] * q[0];
    }
    EXPECT_GT(area, 0.) << f;
  }
  // each part is one disk, and the seams are those where corners differ
  std::set<Edge> edges;
  curve_measures::Union_find parts(obj.uv.size());
  std::size_t number_of_parts = obj.uv.size();
  for(std::size_t f = 0; f < obj.faces.size(); ++f)
    for(std::size_t i = 0; i < obj.faces[f].size(); ++i)
    {
      const std::size_t a = obj.texture(f, i), b = obj.texture(f, (i + 1) % obj.faces[f].size());
      edges.insert(std::minmax(a, b));
      number_of_parts -= parts.unite(a, b);
    }
  EXPECT_EQ(number_of_parts, 2u);
  EXPECT_EQ(obj.uv.size() + obj.faces.size(), edges.size() + 2);
  std::set<Edge> seams;
  for(const Json& pair : json("seams.json"))
    seams.insert(std::minmax(pair[0].get<std::size_t>(), pair[1].get<std::size_t>()));
  EXPECT_EQ(seams, seams_of(obj));
  EXPECT_GE(seams.size(), 4u);
}

// Lines that go on, ends of lines as on Windows, elements that are no faces, and corners without a number after a slash.
TEST_F(Model, may_be_written_in_any_way)
{
  const std::string points = "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nv 2 0 0\r\nv 2 1 0\r\n# all\r\n";
  write("model.obj", points + "vt 0 0\r\nf 1/1 2/1 \\\r\n 3/1 4/1\r\nf 2// 5\\\n 6 3\r\nl 1/1 2/1\r\n");
  EXPECT_EQ(run_model("--uv " + file("uv.obj")).at("uv").at("faces"), 4);
  const std::string text = read_file(path("uv.obj"));
  std::istringstream lines(text.substr(points.size()));
  EXPECT_EQ(text.substr(0, points.size()), points);
  std::string rest;
  for(std::string line; std::getline(lines, line);)
    rest += line.compare(0, 2, "vt") == 0 ? "t" : line + "\n";
  EXPECT_EQ(rest, "ttttttf 1/1 2/2 3/3 4/4\r\nf 2/2 5/5 6/6 3/3\r\nl 1 2\r\n");
}

// Also with fine seams, and where they divide cells: they go around quads everywhere.
TEST_F(Model, has_seams_on_its_edges_alone)
{
  for(const std::string more :
      {"--min-branch-width 0.01", "--method polyhedral", "--source 0 --source 50 --source 90",
       "--source 3 --source 240", "--method laplacian --min-branch-edges 0", "--source 250 --min-branch-width 0.02"})
  {
    const Json report = run_model(more + " --uv " + file("uv.obj") + " --seams " + file("seams.obj"));
    EXPECT_EQ(report.at("seams").at("edges_not_in_file"), 0) << more;
    EXPECT_EQ(report.at("uv").at("flipped_faces"), 0) << more;
    EXPECT_EQ(report.at("seams").at("charts"), more.find("--source 50") != std::string::npos ? 4 : 2) << more;
    const Obj obj = parse(read_file(path("uv.obj")));
    std::istringstream lines(read_file(path("seams.obj")));
    std::set<Edge> seams;
    std::size_t vertices = 0;
    for(std::string line; std::getline(lines, line);)
    {
      std::istringstream words(line);
      std::string word;
      std::size_t a = 0, b = 0;
      words >> word;
      if(word == "l" && words >> a >> b)
        seams.insert(std::minmax(a - 1, b - 1));
      vertices += word == "v";
    }
    EXPECT_EQ(vertices, obj.vertices);
    EXPECT_EQ(seams, seams_of(obj)) << more;
  }
}

TEST_F(Model, is_packed_with_a_margin_and_one_density)
{
  const Json report = run_model("--source 0 --source 50 --source 90 --uv " + file("uv.obj"));
  const Obj obj = parse(read_file(path("uv.obj")));
  curve_measures::Union_find parts(obj.uv.size());
  double covered = 0.;
  for(std::size_t f = 0; f < obj.faces.size(); ++f)
    for(std::size_t i = 0; i < obj.faces[f].size(); ++i)
    {
      const std::size_t a = obj.texture(f, i), b = obj.texture(f, (i + 1) % obj.faces[f].size());
      parts.unite(a, b);
      covered += 0.5 * (obj.uv[a][0] * obj.uv[b][1] - obj.uv[a][1] * obj.uv[b][0]);
    }
  EXPECT_NEAR(report.at("uv").at("covered").get<double>(), covered, 1e-9);
  EXPECT_GT(covered, 0.3);
  constexpr double margin = 1. / 128. - 1e-9;
  for(std::size_t v = 0; v < obj.uv.size(); ++v)
  {
    for(const double x : obj.uv[v])
      EXPECT_TRUE(x >= margin && x <= 1. - margin) << x;
    for(std::size_t f = 0; f < obj.faces.size(); ++f)
      for(std::size_t i = 0; i < obj.faces[f].size(); ++i)
      {
        const std::size_t a = obj.texture(f, i), b = obj.texture(f, (i + 1) % obj.faces[f].size());
        if(parts.find(a) != parts.find(v))
        {
          ASSERT_GE(distance_to_segment(obj.uv[v], obj.uv[a], obj.uv[b]), margin);
        }
      }
  }
}

// What is stretched too much is cut along finer branches, unless the detail is given.
TEST_F(Model, is_stretched_as_little_as_asked_for)
{
  const auto run_with = [&](const std::string& more)
  {
    const Json report = run_model("--uv " + file("uv.obj") + more);
    EXPECT_EQ(report.at("uv").at("flipped_faces"), 0);
    return std::make_pair(report.at("uv").at("stretch").get<double>(), report.at("seams").at("length").get<double>());
  };
  const auto usual = run_with(""), coarse = run_with(" --max-stretch 1000"), fine = run_with(" --max-stretch 1.25");
  EXPECT_LE(usual.first, 2.);
  EXPECT_GT(coarse.first, 1.5);
  EXPECT_LE(fine.first, 1.25);
  EXPECT_GT(fine.second, coarse.second);
  // it says so, and how the curve of the other outputs becomes the same
  const auto noted = [&](const std::string& more)
  {
    const std::string text = run(file("model.obj") + " --uv " + file("uv.obj") + more).messages;
    const std::string words = "note: seams follow finer branches than the curve of the other outputs: with ";
    const std::size_t begin = text.find(words);
    return begin == std::string::npos
             ? ""
             : text.substr(begin + words.size(), text.find(" it", begin + words.size()) - begin - words.size());
  };
  EXPECT_EQ(noted(" --max-stretch 1000"), "");
  const std::string option = noted(" --max-stretch 1.25");
  ASSERT_EQ(option.compare(0, 19, "--min-branch-width "), 0) << option;
  EXPECT_EQ(noted(" " + option), "");
  const std::string width = " --min-branch-width 0.3";
  EXPECT_EQ(run_with(width + " --max-stretch 1"), run_with(width));
  expect_failure(run_on_torus("--max-stretch 2"), "--max-stretch is for --uv and --seams");
  expect_failure(run_on_torus("--max-stretch 0.5 --uv " + file("uv.obj")), "--max-stretch takes a number from 1");
}

// The vertex that is farthest from the middle of one component is one of the other, too.
TEST_F(Program, Components_that_share_a_vertex_of_the_file_are_all_cut_open)
{
  write("two.obj", "v 0 0 0\nv 20 0 0\nv 0 20 0\nv 0 0 20\nv -9 0 0\nv -9 1 0\nv -9 0 1\n"
                   "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 1 5 6\nf 1 6 7\nf 1 7 5\nf 5 7 6\n");
  const Outcome outcome = run(file("two.obj") + " --uv " + file("uv.obj"));
  EXPECT_EQ(outcome.status, 0);
  expect_has(outcome.messages, "charts: 2,");
  EXPECT_EQ(outcome.messages.find("faces are split"), std::string::npos) << outcome.messages;
  const Obj obj = parse(read_file(path("uv.obj")));
  ASSERT_EQ(obj.faces.size(), 8u);
  for(std::size_t f = 0; f < obj.faces.size(); ++f)
    for(std::size_t i = 0; i < 3; ++i)
      EXPECT_LT(obj.texture(f, i), obj.uv.size());
}

TEST_F(Model, as_glTF)
{
  const Json report = run_model("--uv " + file("uv.glb"));
  const std::string glb = read_file(path("uv.glb"));
  const auto number = [&](std::size_t at)
  {
    std::uint32_t result = 0;
    for(int i = 3; i >= 0; --i)
      result = result << 8 | static_cast<unsigned char>(glb.at(at + std::size_t(i)));
    return result;
  };
  ASSERT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(number(4), 2u);
  EXPECT_EQ(number(8), glb.size());
  const std::size_t length = number(12), binary = 20 + length;
  EXPECT_EQ(glb.substr(16, 4) + glb.substr(binary + 4, 4), std::string("JSONBIN\0", 8));
  EXPECT_EQ(binary + 8 + number(binary), glb.size());
  const Json gltf = Json::parse(glb.substr(20, length));
  const Json &accessors = gltf.at("accessors"), &views = gltf.at("bufferViews");
  EXPECT_EQ(accessors[2].at("count"), 3 * report.at("uv").at("faces").get<std::size_t>());
  const auto part = [&](std::size_t i) { return binary + 8 + views[i].at("byteOffset").get<std::size_t>(); };
  for(std::size_t i = 0; i < accessors[2].at("count"); ++i)
    ASSERT_LT(number(part(2) + 4 * i), accessors[1].at("count").get<std::size_t>());
  const auto real = [&](std::size_t view, std::size_t i)
  {
    const std::uint32_t bits = number(part(view) + 4 * i);
    float x = 0.f;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  };
  const std::size_t vertices = accessors[1].at("count");
  for(std::size_t i = 0; i < 2 * vertices; ++i)
    ASSERT_TRUE(real(1, i) > 0.f && real(1, i) < 1.f) << real(1, i);
  // each box has a normal of its own
  ASSERT_EQ(gltf.at("meshes")[0].at("primitives")[0].at("attributes").at("NORMAL"), 3);
  ASSERT_EQ(accessors[3].at("count"), vertices);
  for(std::size_t i = 0; i < 3 * vertices; ++i)
    ASSERT_EQ(real(3, i), (real(0, i - i % 3) > 2.5f ? i % 3 == 0 : i % 3 == 2) ? 1.f : 0.f);
  EXPECT_EQ(glb.compare(part(4) + 1, 3, "PNG"), 0);

  // a normal is missing: there are none, and one without a direction is that of the face
  std::string model = read_file(path("model.obj"));
  const std::size_t at = model.find("vn 2 0 0");
  write("zero.obj", model.replace(at, 8, "vn 0 0 0"));
  EXPECT_EQ(run(file("zero.obj") + " --quiet --uv " + file("zero.glb")).status, 0);
  expect_has(read_file(path("zero.glb")), "NORMAL");
  write("less.obj", model.replace(at, 9, ""));
  EXPECT_EQ(run(file("less.obj") + " --quiet --uv " + file("less.glb")).status, 0);
  EXPECT_EQ(read_file(path("less.glb")).find("NORMAL"), std::string::npos);
}

TEST_F(Model, is_cut_open_behind)
{
  const Json report = run_model("--from-view 1,0,0 --uv " + file("uv.obj") + " --seams " + file("s.py"));
  EXPECT_GT(report.at("source_point")[0].get<double>(), 1.3);
  const std::string script = read_file(path("s.py"));
  const std::size_t begin = script.find('[', script.find("SEAMS = "));
  const Json seams = Json::parse(script.substr(begin, script.find("]]") + 2 - begin));
  std::istringstream model(read_file(path("model.obj")));
  std::vector<double> x;
  for(std::string line; std::getline(model, line);)
    if(line.compare(0, 2, "v ") == 0)
      x.push_back(std::stod(line.substr(2)));
  for(const Json& pair : seams)
    for(const std::size_t v : pair.get<std::vector<std::size_t>>())
      EXPECT_LT(x.at(v), v < first_vertices_ ? 0. : 5.);
  expect_failure(run_on_torus("--from-view 1,0,0 --source 3"), "--from-view chooses the source");
  expect_failure(run_on_torus("--from-view 0,0,0"), "--from-view takes a direction");
  expect_failure(run_on_torus("--curve faces --seams " + file("s.py")), "--seams writes a curve of edges");
  expect_failure(run_on_torus("--seams " + file("s.txt")), "must be .obj, .json or .py");
}

TEST_F(Model, straight_seams_split_faces_and_say_so)
{
  const Outcome outcome = run(file("model.obj") + " --curve faces --uv " + file("uv.obj"));
  EXPECT_EQ(outcome.status, 0) << outcome.messages;
  expect_has(outcome.messages, "faces are split");
  EXPECT_TRUE(fs::exists(path("uv.png")) && fs::exists(path("uv.mtl")));
  for(const auto& face : parse(read_file(path("uv.obj"))).faces)
    EXPECT_EQ(face.size(), 3u);
}
