// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Options.h"
#include "file_checks.h"
#include "generated_texts.h"
#include "option_descriptions.h"
#include "output.h"
#include "output_file.h"
#include "solvers.h"
#include "threads.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <typeinfo>
#include <utility>
#include <variant>

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

struct Number_option
{
  const char* name;
  double largest;
  std::optional<double> Options::*target;
};
constexpr Number_option number_options[] = {{"max-relative-error", 0.1, &Options::maximum_relative_error},
                                            {"angle", pi, &Options::angle},
                                            {"min-branch-length", 1000., &Options::minimum_branch_length},
                                            {"min-branch-gap", pi, &Options::minimum_branch_gap},
                                            {"min-branch-curvature", 4. * pi, &Options::minimum_branch_curvature},
                                            {"min-branch-width", 1., &Options::minimum_branch_width}};

struct File_option
{
  const char* name;
  std::string Options::*target;
  bool may_be_standard_output;
};
constexpr File_option file_options[] = {{"edges", &Options::edges, true},     {"cells", &Options::cells, false},
                                        {"surface", &Options::surface, true}, {"uv", &Options::uv, false},
                                        {"seams", &Options::seams, false},    {"unfold", &Options::unfold, false},
                                        {"report", &Options::report, true}};

// "a, b or c"
std::string listed(const std::vector<std::string>& words)
{
  std::string result = words.front();
  for(std::size_t i = 1; i < words.size(); ++i)
    result += (i + 1 < words.size() ? ", " : " or ") + words[i];
  return result;
}

// What the descriptions allow: one of some words, or the name of a file with one of some extensions.
// a word that stands for what was called otherwise before
std::string current_word(const std::string& option, const std::string& word)
{
  return option == "repair" && word == "auto" ? "weld" : option == "method" && word == "direction" ? "default" : word;
}

void check_words(const po::variables_map& given)
{
  const auto has = [](const std::vector<std::string>& words, const std::string& word)
  { return words.empty() || std::find(words.begin(), words.end(), word) != words.end(); };
  for(const auto& group : option_groups())
    for(const auto& option : group.second.options())
    {
      const std::string name = option->long_name();
      if(!given.count(name) || given[name].value().type() != typeid(std::string))
        continue;
      const std::string value = given[name].as<std::string>();
      const std::vector<std::string> words = choices(*option), extensions = file_extensions(*option);
      if(!has(words, current_word(name, value)))
        throw Usage_error("--" + name + " takes " + listed(words) + ", not '" + value + "'");
      if(value != standard_stream && !has(extensions, std::filesystem::path(value).extension().string()))
        throw Usage_error("--" + name + ": the extension of '" + value + "' must be " + listed(extensions));
    }
}

// Boost's errors, as all others are put.
std::string message(const po::error& error)
{
  if(const auto* unknown = dynamic_cast<const po::unknown_option*>(&error))
    return "there is no option " + unknown->get_option_name() + ": cut_locus --help-all lists all of them";
  if(const auto* several = dynamic_cast<const po::multiple_occurrences*>(&error))
    return several->get_option_name() + " may be given once only";
  const auto* syntax = dynamic_cast<const po::invalid_command_line_syntax*>(&error);
  if(syntax == nullptr)
    return error.what();
  return syntax->get_option_name() +
         (syntax->kind() == po::invalid_syntax::extra_parameter ? " takes no value" : " takes a value");
}

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

std::array<double, 3> to_direction(const std::string& text, const std::string& option)
{
  const std::array<double, 3> result = to_point(text, option);
  if(result == std::array<double, 3>{{0., 0., 0.}})
    throw Usage_error(option + " takes a direction, not '" + text + "'");
  return result;
}

// whether --uv writes a texture and a material: not into a file of its own, nor beside an OBJ file that is kept
bool has_files_beside_uv(const Options& options)
{
  const auto extension = [](const std::string& name) { return std::filesystem::path(name).extension(); };
  return extension(options.uv) == ".obj" &&
         (extension(options.mesh) != ".obj" || options.curve != CGAL::Cut_loci::Curve::MESH_EDGES);
}

// No output may replace what is read, nor another output.
void check_overwriting(const po::variables_map& given, const Options& options)
{
  namespace fs = std::filesystem;
  std::vector<std::pair<fs::path, std::string>> outputs;
  for(const std::string& output : options.outputs)
    outputs.emplace_back(is_standard_output(output) ? standard_stream : output, "-o");
  for(const File_option& file : file_options)
    if(!(options.*file.target).empty())
      outputs.emplace_back(options.*file.target, std::string("--") + file.name);
  if(has_files_beside_uv(options))
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

bool is_laplacian(const Options& options)
{
  return std::holds_alternative<CGAL::Cut_loci::Laplacian_method>(options.method);
}

void read_method(const std::string& name, Options& options)
{
  using CGAL::Cut_loci::Method;
  const std::pair<const char*, Method> methods[] = {{"default", CGAL::Cut_loci::Default_method()},
                                                    {"polyhedral", CGAL::Cut_loci::Polyhedral_method()},
                                                    {"laplacian", CGAL::Cut_loci::Laplacian_method()}};
  options.method = default_method(options.solver);
  for(const auto& [method_name, method] : methods)
    if(current_word("method", name) == method_name)
      options.method = method;
  options.method_name = methods[options.method.index()].first;
  if(!is_laplacian(options) && options.solver != "exact")
    throw Usage_error("--method " + name + " needs the paths of --solver exact");
}

// An option of another method would be ignored.
void check_options_of_method(const po::variables_map& given, const Options& options)
{
  const auto refuse = [&](const char* option, const std::string& methods)
  {
    if(given.count(option))
      throw Usage_error(std::string("--") + option + " is for --method " + methods + ", and here the method is " +
                        options.method_name + (given["method"].defaulted() ? ", the default for these distances" : ""));
  };
  if(!is_laplacian(options))
    for(const char* option : {"angle", "laplacian", "policy"})
      refuse(option, "laplacian");
  if(!is_laplacian(options) && given.count("smooth"))
    throw Usage_error("--smooth is for --method laplacian: the method " + options.method_name +
                      " needs no smoothing, --curve faces gives its curve through the faces");
  if(is_laplacian(options))
    for(const char* option : {"min-branch-gap", "min-branch-width", "min-branch-curvature"})
      refuse(option, "default or polyhedral");
}

void check_maximum_relative_error(const Options& options)
{
  if(options.maximum_relative_error && options.solver != "exact")
    throw Usage_error("--max-relative-error is for --solver exact");
  if(options.maximum_relative_error && std::holds_alternative<CGAL::Cut_loci::Polyhedral_method>(options.method))
    throw Usage_error("--max-relative-error: --method polyhedral needs exact distances");
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
  for(const char* name : {"source", "source-point", "from-view", "edges", "cells", "surface", "uv", "seams", "unfold",
                          "check", "check-completeness", "view"})
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
    throw Usage_error(message(error));
  }
  check_words(given);

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
    options.text = given["generate"].as<std::string>() == "man" ? man_page() : bash_completion();
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
    options.input_format = text("input-format");
  options.repair = text("repair") == "orient" ? Repair::ORIENT : text("repair") == "none" ? Repair::NONE : Repair::WELD;
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
  if(given.count("from-view"))
    options.from_view = to_direction(text("from-view"), "--from-view");
  if(options.from_view && (number_of_source_points(options) > 0 || has_curves(options)))
    throw Usage_error("--from-view chooses the source: give no other one");
  if(number_of_source_points(options) > 1 || has_curves(options))
  {
    if(given.count("unfold"))
      throw Usage_error("--unfold takes one source, a point");
    if(text("parameterization") == "logmap")
      throw Usage_error("--parameterization logmap takes one source, a point: give that, or leave it away");
  }
  options.solver = text("solver");
  read_method(text("method"), options);
  check_options_of_method(given, options);
  for(const char* name : {"min-branch-edges", "min-branch-length"})
    if(has_curves(options) && !is_laplacian(options) && given.count(name) &&
       (!given.count("curve") || text("curve") != "edges"))
      throw Usage_error("--" + std::string(name) +
                        " is for a cut locus along edges of the mesh, which sources that are curves have with "
                        "--curve edges only");
  if(given.count("keep"))
    options.kept = text("keep") == "voronoi"  ? Kept_part::VORONOI
                   : text("keep") == "medial" ? Kept_part::MEDIAL
                                              : Kept_part::ALL;
  for(const char* name : {"uv", "seams", "check", "check-completeness"})
    if(options.kept != Kept_part::ALL && given.count(name) && !given[name].defaulted())
      throw Usage_error("--" + std::string(name) +
                        " is about all of the cut locus, and not about a part: leave --keep away");
  for(const Number_option& number : number_options)
    if(given.count(number.name))
      options.*number.target = to_number_in_range(text(number.name), std::string("--") + number.name, number.largest);
  check_maximum_relative_error(options);
  if(options.angle == 0.)
    throw Usage_error("--angle takes an angle above 0, not '" + text("angle") + "'");
  if(given.count("laplacian"))
    options.laplacian = to_number(text("laplacian"), "--laplacian");
  if(given.count("policy"))
    options.grow = text("policy") == "grow";
  if(given.count("min-branch-edges"))
    options.minimum_branch_edges = to_count(text("min-branch-edges"), "--min-branch-edges");
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
    if(output != standard_stream)
      check_output_path(output, "-o");
    else if(given.count("each-source") == 0)
      output += "." + text("output-format");
    if(!is_output_name(output) && given.count("each-source") == 0)
      throw Usage_error("-o: the extension of '" + output + "' must be one of" + output_extensions());
  }
  if(given.count("view"))
    options.view = to_direction(text("view"), "--view");
  for(const File_option& file : file_options)
    if(given.count(file.name))
    {
      options.*file.target = text(file.name);
      if(!file.may_be_standard_output || text(file.name) != standard_stream)
        check_output_path(text(file.name), std::string("--") + file.name);
    }
  for(const char* name : {"edges", "seams"})
    if(given.count(name) &&
       (options.curve == CGAL::Cut_loci::Curve::THROUGH_FACES || options.smoothing.value_or(0) > 0))
      throw Usage_error("--" + std::string(name) +
                        " writes a curve of edges of the mesh: not with --curve faces or --smooth");
  if(!has_atlas(options) && !given["parameterization"].defaulted())
    throw Usage_error("--parameterization is for --uv and --seams");
  options.parameterization = text("parameterization");
  if(given.count("max-stretch"))
    options.maximum_stretch = to_number(text("max-stretch"), "--max-stretch");
  if(options.maximum_stretch < 1.)
    throw Usage_error("--max-stretch takes a number from 1, not '" + text("max-stretch") + "'");
  if(!has_atlas(options) && given.count("max-stretch"))
    throw Usage_error("--max-stretch is for --uv and --seams");
  if(!options.curve && !options.smoothing &&
     (given.count("edges") || given.count("seams") || (given.count("uv") && options.parameterization != "logmap")))
    options.curve = CGAL::Cut_loci::Curve::MESH_EDGES; // these need them
  read_each_source(given, options);
  if(given.count("threads"))
    options.threads = number_of_threads(to_count(text("threads"), "--threads"));
  check_overwriting(given, options);
  return options;
}
