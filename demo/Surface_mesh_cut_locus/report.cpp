// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "report.h"
#include "packing.h"
#include "output_file.h"
#include "report_json.h"

#include <CGAL/Cut_loci/statistics.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

void add_method(Json& report, const Options& options, CGAL::Cut_loci::Curve curve)
{
  report["solver"] = options.solver;
  report["max_relative_error"] = options.maximum_relative_error.value_or(0.);
  report["method"] = options.method_name;
  report["curve"] = curve == CGAL::Cut_loci::Curve::MESH_EDGES ? "edges" : "faces";
}

void write_json(const std::string& filename, const Json& json)
{
  // a name that is not UTF-8 must not spoil the report
  write_file(filename,
             [&](std::ostream& os) { os << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n'; });
}

namespace {

Json to_json(const Kernel::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

template <typename T>
Json to_json(const std::optional<T>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json to_json(const Repairs& repairs, Repair repair)
{
  Json json;
  json["option"] = repair == Repair::WELD ? "weld" : repair == Repair::ORIENT ? "orient" : "none";
  json["done"] = description(repairs);
  json["triangulated_polygons"] = repairs.triangulated_faces;
  json["merged_vertices"] = repairs.merged_vertices;
  json["reversed_faces"] = repairs.reversed_faces;
  json["added_vertices"] = repairs.duplicated_vertices;
  json["removed_faces"] = repairs.removed_faces;
  json["unused_vertices"] = repairs.unused_vertices;
  json["open_edges"] = repairs.open_edges;
  return json;
}

std::size_t count_added_edges(const Input_mesh& input, const Cut_locus& cut_locus)
{
  const Cut_locus::Graph& graph = cut_locus.graph();
  const auto all = CGAL::make_range(edges(graph));
  return static_cast<std::size_t>(
    std::count_if(all.begin(), all.end(), [&](const auto& e) { return is_added(graph[e], input); }));
}

void add_check(Json& report, const Check& check)
{
  report["topology"] = check.topology_fault.empty() ? "right" : check.topology_fault;
  const auto figure = [&](double x) { return check.failed.empty() ? Json(x) : Json(nullptr); };
  report["detour_mean"] = figure(check.detour_mean);
  report["detour_p99"] = figure(check.detour_p99);
  report["detour_max"] = figure(check.detour_max);
  if(!check.failed.empty())
    report["detour_failed"] = check.failed;
  const auto distance = [&](double x) { return check.nodes_failed.empty() ? Json(x) : Json(nullptr); };
  report["node_distance_error_mean"] = distance(check.node_distance_mean);
  report["node_distance_error_max"] = distance(check.node_distance_max);
  if(!check.nodes_failed.empty())
    report["node_distances_failed"] = check.nodes_failed;
  if(check.completeness)
    report["completeness"] = {{"width", check.completeness->width},
                              {"found", check.completeness->found},
                              {"confirmed", check.completeness->confirmed}};
  else
    report["not_checked"] = {"completeness"};
}

void add_atlas(Json& report, const Atlas& atlas, const std::optional<double>& short_cut_graph_distance)
{
  Json& seams = report["seams"];
  seams["length"] = atlas.seam_length;
  seams["distance"] = atlas.seam_distance;
  seams["edges_not_in_file"] = atlas.seams_in_polygons;
  seams["charts"] = atlas.charts.size();
  const CGAL::Cut_loci::Layout_quality& quality = atlas.quality;
  const auto figure = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  Json& uv = report["uv"];
  uv["parameterization"] = atlas.parameterization;
  std::size_t faces = 0;
  double area = 0.;
  for(const auto& chart : atlas.charts)
  {
    faces += chart->faces.size();
    area += chart->area;
  }
  seams["area"] = area;
  uv["faces"] = faces;
  uv["covered"] = atlas.covered;
  uv["stretch"] = figure(atlas.stretch);
  uv["flipped_faces"] = quality.flipped_faces;
  uv["injective"] = quality.is_injective;
  uv["overlapping_faces"] = quality.overlapping_faces;
  uv["overlap"] = quality.overlap;
  uv["area_distortion"] = figure(quality.area_distortion);
  uv["angle_distortion"] = figure(quality.angle_distortion);
  uv["symmetric_dirichlet_energy"] = figure(quality.symmetric_dirichlet_energy);
  uv["faces_without_shape"] = quality.faces_without_shape;
  uv["seam_distance"] = atlas.seam_distance;
  uv["short_cut_graph_distance"] = to_json(short_cut_graph_distance);
}

void add_seconds(Json& seconds, const Progress& progress)
{
  double total = 0.;
  for(const auto& stage : progress.seconds())
  {
    seconds[stage.first] = stage.second;
    total += stage.second;
  }
  seconds["total"] = total;
}

} // namespace

void add_farthest(Json& report, const Input_mesh& input, const Cut_locus& cut_locus)
{
  const Mesh::Vertex_index vertex = cut_locus.farthest_vertex();
  const double distance = cut_locus.distance(vertex);
  report["farthest"] = input.number[vertex];
  report["farthest_distance"] = distance;
  // a node, or a vertex where branches are left out
  const Cut_locus::vertex_descriptor node = cut_locus.farthest_node();
  const bool is_node =
    node != boost::graph_traits<Cut_locus::Graph>::null_vertex() && cut_locus.graph()[node].distance >= distance;
  report["farthest_point"] = to_json(is_node ? cut_locus.graph()[node].point : input.mesh.point(vertex));
  report["farthest_point_distance"] = is_node ? cut_locus.graph()[node].distance : distance;
}

void add_parameters(Json& parameters, const Options& options)
{
  parameters["angle"] = to_json(options.angle);
  parameters["laplacian"] = to_json(options.laplacian);
  parameters["policy"] = options.grow ? Json(*options.grow ? "grow" : "prune") : Json(nullptr);
  parameters["min_branch_edges"] = to_json(options.minimum_branch_edges);
  parameters["min_branch_length"] = to_json(options.minimum_branch_length);
  parameters["min_branch_gap"] = to_json(options.minimum_branch_gap);
  parameters["min_branch_width"] = to_json(options.minimum_branch_width);
  parameters["min_branch_curvature"] = to_json(options.minimum_branch_curvature);
  parameters["smooth"] = to_json(options.smoothing);
}

void write_report(const Options& options, CGAL::Cut_loci::Curve curve, const Input_mesh& input,
                  const Cut_locus& cut_locus, const std::optional<Atlas>& atlas, const std::optional<Check>& check,
                  const Progress& progress)
{
  const Mesh& mesh = input.mesh;
  const auto number = [&](Mesh::Vertex_index v)
  { return v == Mesh::null_vertex() ? Json(nullptr) : Json(input.number[v]); };
  const CGAL::Cut_loci::Cut_locus_statistics statistics = CGAL::Cut_loci::compute_statistics(cut_locus);
  const Cut_locus::Vertex& source = cut_locus.source();
  const Mesh::Vertex_index root = cut_locus.graph()[cut_locus.root()].mesh_vertex;

  Json report;
  report["mesh"] = options.mesh;
  report["vertices"] = mesh.number_of_vertices();
  report["faces"] = mesh.number_of_faces();
  report["mean_edge_length"] = mean_edge_length(mesh);
  report["repair"] = to_json(input.repairs, options.repair);
  report["components_of_mesh"] = input.component_size.size();
  report["faces_of_component"] = input.component_size[component_of_source(input, cut_locus)];
  report["genus"] = cut_locus.genus();
  report["border_loops"] = cut_locus.number_of_border_loops();

  report["source"] = number(source.mesh_vertex);
  report["source_point"] = to_json(source.point);
  for(std::size_t i = 0; i < cut_locus.number_of_sources() && cut_locus.number_of_sources() > 1; ++i)
  {
    report["sources"].push_back(number(cut_locus.source(i).mesh_vertex));
    report["source_points"].push_back(to_json(cut_locus.source(i).point));
  }
  add_farthest(report, input, cut_locus);
  report["root"] = number(root);

  report["note"] = CGAL::Cut_loci::description(statistics.status);
  report["edges"] = statistics.edges;
  report["edges_not_in_file"] = count_added_edges(input, cut_locus);
  report["cycles"] = statistics.cycles;
  report["components"] = statistics.components;
  report["leaves"] = statistics.leaves;
  report["branchings"] = statistics.branchings;
  report["narrow_corridors"] = statistics.narrow_corridors;
  report["one_of_several"] = statistics.is_one_of_several;
  report["length"] = statistics.length;
  report["injectivity_radius"] = statistics.injectivity_radius;
  report["injectivity_lower_bound"] = statistics.injectivity_lower_bound;

  if(check)
    add_check(report, *check);
  if(atlas)
    add_atlas(report, *atlas, distance_to_short_cut_graph(mesh, cut_locus));
  add_method(report, options, curve);
  add_parameters(report["parameters"], options);
  add_seconds(report["seconds"], progress);
  write_json(options.report, report);
}

namespace {

// What decides which points belong to the curve, and so its smallest distance.
std::string basis_of_radius(const Options& options, CGAL::Cut_loci::Curve curve)
{
  std::ostringstream text;
  text << std::setprecision(3) << options.method_name << ", "
       << (curve == CGAL::Cut_loci::Curve::MESH_EDGES ? "mesh edges" : "through faces");
  const auto add = [&](const char* name, const std::optional<double>& value)
  {
    if(value && *value > 0.) // 0 asks for nothing
      text << ", " << name << " " << *value;
  };
  add("angle", options.angle);
  add("laplacian", options.laplacian);
  add("width", options.minimum_branch_width);
  add("curvature", options.minimum_branch_curvature);
  add("gap", options.minimum_branch_gap);
  return text.str();
}

// what branches that are left out may make of it
std::string whatever_the_thresholds(const CGAL::Cut_loci::Cut_locus_statistics& statistics)
{
  if(statistics.injectivity_lower_bound == 0. ||
     statistics.injectivity_lower_bound > (1. - 1e-6) * statistics.injectivity_radius)
    return {};
  std::ostringstream text;
  text << std::setprecision(3) << ", with all weak branches at least " << statistics.injectivity_lower_bound;
  return text.str();
}

} // namespace

std::string summary(const Options& options, CGAL::Cut_loci::Curve curve, const Mesh& mesh, const Cut_locus& cut_locus)
{
  const CGAL::Cut_loci::Cut_locus_statistics statistics = CGAL::Cut_loci::compute_statistics(cut_locus);
  std::ostringstream text;
  text << mesh.number_of_faces() << " faces, genus " << cut_locus.genus() << "; cut locus: " << statistics.edges
       << " edges, " << statistics.cycles << " cycles, " << statistics.leaves << " leaves";
  // It is off by a part of an edge, which more digits would hide. That of a lone vertex says nothing.
  if(statistics.edges > 0)
    text << ", injectivity radius " << std::setprecision(3) << statistics.injectivity_radius << " ("
         << basis_of_radius(options, curve) << ")" << whatever_the_thresholds(statistics);
  const std::string doubt = CGAL::Cut_loci::description(statistics.status);
  if(!doubt.empty())
    text << "\nnote: " << doubt;
  if(statistics.is_one_of_several)
    text
      << "\nnote: the source is placed symmetrically: some points have several shortest paths in a whole region around "
         "them, and other curves through it are as right as this one";
  return text.str();
}

namespace {

// what an artist should know about the seams
std::string notes_on_seams(const Atlas& atlas, const Input_mesh& input)
{
  std::string result;
  if(const std::optional<double> width = atlas.charts.front()->finer_width)
  {
    std::ostringstream text;
    text << std::setprecision(9) << "\nnote: seams follow finer branches than the curve of the other outputs: with "
         << "--min-branch-width " << *width << " it has them, too";
    result += text.str();
  }
  if(atlas.splits_faces)
    result += "\nnote: seams are straight: faces are split, and those of the file are not kept";
  if(atlas.seams_in_polygons > 0)
    result += "\nnote: " + std::to_string(atlas.seams_in_polygons) +
              " edges of seams are diagonals of polygons: no way around leaves a disk";
  const auto flat =
    std::count_if(input.component_area.begin(), input.component_area.end(), [](double area) { return !(area > 0.); });
  if(flat > 0)
    result += "\nnote: " + std::to_string(flat) + " components without area are left out";
  return result;
}

} // namespace

std::string summary(const Atlas& atlas, const Input_mesh& input)
{
  std::ostringstream text;
  text << std::setprecision(3) << "seams: length " << atlas.seam_length << ", charts: " << atlas.charts.size();
  text << ", which cover " << 100. * atlas.covered << " % of the unit square, at least " << 100. * margin_of_packing
       << " % of its side apart\n";
  const CGAL::Cut_loci::Layout_quality& quality = atlas.quality;
  text << std::setprecision(4) << "atlas: ";
  if(quality.is_injective)
    text << "injective";
  else
    text << quality.flipped_faces << " faces flipped, " << quality.overlapping_faces << " overlap, which is "
         << 100. * quality.overlap << " % of what is covered";
  text << "; distortion of areas " << quality.area_distortion << ", of angles " << quality.angle_distortion
       << ", largest stretch of a chart " << atlas.stretch;
  if(quality.faces_without_shape > 0)
    text << "; " << quality.faces_without_shape << " faces are too thin to have a shape";
  if(!quality.is_injective && atlas.parameterization != "injective")
    text << "; --parameterization injective avoids that where numbers are fine enough";
  return text.str() + notes_on_seams(atlas, input);
}
