// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Runs the program as a user would, in a folder of its own.

#ifndef SURFACE_MESH_CUT_LOCUS_TEST_PROGRAM_FIXTURE_H
#define SURFACE_MESH_CUT_LOCUS_TEST_PROGRAM_FIXTURE_H

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Outcome
{
  int status = -1;
  std::string messages; // both streams
};

inline std::string quoted(const std::string& text)
{
  return "'" + text + "'";
}

inline std::string read_file(const fs::path& path)
{
  std::ifstream is(path, std::ios_base::binary);
  return std::string((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
}

inline void expect_has(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text << "does not contain: " << part;
}

inline std::size_t number_of(const std::string& part, const std::string& text)
{
  std::size_t n = 0;
  for(std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1))
    ++n;
  return n;
}

class Program : public ::testing::Test
{
protected:
  using Triangle = std::array<int, 3>;

  void SetUp() override
  {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(::testing::TempDir()) / ("cut_locus_program_" + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write_torus();
  }

  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  // `before` is what the shell does first; `arguments` may have redirections of their own
  Outcome run(const std::string& arguments, const std::string& before = "") const
  {
    Outcome outcome;
    const std::string command = before + "2>&1 < /dev/null " + quoted(CUT_LOCUS_PROGRAM) + " " + arguments;
    FILE* const pipe = popen(command.c_str(), "r");
    if(pipe == nullptr)
      return outcome;
    std::array<char, 4096> buffer;
    for(std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
      outcome.messages.append(buffer.data(), n);
    const int status = pclose(pipe);
    if(WIFEXITED(status))
      outcome.status = WEXITSTATUS(status);
    return outcome;
  }

  Outcome run_on_torus(const std::string& arguments, const std::string& before = "") const
  {
    return run(quoted(path("torus.off")) + " " + arguments, before);
  }

  // the name of a file in the folder, as the shell takes it
  std::string file(const std::string& name) const { return quoted(path(name)); }

  Json json(const std::string& name) const { return Json::parse(read_file(path(name))); }

  // what `--report` writes
  Json report_on(const std::string& mesh, const std::string& arguments = "") const
  {
    const Outcome outcome = run(file(mesh) + " --quiet " + arguments + " --report " + file("report.json"));
    EXPECT_EQ(outcome.status, 0) << mesh << ' ' << arguments << ": " << outcome.messages;
    return outcome.status == 0 ? json("report.json") : Json();
  }

  Json torus_report(const std::string& arguments) const { return report_on("torus.off", arguments); }

  // One line that starts with the program's name and holds `part`.
  void expect_failure(const Outcome& outcome, const std::string& part) const
  {
    EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << outcome.status << "\n" << outcome.messages;
    EXPECT_EQ(outcome.messages.compare(0, 11, "cut_locus: "), 0) << outcome.messages;
    expect_has(outcome.messages, part);
    EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 1) << outcome.messages;
    EXPECT_EQ(outcome.messages.find("::"), std::string::npos) << outcome.messages << "has words of C++";
  }

  // runs on the torus that fail, each with its message
  void expect_failures(const std::vector<std::pair<std::string, std::string>>& runs) const
  {
    for(const auto& [arguments, part] : runs)
    {
      SCOPED_TRACE(arguments);
      expect_failure(run_on_torus(arguments), part);
    }
  }

  fs::path folder_;
  int number_of_vertices_ = 0;
  std::vector<Triangle> triangles_;

private:
  // Vertex 0 is isolated: it keeps its number.
  void write_torus()
  {
    const int n = 24, m = 12;
    std::ostringstream text;
    text.precision(17);
    number_of_vertices_ = n * m + 1;
    text << "OFF\n" << number_of_vertices_ << ' ' << 2 * n * m << " 0\n9 9 9\n";
    const double pi = std::acos(-1.);
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < m; ++j)
      {
        const double u = 2. * pi * i / n, w = 2. * pi * (j + 0.1 * std::sin(5. * i)) / m, r = 1. + 0.4 * std::cos(w);
        text << r * std::cos(u) << ' ' << r * std::sin(u) << ' ' << 0.4 * std::sin(w) << '\n';
      }
    const auto vertex = [&](int i, int j) { return 1 + (i % n) * m + j % m; };
    triangles_.clear();
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < m; ++j)
      {
        triangles_.push_back({{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)}});
        triangles_.push_back({{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)}});
      }
    for(const Triangle& t : triangles_)
      text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    write("torus.off", text.str());
  }
};

#endif // SURFACE_MESH_CUT_LOCUS_TEST_PROGRAM_FIXTURE_H
