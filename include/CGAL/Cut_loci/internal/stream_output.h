// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_STREAM_OUTPUT_H
#define CGAL_CUT_LOCI_INTERNAL_STREAM_OUTPUT_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>

namespace CGAL::Cut_loci::internal {

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
template <typename Graph, typename NamedParameters>
class Edge_marks
{
  struct No_map
  {
  };
  using Map =
    typename internal_np::Lookup_named_param_def<internal_np::edge_is_constrained_t, NamedParameters, No_map>::type;
  using edge_descriptor = typename boost::graph_traits<Graph>::edge_descriptor;

public:
  explicit Edge_marks(const NamedParameters& np)
    : map_(parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained), No_map()))
  {
  }

  static constexpr bool is_given() { return !std::is_same<Map, No_map>::value; }

  bool operator()(const edge_descriptor& e) const
  {
    if constexpr(is_given())
      return get(map_, e);
    else
      return false;
  }

private:
  Map map_;
};

template <typename Graph, typename NamedParameters>
Edge_marks<Graph, NamedParameters> edge_marks(const Graph&, const NamedParameters& np)
{
  return Edge_marks<Graph, NamedParameters>(np);
}

template <typename Point_3>
void write_point(std::ostream& os, const Point_3& p)
{
  os << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z());
}

// Opens the file, calls the writer and tells whether all has been written.
template <typename Writer>
bool write_file(const std::string& filename, const Writer& writer)
{
  std::ofstream os(filename);
  if(!os || !writer(os))
    return false;
  os.close();
  return !os.fail();
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_STREAM_OUTPUT_H
