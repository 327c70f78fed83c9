// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "log_map.h"

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/face_graph/Surface_component.h>
#include <CGAL/Cut_loci/face_graph/read_source.h>
#include <CGAL/Cut_loci/face_graph/read_triangle_mesh.h>

#include <cmath>

std::string cause_of_no_log_map(const Options& options)
{
  if(has_curves(options))
    return "the paths from a curve start at no single point";
  if(options.solver != "exact")
    return "it takes --solver exact";
  return options.maximum_relative_error.value_or(0.) > 0. ? "it takes distances without --max-relative-error" : "";
}

Log_map log_map(const Mesh& mesh, const Cut_locus& cut_locus)
{
  using namespace CGAL::Cut_loci;
  auto read = internal::read_triangle_mesh(mesh, mesh.points());
  internal::normalize_lengths(read);
  Index number_of_components = 0;
  const std::vector<Index> component_of_face = internal::face_components(read.mesh, number_of_components);
  std::vector<Indexed_source> sources;
  for(std::size_t i = 0; i < cut_locus.number_of_sources(); ++i)
  {
    const auto& [face, coordinates] = cut_locus.source(i).location;
    sources.push_back(internal::source_in_face(mesh, read, face, coordinates, 0.));
  }
  // flat faces have got an area there, as for the cut locus
  const internal::Surface_component component(read.mesh, component_of_face,
                                              component_of_face[sources.front().location.face], number_of_components);
  std::vector<Indexed_location> locations;
  for(const Indexed_source& source : sources)
    locations.push_back(component.local(source).location);
  internal::Exact_geodesic_options options;
  options.directions = true;
  internal::Exact_geodesic_propagation geodesics(component.measured());
  geodesics.run(locations, options);

  Log_map result;
  result.source.assign(read.vertices.size(), 0);
  result.place.assign(read.vertices.size(), {{0., 0.}});
  for(Index v = 0; v < component.mesh->number_of_vertices(); ++v)
  {
    const Index w = component.vertex(v), source = geodesics.nearest_source(v);
    result.source[w] = source;
    const double distance = cut_locus.distance(read.vertices[w]);
    if(distance == 0.)
      continue;
    const double scale =
      geodesics.is_source_on_border(source) ? 1. : 2. * internal::geodesic_pi / geodesics.source_angle(source);
    const double angle = scale * geodesics.direction_at_source(v);
    result.place[w] = {{distance * std::cos(angle), distance * std::sin(angle)}};
  }
  return result;
}
