// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_IO_WRITE_CUT_LOCUS_H
#define CGAL_CUT_LOCI_IO_WRITE_CUT_LOCUS_H

#include <CGAL/Cut_loci/extract_polylines.h>
#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Cut_loci::internal {

// Sets what the writers need of a stream, and gives it back as it was.
class Stream_format
{
public:
  template <typename NamedParameters>
  Stream_format(std::ostream& os, const NamedParameters& np) : os_(os), flags_(os.flags()), precision_(os.precision())
  {
    os.flags(std::ios_base::dec);
    // 17 digits give every double back as it was
    os.precision(parameters::choose_parameter(parameters::get_parameter(np, internal_np::stream_precision),
                                              (std::numeric_limits<double>::max_digits10)));
  }

  ~Stream_format()
  {
    os_.flags(flags_);
    os_.precision(precision_);
  }

  Stream_format(const Stream_format&) = delete;
  Stream_format& operator=(const Stream_format&) = delete;

private:
  std::ostream& os_;
  std::ios_base::fmtflags flags_;
  std::streamsize precision_;
};

// Whether each edge of a graph is marked, and whether that is to be written.
template <typename Map>
struct Edge_marks
{
  Map map;

  static constexpr bool is_given() { return !std::is_same<Map, internal_np::Param_not_found>::value; }
  template <typename Edge>
  bool operator()(const Edge& e) const
  {
    if constexpr(is_given())
      return get(map, e);
    else
      return false;
  }
};

template <typename NamedParameters>
auto edge_marks(const NamedParameters& np)
{
  const auto map = parameters::get_parameter(np, internal_np::edge_is_constrained);
  return Edge_marks<std::decay_t<decltype(map)>>{map};
}

template <typename Point_3>
void write_point(std::ostream& os, const Point_3& p)
{
  os << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z());
}

// What files tell of each edge: calls `take(name, value_of)` for each array, and `value_of(e)` has the type of its
// values. So the names are the same in all formats.
template <typename Graph, typename Edge_marks, typename Function>
void for_each_edge_array(const Graph& graph, const Edge_marks& is_marked, const Function& take)
{
  take("strength", [&](const auto& e) { return graph[e].strength; });
  take("width", [&](const auto& e) { return graph[e].width; });
  take("enclosed", [&](const auto& e) { return graph[e].curvature; });
  take("source1", [&](const auto& e) { return static_cast<std::int32_t>(graph[e].sources[0]); });
  take("source2", [&](const auto& e) { return static_cast<std::int32_t>(graph[e].sources[1]); });
  if(is_marked.is_given())
    take("marked", [&](const auto& e) { return static_cast<std::uint8_t>(is_marked(e)); });
}

// The name of a type in a file, of those for real numbers, whole ones and truth values.
template <typename T>
const char* name_of_type(const std::array<const char*, 3>& names)
{
  return names[std::is_same<T, double>::value ? 0 : std::is_same<T, std::int32_t>::value ? 1 : 2];
}

} // namespace Cut_loci::internal

namespace IO {

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus in CGAL's format for polylines (extension `.polylines.txt`): a line for each maximal chain of
 * edges between vertices of degree other than 2, with the number of its points and their coordinates. A closed chain
 * ends with its first point; a cut locus that is a single point is a line with that one point.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the `stream_precision` of
 *        `write_cut_locus()`
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_polylines(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  const Cut_loci::internal::Stream_format format(os, np);
  for(const auto& polyline : Cut_loci::extract_polylines(cut_locus))
  {
    os << polyline.size();
    for(const Point_3& p : polyline)
    {
      os << ' ';
      Cut_loci::internal::write_point(os, p);
    }
    os << '\n';
  }
  return os.good();
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus in the format of Wavefront (extension `.obj`): a record `v` for each vertex of the graph and a
 * record `l` for each maximal chain of edges between vertices of degree other than 2. A vertex without edges, as of a
 * cut locus that is a single point, is a record `p`.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `write_cut_locus()`; edges are
 *        marked each by a comment `# marked` with its two vertices
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_OBJ(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  const Cut_loci::internal::Stream_format format(os, np);
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    os << "v ";
    Cut_loci::internal::write_point(os, graph[v].point);
    os << '\n';
  }
  for(const auto& chain : Cut_loci::internal::maximal_chains(graph))
  {
    if(cut_locus.number_of_sources() > 1 && !chain.edges.empty())
      os << "g sources_" << graph[chain.edges.front()].sources[0] << '_' << graph[chain.edges.front()].sources[1]
         << '\n';
    os << (chain.edges.empty() ? 'p' : 'l');
    for(auto v : chain.vertices)
      os << ' ' << v + 1;
    os << '\n';
  }
  const auto is_marked = Cut_loci::internal::edge_marks(np);
  for(auto e : CGAL::make_range(edges(graph)))
    if(is_marked(e))
      os << "# marked " << source(e, graph) + 1 << ' ' << target(e, graph) + 1 << '\n';
  return os.good();
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus as an ASCII file of the format PLY (extension `.ply`) with the elements `vertex`, with the
 * property `distance`, and `edge`, with the properties `strength`, `width`, `enclosed`, `source1` and `source2`: its
 * `strength`, `width`, `curvature` and `sources`, see `Cut_locus_edge`.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `write_cut_locus()`; edges are
 *        marked by 1 in the property `marked` of the element `edge`
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_PLY(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  const Cut_loci::internal::Stream_format format(os, np);
  const auto is_marked = Cut_loci::internal::edge_marks(np);
  os << "ply\nformat ascii 1.0\n"
     << "element vertex " << num_vertices(graph)
     << "\nproperty double x\nproperty double y\nproperty double z\nproperty double distance\n"
     << "element edge " << num_edges(graph) << "\nproperty int vertex1\nproperty int vertex2\n";
  Cut_loci::internal::for_each_edge_array(graph, is_marked,
                                          [&](const char* name, const auto& value_of)
                                          {
    using Value = decltype(value_of(*edges(graph).first));
    os << "property " << Cut_loci::internal::name_of_type<Value>({{"double", "int", "uchar"}}) << ' ' << name << '\n';
  });
  os << "end_header\n";
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    Cut_loci::internal::write_point(os, graph[v].point);
    os << ' ' << graph[v].distance << '\n';
  }
  for(auto e : CGAL::make_range(edges(graph)))
  {
    os << source(e, graph) << ' ' << target(e, graph);
    Cut_loci::internal::for_each_edge_array(graph, is_marked,
                                            [&](const char*, const auto& value_of) { os << ' ' << +value_of(e); });
    os << '\n';
  }
  return os.good();
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus in the XML format of VTK for polygonal data (extension `.vtp`), as ASCII: a line for each edge,
 * with the array `distance` of the points, and `strength`, `width`, `enclosed`, `source1` and `source2` of the cells: its
 * `strength`, `width`, `curvature` and `sources`, see `Cut_locus_edge`. A vertex without edges, as of a cut locus that is
 * a single point, is a cell `Verts` for which these are 0.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `write_cut_locus()`; edges are
 *        marked by 1 in the array `marked` of the cells
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_VTP(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  const Cut_loci::internal::Stream_format format(os, np);
  const auto is_marked = Cut_loci::internal::edge_marks(np);
  std::vector<std::size_t> isolated;
  for(auto v : CGAL::make_range(vertices(graph)))
    if(degree(v, graph) == 0)
      isolated.push_back(v);

  const auto start_array = [&](const char* type, const char* name)
  { os << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n"; };
  const auto end_array = [&]() { os << "</DataArray>\n"; };
  const auto write_offsets = [&](std::size_t number_of_cells, std::size_t size_of_cell)
  {
    start_array("Int64", "offsets");
    for(std::size_t i = 1; i <= number_of_cells; ++i)
      os << i * size_of_cell << '\n';
    end_array();
  };

  os << "<?xml version=\"1.0\"?>\n"
     << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
     << "<Piece NumberOfPoints=\"" << num_vertices(graph) << "\" NumberOfVerts=\"" << isolated.size()
     << "\" NumberOfLines=\"" << num_edges(graph) << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
     << "<PointData Scalars=\"distance\">\n";
  start_array("Float64", "distance");
  for(auto v : CGAL::make_range(vertices(graph)))
    os << graph[v].distance << '\n';
  end_array();
  os << "</PointData>\n<CellData Scalars=\"strength\">\n";
  Cut_loci::internal::for_each_edge_array(graph, is_marked,
                                          [&](const char* name, const auto& value_of)
                                          {
    using Value = decltype(value_of(*edges(graph).first));
    start_array(Cut_loci::internal::name_of_type<Value>({{"Float64", "Int32", "UInt8"}}), name);
    for(std::size_t i = 0; i < isolated.size(); ++i)
      os << "0\n";
    for(auto e : CGAL::make_range(edges(graph)))
      os << +value_of(e) << '\n';
    end_array();
  });
  os << "</CellData>\n<Points>\n"
     << "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    Cut_loci::internal::write_point(os, graph[v].point);
    os << '\n';
  }
  end_array();
  os << "</Points>\n<Verts>\n";
  start_array("Int64", "connectivity");
  for(std::size_t v : isolated)
    os << v << '\n';
  end_array();
  write_offsets(isolated.size(), 1);
  os << "</Verts>\n<Lines>\n";
  start_array("Int64", "connectivity");
  for(auto e : CGAL::make_range(edges(graph)))
    os << source(e, graph) << ' ' << target(e, graph) << '\n';
  end_array();
  write_offsets(num_edges(graph), 2);
  os << "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return os.good();
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes the edges of the mesh that a cut locus consists of, each as a line with the numbers of its two vertices. Edges
 * of the graph that follow no edge of the mesh are left out.
 *
 * @param os the output stream
 * @param cut_locus the cut locus
 * @param tm the mesh it was computed on
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{a property map with the number of each vertex of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an integer as value type}
 *     \cgalParamDefault{the positions in the range `vertices(tm)`, counted from 0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map of the edges of the graph that are to be marked, by a third word, `marked`, in their lines}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<Cut_locus::Graph>::%edge_descriptor`
 *                    as key type and `bool` as value type}
 *     \cgalParamDefault{none: nothing is written about marks}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return `true` if all has been written
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_edges(std::ostream& os, const Cut_locus<TriangleMesh, Point_3>& cut_locus, const TriangleMesh& tm,
                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto& graph = cut_locus.graph();
  auto position = get(dynamic_vertex_property_t<std::size_t>(), tm);
  std::size_t number = 0;
  for(auto v : CGAL::make_range(vertices(tm)))
    put(position, v, number++);
  const auto numbers = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_index), position);
  const auto is_marked = Cut_loci::internal::edge_marks(np);
  for(auto e : CGAL::make_range(edges(graph)))
  {
    const auto h = graph[e].mesh_halfedge;
    if(h != boost::graph_traits<TriangleMesh>::null_halfedge())
      os << get(numbers, source(h, tm)) << ' ' << get(numbers, target(h, tm)) << (is_marked(e) ? " marked\n" : "\n");
  }
  return os.good();
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusIO
 *
 * writes a cut locus to a file in the format that its extension names: `.polylines.txt` (`write_polylines()`), `.obj`
 * (`write_OBJ()`), `.ply` (`write_PLY()`) or `.vtp` (`write_VTP()`).
 *
 * @param filename the name of the file
 * @param cut_locus the cut locus
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{stream_precision}
 *     \cgalParamDescription{the number of significant digits of the numbers}
 *     \cgalParamType{int}
 *     \cgalParamDefault{17, with which every `double` is read back as it was}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map of the edges of the graph that are to be marked, by 1 in a property `marked` of the edges (PLY, VTP) or by comments (OBJ)}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<Cut_locus::Graph>::%edge_descriptor`
 *                    as key type and `bool` as value type}
 *     \cgalParamDefault{none: nothing is written about marks}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return `true` if all has been written, `false` also if the extension is another one
 */
template <typename TriangleMesh, typename Point_3, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_cut_locus(const std::string& filename, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto ends_with = [&](const std::string& extension)
  {
    return filename.size() > extension.size() &&
           filename.compare(filename.size() - extension.size(), extension.size(), extension) == 0;
  };
  const bool is_polylines = ends_with(".polylines.txt"), is_OBJ = ends_with(".obj"), is_PLY = ends_with(".ply");
  if(!is_polylines && !is_OBJ && !is_PLY && !ends_with(".vtp"))
    return false;
  std::ofstream os(filename);
  const bool is_written = is_polylines ? IO::write_polylines(os, cut_locus, np)
                          : is_OBJ     ? IO::write_OBJ(os, cut_locus, np)
                          : is_PLY     ? IO::write_PLY(os, cut_locus, np)
                                       : IO::write_VTP(os, cut_locus, np);
  os.close();
  return is_written && !os.fail();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_CUT_LOCI_IO_WRITE_CUT_LOCUS_H
