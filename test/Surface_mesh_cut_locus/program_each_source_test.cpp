// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cut loci of many sources by the program, in parts and in threads.

#include "program_fixture.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

class Each_source : public Program
{
protected:
  void SetUp() override
  {
    Program::SetUp();
    write("sources.txt", "# vertices, and points\n1\n17\n\n 203 \n1.4, 0, 0\n-1.4 0 0\n88\n240\n");
  }

  std::string sources() const { return "--each-source " + file("sources.txt"); }

  std::string results(const std::string& name, const std::string& arguments) const
  {
    const Outcome outcome = run_on_torus(sources() + " --quiet -o " + file(name) + " " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.messages;
    EXPECT_EQ(outcome.messages, "");
    return read_file(path(name));
  }

  static std::vector<Json> lines(const std::string& text)
  {
    std::vector<Json> result;
    std::istringstream is(text);
    for(std::string line; std::getline(is, line);)
      result.push_back(Json::parse(line));
    return result;
  }
};

TEST_F(Each_source, All_parts_one_after_another_are_one_run)
{
  const std::string all = results("all.jsonl", "");
  EXPECT_EQ(lines(all).size(), 7u);
  for(int parts : {1, 2, 3, 7, 9}) // of nine two are empty
  {
    std::string joined;
    for(int part = 1; part <= parts; ++part)
      joined += results("part.jsonl", "--part " + std::to_string(part) + "/" + std::to_string(parts));
    EXPECT_EQ(joined, all) << parts << " parts";
  }
}

TEST_F(Each_source, Threads_find_the_same)
{
  EXPECT_EQ(results("threads.jsonl", "--threads 0"), results("one.jsonl", ""));
  for(const char* method : {"--method polyhedral", "--method laplacian --curve faces", "--max-relative-error 1e-3"})
    EXPECT_EQ(results("threads.jsonl", std::string("--threads 0 ") + method), results("one.jsonl", method)) << method;
}

TEST_F(Each_source, A_line_tells_what_a_run_for_this_source_tells)
{
  const std::vector<Json> all = lines(results("all.jsonl", ""));
  ASSERT_EQ(all.size(), 7u);
  EXPECT_EQ(all[2]["source"], 203);
  EXPECT_EQ(all[3]["source"], Json({1.4, 0., 0.}));
  for(std::size_t i : {std::size_t(2), std::size_t(3)})
  {
    const std::string source = i == 2 ? "--source 203" : "--source-point 1.4,0,0";
    ASSERT_EQ(run_on_torus(source + " --curve faces --quiet --report " + file("report.json")).status, 0);
    const Json report = json("report.json");
    for(const char* figure : {"edges", "cycles", "leaves", "branchings", "length", "injectivity_radius", "farthest",
                              "farthest_distance", "farthest_point", "farthest_point_distance"})
      EXPECT_EQ(all[i][figure], report[figure]) << figure;
  }
  std::size_t number_of_edges = 0;
  for(const Json& polyline : all[2]["polylines"])
    number_of_edges += polyline.size() - 1;
  EXPECT_EQ(number_of_edges, all[2]["edges"]);
}

TEST_F(Each_source, The_report_names_the_smallest_and_the_largest_injectivity_radius)
{
  const std::vector<Json> all = lines(results("all.jsonl", "--report " + file("report.json")));
  const Json report = json("report.json");
  EXPECT_EQ(report["sources"], 7);
  EXPECT_EQ(report["failed"], 0);
  EXPECT_EQ(report["part"], Json({1, 1}));
  double smallest = 1e9, largest = 0.;
  for(const Json& line : all)
  {
    smallest = std::min(smallest, line["injectivity_radius"].get<double>());
    largest = std::max(largest, line["injectivity_radius"].get<double>());
  }
  EXPECT_EQ(report["smallest_injectivity_radius"]["injectivity_radius"], smallest);
  EXPECT_EQ(report["largest_injectivity_radius"]["injectivity_radius"], largest);
}

// The lines that are there are marked, to see that they stay.
TEST_F(Each_source, What_was_stopped_goes_on)
{
  const std::string all = results("all.jsonl", "");
  std::size_t end = 0;
  for(int i = 0; i < 3; ++i)
    end = all.find('\n', end) + 1;
  std::string known = all.substr(0, end);
  known.insert(1, "\"mark\":1,");
  for(const char* name : {"stopped.jsonl.part", "stopped.jsonl"})
    for(const std::size_t more : {std::size_t(0), std::size_t(40), all.find('\n', end) - end}) // of the next line
    {
      write(name, known + all.substr(end, more));
      EXPECT_EQ(results("stopped.jsonl", "--threads 0 --report " + file("report.json")), known + all.substr(end));
      EXPECT_FALSE(fs::exists(path("stopped.jsonl.part")));
      const Json report = json("report.json");
      EXPECT_EQ(report["sources"], 7);
      EXPECT_FALSE(report["smallest_injectivity_radius"].is_null());
      fs::remove(path("stopped.jsonl"));
    }
  // those of another run are not
  for(const char* option : {"--method polyhedral", "--min-branch-width 0.3"})
  {
    write("stopped.jsonl.part", known);
    EXPECT_EQ(results("stopped.jsonl", option), results("other.jsonl", option));
  }
  write("stopped.jsonl.part", "[]\n{\"run\":1}\n");
  EXPECT_EQ(results("stopped.jsonl", ""), all);
}

TEST_F(Each_source, A_full_disk_ends_the_run_at_once_and_leaves_the_old_file)
{
  write("x.jsonl", "old\n");
  const std::string arguments = sources() + " --quiet -o " + file("x.jsonl");
  expect_failure(run_on_torus(arguments, "trap '' XFSZ; ulimit -f 10; "), "cannot write to");
  EXPECT_EQ(read_file(path("x.jsonl")), "old\n");
  EXPECT_GT(fs::file_size(path("x.jsonl.part")), 0u);
  EXPECT_EQ(run_on_torus(arguments).status, 0);
  EXPECT_EQ(read_file(path("x.jsonl")), results("all.jsonl", ""));
}

// Looks at the program while it runs: more threads than one stay until its end.
TEST_F(Each_source, One_thread_is_one)
{
  if(!fs::exists("/proc/self/status"))
    GTEST_SKIP() << "threads can not be counted here";
  std::ostringstream many; // so that it can be seen running
  for(int v = 1; v < number_of_vertices_; ++v)
    many << v << '\n';
  write("sources.txt", many.str());
  for(const std::string method : {"laplacian", "default"})
  {
    const Outcome outcome =
      run_on_torus(sources() + " -o " + file("x.jsonl") + " --quiet --threads 1 --method " + method +
                   " > /dev/null & p=$!; while kill -0 $p; do grep Threads: /proc/$p/status; done 2> /dev/null; true");
    std::istringstream words(outcome.messages);
    int number_of_looks = 0;
    for(std::string word; words >> word;)
      if(word == "Threads:" && words >> word)
      {
        EXPECT_EQ(word, "1") << method;
        ++number_of_looks;
      }
    EXPECT_GT(number_of_looks, 0);
  }
}

TEST_F(Each_source, Wrong_sources_and_options)
{
  const std::string output = " -o " + file("x.jsonl");
  expect_failure(run_on_torus(sources()), "-o FILE.jsonl");
  expect_failure(run_on_torus(sources() + " -o " + file("x.obj")), "-o FILE.jsonl");
  expect_failure(run_on_torus(sources() + output + " --source 3"), "exclude each other");
  expect_failure(run_on_torus("--part 1/2"), "--part is for --each-source");
  for(const char* part : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "a/b", "1/0"})
    expect_failure(run_on_torus(sources() + output + " --part " + part), "--part takes");
  expect_failure(run_on_torus("--quiet --each-source " + file("none.txt") + output), "cannot read");
  const auto refuse = [&](const std::string& text, const std::string& part)
  {
    write("wrong.txt", text);
    expect_failure(run_on_torus("--quiet --each-source " + file("wrong.txt") + output), part);
  };
  refuse("", "empty");
  refuse("1\n2 3\n", "line 2 of");
  refuse("-1\n", "line 1 of");
  refuse("nan 0 0\n", "line 1 of");
  refuse("1\n99999\n", "99999 is out of range");
  refuse("0\n", "isolated vertex");
  for(const char* name : {"x.jsonl", "x.jsonl.part"})
  {
    write(name, "1\n");
    expect_failure(run_on_torus("--each-source " + file(name) + output), "would overwrite");
  }
}

} // namespace
