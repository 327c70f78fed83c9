// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "each_source.h"
#include "output_file.h"
#include "report_json.h"
#include "thresholds.h"

#include <CGAL/Cut_loci/extract_polylines.h>
#include <CGAL/Cut_loci/internal/transform_in_order.h>
#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/tags.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <new>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

using Source = Cut_locus_solver::Source;

constexpr bool may_have_threads = std::is_same<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value;

// A source as the file has it: the number of a vertex, or a point.
using Named_source = std::variant<std::size_t, std::array<double, 3>>;

Named_source parse_source(std::string line, const std::string& where)
{
  for(char& c : line)
    if(c == ',' || c == '\r')
      c = ' ';
  std::istringstream words(line);
  std::vector<std::string> numbers;
  for(std::string word; words >> word;)
    numbers.push_back(word);
  if(numbers.size() == 1)
    return to_count(numbers[0], where);
  if(numbers.size() != 3)
    throw Usage_error(where + " takes the number of a vertex or a point x,y,z, not '" + line + "'");
  return std::array<double, 3>{
    {to_number(numbers[0], where), to_number(numbers[1], where), to_number(numbers[2], where)}};
}

// Empty lines and those that start with # are passed over.
std::vector<Named_source> read_sources(const std::string& filename)
{
  std::ifstream is(filename);
  std::vector<Named_source> sources;
  std::size_t number = 0;
  for(std::string line; std::getline(is, line);)
  {
    ++number;
    if(line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#')
      sources.push_back(parse_source(line, "--each-source: line " + std::to_string(number) + " of " + filename));
  }
  if(is.bad() || number == 0)
    throw Usage_error("--each-source: cannot read '" + filename + "', or it is empty");
  return sources;
}

// The sources of one part, which follow each other in the file: the results of all parts, one after another, are those of
// one run.
std::vector<Named_source> part_of(const std::vector<Named_source>& sources, std::size_t part, std::size_t parts)
{
  const auto begin = [&](std::size_t i) { return sources.begin() + std::ptrdiff_t(sources.size() * i / parts); };
  return {begin(part - 1), begin(part)};
}

Source find_source(const Named_source& named, const Input_mesh& input)
{
  if(const std::size_t* const number = std::get_if<std::size_t>(&named))
    return find_vertex(*number, input, "--each-source");
  const auto& p = std::get<1>(named);
  return closest_location(input.mesh, Kernel::Point_3(p[0], p[1], p[2]));
}

// What a line tells, and what the report keeps of it.
struct Source_result
{
  Json line;
  double injectivity_radius = std::numeric_limits<double>::infinity();
  bool is_found = false;
};

Json to_json(const std::vector<std::vector<Kernel::Point_3>>& polylines)
{
  Json result = Json::array();
  for(const auto& polyline : polylines)
  {
    result.push_back(Json::array());
    for(const Kernel::Point_3& p : polyline)
      result.back().push_back({p.x(), p.y(), p.z()});
  }
  return result;
}

Source_result describe(const Cut_locus& cut_locus, const Input_mesh& input, Json line)
{
  const CGAL::Cut_loci::Cut_locus_statistics statistics = CGAL::Cut_loci::compute_statistics(cut_locus);
  add_farthest(line, input, cut_locus);
  line["edges"] = statistics.edges;
  line["cycles"] = statistics.cycles;
  line["leaves"] = statistics.leaves;
  line["branchings"] = statistics.branchings;
  line["length"] = statistics.length;
  line["injectivity_radius"] = statistics.injectivity_radius;
  line["injectivity_lower_bound"] = statistics.injectivity_lower_bound;
  line["polylines"] = to_json(CGAL::Cut_loci::extract_polylines(cut_locus));
  return {line, statistics.injectivity_radius, true};
}

// What all lines depend on. Its number tells those of other runs.
struct Run
{
  Run(const Options& o, const Input_mesh& i) : options(o), input(i)
  {
    Json all;
    add_method(all, options, curve_of(options));
    add_parameters(all, options);
    std::size_t seed = 0;
    for(Mesh::Vertex_index v : input.mesh.vertices())
      for(int k = 0; k < 3; ++k)
        boost::hash_combine(seed, input.mesh.point(v)[k]);
    for(Mesh::Halfedge_index h : input.mesh.halfedges())
      boost::hash_combine(seed, std::size_t(input.mesh.target(h)));
    boost::hash_combine(seed, all.dump());
    id = std::to_string(seed);
  }

  const Options& options;
  const Input_mesh& input;
  std::string id;
};

Json to_json(const Named_source& named)
{
  return std::visit([](const auto& value) { return Json(value); }, named);
}

// Beside the computed ones, as a run over many sources is not worth less for one that failed.
Source_result compute(const Named_source& named, const Source& source, const Run& run, Cut_locus_solver& solver)
{
  const Options& options = run.options;
  Json line = {{"source", to_json(named)}, {"run", run.id}};
  try
  {
    solver.set_sources(std::array<Source, 1>{{source}},
                       CGAL::parameters::maximum_relative_error(options.maximum_relative_error.value_or(0.)));
    return describe(apply_thresholds(options, solver), run.input, line);
  }
  catch(const std::bad_alloc&)
  {
    throw;
  }
  catch(const std::exception& error)
  {
    line["error"] = error.what();
    return {line, std::numeric_limits<double>::infinity(), false};
  }
}

// Of all sources of a part.
struct Summary
{
  std::size_t failed = 0;
  Json smallest, largest; // injectivity radius, and the source that has it

  void add(const Source_result& result)
  {
    if(!result.is_found)
    {
      ++failed;
      return;
    }
    const Json entry = {{"source", result.line["source"]}, {"injectivity_radius", result.injectivity_radius}};
    if(smallest.is_null() || result.injectivity_radius < smallest["injectivity_radius"])
      smallest = entry;
    if(largest.is_null() || result.injectivity_radius > largest["injectivity_radius"])
      largest = entry;
  }
};

// What there is of a run that was stopped.
struct Earlier_lines
{
  std::size_t number = 0;
  std::uintmax_t bytes = 0;
  Summary summary;
};

// Lines that are complete, as far as they are those of this run.
Earlier_lines read_earlier_lines(const std::string& filename, const std::vector<Named_source>& named, const Run& run)
{
  Earlier_lines result;
  if(is_device(filename))
    return result;
  std::ifstream is(filename, std::ios_base::binary);
  for(std::string text; result.number < named.size() && std::getline(is, text) && !is.eof(); ++result.number)
  {
    const Json line = Json::parse(text, nullptr, false);
    if(!line.is_object() || !line.contains("run") || line["run"] != run.id || !line.contains("source") ||
       line["source"] != to_json(named[result.number]))
      break;
    const bool is_found = line.contains("injectivity_radius");
    const Json radius = is_found ? line["injectivity_radius"] : Json();
    result.summary.add(
      {line, radius.is_number() ? radius.get<double>() : std::numeric_limits<double>::infinity(), is_found});
    result.bytes += text.size() + 1;
  }
  return result;
}

// The file of results gets its name once it is complete: until then it has the lines that are there.
class Results_file
{
public:
  Results_file(const std::vector<Named_source>& named, const Run& run)
    : target_(run.options.outputs.front()), part_(is_device(target_) ? target_ : part_of_results(run.options))
  {
    namespace fs = std::filesystem;
    earlier_ = read_earlier_lines(part_, named, run);
    const Earlier_lines of_target = read_earlier_lines(target_, named, run);
    if(of_target.number > earlier_.number)
    {
      earlier_ = of_target;
      fs::copy_file(target_, part_, fs::copy_options::overwrite_existing);
    }
    errno = 0;
    if(earlier_.number > 0)
      fs::resize_file(part_, earlier_.bytes);
    os_.open(part_, std::ios_base::binary | (earlier_.number > 0 ? std::ios_base::app : std::ios_base::trunc));
    if(!os_)
      throw_not_written(part_);
  }

  const Earlier_lines& earlier() const { return earlier_; }

  void write(const Json& line)
  {
    os_ << line.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl; // so that it is not lost
    if(!os_)
      throw_not_written(part_);
  }

  void finish()
  {
    os_.close();
    if(part_ != target_)
      std::filesystem::rename(part_, target_);
  }

private:
  std::string target_, part_;
  Earlier_lines earlier_;
  std::ofstream os_;
};

void write_report_of_sources(const Options& options, const Input_mesh& input, std::size_t number,
                             const Summary& summary, const Progress& progress)
{
  Json report;
  report["mesh"] = options.mesh;
  report["vertices"] = input.mesh.number_of_vertices();
  report["faces"] = input.mesh.number_of_faces();
  report["each_source"] = options.each_source;
  report["part"] = {options.part, options.number_of_parts};
  report["sources"] = number;
  report["failed"] = summary.failed;
  report["smallest_injectivity_radius"] = summary.smallest;
  report["largest_injectivity_radius"] = summary.largest;
  add_method(report, options, curve_of(options));
  report["threads"] = options.threads;
  for(const auto& [stage, seconds] : progress.seconds())
    report["seconds"][stage] = seconds;
  write_json(options.report, report);
}

} // namespace

bool compute_each_source(const Options& options, const Input_mesh& input, Cut_locus_solver& solver, Progress& progress)
{
  std::vector<Named_source> named = part_of(read_sources(options.each_source), options.part, options.number_of_parts);
  std::vector<Source> sources;
  for(const Named_source& source : named)
    sources.push_back(find_source(source, input));
  const std::size_t number = sources.size();
  const Run run(options, input);
  Results_file file(named, run);
  const auto kept = static_cast<std::ptrdiff_t>(file.earlier().number);
  named.erase(named.begin(), named.begin() + kept);
  sources.erase(sources.begin(), sources.begin() + kept);
  Summary summary = file.earlier().summary;
  const auto write = [&](const Source_result& result)
  {
    file.write(result.line);
    summary.add(result);
  };
  const auto compute_all = [&]()
  {
    solver.prepare(sources);
    CGAL::Cut_loci::internal::Copy_pool<Cut_locus_solver> pool(solver);
    const auto compute_one = [&](std::size_t i)
    {
      auto copy = pool.take();
      Source_result result = compute(named[i], sources[i], run, *copy);
      pool.give_back(std::move(copy));
      return result;
    };
    if(options.threads > 1)
      CGAL::Cut_loci::internal::transform_in_order<may_have_threads>(sources.size(), compute_one, write);
    else
      CGAL::Cut_loci::internal::transform_in_order<false>(sources.size(), compute_one, write);
  };
  if(!sources.empty())
    progress.run("sources", compute_all);
  file.finish();
  if(!options.report.empty())
    write_report_of_sources(options, input, number, summary, progress);
  if(!options.is_quiet)
    std::cerr << input.mesh.number_of_faces() << " faces; part " << options.part << " of " << options.number_of_parts
              << ": " << number << " sources, " << kept << " of them known from an earlier run" << std::endl;
  if(summary.failed > 0)
    std::cerr << "cut_locus: " << summary.failed << " of " << number
              << " sources failed: see the lines with \"error\" in '" << options.outputs.front() << "'" << std::endl;
  return summary.failed == 0;
}
