// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_files.h"
#include "log_map.h"
#include "output_file.h"

#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>

#include <cmath>
#include <ostream>

namespace {

using CGAL::Cut_loci::Index;

template <typename Write>
void write_array(std::ostream& os, const std::string& attributes, Index size, const Write& write)
{
  os << "<DataArray " << attributes << " format=\"ascii\">\n";
  for(Index i = 0; i < size; ++i)
  {
    write(i);
    os << '\n';
  }
  os << "</DataArray>\n";
}

void write_arrays(std::ostream& os, const std::string& element, Index size, const std::vector<Surface_array>& arrays)
{
  os << "<" << element << " Scalars=\"" << (arrays.empty() ? "" : arrays.front().name) << "\">\n";
  for(const Surface_array& array : arrays)
    write_array(os,
                (array.is_whole ? "type=\"Int32\" Name=\"" : "type=\"Float64\" Name=\"") + array.name + "\"" +
                  (array.second ? " NumberOfComponents=\"2\"" : ""),
                size,
                [&](Index i)
                {
      os << array.value(i);
      if(array.second)
        os << ' ' << array.second(i);
    });
  os << "</" << element << ">\n";
}

} // namespace

double finite_distance(double distance)
{
  return std::isfinite(distance) ? distance : -1.;
}

void write_vtp(std::ostream& os, const CGAL::Cut_loci::Indexed_triangle_mesh& mesh,
               const std::vector<Surface_array>& of_vertices, const std::vector<Surface_array>& of_faces)
{
  const auto write_three = [&](const auto& x) { os << x[0] << ' ' << x[1] << ' ' << x[2]; };
  const Index nv = mesh.number_of_vertices(), nf = mesh.number_of_faces();
  os << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
     << "<Piece NumberOfPoints=\"" << nv
     << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" << nf << "\">\n";
  write_arrays(os, "PointData", nv, of_vertices);
  write_arrays(os, "CellData", nf, of_faces);
  os << "<Points>\n";
  write_array(os, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", nv,
              [&](Index v) { write_three(mesh.points[v]); });
  os << "</Points>\n<Polys>\n";
  write_array(os, "type=\"Int64\" Name=\"connectivity\"", nf, [&](Index f) { write_three(mesh.triangles[f]); });
  write_array(os, "type=\"Int64\" Name=\"offsets\"", nf, [&](Index f) { os << 3 * (f + 1); });
  os << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

void write_surface(const Options& options, const Input_mesh& input, const Cut_locus& cut_locus)
{
  const auto read = CGAL::Cut_loci::internal::read_triangle_mesh(input.mesh, input.mesh.points());
  std::unique_ptr<const Log_map> log;
  if(cause_of_no_log_map(options).empty())
    log = log_map(input.mesh, cut_locus);
  const auto source = [&](Index v)
  {
    const auto nearest = cut_locus.nearest_source(read.vertices[v]);
    return !nearest ? -1.
                    : static_cast<double>(log ? log->nearest_source(read.vertices[v]) : *nearest); // of two as near
  };
  std::vector<Surface_array> arrays = {
    {"distance", false, [&](Index v) { return finite_distance(cut_locus.distance(read.vertices[v])); }},
    {"source", true, source},
    {"vertex", true, [&](Index v) { return static_cast<double>(input.number[read.vertices[v]]); }}};
  const auto place = [&](Index v, std::size_t k)
  { return cut_locus.nearest_source(read.vertices[v]) ? log->logarithmic_map(read.vertices[v])[k] : 0.; };
  if(log)
    arrays.push_back({"log_map", false, [&](Index v) { return place(v, 0); }, [&](Index v) { return place(v, 1); }});
  write_file(options.surface, [&](std::ostream& os) { write_vtp(os, read.mesh, arrays, {}); });
}
