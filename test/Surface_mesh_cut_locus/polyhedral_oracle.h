// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TEST_POLYHEDRAL_ORACLE_H
#define CGAL_CUT_LOCI_TEST_POLYHEDRAL_ORACLE_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <vector>

// Shortest paths on polyhedra by plain unfolding. Nothing is shared with the exact geodesics of the package but the
// arrays of the mesh: that is what makes it a test of them.
namespace polyhedral_oracle {

using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::Indexed_location;
using CGAL::Cut_loci::null_index;
using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;

constexpr double pi = 3.14159265358979323846;
constexpr double infinity = (std::numeric_limits<double>::infinity)();

// how a shortest path arrives
struct Arrival
{
  double distance = infinity; // from the source
  // In which direction the path leads back, counterclockwise around the location, in the angles of its faces. Zero is
  // the direction of the first edge of the face; at a vertex, that of the first edge of its fan.
  double direction = 0.;
  Index root = null_index;    // the last vertex at which the path bends, or null for the source
  double root_distance = 0.;  // of that vertex
  double root_direction = 0.; // in which the path leaves it
};

struct Plane_point
{
  double x = 0., y = 0.;
};

inline Plane_point operator+(const Plane_point& p, const Plane_point& q)
{
  return {p.x + q.x, p.y + q.y};
}
inline Plane_point operator-(const Plane_point& p, const Plane_point& q)
{
  return {p.x - q.x, p.y - q.y};
}
inline Plane_point operator*(double s, const Plane_point& p)
{
  return {s * p.x, s * p.y};
}
inline double cross(const Plane_point& p, const Plane_point& q)
{
  return p.x * q.y - p.y * q.x;
}
inline double length(const Plane_point& p)
{
  return std::hypot(p.x, p.y);
}
inline double distance(const Mesh::Point& p, const Mesh::Point& q)
{
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

// Unfolds the surface around a point: sends cones of straight paths from it through face after face.
class Unfolding
{
public:
  // a face with its corners in a plane in which the point is the origin
  struct Laid_face
  {
    Index face;
    std::array<Plane_point, 3> corner;
  };

  // The straight paths that enter the face of a halfedge through it. The origin is on its right, so that, seen from
  // there, the source of the halfedge is on the left.
  struct Cone
  {
    Index halfedge;
    Plane_point source, target; // of the halfedge
    Plane_point left, right;    // the ends of what the cone covers of the halfedge
  };

  explicit Unfolding(const Mesh& mesh) : mesh_(mesh)
  {
    first_halfedge_.assign(mesh.number_of_vertices(), null_index);
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      Index& first = first_halfedge_[mesh.source(h)];
      if(first == null_index || mesh.is_border_edge(h)) // a fan with border starts there
        first = h;
    }
  }

  double edge_length(Index h) const { return distance(mesh_.points[mesh_.source(h)], mesh_.points[mesh_.target(h)]); }

  // the angle of the corner at the source of `h`
  double angle(Index h) const
  {
    const Plane_point p = apex(h);
    return std::atan2(p.y, p.x);
  }

  // all faces around the location, in their order; those around an edge or a vertex fit together along it
  std::vector<Laid_face> around(const Indexed_location& location) const
  {
    std::array<double, 3> c = location.coordinates;
    std::vector<Index> corners;
    for(Index i = 0; i < 3; ++i)
      if(std::fabs(c[i]) < 1e-13)
        c[i] = 0.;
      else
        corners.push_back(i);
    if(corners.size() == 1)
      return around_vertex(mesh_.triangles[location.face][corners[0]]);
    std::vector<Laid_face> result(1, laid(3 * location.face, c));
    if(corners.size() == 2)
    {
      const Index i = corners[1] == (corners[0] + 1) % 3 ? corners[0] : corners[1], h = 3 * location.face + i;
      const Index o = mesh_.opposite[h];
      if(o != null_index)
      {
        std::array<double, 3> d = {{0., 0., 0.}};
        d[o % 3] = c[(i + 1) % 3];
        d[(o + 1) % 3] = c[i];
        Laid_face other = laid(o, d);
        const Plane_point along = result[0].corner[(i + 1) % 3] - result[0].corner[i];
        const Plane_point u = (-1. / length(along)) * along;
        for(Plane_point& p : other.corner)
          p = {p.x * u.x - p.y * u.y, p.x * u.y + p.y * u.x};
        result.push_back(other);
      }
    }
    return result;
  }

  // The faces around a vertex; their angles go on beyond 2 pi, which a plane can not show, so each face is rotated
  // separately, by `turn()`.
  std::vector<Laid_face> around_vertex(Index v) const
  {
    std::vector<Laid_face> result;
    Index h = first_halfedge_[v];
    do
    {
      std::array<double, 3> c = {{0., 0., 0.}};
      c[h % 3] = 1.;
      result.push_back(laid(h, c));
      h = mesh_.opposite[Mesh::previous(h)];
    } while(h != null_index && h != first_halfedge_[v]);
    return result;
  }

  // by how much the direction zero of face `i` around a vertex is ahead of that of the first
  double turn(Index v, std::size_t i) const
  {
    double result = 0.;
    Index h = first_halfedge_[v];
    for(; i > 0; --i)
    {
      result += angle(h);
      h = mesh_.opposite[Mesh::previous(h)];
    }
    return result;
  }

  double total_angle(Index v) const
  {
    double result = 0.;
    Index h = first_halfedge_[v];
    do
    {
      result += angle(h);
      h = mesh_.opposite[Mesh::previous(h)];
    } while(h != null_index && h != first_halfedge_[v]);
    return result;
  }

  // the direction at corner `i` of a laid face towards the origin, in the angles around that vertex
  double direction_at_corner(const Laid_face& f, int i) const
  {
    const Index v = mesh_.triangles[f.face][i];
    double result = 0.;
    Index h = first_halfedge_[v];
    for(; h / 3 != f.face; h = mesh_.opposite[Mesh::previous(h)])
      result += angle(h);
    const Plane_point from = f.corner[(i + 1) % 3] - f.corner[i], to = -1. * f.corner[i];
    return result + std::atan2(cross(from, to), from.x * to.x + from.y * to.y);
  }

  Indexed_location location_of_vertex(Index v) const
  {
    Indexed_location result;
    result.face = first_halfedge_[v] / 3;
    result.coordinates[first_halfedge_[v] % 3] = 1.;
    return result;
  }

  bool is_border(Index v) const { return mesh_.is_border_edge(first_halfedge_[v]); }

  // the paths that leave a face which the origin lies in or beside, one cone for each edge it does not lie on
  std::vector<Cone> leave(const Laid_face& f) const
  {
    std::vector<Cone> result;
    for(Index i = 0; i < 3; ++i)
    {
      const Index o = mesh_.opposite[3 * f.face + i];
      const Plane_point &p = f.corner[i], &q = f.corner[(i + 1) % 3];
      if(o != null_index && cross(p, q) > 1e-13 * length(p) * length(q) && length(p) > 0. && length(q) > 0.)
        result.push_back({o, q, p, q, p});
    }
    return result;
  }

  Plane_point apex(const Cone& c) const
  {
    const Plane_point p = apex(c.halfedge), e = c.target - c.source;
    const Plane_point u = (1. / length(e)) * e;
    return c.source + Plane_point{p.x * u.x - p.y * u.y, p.x * u.y + p.y * u.x};
  }

  // Whether a point of the face entered is seen, up to rounding.
  static bool is_in(const Cone& c, const Plane_point& p)
  {
    const double tolerance = 1e-12 * length(p);
    return cross(c.right, p) >= -tolerance * length(c.right) && cross(p, c.left) >= -tolerance * length(c.left);
  }

  // what goes on through the other two edges of the face
  template <typename Output>
  void cross_face(const Cone& c, const Output& output) const
  {
    const Plane_point a = apex(c);
    const Index n = mesh_.opposite[Mesh::next(c.halfedge)], p = mesh_.opposite[Mesh::previous(c.halfedge)];
    const bool is_left_of_right = cross(c.right, a) > 0., is_right_of_left = cross(a, c.left) > 0.;
    if(n != null_index && is_left_of_right)
      put({n, a, c.target, is_right_of_left ? a : c.left, c.right}, output);
    if(p != null_index && is_right_of_left)
      put({p, c.source, a, c.left, is_left_of_right ? a : c.right}, output);
  }

  // the length of the shortest path of the cone to its halfedge
  static double nearest(const Cone& c)
  {
    const Plane_point e = c.left - c.right;
    const double square = e.x * e.x + e.y * e.y;
    const double t = square > 0. ? -(c.right.x * e.x + c.right.y * e.y) / square : 0.;
    return length(c.right + (std::max)(0., (std::min)(1., t)) * e);
  }

private:
  // the third corner of the face of `h`, where `h` starts at the origin and runs along the x axis
  Plane_point apex(Index h) const
  {
    const Mesh::Point &p = mesh_.points[mesh_.source(h)], &q = mesh_.points[mesh_.target(h)],
                      &r = mesh_.points[mesh_.target(Mesh::next(h))];
    const Mesh::Point u = {{q[0] - p[0], q[1] - p[1], q[2] - p[2]}}, v = {{r[0] - p[0], r[1] - p[1], r[2] - p[2]}};
    const Mesh::Point n = {{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
    const double l = distance(p, q);
    return {(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / l, distance(n, {{0., 0., 0.}}) / l};
  }

  // with `h` along the x axis and the point with these coordinates at the origin
  Laid_face laid(Index h, const std::array<double, 3>& coordinates) const
  {
    Laid_face result;
    result.face = h / 3;
    result.corner[h % 3] = {0., 0.};
    result.corner[Mesh::next(h) % 3] = {edge_length(h), 0.};
    result.corner[Mesh::previous(h) % 3] = apex(h);
    Plane_point origin;
    int zeros = 0, last = 0;
    for(int i = 0; i < 3; ++i)
    {
      origin = origin + coordinates[i] * result.corner[i];
      zeros += coordinates[i] == 0.;
      last = coordinates[i] == 0. ? last : i;
    }
    if(zeros == 2)
      origin = result.corner[last]; // exactly
    for(Plane_point& p : result.corner)
      p = p - origin;
    return result;
  }

  // Puts the cone out, its ends moved onto its halfedge. One that is as narrow as rounding errors might turn around a
  // vertex for ever; what it sees, the cone beside it does too.
  template <typename Output>
  static void put(Cone c, const Output& output)
  {
    if(cross(c.right, c.left) <= 1e-13 * length(c.right) * length(c.left))
      return;
    for(Plane_point* p : {&c.left, &c.right})
    {
      const double from = cross(c.source, *p), to = cross(c.target, *p);
      const double t = from == to ? 0. : (std::max)(0., (std::min)(1., from / (from - to)));
      *p = c.source + t * (c.target - c.source);
    }
    output(c);
  }

  const Mesh& mesh_;
  std::vector<Index> first_halfedge_;
};

/*!
 * answers in how many ways shortest paths arrive at points of a surface.
 *
 * The constructor finds the distances of all vertices: cones from the source, and from each vertex at which a shortest
 * path may bend (on the border, or with an angle of 2 pi and more), in the order of the distance. Cones may overlap:
 * they are dropped only where a path through an end of their edge is shorter for all their points. A query sends cones
 * back from its location, and takes all ways to the source, or to a vertex whose distance is known, that are shortest.
 */
class Polyhedral_oracle
{
public:
  Polyhedral_oracle(const Mesh& mesh, const Indexed_location& source)
    : mesh_(mesh), unfolding_(mesh), source_(source), distance_(mesh.number_of_vertices(), infinity),
      bends_(mesh.number_of_vertices())
  {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    {
      bends_[v] = unfolding_.is_border(v) || unfolding_.total_angle(v) > 2. * pi + 1e-9;
      for(const Mesh::Point& p : {mesh.points[v]})
        scale_ = (std::max)(scale_, polyhedral_oracle::distance(p, mesh.points[0]));
    }
    find_source();
    compute_distances();
  }

  double distance(Index v) const { return distance_[v]; }

  // after which angle directions are the same again; infinity for a location on the border, around which they end
  double full_turn(const Indexed_location& location) const
  {
    const Index v = vertex_at(location);
    if(v != null_index)
      return unfolding_.is_border(v) ? infinity : unfolding_.total_angle(v);
    const bool is_on_edge = *std::min_element(location.coordinates.begin(), location.coordinates.end()) < 1e-13;
    return is_on_edge && unfolding_.around(location).size() == 1 ? infinity : 2. * pi;
  }

  // The shortest paths to the location that arrive in different directions, sorted by length: those that exceed the
  // least by up to `tolerance` times the size of the mesh. Where two paths meet at an angle, a location that is less than
  // about the tolerance divided by this angle away from the cut locus counts as on it.
  std::vector<Arrival> shortest_arrivals(const Indexed_location& location, double tolerance = 1e-10) const
  {
    const double slack = tolerance * scale_;
    std::vector<Arrival> found = arrivals(location, slack);
    std::sort(found.begin(), found.end(), [](const Arrival& a, const Arrival& b) { return a.distance < b.distance; });
    std::vector<Arrival> result;
    const double turn = full_turn(location);
    for(const Arrival& a : found)
    {
      const bool is_new = std::none_of(result.begin(), result.end(),
                                       [&](const Arrival& b)
                                       {
        const double d = std::fabs(a.direction - b.direction);
        return (std::min)(d, std::fabs(turn - d)) < least_angle;
      });
      if(a.distance <= found.front().distance + slack && is_new && is_straight_at_root(a, tolerance))
        result.push_back(a);
    }
    return result;
  }

private:
  using Cone = Unfolding::Cone;
  using Laid_face = Unfolding::Laid_face;

  // Paths whose directions differ less are taken for one: rounding finds some of them on both sides of a vertex.
  static constexpr double least_angle = 4e-6;

  // A way around a vertex that could be shortened is longer than the shortest by the square of what it bends only, which
  // can be less than any tolerance: it must have an angle of pi on both sides, or beside the border.
  bool is_straight_at_root(const Arrival& a, double tolerance) const
  {
    if(a.root == null_index)
      return true;
    const Indexed_location root = unfolding_.location_of_vertex(a.root);
    const std::vector<Arrival> to_root = shortest_arrivals(root, tolerance);
    return std::any_of(to_root.begin(), to_root.end(),
                       [&](const Arrival& b)
                       {
      const double d = std::fabs(a.root_direction - b.direction);
      return (std::min)(d, full_turn(root) - d) >= pi - 0.25 * least_angle;
    });
  }

  struct Entry
  {
    double key;
    double root_distance;
    Index vertex; // to start from, or null for a cone
    Cone cone;
    double turn;

    bool operator<(const Entry& other) const { return key > other.key; }
  };

  Index vertex_at(const Indexed_location& location) const
  {
    for(int i = 0; i < 3; ++i)
      if(location.coordinates[i] > 1. - 1e-13)
        return mesh_.triangles[location.face][i];
    return null_index;
  }

  // The source as a vertex, or in all its faces.
  void find_source()
  {
    source_vertex_ = vertex_at(source_);
    if(source_vertex_ != null_index)
      return;
    source_in_.push_back({source_.face, source_.coordinates});
    for(Index i = 0; i < 3; ++i)
    {
      const Index h = 3 * source_.face + i, o = mesh_.opposite[h];
      if(std::fabs(source_.coordinates[(i + 2) % 3]) > 1e-13 || o == null_index)
        continue;
      std::array<double, 3> c = {{0., 0., 0.}};
      c[o % 3] = source_.coordinates[(i + 1) % 3];
      c[(o + 1) % 3] = source_.coordinates[i];
      source_in_.push_back({o / 3, c});
    }
  }

  void compute_distances()
  {
    std::priority_queue<Entry> queue;
    const auto reach = [&](Index v, double d)
    {
      if(!(d < distance_[v] - 1e-14 * scale_))
        return;
      distance_[v] = d;
      if(bends_[v])
        queue.push({d, d, v, Cone(), 0.});
    };
    const auto push = [&](const Cone& c, double root_distance)
    {
      if(is_useful(c, root_distance))
        queue.push({root_distance + Unfolding::nearest(c), root_distance, null_index, c, 0.});
    };
    const auto start = [&](const std::vector<Laid_face>& faces, double root_distance)
    {
      for(const Laid_face& f : faces)
        for(int i = 0; i < 3; ++i)
          reach(mesh_.triangles[f.face][i], root_distance + length(f.corner[i]));
      for(const Laid_face& f : faces)
        for(const Cone& c : unfolding_.leave(f))
          push(c, root_distance);
    };
    start(unfolding_.around(source_), 0.);
    while(!queue.empty())
    {
      const Entry e = queue.top();
      queue.pop();
      if(e.vertex != null_index)
      {
        if(e.key == distance_[e.vertex])
          start(unfolding_.around_vertex(e.vertex), e.key);
        continue;
      }
      if(!is_useful(e.cone, e.root_distance))
        continue;
      const Plane_point apex = unfolding_.apex(e.cone);
      if(Unfolding::is_in(e.cone, apex))
        reach(mesh_.target(Mesh::next(e.cone.halfedge)), e.root_distance + length(apex));
      unfolding_.cross_face(e.cone, [&](const Cone& c) { push(c, e.root_distance); });
    }
  }

  // Not if the path through an end of the edge to the far end of the cone is shorter than that of the cone: then it is
  // for all points that the cone reaches, since paths to them cross this one [Xin, Wang 2009].
  bool is_useful(const Cone& c, double root_distance) const
  {
    const double slack = 1e-11 * scale_;
    const double from_source = distance_[mesh_.source(c.halfedge)] + length(c.right - c.source);
    const double from_target = distance_[mesh_.target(c.halfedge)] + length(c.left - c.target);
    return root_distance + length(c.right) <= from_source + slack &&
           root_distance + length(c.left) <= from_target + slack;
  }

  // all ways to the location whose length is at most `slack` above the least found
  std::vector<Arrival> arrivals(const Indexed_location& location, double slack) const
  {
    std::vector<Arrival> result;
    double best = infinity;
    const auto found = [&](double rest, const Plane_point& p, double turn, Index root, double root_direction)
    {
      const double d = rest + length(p);
      if(!(d <= best + slack))
        return;
      best = (std::min)(best, d);
      double angle = length(p) == 0. ? 0. : std::atan2(p.y, p.x) + turn;
      if(angle < 0. && angle > -1e-12)
        angle = 0.;
      result.push_back({d, angle < 0. ? angle + 2. * pi : angle, root, rest, root_direction});
    };
    const auto see_corner = [&](const Laid_face& f, int i, double turn)
    {
      const Index v = mesh_.triangles[f.face][i];
      if(v == source_vertex_)
        found(0., f.corner[i], turn, null_index, 0.);
      else if(bends_[v] && length(f.corner[i]) > 0.)
        found(distance_[v], f.corner[i], turn, v, unfolding_.direction_at_corner(f, i));
    };
    const auto see_source = [&](const Laid_face& f, const Cone* cone, double turn)
    {
      for(const Indexed_location& s : source_in_)
      {
        Plane_point p;
        for(int i = 0; i < 3; ++i)
          p = p + s.coordinates[i] * f.corner[i];
        if(s.face == f.face && (cone == nullptr || Unfolding::is_in(*cone, p)))
          found(0., p, turn, null_index, 0.);
      }
    };
    std::priority_queue<Entry> queue;
    const auto push = [&](const Cone& c, double turn)
    {
      const double e = length(c.target - c.source);
      const double rest = (std::max)(distance_[mesh_.source(c.halfedge)], distance_[mesh_.target(c.halfedge)]) - e;
      const double key = Unfolding::nearest(c) + (std::max)(0., rest);
      if(key <= best + slack + 1e-11 * scale_)
        queue.push({key, 0., null_index, c, turn});
    };

    const Index v = vertex_at(location);
    const std::vector<Laid_face> faces = v != null_index ? unfolding_.around_vertex(v) : unfolding_.around(location);
    for(std::size_t k = 0; k < faces.size(); ++k)
    {
      const double turn = v != null_index ? unfolding_.turn(v, k) : 0.;
      for(int i = 0; i < 3; ++i)
        see_corner(faces[k], i, turn);
      see_source(faces[k], nullptr, turn);
      for(const Cone& c : unfolding_.leave(faces[k]))
        push(c, turn);
    }
    while(!queue.empty() && queue.top().key <= best + slack + 1e-11 * scale_)
    {
      const Entry e = queue.top();
      queue.pop();
      const Index h = e.cone.halfedge;
      Laid_face f;
      f.face = h / 3;
      f.corner[h % 3] = e.cone.source;
      f.corner[Mesh::next(h) % 3] = e.cone.target;
      f.corner[Mesh::previous(h) % 3] = unfolding_.apex(e.cone);
      if(Unfolding::is_in(e.cone, f.corner[Mesh::previous(h) % 3]))
        see_corner(f, Mesh::previous(h) % 3, e.turn);
      see_source(f, &e.cone, e.turn);
      unfolding_.cross_face(e.cone, [&](const Cone& c) { push(c, e.turn); });
    }
    return result;
  }

  const Mesh& mesh_;
  Unfolding unfolding_;
  Indexed_location source_;
  Index source_vertex_ = null_index;
  std::vector<Indexed_location> source_in_;
  std::vector<double> distance_;
  std::vector<char> bends_;
  double scale_ = 0.;
};

// A `CGAL::Surface_mesh` without garbage, with the same numbers of vertices and faces, and the same coordinates in them.
template <typename Surface_mesh>
Mesh indexed_mesh(const Surface_mesh& tm)
{
  Mesh mesh;
  for(const auto v : tm.vertices())
    mesh.points.push_back({{tm.point(v).x(), tm.point(v).y(), tm.point(v).z()}});
  std::vector<Index> number(tm.number_of_halfedges(), null_index);
  for(const auto f : tm.faces())
  {
    Mesh::Triangle t;
    auto h = tm.halfedge(f);
    for(Index i = 0; i < 3; ++i, h = tm.next(h))
    {
      t[i] = static_cast<Index>(tm.source(h));
      number[h] = 3 * mesh.number_of_faces() + i;
    }
    mesh.triangles.push_back(t);
  }
  mesh.opposite.resize(mesh.number_of_halfedges());
  for(const auto h : tm.halfedges())
    if(number[h] != null_index)
      mesh.opposite[number[h]] = number[tm.opposite(h)];
  return mesh;
}

// a face location of a `CGAL::Surface_mesh`, as those of `Cut_locus`
template <typename Face_location>
Indexed_location indexed_location(const Face_location& location)
{
  Indexed_location result;
  result.face = static_cast<Index>(location.first);
  for(std::size_t i = 0; i < 3; ++i)
    result.coordinates[i] = location.second[i];
  return result;
}

inline Indexed_location location_of_vertex(const Mesh& mesh, Index v)
{
  return Unfolding(mesh).location_of_vertex(v);
}

// For a single query; a `Polyhedral_oracle` answers many.
inline std::vector<Arrival> shortest_arrivals(const Mesh& mesh, const Indexed_location& source,
                                              const Indexed_location& location, double tolerance = 1e-10)
{
  return Polyhedral_oracle(mesh, source).shortest_arrivals(location, tolerance);
}

} // namespace polyhedral_oracle

#endif // CGAL_CUT_LOCI_TEST_POLYHEDRAL_ORACLE_H
