// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_SURFACE_WITHOUT_FLAT_FACES_H
#define CGAL_CUT_LOCI_SURFACE_SURFACE_WITHOUT_FLAT_FACES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the surface of a mesh without its faces that have no area, and the way back to the mesh.
 *
 * Such a face is a segment with a vertex on it, its longest edge is the other two. The face on the other side of that edge
 * is divided at the vertex, which takes one face without area away and changes no distance, unlike other lengths of edges
 * (see `Mollification`). Of several next to each other, those with a longest edge that is shared come first; what shares it
 * with another one gets a shorter one in its place. Ends of edges without length become one vertex.
 *
 * The result may have several edges between two vertices. What cannot be taken away, as at pinched places, stays.
 */
class Surface_without_flat_faces
{
public:
  explicit Surface_without_flat_faces(const Indexed_triangle_mesh& with,
                                      const Indexed_location& location = Indexed_location())
    : mesh_(with), location_(location), usual_(usual_edge_length(with)), vertex_(with.number_of_vertices()),
      origin_(with.number_of_halfedges()), is_removed_(with.number_of_faces(), 0)
  {
    for(Index v = 0; v < vertex_.size(); ++v)
      vertex_[v] = v;
    for(Index h = 0; h < origin_.size(); ++h)
      origin_[h] = h;
    for(Index f = 0; f < with.number_of_faces(); ++f)
      places_.push_back({f, {{{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}}});
    take_away_flat_faces();
    leave_out_what_is_removed();
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  /// where the location is in it
  const Indexed_location& location() const { return location_; }
  /// the vertex of `mesh()` at which a vertex of the mesh with flat faces is
  Index vertex_without(Index with) const { return vertex_[with]; }
  /// the other way around; of several at one place, one
  Index vertex_with(Index without) const { return vertex_with_[without]; }
  /// a halfedge of the mesh with flat faces that leads along one of `mesh()`, or null inside of a face
  Index halfedge_with(Index without) const { return origin_[without]; }
  Indexed_location location_with(const Indexed_location& without) const
  {
    const Place& place = places_[without.face];
    Indexed_location result;
    result.face = place.face;
    for(std::size_t i = 0; i < 3; ++i)
      result.coordinates = sum(1., result.coordinates, without.coordinates[i], place.corners[i]);
    return result;
  }

private:
  using Coordinates = std::array<double, 3>;

  /// of a face in one of the mesh with flat faces
  struct Place
  {
    Index face;
    std::array<Coordinates, 3> corners;
  };

  static Coordinates sum(double s, const Coordinates& a, double t, const Coordinates& b)
  {
    return {{s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]}};
  }

  static Index next(Index h) { return Indexed_triangle_mesh::next(h); }
  static Index previous(Index h) { return Indexed_triangle_mesh::previous(h); }

  bool is_flat(Index f) const { return !has_area(mesh_, f, usual_); }

  Index longest(Index f) const
  {
    Index result = 3 * f;
    for(Index h = result + 1; h < 3 * f + 3; ++h)
      if(edge_length(mesh_, h) > edge_length(mesh_, result))
        result = h;
    return result;
  }

  void glue(Index h, Index o)
  {
    if(h != null_index)
      mesh_.opposite[h] = o;
    if(o != null_index)
      mesh_.opposite[o] = h;
  }

  /// whether the source of a halfedge is on the border
  bool is_on_border(Index h) const
  {
    Index g = h;
    do
      g = mesh_.opposite[previous(g)];
    while(g != null_index && g != h);
    return g == null_index;
  }

  void locate(Index h, double at_source, double at_target, double at_third = 0.)
  {
    location_.face = h / 3;
    location_.coordinates[h % 3] = (std::max)(at_source, 0.);
    location_.coordinates[next(h) % 3] = (std::max)(at_target, 0.);
    location_.coordinates[previous(h) % 3] = (std::max)(at_third, 0.);
  }

  /// Each step leaves fewer flat faces, or such with shorter longest edges, but for rounding; what has to wait for others
  /// is met again.
  void take_away_flat_faces()
  {
    std::vector<Index> flat;
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
      if(is_flat(f))
        flat.push_back(f);
    bool has_changed = true;
    for(std::size_t turns_left = 2 * flat.size(); has_changed && turns_left > 0; --turns_left)
    {
      has_changed = false;
      for(std::size_t i = 0; i < flat.size(); ++i) // may grow
      {
        const Index f = flat[i];
        if(is_removed_[f] || !is_flat(f))
          continue;
        const Index o = mesh_.opposite[longest(f)];
        if(!take_away(f))
          continue;
        has_changed = true;
        if(o != null_index && !is_removed_[o / 3] && is_flat(o / 3))
          flat.push_back(o / 3);
      }
      std::sort(flat.begin(), flat.end());
      flat.erase(std::unique(flat.begin(), flat.end()), flat.end());
      flat.erase(std::remove_if(flat.begin(), flat.end(), [this](Index f) { return is_removed_[f] || !is_flat(f); }),
                 flat.end());
    }
  }

  /// or replaces the face by a smaller one, if that is possible as long as others are there
  bool take_away(Index f)
  {
    if(has_edge_without_length(f))
      return contract_in(f);
    const Index h = longest(f), o = mesh_.opposite[h];
    if(o == null_index)
      return remove_on_border(h);
    const Index g = o / 3;
    if(g == f || has_edge_without_length(g) || (is_flat(g) && edge_length(mesh_, longest(g)) > edge_length(mesh_, o)))
      return false;
    divide(h);
    return true;
  }

  // -- edges without length --------------------------------------------------------------------------------------------

  bool has_no_length(Index h) const
  {
    return edge_length(mesh_, h) <= least_length * (std::min)(edge_length(mesh_, longest(h / 3)), usual_);
  }

  bool has_edge_without_length(Index f) const
  {
    return is_flat(f) && (has_no_length(3 * f) || has_no_length(3 * f + 1) || has_no_length(3 * f + 2));
  }

  /// whether a flat face, and maybe one beside it, has been removed
  bool contract_in(Index f)
  {
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(has_no_length(h) && can_be_contracted(h))
      {
        contract(h);
        return true;
      }
    return false;
  }

  /// Between two edges with the same ends there are others, which come first. Where a hole or nothing would be left, the
  /// edge stays.
  bool can_be_contracted(Index h) const
  {
    const Index o = mesh_.opposite[h];
    if(mesh_.source(h) == mesh_.target(h) || number_of_edges_beside(h) > 1 || !can_vanish(h))
      return false;
    return o == null_index || (can_vanish(o) && !(is_on_border(h) && is_on_border(o)) &&
                               (has_neighbor_but(h, o / 3) || has_neighbor_but(o, h / 3)));
  }

  /// whether two edges of the face of `h` can become one
  bool can_vanish(Index h) const
  {
    const Index a = mesh_.opposite[next(h)], b = mesh_.opposite[previous(h)];
    return a != previous(h) && (a != null_index || b != null_index);
  }

  /// beyond the edges that become one
  bool has_neighbor_but(Index h, Index f) const
  {
    const Index a = mesh_.opposite[next(h)], b = mesh_.opposite[previous(h)];
    return (a != null_index && a / 3 != f) || (b != null_index && b / 3 != f);
  }

  /// the edges with the ends of `h`
  int number_of_edges_beside(Index h) const
  {
    int result = 0;
    const Index v = mesh_.target(h);
    Index g = h;
    do
    {
      result += mesh_.target(g) == v;
      if(mesh_.opposite[previous(g)] == null_index)
        result += mesh_.source(previous(g)) == v;
      g = mesh_.opposite[previous(g)];
    } while(g != null_index && g != h);
    if(g == null_index)
      for(g = mesh_.opposite[h]; g != null_index; g = mesh_.opposite[next(g)])
        result += mesh_.target(next(g)) == v;
    return result;
  }

  void contract(Index h)
  {
    const Index kept = mesh_.source(h), gone = mesh_.target(h), o = mesh_.opposite[h];
    // counterclockwise, and on the border the other way, too
    Index g = next(h);
    do
    {
      mesh_.triangles[g / 3][g % 3] = kept;
      g = mesh_.opposite[previous(g)];
    } while(g != null_index && g != next(h));
    if(g == null_index)
      for(g = mesh_.opposite[next(h)]; g != null_index; g = mesh_.opposite[next(g)])
        mesh_.triangles[next(g) / 3][next(g) % 3] = kept;
    vertex_[gone] = kept;
    vanish(h);
    if(o != null_index)
      vanish(o);
  }

  void vanish(Index h)
  {
    const Index f = h / 3, from_third = mesh_.opposite[next(h)], to_third = mesh_.opposite[previous(h)];
    glue(from_third, to_third);
    is_removed_[f] = 1;
    if(location_.face != f)
      return;
    const double third = location_.coordinates[previous(h) % 3];
    if(from_third != null_index)
      locate(from_third, third, 1. - third);
    else
      locate(to_third, 1. - third, third);
  }

  // -- vertices on edges -----------------------------------------------------------------------------------------------

  /// where the vertex opposite to the longest edge of a flat face is on this
  double share(Index h) const
  {
    const double before = edge_length(mesh_, previous(h)), after = edge_length(mesh_, next(h));
    return before / (before + after);
  }

  /// The border takes the way over the vertex, unless it has been there.
  bool remove_on_border(Index h)
  {
    const Index f = h / 3, to_target = mesh_.opposite[next(h)], from_source = mesh_.opposite[previous(h)];
    if(to_target == null_index || from_source == null_index || to_target / 3 == f || is_on_border(previous(h)))
      return false;
    glue(to_target, null_index);
    glue(from_source, null_index);
    is_removed_[f] = 1;
    if(location_.face != f)
      return true;
    const double t = share(h), s = location_.coordinates[next(h) % 3] + t * location_.coordinates[previous(h) % 3];
    if(s < t)
      locate(from_source, 1. - s / t, s / t);
    else
      locate(to_target, (1. - s) / (1. - t), (s - t) / (1. - t));
    return true;
  }

  /// A flat face (a, b, v) and its neighbor (b, a, c) become (v, a, c) and (v, c, b).
  void divide(Index h)
  {
    const Index o = mesh_.opposite[h], f = h / 3, g = o / 3;
    const Index bv = next(h), va = previous(h), ac = next(o), cb = previous(o);
    const Index a = mesh_.source(h), b = mesh_.source(bv), v = mesh_.source(va), c = mesh_.source(cb);
    const bool is_neighbor_flat = is_flat(g);
    const double t = share(h), u = is_neighbor_flat ? 1. - share(o) : 0.; // from a to b: of v, and of c if it is there
    const std::array<double, 3> at = in_neighbor(h, t);
    const bool holds_location = location_.face == f || location_.face == g;

    const Place old = places_[g];
    const Coordinates &in_a = old.corners[ac % 3], &in_b = old.corners[o % 3], &in_c = old.corners[cb % 3];
    const Coordinates in_v = sum(1. - t, in_a, t, in_b);
    places_[f] = {old.face, {{in_v, in_a, in_c}}};
    places_[g] = {old.face, {{in_v, in_c, in_b}}};

    const std::array<Index, 4> before = {{va, ac, cb, bv}}, after = {{3 * f, 3 * f + 1, 3 * g + 1, 3 * g + 2}};
    std::array<Index, 4> outside, origin;
    for(std::size_t i = 0; i < 4; ++i)
    {
      outside[i] = mesh_.opposite[before[i]];
      origin[i] = origin_[before[i]];
    }
    const Index along = origin_[h], against = origin_[o];
    mesh_.triangles[f] = {{v, a, c}};
    mesh_.triangles[g] = {{v, c, b}};
    for(std::size_t i = 0; i < 4; ++i)
    {
      const auto same = std::find(before.begin(), before.end(), outside[i]);
      glue(after[i], same != before.end() ? after[static_cast<std::size_t>(same - before.begin())] : outside[i]);
      origin_[after[i]] = origin[i];
    }
    const Index vc = 3 * g, cv = 3 * f + 2;
    glue(vc, cv);
    origin_[vc] = !is_neighbor_flat ? null_index : t < u ? along : against;
    origin_[cv] = !is_neighbor_flat ? null_index : t < u ? against : along;

    if(!holds_location)
      return;
    if(is_neighbor_flat)
      locate_in_line(f, g, t, u, at[1] + u * at[2]);
    else if(at[1] <= t * (at[0] + at[1]))
      locate(3 * f, t > 0. ? at[1] / t : 0., t > 0. ? at[0] - at[1] * (1. - t) / t : at[0], at[2]);
    else
      locate(3 * g, at[0] / (1. - t), at[2], at[1] - at[0] * t / (1. - t));
  }

  /// the location as a sum of a, b and c
  std::array<double, 3> in_neighbor(Index h, double t) const
  {
    const Coordinates& x = location_.coordinates;
    if(location_.face == h / 3)
    {
      const double third = x[previous(h) % 3];
      return {{x[h % 3] + (1. - t) * third, x[next(h) % 3] + t * third, 0.}};
    }
    const Index o = mesh_.opposite[h];
    return {{x[next(o) % 3], x[o % 3], x[previous(o) % 3]}};
  }

  /// at `s` on the line of a = 0, b = 1, v = t and c = u
  void locate_in_line(Index f, Index g, double t, double u, double s)
  {
    const bool is_v_first = t < u;
    const double low = (std::min)(t, u), high = (std::max)(t, u);
    if(s < low)
    {
      const double share = s / low;
      locate(3 * f, is_v_first ? share : 0., 1. - share, is_v_first ? 0. : share);
    }
    else if(s < high)
    {
      const double share = (s - low) / (high - low);
      locate(3 * f, is_v_first ? 1. - share : share, 0., is_v_first ? share : 1. - share);
    }
    else
    {
      const double share = high < 1. ? (s - high) / (1. - high) : 1.;
      locate(3 * g, is_v_first ? 0. : 1. - share, is_v_first ? 1. - share : 0., share);
    }
  }

  // -- the result ------------------------------------------------------------------------------------------------------

  void leave_out_what_is_removed()
  {
    std::vector<Index> face(mesh_.number_of_faces(), null_index), vertex(mesh_.number_of_vertices(), null_index);
    Index faces = 0, vertices = 0;
    for(Index f = 0; f < face.size(); ++f)
      if(!is_removed_[f])
      {
        face[f] = faces++;
        for(Index v : mesh_.triangles[f])
          vertex[v] = 0;
      }
    for(Index& v : vertex)
      v = v == 0 ? vertices++ : null_index;
    const auto halfedge = [&](Index h) { return h != null_index ? 3 * face[h / 3] + h % 3 : null_index; };
    for(Index f = 0; f < face.size(); ++f)
      if(face[f] != null_index)
      {
        places_[face[f]] = places_[f];
        for(Index i = 0; i < 3; ++i)
        {
          mesh_.triangles[face[f]][i] = vertex[mesh_.triangles[f][i]];
          mesh_.opposite[3 * face[f] + i] = halfedge(mesh_.opposite[3 * f + i]);
          origin_[3 * face[f] + i] = origin_[3 * f + i];
        }
      }
    mesh_.triangles.resize(faces);
    mesh_.opposite.resize(3 * std::size_t(faces));
    if(location_.face != null_index)
      location_.face = face[location_.face];
    vertex_with_.resize(vertices);
    for(Index v = 0; v < vertex.size(); ++v)
      if(vertex[v] != null_index)
      {
        mesh_.points[vertex[v]] = mesh_.points[v];
        vertex_with_[vertex[v]] = v;
      }
    mesh_.points.resize(vertices);
    for(Index v = 0; v < vertex_.size(); ++v)
    {
      Index w = v;
      while(vertex_[w] != w)
        w = vertex_[w];
      vertex_[v] = w;
    }
    for(Index& v : vertex_)
      v = vertex[v];
  }

  static constexpr double least_length = 1e-9; // below, vertices cannot be told apart, as in `has_area()`

  Indexed_triangle_mesh mesh_;
  Indexed_location location_;
  double usual_;
  std::vector<Index> vertex_, vertex_with_;
  std::vector<Index> origin_; // of each halfedge
  std::vector<Place> places_; // of each face
  std::vector<unsigned char> is_removed_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_SURFACE_WITHOUT_FLAT_FACES_H
