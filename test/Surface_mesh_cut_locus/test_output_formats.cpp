// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What the writers write is read back and compared with the graph, number by number.

#include "surface_test.h"
#include "cut_locus_by_hand.h"

#include <CGAL/Cut_loci/IO/write_cut_locus.h>
#include <CGAL/Cut_loci/statistics.h>

#include <CGAL/boost/graph/generators.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <boost/property_map/function_property_map.hpp>

#include <fstream>

namespace test_output_formats {

namespace {

using namespace surface_test;
using Point_3 = Kernel::Point_3;
using Graph = Cut_locus::Graph;
using Coordinates = std::array<double, 3>;
using Segment = std::pair<Coordinates, Coordinates>;

Coordinates coordinates(const Point_3& p)
{
  return {{p.x(), p.y(), p.z()}};
}

Segment segment(Coordinates a, Coordinates b)
{
  if(b < a)
    std::swap(a, b);
  return {a, b};
}

// A cut locus with the given edges, whose coordinates take all digits of a double.
Cut_locus make_cut_locus(std::size_t number_of_vertices, const std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  Graph graph(number_of_vertices);
  for(std::size_t i = 0; i < number_of_vertices; ++i)
  {
    const double t = static_cast<double>(i);
    graph[i].point = Point_3(std::sin(t), -1e-9 / (t + 3.), 1e6 * std::cos(t));
    graph[i].mesh_vertex = Mesh::null_vertex();
    graph[i].distance = 5. + std::sqrt(t);
  }
  for(const auto& e : edges)
  {
    Cut_locus::Edge edge;
    edge.mesh_halfedge = Mesh::null_halfedge();
    edge.width = 3. + std::sqrt(static_cast<double>(e.first));
    edge.curvature = 1e-3 * static_cast<double>(e.second);
    edge.sources = {{1, 2}};
    edge.strength = 1. / (1. + static_cast<double>(e.first) + 7. * static_cast<double>(e.second));
    add_edge(e.first, e.second, edge, graph);
  }
  return cut_locus_by_hand<Cut_locus>(graph);
}

// Three branches of different lengths, one of which ends in a loop.
Cut_locus branched()
{
  return make_cut_locus(9, {{0, 1}, {2, 1}, {2, 3}, {2, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {5, 8}});
}
Cut_locus closed()
{
  return make_cut_locus(4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}});
}
Cut_locus single()
{
  return make_cut_locus(1, {});
}
Cut_locus parallel()
{
  return make_cut_locus(4, {{0, 1}, {1, 2}, {0, 3}, {3, 2}, {0, 2}});
}

std::vector<Cut_locus> all_cases()
{
  return {branched(), closed(), single(), parallel()};
}

std::vector<Segment> segments(const Cut_locus& cut_locus)
{
  const Graph& graph = cut_locus.graph();
  std::vector<Segment> result;
  for(auto e : CGAL::make_range(edges(graph)))
    result.push_back(segment(coordinates(graph[source(e, graph)].point), coordinates(graph[target(e, graph)].point)));
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Segment> segments(const std::vector<std::vector<Coordinates>>& polylines)
{
  std::vector<Segment> result;
  for(const auto& polyline : polylines)
    for(std::size_t i = 1; i < polyline.size(); ++i)
      result.push_back(segment(polyline[i - 1], polyline[i]));
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::vector<Coordinates>> read_polylines(const std::string& text)
{
  std::vector<std::vector<Coordinates>> polylines;
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);)
  {
    std::istringstream numbers(line);
    std::size_t n = 0;
    EXPECT_TRUE(numbers >> n);
    polylines.emplace_back(n);
    for(Coordinates& p : polylines.back())
      EXPECT_TRUE(numbers >> p[0] >> p[1] >> p[2]);
    std::string rest;
    EXPECT_FALSE(numbers >> rest);
  }
  return polylines;
}

template <typename T>
std::vector<T> read_numbers(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<T> numbers;
  for(T number; stream >> number;)
    numbers.push_back(number);
  EXPECT_TRUE(stream.eof());
  return numbers;
}

} // namespace

TEST(Output_formats, Polylines)
{
  for(const Cut_locus& cut_locus : all_cases())
  {
    std::ostringstream os;
    ASSERT_TRUE(CGAL::IO::write_polylines(os, cut_locus));
    EXPECT_EQ(segments(read_polylines(os.str())), segments(cut_locus));
  }
}

TEST(Output_formats, Polylines_are_maximal_chains)
{
  std::ostringstream os;
  CGAL::IO::write_polylines(os, branched());
  std::vector<std::size_t> sizes;
  for(const auto& polyline : read_polylines(os.str()))
    sizes.push_back(polyline.size());
  std::sort(sizes.begin(), sizes.end());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{2, 3, 3, 5})); // 3-2, 0-1-2, 2-4-5 and the loop at 5

  std::ostringstream os_closed;
  CGAL::IO::write_polylines(os_closed, closed());
  const auto loop = read_polylines(os_closed.str());
  ASSERT_EQ(loop.size(), 1u);
  ASSERT_EQ(loop.front().size(), 5u);
  EXPECT_EQ(loop.front().front(), loop.front().back());

  std::ostringstream os_single;
  CGAL::IO::write_polylines(os_single, single());
  const auto point = read_polylines(os_single.str());
  ASSERT_EQ(point.size(), 1u);
  ASSERT_EQ(point.front().size(), 1u);
  EXPECT_EQ(point.front().front(), coordinates(single().graph()[0].point));
}

TEST(Output_formats, OBJ)
{
  for(const Cut_locus& cut_locus : all_cases())
  {
    std::ostringstream os;
    ASSERT_TRUE(CGAL::IO::write_OBJ(os, cut_locus));
    std::istringstream lines(os.str());
    std::vector<Coordinates> points;
    std::vector<std::vector<Coordinates>> polylines;
    std::size_t isolated = 0;
    for(std::string line; std::getline(lines, line);)
    {
      std::istringstream record(line);
      std::string type;
      record >> type;
      if(type == "v")
      {
        points.emplace_back();
        EXPECT_TRUE(record >> points.back()[0] >> points.back()[1] >> points.back()[2]);
        continue;
      }
      ASSERT_TRUE(type == "l" || type == "p") << line;
      isolated += type == "p";
      polylines.emplace_back();
      for(std::size_t i; record >> i;)
      {
        ASSERT_GE(i, 1u);
        ASSERT_LE(i, points.size());
        polylines.back().push_back(points[i - 1]);
      }
      EXPECT_EQ(polylines.back().size() == 1, type == "p");
    }
    EXPECT_EQ(points.size(), num_vertices(cut_locus.graph()));
    EXPECT_EQ(segments(polylines), segments(cut_locus));
    EXPECT_EQ(isolated, num_edges(cut_locus.graph()) == 0 ? 1u : 0u);
  }
}

TEST(Output_formats, PLY)
{
  for(const Cut_locus& cut_locus : all_cases())
  {
    const Graph& graph = cut_locus.graph();
    std::ostringstream os;
    ASSERT_TRUE(CGAL::IO::write_PLY(os, cut_locus));
    std::istringstream is(os.str());
    std::vector<std::string> header;
    for(std::string line; std::getline(is, line) && line != "end_header";)
      header.push_back(line);
    const std::vector<std::string> expected = {"ply",
                                               "format ascii 1.0",
                                               "element vertex " + std::to_string(num_vertices(graph)),
                                               "property double x",
                                               "property double y",
                                               "property double z",
                                               "property double distance",
                                               "element edge " + std::to_string(num_edges(graph)),
                                               "property int vertex1",
                                               "property int vertex2",
                                               "property double strength",
                                               "property double width",
                                               "property double enclosed",
                                               "property int source1",
                                               "property int source2"};
    EXPECT_EQ(header, expected);
    for(auto v : CGAL::make_range(vertices(graph)))
    {
      Coordinates p;
      double distance = 0.;
      ASSERT_TRUE(is >> p[0] >> p[1] >> p[2] >> distance);
      EXPECT_EQ(p, coordinates(graph[v].point));
      EXPECT_EQ(distance, graph[v].distance);
    }
    for(std::size_t i = 0; i < num_edges(graph); ++i)
    {
      std::size_t a = 0, b = 0;
      double strength = 0., width = 0., enclosed = 0., source1 = 0., source2 = 0.;
      ASSERT_TRUE(is >> a >> b >> strength >> width >> enclosed >> source1 >> source2);
      const auto e = boost::edge(a, b, graph);
      ASSERT_TRUE(e.second);
      EXPECT_EQ(strength, graph[e.first].strength);
      EXPECT_EQ(width, graph[e.first].width);
      EXPECT_EQ(enclosed, graph[e.first].curvature);
      EXPECT_EQ(source1, 1.);
      EXPECT_EQ(source2, 2.);
    }
    std::string rest;
    EXPECT_FALSE(is >> rest);
  }
}

TEST(Output_formats, VTP)
{
  for(const Cut_locus& cut_locus : all_cases())
  {
    const Graph& graph = cut_locus.graph();
    const std::size_t isolated = num_edges(graph) == 0 ? 1 : 0;
    std::ostringstream os;
    ASSERT_TRUE(CGAL::IO::write_VTP(os, cut_locus));
    std::istringstream is(os.str());
    boost::property_tree::ptree tree;
    ASSERT_NO_THROW(boost::property_tree::read_xml(is, tree));
    EXPECT_EQ(tree.get<std::string>("VTKFile.<xmlattr>.type"), "PolyData");
    const auto& piece = tree.get_child("VTKFile.PolyData.Piece");
    EXPECT_EQ(piece.get<std::size_t>("<xmlattr>.NumberOfPoints"), num_vertices(graph));
    EXPECT_EQ(piece.get<std::size_t>("<xmlattr>.NumberOfLines"), num_edges(graph));
    EXPECT_EQ(piece.get<std::size_t>("<xmlattr>.NumberOfVerts"), isolated);

    const auto points = read_numbers<double>(piece.get<std::string>("Points.DataArray"));
    const auto distances = read_numbers<double>(piece.get<std::string>("PointData.DataArray"));
    ASSERT_EQ(points.size(), 3 * num_vertices(graph));
    ASSERT_EQ(distances.size(), num_vertices(graph));
    for(auto v : CGAL::make_range(vertices(graph)))
    {
      EXPECT_EQ((Coordinates{{points[3 * v], points[3 * v + 1], points[3 * v + 2]}}), coordinates(graph[v].point));
      EXPECT_EQ(distances[v], graph[v].distance);
    }

    std::map<std::string, std::vector<std::size_t>> lines, verts;
    for(const auto& array : piece.get_child("Lines"))
      lines[array.second.get<std::string>("<xmlattr>.Name")] = read_numbers<std::size_t>(array.second.data());
    for(const auto& array : piece.get_child("Verts"))
      verts[array.second.get<std::string>("<xmlattr>.Name")] = read_numbers<std::size_t>(array.second.data());
    EXPECT_EQ(verts["connectivity"].size(), isolated);
    EXPECT_EQ(verts["offsets"].size(), isolated);
    ASSERT_EQ(lines["connectivity"].size(), 2 * num_edges(graph));
    ASSERT_EQ(lines["offsets"].size(), num_edges(graph));
    std::map<std::string, std::vector<double>> cells;
    for(const auto& array : piece.get_child("CellData"))
      if(array.first == "DataArray")
        cells[array.second.get<std::string>("<xmlattr>.Name")] = read_numbers<double>(array.second.data());
    for(const char* name : {"strength", "width", "enclosed", "source1", "source2"})
      ASSERT_EQ(cells[name].size(), num_edges(graph) + isolated) << name;
    for(std::size_t i = 0; i < num_edges(graph); ++i)
    {
      EXPECT_EQ(lines["offsets"][i], 2 * (i + 1));
      const auto e = boost::edge(lines["connectivity"][2 * i], lines["connectivity"][2 * i + 1], graph);
      ASSERT_TRUE(e.second);
      EXPECT_EQ(cells["strength"][isolated + i], graph[e.first].strength);
      EXPECT_EQ(cells["width"][isolated + i], graph[e.first].width);
      EXPECT_EQ(cells["enclosed"][isolated + i], graph[e.first].curvature);
      EXPECT_EQ(cells["source2"][isolated + i], 2.);
    }
  }
}

TEST(Output_formats, Edges_of_the_mesh)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), mesh);
  // an element that is removed but not yet collected: positions and indices differ from there on
  const Mesh::Vertex_index first = *mesh.vertices_begin();
  const Mesh::Vertex_index added = mesh.add_vertex(Point_3(2, 2, 2));
  CGAL::Euler::remove_face(mesh.halfedge(*mesh.faces_begin()), mesh);
  mesh.remove_vertex(added);
  ASSERT_EQ(*mesh.vertices_begin(), first);

  Graph graph(2);
  Cut_locus::Edge on_mesh, elsewhere;
  on_mesh.mesh_halfedge = mesh.halfedge(*mesh.edges_begin());
  elsewhere.mesh_halfedge = Mesh::null_halfedge();
  add_edge(0, 1, on_mesh, graph);
  add_edge(0, 1, elsewhere, graph);
  const Cut_locus cut_locus = cut_locus_by_hand<Cut_locus>(graph);
  std::ostringstream os;
  ASSERT_TRUE(CGAL::IO::write_edges(os, cut_locus, mesh));
  const auto numbers = read_numbers<std::size_t>(os.str());
  ASSERT_EQ(numbers.size(), 2u);
  EXPECT_EQ(*std::next(mesh.vertices_begin(), static_cast<std::ptrdiff_t>(numbers[0])),
            mesh.source(on_mesh.mesh_halfedge));
  EXPECT_EQ(*std::next(mesh.vertices_begin(), static_cast<std::ptrdiff_t>(numbers[1])),
            mesh.target(on_mesh.mesh_halfedge));

  const auto number =
    boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) { return v == first ? 70 : 80; });
  const auto always = CGAL::Static_boolean_property_map<boost::graph_traits<Graph>::edge_descriptor, true>();
  std::ostringstream marked;
  ASSERT_TRUE(
    CGAL::IO::write_edges(marked, cut_locus, mesh, params::vertex_index_map(number).edge_is_constrained_map(always)));
  EXPECT_EQ(marked.str().substr(5), " marked\n") << marked.str();
  EXPECT_EQ(marked.str().find_first_not_of("780 marked\n"), std::string::npos) << marked.str();
}

TEST(Output_formats, Marked_edges)
{
  const Cut_locus cut_locus = closed();
  const Graph& graph = cut_locus.graph();
  const auto is_marked = boost::make_function_property_map<boost::graph_traits<Graph>::edge_descriptor>(
    [&](const auto& e) { return source(e, graph) == 1 || target(e, graph) == 1; });
  const auto count = [](const std::string& text, const std::string& part)
  {
    std::size_t n = 0;
    for(std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1))
      ++n;
    return n;
  };
  std::ostringstream ply, vtp, obj, plain;
  const auto np = params::edge_is_constrained_map(is_marked);
  EXPECT_TRUE(CGAL::IO::write_PLY(ply, cut_locus, np) && CGAL::IO::write_VTP(vtp, cut_locus, np) &&
              CGAL::IO::write_OBJ(obj, cut_locus, np) && CGAL::IO::write_PLY(plain, cut_locus));
  EXPECT_EQ(count(ply.str(), "property uchar marked\n"), 1u);
  EXPECT_EQ(count(ply.str(), " 1\n"), 2u);
  EXPECT_EQ(count(ply.str(), " 0\n"), 2u);
  expect_has(vtp.str(), "Name=\"marked\" format=\"ascii\">\n1\n1\n0\n0\n");
  EXPECT_EQ(count(obj.str(), "# marked "), 2u);
  EXPECT_EQ(count(plain.str(), "marked"), 0u);
}

TEST(Output_formats, The_extension_names_the_format)
{
  const std::string base = ::testing::TempDir() + "cut_locus_output";
  const std::map<std::string, std::string> starts = {
    {".polylines.txt", "3 "}, {".obj", "v "}, {".ply", "ply\n"}, {".vtp", "<?xml"}};
  for(const auto& format : starts)
  {
    const std::string filename = base + format.first;
    ASSERT_TRUE(CGAL::IO::write_cut_locus(filename, branched()));
    std::ifstream is(filename);
    const std::string text((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
    EXPECT_EQ(text.compare(0, format.second.size(), format.second), 0) << filename;
    std::remove(filename.c_str());
  }
  EXPECT_FALSE(CGAL::IO::write_cut_locus(base + ".txt", branched()));
  EXPECT_FALSE(CGAL::IO::write_cut_locus("", branched()));
  EXPECT_FALSE(CGAL::IO::write_cut_locus(base + "/no/such/folder.obj", branched()));
}

TEST(Output_formats, Streams_keep_their_format)
{
  std::ostringstream os;
  os.precision(3);
  os.setf(std::ios_base::fixed, std::ios_base::floatfield);
  CGAL::IO::write_PLY(os, branched());
  EXPECT_EQ(os.precision(), 3);
  EXPECT_TRUE(os.flags() & std::ios_base::fixed);

  std::ostringstream narrow;
  CGAL::IO::write_polylines(narrow, single(), params::stream_precision(2));
  EXPECT_EQ(narrow.str(), "1 0 -3.3e-10 1e+06\n");
}

TEST(Statistics, Count_what_the_graph_consists_of)
{
  const auto s = CGAL::Cut_loci::compute_statistics(branched());
  EXPECT_EQ(s.vertices, 9u);
  EXPECT_EQ(s.edges, 9u);
  EXPECT_EQ(s.components, 1u);
  EXPECT_EQ(s.cycles, 1u);
  EXPECT_EQ(s.leaves, 2u);
  EXPECT_EQ(s.branchings, 2u);
  EXPECT_EQ(s.injectivity_radius, 5.);
  EXPECT_EQ(CGAL::Cut_loci::description(s.status), "");

  const auto point = CGAL::Cut_loci::compute_statistics(single());
  EXPECT_EQ(point.components, 1u);
  EXPECT_EQ(point.cycles, 0u);
  EXPECT_EQ(point.leaves, 0u);
  EXPECT_EQ(point.length, 0.);
  EXPECT_EQ(point.status, CGAL::Cut_loci::Cut_locus_status::ONE_POINT);
  EXPECT_NE(CGAL::Cut_loci::description(point.status), "");

  EXPECT_EQ(CGAL::Cut_loci::compute_statistics(parallel()).cycles, 2u);
}

} // namespace test_output_formats
