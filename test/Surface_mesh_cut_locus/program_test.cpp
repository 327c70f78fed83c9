// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Runs the program as a user would, and looks at its exit status, messages and files.

#include "Union_find.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using curve_measures::Union_find;

TEST_F(Program, Help)
{
  const Outcome all = run("--help-all"), most = run("--help"), version = run("--version");
  for(const Outcome* outcome : {&all, &most, &version})
    EXPECT_EQ(outcome->status, 0);
  std::istringstream options(
    "--source --source-point --from-view --sources --source-edges --source-border --each-source --part --solver "
    "--method "
    "--max-relative-error --threads --curve --min-branch-width --min-branch-gap --min-branch-curvature --angle "
    "--laplacian --policy --min-branch-edges --min-branch-length --smooth --output --view --edges --cells --surface "
    "--keep --uv --seams --max-stretch --parameterization --unfold --report --check --check-completeness --repair "
    "--input-format --output-format --quiet --generate --version --help-all");
  for(std::string option; options >> option;)
    expect_has(all.messages, option == "--source" ? "--source " : option);
  EXPECT_LE(std::count(most.messages.begin(), most.messages.end(), '\n'), 60);
  std::istringstream words(most.messages);
  for(std::string word; words >> word;)
    if(word.compare(0, 2, "--") == 0)
    {
      expect_has(all.messages, word);
    }
  EXPECT_EQ(version.messages.compare(0, 10, "cut_locus "), 0);
}

TEST_F(Program, Completion_for_bash)
{
  if(std::system("bash -c true") != 0)
    GTEST_SKIP() << "there is no bash";
  ASSERT_EQ(run("--generate completion > " + file("completion")).status, 0);
  const auto complete = [&](const std::string& previous, const std::string& word)
  {
    const std::string script =
      ". \"$0\"; _cut_locus cut_locus " + quoted(word) + " " + previous + "; echo ${COMPREPLY[*]}";
    write("script", script);
    return run("--version > /dev/null", "bash -c \"$(cat " + file("script") + ")\" " + file("completion") + "; ")
      .messages;
  };
  EXPECT_EQ(complete("cut_locus", "--source-"), "--source-point --source-edges --source-border\n");
  EXPECT_EQ(complete("--repair", ""), "weld orient none\n");
  EXPECT_EQ(complete("--solver", "gr"), "graph\n");
  EXPECT_EQ(complete("cut_locus", "bunny"), "\n"); // files, which bash looks for
  expect_failure(run("--generate html"), "--generate takes man or completion");
}

TEST_F(Program, Page_for_man)
{
  const Outcome outcome = run("--generate man > " + file("cut_locus.1"));
  ASSERT_EQ(outcome.status, 0) << outcome.messages;
  const std::string text = read_file(path("cut_locus.1"));
  for(const char* part : {".TH CUT_LOCUS 1 ", ".SH NAME\n", ".SS Sources\n", "\\-\\-source\\-point", ".SH EXAMPLES\n"})
    expect_has(text, part);
  if(std::system("groff --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "there is no groff";
  const std::string formatted = file("formatted");
  EXPECT_EQ(std::system(("groff -man -Tascii -ww " + file("cut_locus.1") + " > " + formatted + " 2>&1").c_str()), 0);
  EXPECT_EQ(read_file(path("formatted")).find("warning"), std::string::npos) << read_file(path("formatted"));
}

// Each example of the help, with a mesh that is there.
TEST_F(Program, Examples_of_the_help)
{
  std::istringstream lines(run("--help").messages);
  int number = 0;
  for(std::string line; std::getline(lines, line);)
  {
    if(line.compare(0, 12, "  cut_locus ") != 0)
      continue;
    std::string arguments = line.substr(12);
    arguments = arguments.substr(arguments.find(' '));
    if(const std::size_t at = arguments.find("4711"); at != std::string::npos)
      arguments.replace(at, 4, "47"); // the mesh has few vertices
    write("square.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n");
    const char* mesh = arguments.find("--source-border") != std::string::npos ? "square.off" : "torus.off";
    const Outcome outcome = run(file(mesh) + arguments, "cd " + quoted(folder_.string()) + "; ");
    EXPECT_EQ(outcome.status, 0) << line << outcome.messages;
    ++number;
  }
  EXPECT_EQ(number, 7);
}

TEST_F(Program, Report_and_edges)
{
  for(const char* solver : {"exact", "cgal-exact", "heat", "heat-direct"})
  {
    SCOPED_TRACE(solver);
    const Outcome outcome = run_on_torus(std::string("--quiet --source 5 --solver ") + solver + " --report " +
                                         file("report.json") + " --edges " + file("edges.txt"));
    ASSERT_EQ(outcome.status, 0) << outcome.messages;
    EXPECT_EQ(outcome.messages, "");

    const auto report = json("report.json");
    EXPECT_EQ(report.at("vertices"), number_of_vertices_);
    EXPECT_EQ(report.at("faces"), triangles_.size());
    EXPECT_EQ(report.at("genus"), 1);
    EXPECT_EQ(report.at("source"), 5);
    EXPECT_EQ(report.at("cycles"), 2);
    EXPECT_EQ(report.at("components"), 1);
    EXPECT_EQ(report.at("solver"), solver);
    EXPECT_GT(report.at("injectivity_radius").get<double>(), 0.5);
    EXPECT_LE(report.at("injectivity_radius").get<double>(), report.at("farthest_distance").get<double>());
    EXPECT_GE(report.at("farthest_point_distance").get<double>(), report.at("farthest_distance").get<double>());
    EXPECT_EQ(report.at("farthest_point").size(), 3u);
    for(const char* key : {"farthest", "leaves", "branchings", "root", "border_loops"})
      EXPECT_TRUE(report.at(key).is_number_unsigned()) << key;
    for(const char* stage :
        {"read", "preprocess", "distance", "strengths", "tree", "homology", "filter", "write", "total"})
      EXPECT_GE(report.at("seconds").at(stage).get<double>(), 0.) << stage;

    // The edges are edges of the mesh, they form a connected graph with two cycles, and the faces stay connected without
    // crossing them: so the rest of the torus is a disk.
    std::map<std::pair<int, int>, std::vector<std::size_t>> faces_of_edge;
    for(std::size_t f = 0; f < triangles_.size(); ++f)
      for(int i = 0; i < 3; ++i)
        faces_of_edge[std::minmax(triangles_[f][i], triangles_[f][(i + 1) % 3])].push_back(f);
    std::set<std::pair<int, int>> cut;
    std::set<int> cut_vertices;
    std::istringstream edges(read_file(path("edges.txt")));
    for(int a, b; edges >> a >> b;)
    {
      ASSERT_EQ(faces_of_edge.count(std::minmax(a, b)), 1u) << a << ' ' << b;
      EXPECT_TRUE(cut.insert(std::minmax(a, b)).second);
      cut_vertices.insert({a, b});
    }
    EXPECT_TRUE(edges.eof());
    EXPECT_EQ(report.at("edges"), cut.size());
    EXPECT_EQ(cut_vertices.count(5), 0u) << "the source is not on the cut locus";
    EXPECT_EQ(cut.size() + 1, cut_vertices.size() + 2);
    Union_find vertices(number_of_vertices_), faces(triangles_.size());
    std::size_t components = cut_vertices.size(), disks = triangles_.size();
    for(const auto& e : cut)
      components -= vertices.unite(e.first, e.second);
    for(const auto& e : faces_of_edge)
      if(cut.count(e.first) == 0)
        disks -= faces.unite(e.second[0], e.second[1]);
    EXPECT_EQ(components, 1u);
    EXPECT_EQ(disks, 1u);
  }
}

TEST_F(Program, Check)
{
  for(const char* curve :
      {"--curve edges", "--curve faces", "--method polyhedral --curve faces", "--method laplacian --smooth 4"})
  {
    SCOPED_TRACE(curve);
    const Outcome outcome =
      run_on_torus(std::string("--source 5 --check ") + curve + " --report " + file("report.json"));
    ASSERT_EQ(outcome.status, 0) << outcome.messages;
    expect_has(outcome.messages, "check: topology right; detour mean 0.0");
    const auto report = json("report.json");
    EXPECT_EQ(report.at("topology"), "right");
    EXPECT_LE(report.at("detour_mean").get<double>(), report.at("detour_max").get<double>());
    EXPECT_LE(report.at("detour_p99").get<double>(), report.at("detour_max").get<double>());
    EXPECT_LE(report.at("node_distance_error_mean").get<double>(), report.at("node_distance_error_max").get<double>());
    // LAPLACIAN knows distances at vertices, and interpolates
    EXPECT_LT(report.at("node_distance_error_max").get<double>(),
              std::string(curve).find("laplacian") == std::string::npos ? 1e-6 : 0.5);
    EXPECT_EQ(report.at("not_checked"), Json({"completeness"}));
    // through the faces no shortest path crosses the branches of the polyhedron
    EXPECT_LT(report.at("detour_max").get<double>(),
              std::string(curve).find("--curve faces") != std::string::npos ? 0.001 : 1.);
  }
}

// A width that is asked for leaves out nothing that is wider; a curve of mesh edges is near that through the faces.
TEST_F(Program, Check_of_completeness)
{
  for(const char* options : {"--min-branch-width 0.05", "", "--curve edges", "--method laplacian"})
  {
    SCOPED_TRACE(options);
    const Outcome outcome =
      run_on_torus(std::string("--source 5 --check-completeness ") + options + " --report " + file("report.json"));
    ASSERT_EQ(outcome.status, 0) << outcome.messages;
    EXPECT_EQ(outcome.messages.find("not checked"), std::string::npos) << outcome.messages;
    const auto figures = json("report.json").at("completeness");
    EXPECT_GT(figures.at("width").get<double>(), 0.);
    EXPECT_GE(figures.at("found").get<double>(), 0.99);
    EXPECT_GE(figures.at("confirmed").get<double>(), 0.99);
  }
}

TEST_F(Program, The_result_of_a_check_is_never_quiet)
{
  const Outcome outcome = run_on_torus("--quiet --source 5 --check");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.messages.compare(0, 22, "check: topology right;"), 0) << outcome.messages;
  EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 1) << outcome.messages;
}

TEST_F(Program, All_formats)
{
  std::string arguments = "--solver heat";
  const std::map<std::string, std::string> starts = {{"a.polylines.txt", ""}, {"a.obj", "v "},      {"a.vtp", "<?xml"},
                                                     {"a.ply", "ply\n"},      {"a.png", "\x89PNG"}, {"a.svg", "<?xml"},
                                                     {"a.json", "{"}};
  for(const auto& format : starts)
    arguments += " -o " + file(format.first);
  const Outcome outcome = run_on_torus(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.messages;
  for(const char* stage : {"read", "distance", "homology", "write", "genus 1"})
    expect_has(outcome.messages, stage);
  for(const auto& format : starts)
  {
    const std::string text = read_file(path(format.first));
    EXPECT_GT(text.size(), 100u) << format.first;
    EXPECT_EQ(text.compare(0, format.second.size(), format.second), 0) << format.first;
  }
  const std::string svg = read_file(path("a.svg"));
  expect_has(svg, "<path");
  expect_has(svg, "<circle");
  expect_has(svg, "</svg>");
}

TEST_F(Program, Sources_and_thresholds)
{
  const auto report = [&](const std::string& arguments) { return torus_report(arguments); };
  EXPECT_EQ(report("").at("source"), 1); // vertex 0 is isolated
  const auto inside = report("--source-point 1.38,0.243,0.055");
  EXPECT_TRUE(inside.at("source").is_null());
  EXPECT_NEAR(inside.at("source_point").at(0).get<double>(), 1.36, 0.03);
  EXPECT_EQ(report("--source-point=-2,-0.01,0.02").at("genus"), 1);

  const auto three = report("--source 5 --source 40 --source 80");
  EXPECT_EQ(three.at("cycles"), 4) << "two of the torus, and one for each cell but the first";
  EXPECT_EQ(three.at("sources"), Json({5, 40, 80}));
  const auto mixed = report("--source-point 1.38,0.243,0.055 --source-point=-2,-0.01,0.02 --source 5 --curve faces");
  EXPECT_EQ(mixed.at("cycles"), 4);
  EXPECT_EQ(mixed.at("sources").at(0), 5) << "the vertices have the first numbers";
  EXPECT_TRUE(mixed.at("sources").at(1).is_null());
  EXPECT_NEAR(mixed.at("source_points").at(1).at(0).get<double>(), 1.36, 0.03);
  EXPECT_LT(mixed.at("source_points").at(2).at(0).get<double>(), -1.3);

  const std::string laplacian = "--method laplacian --curve edges ";
  const auto loose = report(laplacian + "--angle 0.05 --min-branch-edges 0"),
             tight = report(laplacian + "--angle 3.14 --min-branch-edges 0");
  EXPECT_GT(loose.at("edges"), tight.at("edges"));
  EXPECT_EQ(tight.at("cycles"), 2);
  EXPECT_LE(report(laplacian + "--angle 0.05 --min-branch-length 0.3").at("edges"), loose.at("edges"));
  EXPECT_LE(report(laplacian + "--angle 0.05 --policy grow --min-branch-edges 0").at("edges"), loose.at("edges"));
  EXPECT_LE(report(laplacian + "--angle 0.05 --laplacian 0.5 --min-branch-edges 0").at("edges"), loose.at("edges"));

  for(const std::string method : {"--method default ", "--method polyhedral "})
  {
    SCOPED_TRACE(method);
    const auto narrow = report(method + "--min-branch-width 0"), wide = report(method + "--min-branch-width 1");
    EXPECT_GT(narrow.at("edges"), wide.at("edges"));
    EXPECT_GT(narrow.at("edges"), report(method + "--min-branch-gap 1").at("edges"));
    EXPECT_EQ(narrow.at("cycles"), 2);
    EXPECT_EQ(wide.at("cycles"), 2);
    EXPECT_EQ(wide.at("leaves"), 0);
    EXPECT_GT(narrow.at("leaves"), 0);
    EXPECT_EQ(report(method + "--min-branch-width 0 --min-branch-edges 1000").at("leaves"), 0);
    EXPECT_EQ(report(method + "--min-branch-width 0 --min-branch-length 2").at("leaves"), 0);
    EXPECT_EQ(report(method + "--min-branch-width 0 --min-branch-length 2 --curve faces").at("leaves"), 0);
  }
  EXPECT_EQ(report("--min-branch-width 0").at("edges"), report("--method polyhedral").at("edges"));
}

// The report tells what was in force as numbers.
TEST_F(Program, Thresholds_in_the_report)
{
  const auto parameters = [&](const std::string& arguments) { return torus_report(arguments).at("parameters"); };
  const auto standard = parameters("");
  EXPECT_GT(standard.at("min_branch_width").get<double>(), 0.01);
  EXPECT_LT(standard.at("min_branch_width").get<double>(), 1.);
  EXPECT_EQ(standard.at("min_branch_gap"), 0.);
  EXPECT_GE(standard.at("min_branch_curvature").get<double>(), 1.25);
  EXPECT_EQ(standard.at("min_branch_edges"), 0);
  EXPECT_EQ(standard.at("min_branch_length"), 0.);
  for(const char* name : {"angle", "laplacian", "policy", "smooth"})
    EXPECT_TRUE(standard.at(name).is_null()) << name;

  const auto all = parameters("--method polyhedral");
  EXPECT_EQ(all.at("min_branch_width"), 0.);
  EXPECT_EQ(all.at("min_branch_gap"), 0.);

  // one of the two replaces the defaults of both
  const auto gap = parameters("--min-branch-gap 0.25");
  EXPECT_EQ(gap.at("min_branch_width"), 0.);
  EXPECT_EQ(gap.at("min_branch_gap"), 0.25);
  EXPECT_TRUE(gap.at("min_branch_curvature").is_null());

  const auto laplacian = parameters("--method laplacian --curve faces");
  EXPECT_EQ(laplacian.at("angle"), 0.7);
  EXPECT_EQ(laplacian.at("policy"), "prune");
  EXPECT_EQ(laplacian.at("min_branch_edges"), 3);
  EXPECT_EQ(laplacian.at("smooth"), 4);
  EXPECT_TRUE(laplacian.at("min_branch_width").is_null());

  write("t.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  const Json tetrahedron = report_on("t.off").at("parameters");
  // no branch is as wide as three edges, and all of them enclose nine tenths of the least of its corners, pi / 2
  EXPECT_EQ(tetrahedron.at("min_branch_width"), 1.);
  EXPECT_EQ(tetrahedron.at("min_branch_gap"), 0.);
  EXPECT_LE(tetrahedron.at("min_branch_curvature").get<double>(), 0.9 * 1.5708);
}

// Files, report and messages are about one curve, which runs through the faces unless there is a need for edges.
TEST_F(Program, One_curve)
{
  const auto all = [&](const std::string& arguments)
  {
    const Outcome outcome = run_on_torus(arguments + " -o " + file("c.obj") + " --report " + file("r.json"));
    EXPECT_EQ(outcome.status, 0) << arguments << ": " << outcome.messages;
    const Json report = json("r.json");
    // the figures of the report are those of the file
    std::vector<std::array<double, 3>> points;
    std::map<std::size_t, int> degree;
    double length = 0.;
    std::size_t edges = 0;
    std::istringstream obj(read_file(path("c.obj")));
    for(std::string line; std::getline(obj, line);)
    {
      std::istringstream words(line);
      std::string key;
      words >> key;
      std::array<double, 3> p;
      if(key == "v" && words >> p[0] >> p[1] >> p[2])
        points.push_back(p);
      std::size_t previous = 0, next = 0;
      if(key == "l")
        for(words >> previous; words >> next; previous = next)
        {
          length +=
            std::hypot(points[next - 1][0] - points[previous - 1][0], points[next - 1][1] - points[previous - 1][1],
                       points[next - 1][2] - points[previous - 1][2]);
          ++degree[previous];
          ++degree[next];
          ++edges;
        }
    }
    const auto leaves = std::count_if(degree.begin(), degree.end(), [](const auto& d) { return d.second == 1; });
    EXPECT_NEAR(report.at("length").get<double>(), length, 1e-6 * length) << arguments;
    EXPECT_EQ(report.at("edges"), edges) << arguments;
    EXPECT_EQ(report.at("leaves"), leaves) << arguments;
    expect_has(outcome.messages, " " + std::to_string(edges) + " edges, 2 cycles, " + std::to_string(leaves));
    const double radius = report.at("injectivity_radius"), bound = report.at("injectivity_lower_bound");
    EXPECT_LE(bound, radius);
    EXPECT_EQ(bound > 0., report.at("method") != "laplacian");
    EXPECT_EQ(outcome.messages.find("with all weak branches at least") != std::string::npos,
              bound > 0. && report.at("method") == "default")
      << outcome.messages;
    const std::string words = report.at("curve") == "edges" ? "mesh edges" : "through faces";
    expect_has(outcome.messages, words);
    return std::make_pair(report.at("curve").get<std::string>(), length);
  };
  for(const std::string method : {"--method default", "--method polyhedral", "--method laplacian", "--solver heat"})
  {
    SCOPED_TRACE(method);
    const auto edges = all(method + " --curve edges"), faces = all(method + " --curve faces");
    EXPECT_EQ(edges.first, "edges");
    EXPECT_EQ(faces.first, "faces");
    EXPECT_NE(edges.second, faces.second);
    EXPECT_EQ(all(method), faces);
    EXPECT_EQ(all(method + " --edges " + file("e.txt")), edges);
    EXPECT_EQ(all(method + " --uv " + file("u.obj")), edges);
  }
  write("sources.txt", "5\n");
  for(const std::string curve : {"edges", "faces"})
  {
    const double length = all("--source 5 --curve " + curve).second;
    EXPECT_EQ(run_on_torus("--quiet --each-source " + file("sources.txt") + " --curve " + curve + " -o " +
                           file(curve + ".jsonl"))
                .status,
              0);
    const auto line = json(curve + ".jsonl");
    EXPECT_NEAR(line.at("length").get<double>(), length, 1e-6 * length) << curve;
    const Json report = json("r.json");
    for(const char* figure : {"edges", "leaves", "injectivity_radius", "injectivity_lower_bound", "farthest_point"})
      EXPECT_EQ(line.at(figure), report.at(figure)) << curve;
    // along edges of the mesh no face is split
    EXPECT_EQ(run_on_torus("--quiet --source 5 --source 200 --curve " + curve + " --cells " + file("c.obj")).status, 0);
    const std::size_t faces = number_of("\nf ", read_file(path("c.obj")));

    EXPECT_EQ(faces == triangles_.size(), curve == "edges") << faces;
  }
  EXPECT_EQ(all("--method laplacian --smooth 4"), all("--method laplacian"));
  EXPECT_EQ(all("--method laplacian --smooth 0"), all("--method laplacian --curve edges"));
  const std::string to_edges = " --edges " + file("e.txt");
  expect_has(run_on_torus("--curve faces" + to_edges).messages, "--edges writes");
  expect_has(run_on_torus("--method laplacian --smooth 4" + to_edges).messages, "--edges writes");
}

TEST_F(Program, Default_methods)
{
  const auto expect = [&](const std::string& options, const std::string& method)
  { EXPECT_EQ(torus_report(options).at("method"), method) << options; };
  for(const auto& [solver, method] : std::map<std::string, std::string>{
        {"exact", "default"}, {"cgal-exact", "laplacian"}, {"heat", "laplacian"}, {"graph", "laplacian"}})
    for(const char* explicitly : {"", " --method auto"})
      expect("--solver " + solver + explicitly, method);
  expect("--method direction", "default"); // as it was called before
}

// The faces of the OBJ file are those of the mesh, with the vertices of the mesh; by the corners of the texture they
// form one disk in the unit square.
TEST_F(Program, Textured_mesh)
{
  for(const char* method : {"--method laplacian", "--method default", "--method polyhedral",
                            "--method laplacian --curve faces", "--method default --curve faces"})
    for(const char* parameterization : {"injective", "arap", "lscm", "convex"})
    {
      SCOPED_TRACE(std::string(method) + " " + parameterization);
      const Json report =
        torus_report(std::string(method) + " --parameterization " + parameterization + " --uv " + file("uv.obj"))
          .at("uv");
      std::map<std::string, int> lines;
      std::vector<std::array<double, 2>> uv;
      std::vector<std::array<int, 3>> faces, texture_faces;
      std::istringstream obj(read_file(path("uv.obj")));
      std::string material;
      for(std::string line; std::getline(obj, line);)
      {
        std::istringstream words(line);
        std::string key;
        words >> key;
        ++lines[key];
        if(key == "mtllib")
          words >> material;
        else if(key == "vt")
        {
          uv.emplace_back();
          words >> uv.back()[0] >> uv.back()[1];
        }
        else if(key == "f")
        {
          faces.emplace_back();
          texture_faces.emplace_back();
          for(int i = 0; i < 3; ++i)
          {
            char slash = ' ';
            words >> faces.back()[i] >> slash >> texture_faces.back()[i];
            ASSERT_EQ(slash, '/');
            ASSERT_TRUE(texture_faces.back()[i] >= 1 && texture_faces.back()[i] <= int(uv.size()));
          }
        }
        EXPECT_FALSE(words.fail()) << line;
      }
      if(std::string(method).find("faces") == std::string::npos)
      {
        EXPECT_EQ(lines["v"], number_of_vertices_);
        std::multiset<std::set<int>> given, found;
        for(const Triangle& t : triangles_)
          given.insert({t[0] + 1, t[1] + 1, t[2] + 1});
        for(const auto& f : faces)
          found.insert({f[0], f[1], f[2]});
        EXPECT_EQ(given, found);
      }
      else
        EXPECT_GT(faces.size(), triangles_.size());

      // the surface is closed, and its texture one disk
      const auto edges_of = [](const std::vector<std::array<int, 3>>& all)
      {
        std::map<std::pair<int, int>, int> edges;
        for(const auto& f : all)
          for(int i = 0; i < 3; ++i)
            ++edges[std::minmax(f[i], f[(i + 1) % 3])];
        return edges;
      };
      for(const auto& e : edges_of(faces))
        EXPECT_EQ(e.second, 2);
      const auto edges = edges_of(texture_faces);
      EXPECT_EQ(int(uv.size()) - int(edges.size()) + int(faces.size()), 1);
      std::map<int, std::vector<int>> border;
      for(const auto& e : edges)
        if(e.second == 1)
        {
          border[e.first.first].push_back(e.first.second);
          border[e.first.second].push_back(e.first.first);
        }
      Union_find loops(uv.size() + 1);
      std::size_t number_of_loops = border.size();
      for(const auto& b : border)
      {
        EXPECT_EQ(b.second.size(), 2u);
        for(int w : b.second)
          number_of_loops -= loops.unite(b.first, w);
      }
      EXPECT_EQ(number_of_loops, 1u);

      int flipped = 0;
      for(const auto& f : texture_faces)
      {
        const auto &a = uv[f[0] - 1], &b = uv[f[1] - 1], &c = uv[f[2] - 1];
        flipped += !((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.);
      }
      for(const auto& t : uv)
        EXPECT_TRUE(t[0] >= 0. && t[0] <= 1. && t[1] >= 0. && t[1] <= 1.);

      EXPECT_EQ(report.at("parameterization"), parameterization);
      EXPECT_EQ(report.at("faces"), faces.size());
      EXPECT_NEAR(report.at("flipped_faces").get<int>(), flipped, 1); // of no area, up to rounding
      if(std::string(parameterization) == "injective" || std::string(parameterization) == "convex")
      {
        EXPECT_EQ(flipped, 0);
        EXPECT_EQ(report.at("injective"), true);
        EXPECT_EQ(report.at("overlapping_faces"), 0);
        EXPECT_EQ(report.at("overlap"), 0.);
        EXPECT_GE(report.at("symmetric_dirichlet_energy").get<double>(), 1.);
      }
      EXPECT_GE(report.at("area_distortion").get<double>(), 1.);
      EXPECT_GE(report.at("angle_distortion").get<double>(), 1.);
      // all of the cut locus of the polyhedron has branches up to the vertices beside the source: .207
      const bool is_all = std::string(method) == "--method polyhedral";
      EXPECT_GT(report.at("seam_distance").get<double>(), is_all ? 0.2 : 0.4);
      EXPECT_GT(report.at("short_cut_graph_distance").get<double>(), 0.);

      const std::string mtl = read_file(path(material));
      const std::size_t map = mtl.find("map_Kd ");
      ASSERT_NE(map, std::string::npos) << mtl;
      const std::string texture = mtl.substr(map + 7, mtl.find('\n', map) - map - 7);
      EXPECT_EQ(read_file(path(texture)).compare(0, 4, "\x89PNG"), 0) << texture;
    }
}

// A ramp of one turn and a half: laid flat, half of a ring is covered twice.
TEST_F(Program, Overlapping_atlas)
{
  constexpr int columns = 90, rows = 3;
  std::ostringstream off;
  off << "OFF\n" << (columns + 1) * (rows + 1) << ' ' << 2 * columns * rows << " 0\n";
  for(int i = 0; i <= columns; ++i)
    for(int j = 0; j <= rows; ++j)
    {
      const double angle = 3. * std::acos(-1.) * i / columns, radius = 1. + 0.15 * j;
      off << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << ' ' << 0.02 * angle << '\n';
    }
  for(int i = 0; i < columns; ++i)
    for(int j = 0; j < rows; ++j)
    {
      const int a = i * (rows + 1) + j, b = a + rows + 1;
      off << "3 " << a << ' ' << a + 1 << ' ' << b + 1 << "\n3 " << a << ' ' << b + 1 << ' ' << b << '\n';
    }
  write("ramp.off", off.str());
  for(const auto& [parameterization, overlap] :
      std::map<std::string, double>{{"arap", 0.5}, {"convex", 0.}, {"injective", 0.}})
  {
    const Json report =
      report_on("ramp.off", "--parameterization " + parameterization + " --uv " + file("uv.obj")).at("uv");
    EXPECT_NEAR(report.at("overlap").get<double>(), overlap, 0.02) << parameterization;
    EXPECT_EQ(report.at("injective"), overlap == 0.) << parameterization;
    EXPECT_EQ(report.at("overlapping_faces") == 0, overlap == 0.) << parameterization;
  }
}

// the area of the cell of each source in a PLY file with one face per line
std::vector<double> areas_of_cells(const std::string& ply, std::size_t number_of_sources)
{
  std::istringstream is(ply);
  std::string word;
  std::size_t vertices = 0, faces = 0;
  while(is >> word && word != "end_header")
    if(word == "element" && is >> word)
      is >> (word == "vertex" ? vertices : faces);
  std::vector<std::array<double, 4>> points(vertices);
  for(auto& p : points)
    is >> p[0] >> p[1] >> p[2] >> p[3];
  std::vector<double> result(number_of_sources, 0.);
  for(std::size_t f = 0; f < faces; ++f)
  {
    std::size_t n, a, b, c, source;
    is >> n >> a >> b >> c >> source;
    const auto &p = points.at(a), &q = points.at(b), &r = points.at(c);
    result.at(source) += 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  EXPECT_TRUE(is.good());
  return result;
}

TEST_F(Program, Cells_of_several_sources)
{
  // a rectangle of 3 x 1 in two triangles: all sources but one are in the same face, and so is most of each cell
  write("plate.off", "OFF\n4 2 0\n0 0 0\n3 0 0\n3 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  const std::string plate =
    file("plate.off") + " --quiet --method polyhedral --curve faces --source 0 --source 1 --source 2 ";
  const Outcome outcome =
    run(plate + "--check --cells " + file("cells.ply") + " -o " + file("cells.svg") + " --report " + file("all.json"));
  EXPECT_EQ(outcome.status, 0) << outcome.messages;
  const std::vector<double> areas = areas_of_cells(read_file(path("cells.ply")), 3);
  // between 0 and 1 is x = 1.5, between 1 and 2 y = 0.5, and between 0 and 2 the line from (1.5, 0.5) to (4 / 3, 1)
  EXPECT_NEAR(areas[0], 35. / 24., 1e-3);
  EXPECT_NEAR(areas[1], 0.75, 1e-3);
  EXPECT_NEAR(areas[2], 19. / 24., 1e-3);
  for(const char* name : {"cells.vtp", "cells.obj"})
    EXPECT_EQ(run(plate + "--cells " + file(name)).status, 0);
  expect_has(read_file(path("cells.vtp")), "Name=\"source\"");
  for(const char* group : {"g source_0\n", "g source_1\n", "g source_2\n"})
    expect_has(read_file(path("cells.obj")), group);

  const auto length = [&](const std::string& part)
  { return torus_report("--source 3 --source 200 --curve faces --keep " + part).at("length").get<double>(); };
  const double voronoi = length("voronoi"), medial = length("medial");
  EXPECT_GT(voronoi, 0.);
  EXPECT_GT(medial, 0.);
  EXPECT_NEAR(voronoi + medial, length("all"), 1e-9);
}

TEST_F(Program, Cells_of_a_smoothed_curve)
{
  // On a coarse tube it leaves vertices in the cell of a source that is not their nearest: the two borders and a point
  // have a cell each all the same.
  constexpr int n = 12;
  std::ostringstream tube;
  tube << "OFF\n" << n * (n + 1) << ' ' << 2 * n * n << " 0\n";
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const double angle = 2. * std::acos(-1.) * (j + 0.5 * i) / n;
      tube << std::cos(angle) << ' ' << std::sin(angle) << ' ' << 0.4 * i << '\n';
    }
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const int a = n * i + j, b = n * i + (j + 1) % n;
      tube << "3 " << a << ' ' << b << ' ' << a + n << "\n3 " << b << ' ' << b + n << ' ' << a + n << '\n';
    }
  write("tube.off", tube.str());
  for(const char* solver : {"exact", "heat", "graph"})
    for(const char* point : {"-1,-.1,2.5", ".5,.8,2.3", "-.6,.7,1.9"})
    {
      const Outcome outcome = run(file("tube.off") + " --quiet --method laplacian --curve faces --source-border " +
                                  "--solver " + solver + " --source-point=" + point + " --cells " + file("cells.obj"));
      ASSERT_EQ(outcome.status, 0) << outcome.messages;
      for(const char* group : {"g source_0\n", "g source_1\n", "g source_2\n"})
        EXPECT_NE(read_file(path("cells.obj")).find(group), std::string::npos)
          << solver << ' ' << point << ' ' << group;
    }
}

TEST_F(Program, Atlas_of_several_sources)
{
  // points have disks, whatever the curve, and so has a curve: the ring around it is cut
  write("edges.txt", "40 41 42 43\n");
  const std::vector<std::string> sets = {
    "--source 3 --source 200 --source 77 --curve edges", "--source 3 --source 200 --curve faces",
    "--source 200 --source-edges " + file("edges.txt"), "--source-edges " + file("edges.txt")};
  for(const std::string& sources : sets)
    for(const char* parameterization : {"arap", "lscm", "convex"})
    {
      const Json report = torus_report(sources + " --parameterization " + parameterization + " --uv " + file("uv.obj"));
      std::size_t vertices = 0;
      std::vector<std::array<std::size_t, 3>> faces;
      std::istringstream obj(read_file(path("uv.obj")));
      for(std::string line, word; std::getline(obj, line);)
      {
        std::istringstream words(line);
        words >> word;
        vertices += word == "vt";
        if(word != "f")
          continue;
        faces.emplace_back();
        for(std::size_t& corner : faces.back())
        {
          words >> word;
          corner = std::stoul(word.substr(word.find('/') + 1)) - 1;
        }
      }
      const std::size_t disks = report.contains("sources") ? report.at("sources").size() : 1;
      std::set<std::pair<std::size_t, std::size_t>> edges;
      Union_find parts(vertices);
      for(const auto& f : faces)
        for(std::size_t i = 0; i < 3; ++i)
        {
          edges.insert(std::minmax(f[i], f[(i + 1) % 3]));
          parts.unite(f[i], f[(i + 1) % 3]);
        }
      std::set<std::size_t> representatives;
      for(std::size_t v = 0; v < vertices; ++v)
        representatives.insert(parts.find(v));
      EXPECT_EQ(representatives.size(), disks) << sources;
      EXPECT_EQ(vertices + faces.size(), edges.size() + disks) << sources;
      if(parameterization == std::string("convex"))
      {
        EXPECT_EQ(report.at("uv").at("flipped_faces"), 0) << sources;
        EXPECT_EQ(report.at("uv").at("overlap"), 0.) << sources;
      }
      EXPECT_EQ(report.at("uv").at("faces"), faces.size());
    }
}

TEST_F(Program, Logarithmic_chart)
{
  const std::string uv_file = " --uv " + file("uv.obj");
  for(const char* source : {"--source 3", "--source-point 2.5,0,0.1", "--source 3 --curve edges"})
  {
    const Json uv = torus_report(std::string("--parameterization logmap ") + source + uv_file).at("uv");
    EXPECT_EQ(uv.at("parameterization"), "logmap");
    EXPECT_GT(uv.at("faces"), 0);
    EXPECT_TRUE(uv.contains("flipped_faces"));
  }
  expect_failure(run_on_torus("--parameterization logmap --source 3 --source 200" + uv_file),
                 "--parameterization logmap takes one source, a point");
}

TEST_F(Program, Several_sources_with_other_distances)
{
  for(const char* solver : {"exact", "cgal-exact", "heat", "graph"})
    for(const char* curve : {"edges", "faces"})
    {
      const Json report = torus_report(std::string("--source 3 --source 200 --method laplacian --check --curve ") +
                                       curve + " --solver " + solver + " --cells " + file("cells.ply"));
      EXPECT_EQ(report.at("topology"), "right") << solver;
      EXPECT_EQ(report.at("cycles"), 3) << solver;
      EXPECT_LT(report.at("detour_max").get<double>(), 2.) << solver;
    }
  EXPECT_EQ(run_on_torus("--quiet --source 3 --source 200 --method laplacian --keep voronoi").status, 0);
  write("edges.txt", "40 41 42 43\n");
  for(const char* solver : {"exact", "cgal-exact", "heat", "graph"})
  {
    const Json report = torus_report(std::string("--source 200 --method laplacian --check --solver ") + solver +
                                     " --min-branch-edges 2 --source-edges " + file("edges.txt"));
    EXPECT_EQ(report.at("topology"), "right") << solver;
    EXPECT_EQ(report.at("curve"), "faces") << solver;
    EXPECT_LT(report.at("detour_max").get<double>(), 2.) << solver;
  }
  expect_failure(run_on_torus("--quiet --source-border --method laplacian"), "no border");
}

TEST_F(Program, Check_of_several_sources)
{
  for(const char* curve : {"edges", "faces"})
  {
    const Json report =
      torus_report(std::string("--source 3 --source 200 --source 77 --method polyhedral --check --curve ") + curve);
    EXPECT_EQ(report.at("topology"), "right");
    EXPECT_LT(report.at("detour_max").get<double>(), curve == std::string("faces") ? 1e-2 : 2.);
  }
}

TEST_F(Program, Curves_as_sources)
{
  // a rectangle of 3 x 1, in squares with two triangles each
  std::ostringstream text;
  text << "OFF\n124 180 0\n";
  for(int i = 0; i <= 30; ++i)
    for(int j = 0; j <= 3; ++j)
      text << 0.1 * i << ' ' << j / 3. << " 0\n";
  for(int i = 0; i < 30; ++i)
    for(int j = 0; j < 3; ++j)
    {
      const int a = 4 * i + j;
      text << "3 " << a << ' ' << a + 4 << ' ' << a + 5 << "\n3 " << a << ' ' << a + 5 << ' ' << a + 1 << '\n';
    }
  write("plate.off", text.str());
  const auto report = [&](const std::string& arguments)
  { return report_on("plate.off", "--method polyhedral " + arguments); };
  const auto axis = report("--source-border --check -o " + file("axis.png"));
  EXPECT_EQ(axis.at("topology"), "right");
  EXPECT_LT(axis.at("detour_max").get<double>(), 1e-2);
  EXPECT_NEAR(axis.at("length").get<double>(), 2. + 2. * std::sqrt(2.), 1e-3);
  EXPECT_EQ(axis.at("leaves"), 4);
  EXPECT_EQ(axis.at("curve"), "faces");

  // two sides in a file, and a vertex between them in another one
  write("sides.txt", "0 1 2\n2 3\n\n120 121 122 123\n");
  write("points.txt", "61\n");
  const auto mixed = report("--source-edges " + file("sides.txt") + " --sources " + file("points.txt") +
                            " --check -o " + file("mixed.vtp"));
  EXPECT_EQ(mixed.at("topology"), "right");
  EXPECT_LT(mixed.at("detour_max").get<double>(), 1e-2);
  ASSERT_EQ(mixed.at("sources").size(), 3u);
  EXPECT_EQ(mixed.at("sources").at(0), 61);
  EXPECT_LT(mixed.at("sources").at(1), 4);
  EXPECT_GE(mixed.at("sources").at(2), 120);
  expect_has(read_file(path("mixed.vtp")), "source2");

  expect_failures({{"--quiet --source-border", "no border"},
                   {"--source-border --unfold " + file("a.svg"), "--unfold takes one source"},
                   {"--source-border --min-branch-edges 3", "--min-branch-edges is for"},
                   {"--source-border --min-branch-edges 3 --curve faces", "--min-branch-edges is for"},
                   {"--sources " + file("nothing.txt"), "cannot read"}});
  write("near.txt", "0 4\n8 12\n");
  const std::string near = file("plate.off") + " --quiet --curve edges --source-edges " + file("near.txt");
  expect_failure(run(near), "sources 0 and 1 are one edge apart, which no curve of mesh edges crosses: refine the mesh "
                            "there; or ask for --curve faces");
  write("apart.txt", "1 200\n");
  expect_failure(run_on_torus("--quiet --source-edges " + file("apart.txt")), "no edge between");
}

TEST_F(Program, Unfolding)
{
  write("cube.off", "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n"
                    "3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  const std::string cube = file("cube.off") + " --source-point 0.5,0.5,0 --unfold ";
  // four arms around the face of the source; the diagonals are no folds
  Outcome outcome = run(cube + file("net.svg"));
  EXPECT_EQ(outcome.status, 0) << outcome.messages;
  expect_has(outcome.messages, "unfolding: 16 corners, 8 pairs of glued sides");
  const std::string svg = read_file(path("net.svg"));
  expect_has(svg, "</svg>");
  for(const char* label : {">1</text>", ">8</text>"})
  {
    const std::size_t first = svg.find(label);
    EXPECT_NE(first, std::string::npos) << label;
    EXPECT_NE(svg.find(label, first + 1), std::string::npos) << label << " once";
  }
  EXPECT_EQ(svg.find(">9</text>"), std::string::npos);

  outcome = run(cube + file("net.obj"));
  EXPECT_EQ(outcome.status, 0) << outcome.messages;
  std::istringstream obj(read_file(path("net.obj")));
  std::vector<std::array<double, 3>> points;
  double area = 0.;
  for(std::string key; obj >> key;)
    if(key == "v")
    {
      points.emplace_back();
      obj >> points.back()[0] >> points.back()[1] >> points.back()[2];
    }
    else if(key == "f")
    {
      std::array<std::size_t, 3> f;
      obj >> f[0] >> f[1] >> f[2];
      const auto &p = points.at(f[0] - 1), &q = points.at(f[1] - 1), &r = points.at(f[2] - 1);
      area += 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
    }
  EXPECT_NEAR(area, 6., 1e-9);

  expect_failure(run(cube + file("net.pdf")), ".svg or .obj");
  outcome = run_on_torus("--quiet --unfold " + file("torus.svg"));
  EXPECT_EQ(outcome.status, 1) << outcome.messages;
  expect_has(outcome.messages, "more than 360");
}

TEST_F(Program, Wrong_command_lines)
{
  expect_failures({{"--uv " + file("a.png"), "must be .obj"},
                   {"--uv " + file("a.obj") + " --parameterization flat", "--parameterization takes"},
                   {"--parameterization lscm", "--parameterization is for --uv"}});
  expect_failure(run(""), "there is no mesh");
  expect_failure(run("a.off b.off"), "one mesh at a time");
  expect_failures({{"--no-such-option", "no-such-option"},
                   {"--source", "source"},
                   {"--source one", "--source takes"},
                   {"--method laplace", "--method takes"}});
  for(const char* method : {"default", "polyhedral"})
    for(const char* solver : {"heat", "graph", "cgal-exact"})
      expect_failure(run_on_torus(std::string("--method ") + method + " --solver " + solver),
                     "needs the paths of --solver exact");
  expect_failures(
    {{"--method default --angle 1", "--angle is for --method laplacian"},
     {"--method default --policy grow", "--policy is for --method laplacian"},
     {"--angle 1", "--angle is for --method laplacian, and here the method is default"},
     {"--laplacian 1", "--laplacian is for --method laplacian"},
     {"--policy prune", "--policy is for --method laplacian"},
     {"--method laplacian --min-branch-gap 1", "--min-branch-gap is for --method default or polyhedral"},
     {"--solver heat --min-branch-width 0.1",
      "--min-branch-width is for --method default or polyhedral, and here the method is laplacian"},
     {"--min-branch-gap 3.5", "--min-branch-gap takes a number from 0 to 3.14159"},
     {"--min-branch-curvature 13", "--min-branch-curvature takes a number from 0 to 12.5"},
     {"--method laplacian --min-branch-curvature 1", "--min-branch-curvature is for --method default or polyhedral"}});
  for(const char* width : {"1.1", "5", "1e300"})
    expect_failure(run_on_torus(std::string("--min-branch-width ") + width),
                   "--min-branch-width takes a number from 0 to 1");
  for(const char* angle : {"3.1416", "9", "1e300"})
    expect_failure(run_on_torus(std::string("--method laplacian --angle ") + angle),
                   "--angle takes a number from 0 to 3.14159");
  expect_failures({{"--method laplacian --angle 0", "--angle takes an angle above 0"},
                   {"--min-branch-length 1e300", "--min-branch-length takes a number from 0 to 1000"},
                   {"--min-branch-width=-1", "--min-branch-width takes"}});
  for(const char* method : {"", "--method default ", "--method polyhedral "})
    expect_failure(run_on_torus(std::string(method) + "--smooth 4"), "--smooth is for --method laplacian");
  for(const char* error : {"-1", "0.2", "nan", "x"})
    expect_failure(run_on_torus(std::string("--max-relative-error=") + error), "--max-relative-error takes");
  expect_failures({{"--max-relative-error 0.001 --solver heat", "--max-relative-error is for --solver exact"},
                   {"--max-relative-error 0.001 --method polyhedral", "needs exact distances"},
                   {"--quiet --max-relative-error 0.001 --min-branch-width 0", "needs exact distances"},
                   {"--curve both", "--curve takes edges or faces"},
                   {"--method laplacian --curve edges --smooth 4", "contradict"},
                   {"--method laplacian --curve faces --smooth 0", "contradict"},
                   {"--strength 3", "there is no option --strength"},
                   {"--curve edges --curve faces", "--curve may be given once only"},
                   {"--quiet=3", "--quiet takes no value"},
                   {"--source", "--source takes a value"},
                   {"--curve=", "--curve takes a value"},
                   {"--source=-1", "--source takes"},
                   {"--quiet --source 99999", "out of range"},
                   {"--source-point 1,0,0 --source-point 0,1,0 --unfold " + file("a.svg"), "--unfold takes one source"},
                   {"--source 1 --source 2 --unfold " + file("a.svg"), "--unfold takes one source"},
                   {"--source 1 --quiet --unfold " + file("a.svg"), "others are flattened by --uv"},
                   {"--source 1 --source 2 --check --keep voronoi", "--check is about all"},
                   {"--keep some", "--keep takes all, voronoi or medial"},
                   {"--cells " + file("a.off"), "must be .ply, .vtp or .obj"},
                   {"--quiet --source 1 --source 1", "sources 0 and 1 are at the same point"},
                   {"--source-point 1,2", "three numbers"},
                   {"--source-point 1,2,3,4", "three numbers"},
                   {"--source-point 1,2,nan", "a number"},
                   {"--solver magic", "cgal-exact"},
                   {"--method laplacian --angle wide", "--angle takes"},
                   {"--method laplacian --angle=-1", "--angle takes"},
                   {"--method laplacian --laplacian inf", "--laplacian takes"},
                   {"--method laplacian --policy shrink", "--policy takes"},
                   {"--min-branch-edges 1.5", "--min-branch-edges takes"},
                   {"--min-branch-length=-2", "--min-branch-length takes"},
                   {"--repair some", "--repair takes weld, orient or none"},
                   {"--method laplacian --smooth 999999999", "--smooth takes at most"}});
}

TEST_F(Program, Wrong_outputs)
{
  expect_failures(
    {{"-o - --output-format jpg", "--output-format takes polylines.txt, obj, vtp, ply, json, png or svg, not 'jpg'"},
     {"-o - --edges -", "--edges would overwrite '-', which -o writes, too"},
     {"-o -x.obj", "write './-x.obj' if that is its name"}});
  for(const char* option : {"--cells", "--uv", "--unfold"})
    expect_failure(run_on_torus(option + std::string(" -")),
                   option + std::string(" takes the name of a file, not '-'"));
  expect_failures({{"-o ''", "empty"},
                   {"-o " + file("a.jpg"), ".polylines.txt"},
                   {"-o " + file("no/such/folder/a.obj"), "there is no folder"},
                   {"--edges " + quoted(folder_.string()), "is a folder"},
                   {"--report ''", "empty"},
                   {"--edges --quiet", "'--quiet'"},
                   {"--edges " + file("torus.off"), "overwrite"},
                   {"--report " + file("a.txt") + " --edges " + file("./a.txt"), "which --edges writes, too"}});
  write("vertices.txt", "1 13\n");
  for(const char* option : {"--sources ", "--source-edges "})
    for(const char* output : {"--edges ", "--report "})
      expect_failure(run_on_torus(option + file("vertices.txt") + " " + output + file("vertices.txt")),
                     "would overwrite");
  EXPECT_EQ(read_file(path("vertices.txt")), "1 13\n");
  // known before the mesh is read
  if(fs::exists("/proc/self"))
    for(const char* output : {"-o /proc/a.obj", "--edges /proc/a.txt", "--cells /proc/a.ply", "--uv /proc/a.obj",
                              "--unfold /proc/a.svg", "--report /proc/a.json"})
      expect_failure(run("none.off " + std::string(output)), "cannot write to '/proc/a");
  fs::create_hard_link(path("torus.off"), path("torus.obj"));
  expect_failure(run_on_torus("-o " + file("torus.obj")), "overwrite");
  EXPECT_EQ(run_on_torus("--quiet --edges /dev/null --report /dev/null").status, 0);
  if(fs::exists("/dev/full"))
    expect_failure(run_on_torus("--quiet --solver heat --report /dev/full"), "cannot write");
}

// A disk that is full is one on which no file may be longer than a block; a program that does not care is killed then.
TEST_F(Program, Outputs_are_the_old_or_the_new_ones)
{
  const std::vector<std::string> names = {"a.obj", "a.png", "a.ply", "e.txt", "c.ply",
                                          "s.vtp", "u.obj", "u.mtl", "u.png", "r.json"};
  const std::string outputs = "--quiet --source 5 -o " + file("a.obj") + " -o " + file("a.png") + " -o " +
                              file("a.ply") + " --edges " + file("e.txt") + " --cells " + file("c.ply") +
                              " --surface " + file("s.vtp") + " --uv " + file("u.obj") + " --report " + file("r.json");
  for(const std::string& name : names)
    write(name, "old\n");
  const auto number_of_files = [&]()
  { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); };
  const auto before = number_of_files();
  const Outcome full = run_on_torus(outputs, "trap '' XFSZ; ulimit -f 1; ");
  expect_failure(full, "cannot write to '" + path("a.obj"));
  EXPECT_EQ(number_of_files(), before);
  EXPECT_NE(run_on_torus(outputs, "ulimit -f 1; ").status, 0);
  for(const std::string& name : names)
    EXPECT_EQ(read_file(path(name)), "old\n") << name;
  for(const auto& file : fs::directory_iterator(folder_)) // what is left by the one that was killed
    if(file.path().filename().string().compare(0, 11, ".cut_locus_") == 0)
      fs::remove(file.path());

  fs::remove(path("e.txt"));
  fs::create_symlink("elsewhere.txt", path("e.txt"));
  write("elsewhere.txt", "old\n");
  fs::permissions(path("elsewhere.txt"), fs::perms(0640));
  EXPECT_EQ(run_on_torus(outputs).status, 0);
  for(const std::string& name : names)
    EXPECT_GT(read_file(path(name)).size(), 40u) << name;
  EXPECT_TRUE(fs::is_symlink(path("e.txt")));
  EXPECT_EQ(fs::status(path("elsewhere.txt")).permissions(), fs::perms(0640));
  EXPECT_EQ(number_of_files(), before + 1);
}

TEST_F(Program, Killed_at_any_moment_leaves_old_or_new_outputs)
{
  const std::vector<std::string> names = {"a.obj", "a.png", "e.txt", "c.ply", "u.obj", "u.png"};
  const std::string outputs = "--quiet --source 5 -o " + file("a.obj") + " -o " + file("a.png") + " --edges " +
                              file("e.txt") + " --cells " + file("c.ply") + " --uv " + file("u.obj");
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_on_torus(outputs).status, 0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::vector<std::string> whole;
  for(const std::string& name : names)
    whole.push_back(read_file(path(name)));
  std::size_t number_of_old = 0;
  for(double share = 0.1; share < 2.; share *= 1.35) // of a time that may be another one now
  {
    for(const std::string& name : names)
      write(name, "old\n");
    run_on_torus(outputs, "timeout -s KILL " + std::to_string(share * seconds) + " ");
    for(std::size_t k = 0; k < names.size(); ++k)
    {
      const std::string found = read_file(path(names[k]));
      EXPECT_TRUE(found == "old\n" || found == whole[k]) << names[k] << " has " << found.size() << " bytes";
      number_of_old += found == "old\n";
    }
  }
  EXPECT_GT(number_of_old, 0u);
}

TEST_F(Program, Cells_of_a_mesh_of_several_parts_have_finite_numbers)
{
  write("two.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n");
  for(const char* name : {"c.ply", "c.vtp"})
  {
    EXPECT_EQ(run(file("two.off") + " --quiet --source 0 --cells " + file(name)).status, 0);
    EXPECT_EQ(read_file(path(name)).find("inf"), std::string::npos) << name;
    EXPECT_EQ(read_file(path(name)).find("nan"), std::string::npos) << name;
  }
  expect_has(read_file(path("c.ply")), "\n5 1 0 -1\n");
}

TEST_F(Program, A_flat_mesh_is_seen_from_all_sides)
{
  for(const char* points :
      {"0 0 0\n1 0 0\n1 1 0\n0 1 0\n", "0 0 0\n0 1 0\n0 1 1\n0 0 1\n", "0 0 0\n0 0 1\n1 0 1\n1 0 0\n"})
  {
    write("flat.off", "OFF\n4 2 0\n" + std::string(points) + "3 0 1 2\n3 0 2 3\n");
    for(const char* view : {"0,0,1", "0,0,-1", "0,1,0", "0,-1,0", "1,0,0", "-1,0,0", "1,1,1"})
    {
      const Outcome outcome = run(file("flat.off") + " --quiet -o " + file("a.png") + " --view=" + view);
      EXPECT_EQ(outcome.status, 0) << view << " " << points << outcome.messages;
    }
  }
}
