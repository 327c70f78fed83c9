// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Options.h"
#include "cells.h"
#include "file_checks.h"
#include "flatten.h"
#include "generated_texts.h"
#include "option_descriptions.h"
#include "output.h"
#include "output_file.h"
#include "solvers.h"
#include "threads.h"
#include "unfolding.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace po = boost::program_options;

// Numbers are read as text, so that a message can quote what was given: the library takes -1 for an unsigned number.
double to_number(const std::string& text, const std::string& option)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if(text.empty() || *end != '\0' || !std::isfinite(value))
    throw Usage_error(option + " takes a number, not '" + text + "'");
  return value;
}

std::size_t to_count(const std::string& text, const std::string& option)
{
  if(text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
    throw Usage_error(option + " takes a whole number from 0 to 999999999, not '" + text + "'");
  return std::strtoul(text.c_str(), nullptr, 10);
}

std::string part_of_results(const Options& options)
{
  return options.outputs.front() + ".part";
}

namespace {

constexpr std::size_t maximum_smoothing = 1000;

constexpr double pi = 3.14159265358979323846;

double to_number_in_range(const std::string& text, const std::string& option, double largest)
{
  const double value = to_number(text, option);
  if(value < 0. || value > largest)
  {
    std::ostringstream range;
    range << option << " takes a number from 0 to " << largest << ", not '" << text << "'";
    throw Usage_error(range.str());
  }
  return value;
}

std::array<double, 3> to_point(const std::string& text, const std::string& option)
{
  std::vector<std::string> parts(1);
  for(char c : text)
    if(c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  if(parts.size() != 3)
    throw Usage_error(option + " takes three numbers x,y,z, not '" + text + "'");
  return {{to_number(parts[0], option), to_number(parts[1], option), to_number(parts[2], option)}};
}

// The numbers of each line of a file.
std::vector<std::vector<std::size_t>> read_numbers(const std::string& filename, const std::string& option)
{
  std::ifstream is(filename);
  if(!is)
    throw Usage_error(option + ": cannot read '" + filename + "'");
  std::vector<std::vector<std::size_t>> result;
  for(std::string line, word; std::getline(is, line);)
  {
    std::istringstream words(line);
    std::vector<std::size_t> numbers;
    while(words >> word)
      numbers.push_back(to_count(word, option + " '" + filename + "'"));
    if(!numbers.empty())
      result.push_back(numbers);
  }
  if(result.empty())
    throw Usage_error(option + ": there are no numbers in '" + filename + "'");
  return result;
}

void check_output_path(const std::string& path, const std::string& option)
{
  namespace fs = std::filesystem;
  if(path.empty())
    throw Usage_error(option + " takes the name of a file, not an empty one");
  if(path[0] == '-')
    throw Usage_error(option + " takes the name of a file, not '" + path + "': write './" + path +
                      "' if that is its name");
  const fs::path folder = fs::path(path).parent_path();
  std::error_code ignored;
  if(!folder.empty() && !fs::is_directory(folder, ignored))
    throw Usage_error(option + ": there is no folder '" + folder.string() + "' to write to");
  if(fs::is_directory(path, ignored))
    throw Usage_error(option + ": '" + path + "' is a folder");
  if(const std::string cause = cause_not_writable(path); !cause.empty())
    throw Usage_error(option + ": cannot write to '" + path + "': " + cause);
}

// An output that may be `-`, standard output.
std::string to_output(const std::string& path, const std::string& option)
{
  if(path != standard_stream)
    check_output_path(path, option);
  return path;
}

// No output may replace what is read, nor another output.
void check_overwriting(const po::variables_map& given, const Options& options)
{
  namespace fs = std::filesystem;
  std::vector<std::pair<fs::path, std::string>> outputs;
  for(const std::string& output : options.outputs)
    outputs.emplace_back(is_standard_output(output) ? standard_stream : output, "-o");
  for(const auto& [path, option] :
      {std::make_pair(options.edges, "--edges"), std::make_pair(options.cells, "--cells"),
       std::make_pair(options.surface, "--surface"), std::make_pair(options.uv, "--uv"),
       std::make_pair(options.unfold, "--unfold"), std::make_pair(options.report, "--report")})
    if(!path.empty())
      outputs.emplace_back(path, option);
  if(!options.uv.empty()) // it has two files more
    for(const char* extension : {".mtl", ".png"})
    {
      outputs.emplace_back(fs::path(options.uv).replace_extension(extension), "--uv");
      check_output_path(outputs.back().first.string(), "--uv");
    }
  if(!options.each_source.empty())
    outputs.emplace_back(part_of_results(options), "-o");
  const auto is_same = [](const fs::path& a, const fs::path& b)
  {
    std::error_code error;
    return fs::equivalent(a, b, error) || fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
  };
  std::vector<std::pair<fs::path, std::string>> earlier;
  if(options.mesh != standard_stream)
    earlier.emplace_back(options.mesh, "the mesh");
  for(const std::string name : {"sources", "source-edges", "each-source"})
    if(given.count(name))
      earlier.emplace_back(given[name].as<std::string>(), "the file of --" + name);
  for(const auto& [path, option] : outputs)
  {
    std::error_code error;
    const bool is_device = fs::exists(path, error) && !fs::is_regular_file(path, error); // takes several
    for(const auto& [other, what] : earlier)
      if(!is_device && is_same(path, other))
        throw Usage_error(option + " would overwrite '" + path.string() + "', " + what);
    earlier.emplace_back(path, "which " + option + " writes, too");
  }
}

void read_method(const std::string& name, Options& options)
{
  using CGAL::Cut_loci::Method;
  if(name == "auto")
    options.method = default_method(options.solver);
  else if(name == "direction")
    options.method = Method::DIRECTION;
  else if(name == "polyhedral")
    options.method = Method::POLYHEDRAL;
  else if(name == "laplacian")
    options.method = Method::LAPLACIAN;
  else
    throw Usage_error("--method takes auto, direction, laplacian or polyhedral, not '" + name + "'");
  options.method_name = options.method == Method::DIRECTION   ? "direction"
                        : options.method == Method::LAPLACIAN ? "laplacian"
                                                              : "polyhedral";
  if(options.method != Method::LAPLACIAN && options.solver != "exact")
    throw Usage_error("--method " + name + " needs the paths of --solver exact");
}

// An option of another method would be ignored.
void check_options_of_method(const po::variables_map& given, const Options& options)
{
  using CGAL::Cut_loci::Method;
  const auto refuse = [&](const char* option, const std::string& methods)
  {
    if(given.count(option))
      throw Usage_error(std::string("--") + option + " is for --method " + methods + ", and here the method is " +
                        options.method_name + (given["method"].defaulted() ? ", the default for these distances" : ""));
  };
  if(options.method != Method::LAPLACIAN)
    for(const char* option : {"angle", "laplacian", "policy"})
      refuse(option, "laplacian");
  if(options.method != Method::LAPLACIAN && given.count("smooth"))
    throw Usage_error("--smooth is for --method laplacian: the method " + options.method_name +
                      " needs no smoothing, --curve faces gives its curve through the faces");
  if(options.method == Method::LAPLACIAN)
    for(const char* option : {"min-branch-gap", "min-branch-width", "min-branch-curvature"})
      refuse(option, "direction or polyhedral");
}

void read_maximum_relative_error(const std::string& text, Options& options)
{
  const double error = to_number_in_range(text, "--max-relative-error", 0.1);
  if(options.solver != "exact")
    throw Usage_error("--max-relative-error is for --solver exact");
  if(options.method == CGAL::Cut_loci::Method::POLYHEDRAL)
    throw Usage_error("--max-relative-error: --method polyhedral needs exact distances");
  options.maximum_relative_error = error;
}

Repair to_repair(const std::string& name)
{
  if(name == "weld" || name == "auto") // as it was called before
    return Repair::WELD;
  if(name != "orient" && name != "none")
    throw Usage_error("--repair takes weld, orient or none, not '" + name + "'");
  return name == "orient" ? Repair::ORIENT : Repair::NONE;
}

std::string to_input_format(const std::string& name)
{
  std::string list;
  for(const std::string& format : input_formats())
  {
    if(name == format)
      return name;
    list += " " + format;
  }
  throw Usage_error("--input-format takes one of" + list + ", not '" + name + "'");
}

Kept_part to_part(const std::string& name)
{
  if(name == "voronoi")
    return Kept_part::VORONOI;
  if(name == "medial")
    return Kept_part::MEDIAL;
  if(name != "all")
    throw Usage_error("--keep takes all, voronoi or medial, not '" + name + "'");
  return Kept_part::ALL;
}

// "2/10"
void read_part(const std::string& text, Options& options)
{
  const std::size_t slash = text.find('/');
  if(slash != std::string::npos)
  {
    options.part = to_count(text.substr(0, slash), "--part");
    options.number_of_parts = to_count(text.substr(slash + 1), "--part");
  }
  if(slash == std::string::npos || options.part < 1 || options.part > options.number_of_parts)
    throw Usage_error("--part takes the number of a part and that of all, from 1/N to N/N, not '" + text + "'");
}

// What many sources take, and what they do not.
void read_each_source(const po::variables_map& given, Options& options)
{
  const auto text = [&](const char* name) { return given[name].as<std::string>(); };
  if(given.count("each-source") == 0)
  {
    if(given.count("part"))
      throw Usage_error("--part is for --each-source");
    return;
  }
  options.each_source = text("each-source");
  for(const char* name :
      {"source", "source-point", "edges", "cells", "surface", "uv", "unfold", "check", "check-completeness", "view"})
    if(given.count(name) && !given[name].defaulted())
      throw Usage_error("--each-source and --" + std::string(name) + " exclude each other");
  if(given.count("part"))
    read_part(text("part"), options);
  if(options.outputs.size() != 1 || std::filesystem::path(options.outputs.front()).extension() != ".jsonl")
    throw Usage_error("--each-source takes one file for its results, -o FILE.jsonl");
}

void read_curve(const std::string& name, Options& options)
{
  using CGAL::Cut_loci::Curve;
  if(name != "edges" && name != "faces")
    throw Usage_error("--curve takes edges or faces, not '" + name + "'");
  options.curve = name == "edges" ? Curve::MESH_EDGES : Curve::THROUGH_FACES;
  if(options.smoothing && (*options.smoothing > 0) != (options.curve == Curve::THROUGH_FACES))
    throw Usage_error("--curve " + name + " and --smooth " + std::to_string(*options.smoothing) +
                      " contradict each other: smoothing gives a curve through the faces");
}

} // namespace

Options parse_command_line(int argc, char* argv[])
{
  po::options_description all = all_options();
  all.add_options()("mesh", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("mesh", -1);
  po::variables_map given;
  try
  {
    namespace style = po::command_line_style;
    // no guessing: a prefix that is unique today may not be tomorrow
    po::store(po::command_line_parser(argc, argv)
                .options(all)
                .positional(positional)
                .style(style::default_style & ~style::allow_guessing)
                .run(),
              given);
    po::notify(given);
  }
  catch(const po::error& error)
  {
    throw Usage_error(error.what());
  }

  Options options;
  for(const auto& [name, text] :
      {std::make_pair("help", help), std::make_pair("help-all", help_on_all), std::make_pair("version", version)})
    if(given[name].as<bool>())
    {
      options.text = text();
      return options;
    }
  if(given.count("generate"))
  {
    const std::string what = given["generate"].as<std::string>();
    if(what != "man" && what != "completion")
      throw Usage_error("--generate takes man or completion, not '" + what + "'");
    options.text = what == "man" ? man_page() : bash_completion();
    return options;
  }
  options.is_quiet = given["quiet"].as<bool>();
  options.check_completeness = given["check-completeness"].as<bool>();
  options.check = options.check_completeness || given["check"].as<bool>();

  const auto text = [&](const char* name) { return given[name].as<std::string>(); };
  if(!given.count("mesh"))
    throw Usage_error("there is no mesh: cut_locus --help tells how to use the program");
  const std::vector<std::string> meshes = given["mesh"].as<std::vector<std::string>>();
  if(meshes.size() != 1)
    throw Usage_error("one mesh at a time: '" + meshes[1] + "' is too much");
  options.mesh = meshes.front();
  if(given.count("input-format"))
    options.input_format = to_input_format(text("input-format"));
  options.repair = to_repair(text("repair"));
  if(given.count("source"))
    for(const std::string& source : given["source"].as<std::vector<std::string>>())
      options.sources.push_back(to_count(source, "--source"));
  if(given.count("source-point"))
    for(const std::string& point : given["source-point"].as<std::vector<std::string>>())
      options.source_points.push_back(to_point(point, "--source-point"));
  if(given.count("sources"))
    for(const std::vector<std::size_t>& line : read_numbers(text("sources"), "--sources"))
      options.sources.insert(options.sources.end(), line.begin(), line.end());
  if(given.count("source-edges"))
    options.source_edges = read_numbers(text("source-edges"), "--source-edges");
  options.source_border = given["source-border"].as<bool>();
  if((number_of_source_points(options) > 1 || has_curves(options)) && given.count("unfold"))
    throw Usage_error("--unfold takes one source, a point");
  options.solver = text("solver");
  if(!is_solver_name(options.solver))
    throw Usage_error("--solver takes one of" + solver_names() + ", not '" + options.solver + "'");
  read_method(text("method"), options);
  check_options_of_method(given, options);
  for(const char* name : {"min-branch-edges", "min-branch-length"})
    if(has_curves(options) && options.method != CGAL::Cut_loci::Method::LAPLACIAN && given.count(name) &&
       (!given.count("curve") || text("curve") != "edges"))
      throw Usage_error("--" + std::string(name) +
                        " is for a cut locus along edges of the mesh, which sources that are curves have with "
                        "--curve edges only");
  if(given.count("keep"))
    options.kept = to_part(text("keep"));
  for(const char* name : {"uv", "check", "check-completeness"})
    if(options.kept != Kept_part::ALL && given.count(name) && !given[name].defaulted())
      throw Usage_error("--" + std::string(name) +
                        " is about all of the cut locus, and not about a part: leave --keep away");
  if(given.count("max-relative-error"))
    read_maximum_relative_error(text("max-relative-error"), options);
  if(given.count("angle"))
  {
    options.angle = to_number_in_range(text("angle"), "--angle", pi);
    if(*options.angle == 0.)
      throw Usage_error("--angle takes an angle above 0, not '" + text("angle") + "'");
  }
  if(given.count("laplacian"))
    options.laplacian = to_number(text("laplacian"), "--laplacian");
  if(given.count("policy"))
  {
    const std::string policy = text("policy");
    if(policy != "prune" && policy != "grow")
      throw Usage_error("--policy takes prune or grow, not '" + policy + "'");
    options.grow = policy == "grow";
  }
  if(given.count("min-branch-edges"))
    options.minimum_branch_edges = to_count(text("min-branch-edges"), "--min-branch-edges");
  if(given.count("min-branch-length"))
    options.minimum_branch_length = to_number_in_range(text("min-branch-length"), "--min-branch-length", 1000.);
  if(given.count("min-branch-gap"))
    options.minimum_branch_gap = to_number_in_range(text("min-branch-gap"), "--min-branch-gap", pi);
  if(given.count("min-branch-curvature"))
    options.minimum_branch_curvature =
      to_number_in_range(text("min-branch-curvature"), "--min-branch-curvature", 4. * pi);
  if(given.count("min-branch-width"))
    options.minimum_branch_width = to_number_in_range(text("min-branch-width"), "--min-branch-width", 1.);
  if(given.count("smooth"))
    options.smoothing = to_count(text("smooth"), "--smooth");
  if(options.smoothing && *options.smoothing > maximum_smoothing)
    throw Usage_error("--smooth takes at most " + std::to_string(maximum_smoothing) +
                      " steps, and 4 are enough: not '" + text("smooth") + "'");
  if(given.count("curve"))
    read_curve(text("curve"), options);

  if(given.count("output"))
    options.outputs = given["output"].as<std::vector<std::string>>();
  for(std::string& output : options.outputs)
  {
    if(to_output(output, "-o") == standard_stream && given.count("each-source") == 0)
      output += "." + text("output-format");
    if(!is_output_name(output) && given.count("each-source") == 0)
      throw Usage_error((is_standard_output(output) ? "--output-format: '" + output.substr(2) + "'"
                                                    : "-o: the extension of '" + output + "'") +
                        " must be one of" + output_extensions());
  }
  if(given.count("view"))
  {
    options.view = to_point(text("view"), "--view");
    if(*options.view == std::array<double, 3>{{0., 0., 0.}})
      throw Usage_error("--view takes a direction, not '" + text("view") + "'");
  }
  if(given.count("edges"))
  {
    options.edges = to_output(text("edges"), "--edges");
    if(options.curve == CGAL::Cut_loci::Curve::THROUGH_FACES || options.smoothing.value_or(0) > 0)
      throw Usage_error("--edges writes a curve of edges of the mesh: not with --curve faces or --smooth");
  }
  if(given.count("cells"))
  {
    check_output_path(options.cells = text("cells"), "--cells");
    if(!is_cells_name(options.cells))
      throw Usage_error("--cells: the extension of '" + options.cells + "' must be .ply, .vtp or .obj");
  }
  if(given.count("surface"))
  {
    options.surface = to_output(text("surface"), "--surface");
    if(options.surface != standard_stream && std::filesystem::path(options.surface).extension() != ".vtp")
      throw Usage_error("--surface: the extension of '" + options.surface + "' must be .vtp");
  }
  if(given.count("uv"))
  {
    check_output_path(options.uv = text("uv"), "--uv");
    if(std::filesystem::path(options.uv).extension() != ".obj")
      throw Usage_error("--uv: the extension of '" + options.uv + "' must be .obj");
  }
  else if(!given["parameterization"].defaulted())
    throw Usage_error("--parameterization is for --uv");
  options.parameterization = text("parameterization");
  if(!is_parameterization_name(options.parameterization))
    throw Usage_error("--parameterization takes injective, arap, lscm or convex, not '" + options.parameterization +
                      "'");
  if(given.count("unfold"))
  {
    check_output_path(options.unfold = text("unfold"), "--unfold");
    if(!is_unfolding_name(options.unfold))
      throw Usage_error("--unfold: the extension of '" + options.unfold + "' must be .svg or .obj");
  }
  if(!options.curve && !options.smoothing && (given.count("edges") || given.count("uv")))
    options.curve = CGAL::Cut_loci::Curve::MESH_EDGES; // these need them
  if(given.count("report"))
    options.report = to_output(text("report"), "--report");
  read_each_source(given, options);
  if(given.count("threads"))
    options.threads = number_of_threads(to_count(text("threads"), "--threads"));
  check_overwriting(given, options);
  return options;
}
