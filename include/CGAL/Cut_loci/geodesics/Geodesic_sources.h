// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_SOURCES_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_SOURCES_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * holds the sources of a run of `Exact_geodesic_propagation`: points, and edges on the border, called lines.
 *
 * The waves of a line are parallel. They are those of an image far behind it, at the same distance D from both of its
 * ends, and `sigma` is -D: so by the image, distances are zero at the ends of a line of the length l, and in between down to
 * -l^2 / (8 D), as sqrt(D^2 - l^2 / 4) says. By its direction, `distance_to_line()` gives the distance that is meant. Where
 * only distances are wanted, D is so large that no direction tells the waves from parallel ones, and distances are theirs.
 *
 * Paths start at origins: sources, or vertices at which they bend.
 */
class Geodesic_sources
{
public:
  /// a vertex as a location
  Indexed_location vertex_location(Index v) const
  {
    if(v >= faces_.number_of_vertices() || faces_.first_halfedge(v) == null_index)
      throw Invalid_input(Cause::INVALID_SOURCE, "vertex #" + std::to_string(v) + " is on no face");
    return location_on(faces_.first_halfedge(v));
  }

  struct Source
  {
    Indexed_location location;
    Index vertex;   // if it is at one
    Index halfedge; // if it is on an edge
    double total_angle;
    Index owner = null_index;
    Index line = null_index; // the halfedge, if it is an edge
  };

  /// a location as a source, but for what says whose it is
  /// \throws Invalid_input if it is none on the mesh
  Source classify(Indexed_location location) const
  {
    check(location);
    // a point not farther than this from an edge is on it: no coordinate of a mesh is known any better
    constexpr double snap = 1e-13;
    normalize(location.coordinates, snap);
    Source source{location, null_index, edge_of(location), 2. * geodesic_pi};
    for(std::size_t i = 0; i < 3; ++i)
      if(location.coordinates[i] == 1.)
      {
        source.vertex = faces_.face(location.face).vertex[i];
        source.total_angle = faces_.total_angle(source.vertex);
      }
    if(source.halfedge != null_index && faces_.opposite(source.halfedge) == null_index)
      source.total_angle = geodesic_pi;
    return source;
  }

  /// \throws Invalid_input if `location` is none on the mesh
  void check(const Indexed_location& location) const
  {
    if(location.face >= faces_.number_of_faces())
      throw Invalid_input(Cause::INVALID_SOURCE,
                          "a location is in face " + std::to_string(location.face) + ", which does not exist");
    double sum = 0.;
    bool is_inside = true;
    for(double c : location.coordinates)
    {
      is_inside = is_inside && c >= -1e-9; // what point location by projection may get wrong
      sum += c;
    }
    if(!is_inside || !(std::fabs(sum - 1.) <= 1e-9))
      throw Invalid_input(Cause::INVALID_SOURCE, "the coordinates of a location in face " +
                                                   std::to_string(location.face) + " are not barycentric");
  }

  const Geodesic_faces& faces() const { return faces_; }
  const std::shared_ptr<const Geodesic_faces>& shared_faces() const { return shared_faces_; }

  std::size_t number_of_sources() const { return sources_.size(); }
  /// the total angle at source number `i`: two pi in faces
  double source_angle(std::size_t i = 0) const { return sources_[i].total_angle; }

  /// by what angles at source number `i` are multiplied so that they add up to a full turn; on the border they stay
  double angle_scale(std::size_t i = 0) const
  {
    return is_source_on_border(i) ? 1. : 2. * geodesic_pi / source_angle(i);
  }

  bool is_source_on_border(std::size_t i = 0) const
  {
    const Source& source = sources_[i];
    return source.vertex != null_index ? faces_.is_border(source.vertex) : source.total_angle < 1.5 * geodesic_pi;
  }

  /// the halfedge along which directions at source number `i` are zero
  Index source_halfedge(std::size_t i = 0) const
  {
    const Source& source = sources_[i];
    if(source.vertex != null_index)
      return faces_.first_halfedge(source.vertex);
    return source.halfedge != null_index ? source.halfedge : 3 * source.location.face;
  }

  /// the number of a vertex as an origin, and back; the sources come first
  Index origin_of_vertex(Index v) const { return static_cast<Index>(sources_.size()) + v; }
  Index vertex_of_origin(Index origin) const { return origin - static_cast<Index>(sources_.size()); }
  bool is_source(Index origin) const { return origin < sources_.size(); }

  const Indexed_location& source_location(std::size_t i) const { return sources_[i].location; }
  Index source_vertex(std::size_t i) const { return sources_[i].vertex; }
  /// a halfedge of the edge it is on, if it is on one
  Index source_edge(std::size_t i) const { return sources_[i].halfedge; }

  /// the number of the set of sources that a source belongs to
  Index owner(Index source) const { return sources_[source].owner; }

  // -- lines -------------------------------------------------------------------------------------------------------------

  bool has_lines() const { return !line_at_.empty(); }
  /// whether there are lines, and distances from them are not those from images
  bool has_parallel_waves() const { return has_lines() && has_parallel_waves_; }
  bool is_line(Index origin) const { return is_source(origin) && sources_[origin].line != null_index; }
  Index line_halfedge(Index source) const { return sources_[source].line; }
  /// the number of the source that is the border halfedge `h`, or null
  Index line_at(Index h) const { return line_at_.empty() ? null_index : line_at_[h]; }
  /// the sources that are the border edges at a vertex, or null: before its first face, and behind its last one
  Index first_line(Index v) const { return line_at(faces_.first_halfedge(v)); }
  Index last_line(Index v) const { return line_at(Mesh::previous(last_halfedge(v))); }

  /// of the images of lines from the ends of their edges. At 8192 times the longest edge, a distance by an image is too short
  /// by up to 1/65536 of that, and known to 1e-12 of it.
  double line_distance() const { return line_distance_; }
  /// half of the angle between the outer rays of a source: zero for a point
  double half_opening(Index source) const
  {
    const Index h = sources_[source].line;
    return h == null_index ? 0. : std::asin(0.5 * faces_.length(h) / line_distance_);
  }
  /// the image of a line, in the frame of its halfedge
  Plane_point line_image(Index source) const
  {
    const double half = 0.5 * faces_.length(sources_[source].line);
    return {half, -std::sqrt((line_distance_ - half) * (line_distance_ + half))};
  }
  /// the distance from a line of the end of a path that leaves its image in some direction and has the length `d` by that
  double distance_to_line(Index source, double d, double direction) const
  {
    const double depth = -line_image(source).y;
    return (std::max)((d + line_distance_) * std::sin(direction) - depth, 0.);
  }
  /// Of a vertex on lines, the directions from the first halfedge between the outer rays of the lines: in between, paths
  /// start at the vertex. If the second one is smaller, the lines see all points first.
  std::array<double, 2> fan(Index v) const
  {
    constexpr double right = 0.5 * geodesic_pi;
    const Index first = first_line(v), last = last_line(v);
    return {{first != null_index ? right + half_opening(first) : -infinity,
             last != null_index ? faces_.total_angle(v) - right - half_opening(last) : infinity}};
  }

  /// whether two sources of one set, both of them edges or one of them a vertex, have an end in common
  bool are_neighbors(Index a, Index b) const
  {
    if(!is_source(a) || !is_source(b) || owner(a) != owner(b) || (!is_line(a) && !is_line(b)))
      return false;
    const std::array<Index, 2> at_a = ends(a), at_b = ends(b);
    return at_a[0] == at_b[0] || at_a[0] == at_b[1] || at_a[1] == at_b[0] || at_a[1] == at_b[1];
  }

  /// whether paths that meet at this angle come from neighbors whose outer rays, in truth, are one: the boundary between
  /// them is on no cut locus. Outer rays of lines one behind the other meet at up to half of what is allowed; the rest is
  /// for corners that are no larger than that.
  bool is_seam(Index a, Index b, double meeting_angle) const
  {
    return has_lines() && meeting_angle <= seam_angle() && are_neighbors(a, b);
  }
  /// up to which rays that meet at a seam differ
  double seam_angle() const { return 2. / line_reach_; }

  /// whether a branch starts between the two lines at `v`, if there are two
  bool has_corner(Index v) const
  {
    return first_line(v) != null_index && last_line(v) != null_index &&
           geodesic_pi - faces_.total_angle(v) > seam_angle();
  }

  // -- frames ------------------------------------------------------------------------------------------------------------

  /// a vertex of the face of `h` in the frame of `h`
  Plane_point vertex_in_frame(Index h, Index v) const
  {
    if(faces_.source(h) == v)
      return {0., 0.};
    if(faces_.target(h) == v)
      return {faces_.length(h), 0.};
    return faces_.apex(h);
  }

  /// source number `i` in the frame of `h`, if it lies in the face of `h`
  bool source_in_frame(std::size_t i, Index h, Plane_point& p) const
  {
    const Source& source = sources_[i];
    const Index f = h / 3;
    if(source.vertex != null_index)
    {
      for(Index v : faces_.face(f).vertex)
        if(v == source.vertex)
        {
          p = vertex_in_frame(h, v);
          return true;
        }
      return false;
    }
    if(source.line != null_index)
      return false;
    if(source.location.face == f)
    {
      p = faces_.in_frame(h, source.location.coordinates);
      return true;
    }
    if(source.halfedge == null_index)
      return false;
    const Index o = faces_.opposite(source.halfedge);
    if(o == null_index || o / 3 != f)
      return false;
    p = faces_.in_frame(h, across(source.halfedge, o, source.location).coordinates);
    return true;
  }

protected:
  using Mesh = Indexed_triangle_mesh;
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  explicit Geodesic_sources(std::shared_ptr<const Geodesic_faces> faces)
    : shared_faces_(std::move(faces)), faces_(*shared_faces_)
  {
  }

  /// \throws Invalid_input if a location is none on the mesh
  void prepare_sources(const std::vector<Indexed_location>& points, const Exact_geodesic_options& options)
  {
    sources_.clear();
    for(const Indexed_location& location : points)
      sources_.push_back(classify(location));
    for(std::size_t i = 0; i < sources_.size(); ++i)
      sources_[i].owner = options.owners.empty() ? static_cast<Index>(i) : options.owners[i];
    has_parallel_waves_ = options.parallel_waves;
    line_reach_ = has_parallel_waves_ ? 1152921504606846976. : 8192.; // 2^60: nothing on the surface shows beside it
    prepare_lines(options.lines);
  }

private:
  void prepare_lines(const std::vector<Geodesic_line>& lines)
  {
    line_at_.clear();
    if(lines.empty())
      return;
    line_at_.assign(faces_.number_of_halfedges(), null_index);
    double longest = 0.;
    for(const Geodesic_line& line : lines)
    {
      longest = (std::max)(longest, faces_.length(line.halfedge));
      line_at_[line.halfedge] = static_cast<Index>(sources_.size());
      Source source{location_on(line.halfedge, 0.5), null_index, null_index, geodesic_pi, line.owner, line.halfedge};
      sources_.push_back(source);
    }
    line_distance_ = line_reach_ * longest;
  }

  /// that leaves `v`, a vertex of the border: the last one counterclockwise
  Index last_halfedge(Index v) const
  {
    Index h = faces_.first_halfedge(v);
    while(faces_.next_around_source(h) != null_index)
      h = faces_.next_around_source(h);
    return h;
  }

  /// the vertices of a source that is an edge or a vertex
  std::array<Index, 2> ends(Index source) const
  {
    const Index h = sources_[source].line, v = sources_[source].vertex;
    return h != null_index ? std::array<Index, 2>{{faces_.source(h), faces_.target(h)}} : std::array<Index, 2>{{v, v}};
  }

  std::shared_ptr<const Geodesic_faces> shared_faces_; // with others for the same mesh
  std::vector<Index> line_at_;                         // by halfedge; empty without lines
  double line_reach_ = 0., line_distance_ = 0.;
  bool has_parallel_waves_ = false;

protected:
  const Geodesic_faces& faces_;
  std::vector<Source> sources_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_SOURCES_H
