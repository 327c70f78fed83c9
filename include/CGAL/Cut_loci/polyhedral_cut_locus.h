// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CUT_LOCUS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CUT_LOCUS_H

#include <CGAL/Cut_loci/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/internal/Exact_geodesic_propagation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * computes all of the cut locus of a closed polyhedral surface without saddles, such as that of a convex polyhedron.
 *
 * In a face, the cut locus is the part of a Voronoi diagram: that of the images of the source, unfolded along the
 * shortest paths to the points of the face \cgalCite{m-sppd-85}. The images are found by asking the exact solver for
 * the paths to the vertices of the diagram of those already known: an unknown one that is nearest anywhere is so at
 * one of them, since its cell is convex and bounded by lines that meet once. Every vertex of positive curvature, but
 * the source, is on the result.
 */
class Polyhedral_cut_locus
{
public:
  Polyhedral_cut_locus(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                       internal::Exact_geodesic_propagation& propagation)
    : mesh_(mesh), connectivity_(connectivity), propagation_(propagation)
  {
  }

  /// whether all vertices have a total angle of at most 2 pi, and there is no border
  static bool is_applicable(const Indexed_triangle_mesh& mesh, const internal::Geodesic_faces& faces)
  {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(faces.is_border(v) || faces.is_pseudo_source(v))
        return false;
    return true;
  }

  Indexed_cut_locus operator()(const Indexed_source& source)
  {
    images_.assign(mesh_.number_of_faces(), {});
    cells_.assign(mesh_.number_of_faces(), {});
    find_images(source);
    Indexed_cut_locus result;
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
      add_ridges(f, result);
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
      add_ridges_along(e, result);
    merge_nodes(result);
    return result;
  }

private:
  using Point_2 = std::array<double, 2>;

  // a convex polygon; side i goes from corner i to the next one, to the cell of the image `beyond`, or an edge of the
  // face
  struct Cell
  {
    std::vector<Point_2> corners;
    std::vector<Index> beyond;
  };

  static constexpr double tolerance = 1e-9; // of lengths, against the longest edge of the face

  std::array<Point_2, 3> layout(Index f) const
  {
    const internal::Plane_point apex = propagation_.faces().apex(3 * f);
    return {{{{0., 0.}}, {{propagation_.faces().length(3 * f), 0.}}, {{apex.x, apex.y}}}};
  }

  double size(Index f) const
  {
    const internal::Geodesic_faces& faces = propagation_.faces();
    return (std::max)({faces.length(3 * f), faces.length(3 * f + 1), faces.length(3 * f + 2)});
  }

  static double distance(const Point_2& a, const Point_2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

  // from the frame of halfedge `h` to that of the first one of the face
  Point_2 to_face(Index h, double x, double y) const
  {
    const std::array<Point_2, 3> t = layout(h / 3);
    const Point_2 &p = t[h % 3], &q = t[(h + 1) % 3];
    const double l = distance(p, q), c = (q[0] - p[0]) / l, s = (q[1] - p[1]) / l;
    return {{p[0] + c * x - s * y, p[1] + s * x + c * y}};
  }

  Point_2 to_halfedge(Index h, const Point_2& a) const
  {
    const std::array<Point_2, 3> t = layout(h / 3);
    const Point_2 &p = t[h % 3], &q = t[(h + 1) % 3];
    const double l = distance(p, q), c = (q[0] - p[0]) / l, s = (q[1] - p[1]) / l;
    return {{c * (a[0] - p[0]) + s * (a[1] - p[1]), -s * (a[0] - p[0]) + c * (a[1] - p[1])}};
  }

  Indexed_location location(Index f, const Point_2& p) const
  {
    const std::array<Point_2, 3> t = layout(f);
    const double area = t[1][0] * t[2][1];
    Indexed_location result;
    result.face = f;
    std::array<double, 3>& c = result.coordinates;
    c[2] = p[1] / t[2][1];
    c[1] = (p[0] * t[2][1] - p[1] * t[2][0]) / area;
    c[0] = 1. - c[1] - c[2];
    double sum = 0.;
    for(double& x : c)
    {
      x = x < tolerance ? 0. : x;
      sum += x;
    }
    for(double& x : c)
      x /= sum;
    return result;
  }

  void find_images(const Indexed_source& source)
  {
    std::vector<std::pair<Index, Point_2>> queries;
    std::vector<std::vector<Point_2>> asked(mesh_.number_of_faces());
    const auto ask = [&](Index f, const Point_2& at)
    {
      // A little inside: the path to a corner itself may come from any face around it.
      constexpr double inside = 1e-5;
      const std::array<Point_2, 3> t = layout(f);
      Point_2 p;
      for(int k = 0; k < 2; ++k)
        p[k] = (1. - inside) * at[k] + inside * (t[0][k] + t[1][k] + t[2][k]) / 3.;
      for(const Point_2& q : asked[f])
        if(distance(p, q) < 10. * tolerance * size(f))
          return;
      asked[f].push_back(p);
      queries.push_back({f, p});
    };
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
    {
      const std::array<Point_2, 3> t = layout(f);
      ask(f, {{(t[0][0] + t[1][0] + t[2][0]) / 3., (t[0][1] + t[1][1] + t[2][1]) / 3.}});
    }
    while(!queries.empty())
    {
      internal::Exact_geodesic_options options;
      for(const auto& q : queries)
        options.queries.push_back(location(q.first, q.second));
      propagation_.run({source.location}, options);
      std::vector<Index> changed;
      for(std::size_t i = 0; i < queries.size(); ++i)
        if(add_image(queries[i].first, queries[i].second, propagation_.query_arrival(i),
                     propagation_.query_distance(i)))
          changed.push_back(queries[i].first);
      std::sort(changed.begin(), changed.end());
      changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
      queries.clear();
      for(Index f : changed)
      {
        make_cells(f);
        for(const Cell& cell : cells_[f])
          for(const Point_2& p : cell.corners)
            ask(f, p);
      }
    }
  }

  bool add_image(Index f, const Point_2& p, const internal::Geodesic_arrival& arrival, double d)
  {
    Point_2 image = to_face(arrival.halfedge, arrival.x, arrival.y);
    if(arrival.sigma > 0.)
    {
      // The path passes a corner of the face: straight on, since no shortest path bends here.
      const double rest = distance(p, image);
      if(rest < 1e-3 * size(f))
        return false;
      image = {{p[0] + d / rest * (image[0] - p[0]), p[1] + d / rest * (image[1] - p[1])}};
    }
    for(const Point_2& other : images_[f])
      if(distance(p, other) <= d + tolerance * size(f) || distance(image, other) <= tolerance * (d + size(f)))
        return false;
    images_[f].push_back(image);
    return true;
  }

  // the Voronoi cells of the images in the face
  void make_cells(Index f)
  {
    std::vector<Point_2>& images = images_[f];
    std::vector<Cell>& cells = cells_[f];
    const std::array<Point_2, 3> t = layout(f);
    cells.assign(images.size(), Cell());
    for(Index i = 0; i < images.size(); ++i)
    {
      Cell& cell = cells[i];
      cell.corners.assign(t.begin(), t.end());
      cell.beyond.assign(3, null_index);
      for(Index j = 0; j < images.size() && !cell.corners.empty(); ++j)
        if(j != i)
          clip(cell, images[i], images[j], j, tolerance * size(f));
    }
  }

  // keeps the part of the cell of `a` that is nearer to it than to `b`
  static void clip(Cell& cell, const Point_2& a, const Point_2& b, Index number, double epsilon)
  {
    const double l = distance(a, b);
    const std::size_t n = cell.corners.size();
    std::vector<double> side(n); // the distance to the bisector, positive beyond it
    bool is_cut = false, is_kept = false;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Point_2& p = cell.corners[i];
      side[i] = ((p[0] - 0.5 * (a[0] + b[0])) * (b[0] - a[0]) + (p[1] - 0.5 * (a[1] + b[1])) * (b[1] - a[1])) / l;
      if(std::fabs(side[i]) <= epsilon)
        side[i] = 0.;
      is_cut = is_cut || side[i] > 0.;
      is_kept = is_kept || side[i] < 0.;
    }
    if(!is_cut)
      return;
    Cell result;
    for(std::size_t i = 0; is_kept && i < n; ++i)
    {
      const std::size_t j = (i + 1) % n;
      const auto point = [&]() -> Point_2
      {
        const double s = side[i] / (side[i] - side[j]);
        return {{cell.corners[i][0] + s * (cell.corners[j][0] - cell.corners[i][0]),
                 cell.corners[i][1] + s * (cell.corners[j][1] - cell.corners[i][1])}};
      };
      if(side[i] <= 0.)
      {
        const bool leaves = side[i] == 0. && side[j] > 0.;
        result.corners.push_back(cell.corners[i]);
        result.beyond.push_back(leaves ? number : cell.beyond[i]);
        if(side[i] < 0. && side[j] > 0.)
        {
          result.corners.push_back(point());
          result.beyond.push_back(number);
        }
      }
      else if(side[j] < 0.)
      {
        result.corners.push_back(point());
        result.beyond.push_back(cell.beyond[i]);
      }
    }
    cell = result;
  }

  double nearest(Index f, const Point_2& p) const
  {
    double d = (std::numeric_limits<double>::infinity)();
    for(const Point_2& image : images_[f])
      d = (std::min)(d, distance(p, image));
    return d;
  }

  void add_segment(Index f, const Point_2& p, const Point_2& q, Index halfedge, Indexed_cut_locus& result) const
  {
    const Index first = static_cast<Index>(result.nodes.size());
    for(const Point_2& x : {p, q})
      result.nodes.push_back({location(f, x), null_index, nearest(f, x)});
    result.edges.push_back({first, first + 1, halfedge, (std::numeric_limits<float>::max)(), null_index});
  }

  void add_ridges(Index f, Indexed_cut_locus& result) const
  {
    for(Index i = 0; i < cells_[f].size(); ++i)
    {
      const Cell& cell = cells_[f][i];
      for(std::size_t k = 0; k < cell.corners.size(); ++k)
      {
        const Index j = cell.beyond[k];
        const Point_2 &p = cell.corners[k], &q = cell.corners[(k + 1) % cell.corners.size()];
        // Either cell has the side; it is drawn once. A cell without area has none of its own.
        if(j != null_index && (i < j || cells_[f][j].corners.empty()) && distance(p, q) > 10. * tolerance * size(f))
          add_segment(f, p, q, null_index, result);
      }
    }
  }

  // Where the images on both sides of an edge are different points, the edge is a part of the cut locus.
  void add_ridges_along(Index e, Indexed_cut_locus& result) const
  {
    const Index h = connectivity_.halfedge_of_edge[e], o = mesh_.opposite[h];
    const double l = propagation_.faces().length(h);
    std::vector<double> stops = {0., l};
    for(Index side : {h, o})
      for(const Cell& cell : cells_[side / 3])
        for(const Point_2& p : cell.corners)
        {
          const Point_2 q = to_halfedge(side, p);
          if(std::fabs(q[1]) <= 10. * tolerance * l)
            stops.push_back((std::min)((std::max)(side == h ? q[0] : l - q[0], 0.), l));
        }
    std::sort(stops.begin(), stops.end());
    for(std::size_t i = 1; i < stops.size(); ++i)
    {
      if(stops[i] - stops[i - 1] <= 100. * tolerance * l)
        continue;
      const double middle = 0.5 * (stops[i - 1] + stops[i]);
      const Point_2 a = image_at(h, middle), b = image_at(o, l - middle);
      if(std::hypot(a[0] - (l - b[0]), a[1] + b[1]) > 1e3 * tolerance * (l + std::hypot(a[0], a[1])))
        add_segment(h / 3, to_face(h, stops[i - 1], 0.), to_face(h, stops[i], 0.), h, result);
    }
  }

  // in the frame of the halfedge, the image that is nearest to a point of it, seen from inside of the face
  Point_2 image_at(Index h, double t) const
  {
    const std::array<Point_2, 3> corners = layout(h / 3);
    const double inside = 1e-6; // separates images at the same distance from a point of the edge
    const Point_2 p = to_face(h, t, 0.), &apex = corners[(h + 2) % 3];
    const Point_2 q = {{p[0] + inside * (apex[0] - p[0]), p[1] + inside * (apex[1] - p[1])}};
    Point_2 best = images_[h / 3].front();
    for(const Point_2& image : images_[h / 3])
      if(distance(q, image) < distance(q, best))
        best = image;
    return to_halfedge(h, best);
  }

  // Nodes at the same point become one: of a vertex, an edge or a face.
  void merge_nodes(Indexed_cut_locus& graph) const
  {
    struct Key
    {
      int dimension;
      Index element;
      double s, t; // where on the element
      Index node;
    };
    std::vector<Key> keys;
    for(Index i = 0; i < graph.nodes.size(); ++i)
    {
      Indexed_location& location = graph.nodes[i].location;
      const std::array<double, 3>& c = location.coordinates;
      Index zeros = 0;
      for(double x : c)
        zeros += x <= 1e-7;
      Key key{2, location.face, c[0], c[1], i};
      if(zeros == 2)
      {
        const Index k = static_cast<Index>(std::max_element(c.begin(), c.end()) - c.begin());
        key = {0, mesh_.triangles[location.face][k], 0., 0., i};
        graph.nodes[i].vertex = key.element;
        location = internal::location_of_vertex(connectivity_, key.element);
      }
      else if(zeros == 1)
      {
        const Index k = static_cast<Index>(std::min_element(c.begin(), c.end()) - c.begin());
        const Index h = 3 * location.face + (k + 1) % 3;
        const Index e = connectivity_.edge_of_halfedge[h];
        key = {1, e, connectivity_.halfedge_of_edge[e] == h ? c[(k + 2) % 3] : c[(k + 1) % 3], 0., i};
      }
      keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end(),
              [](const Key& a, const Key& b)
              {
      return a.dimension != b.dimension ? a.dimension < b.dimension
             : a.element != b.element   ? a.element < b.element
             : a.s != b.s               ? a.s < b.s
                                        : a.node < b.node;
    });
    std::vector<Index> index(graph.nodes.size());
    std::vector<Indexed_cut_locus::Node> nodes;
    std::vector<Key> representatives;
    for(const Key& key : keys)
    {
      Index found = null_index;
      for(std::size_t k = representatives.size(); k-- > 0 && found == null_index;)
      {
        const Key& r = representatives[k];
        if(r.dimension != key.dimension || r.element != key.element || r.s < key.s - 1e-6)
          break;
        if(std::fabs(r.t - key.t) <= 1e-6)
          found = static_cast<Index>(k);
      }
      if(found == null_index)
      {
        found = static_cast<Index>(nodes.size());
        nodes.push_back(graph.nodes[key.node]);
        representatives.push_back(key);
      }
      index[key.node] = found;
    }
    // the farthest node is the root: on a closed surface it is on the cut locus
    Index root = 0;
    for(Index i = 0; i < nodes.size(); ++i)
      if(nodes[i].distance > nodes[root].distance)
        root = i;
    if(!nodes.empty())
      std::swap(nodes.front(), nodes[root]);
    for(Index& i : index)
      i = i == root ? 0 : i == 0 ? root : i;
    std::vector<Indexed_cut_locus::Edge> edges;
    for(Indexed_cut_locus::Edge e : graph.edges)
    {
      e.source = index[e.source];
      e.target = index[e.target];
      if(e.source != e.target)
        edges.push_back(e);
    }
    graph.nodes = nodes;
    graph.edges = edges;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  internal::Exact_geodesic_propagation& propagation_;
  std::vector<std::vector<Point_2>> images_; // of the source, in each face
  std::vector<std::vector<Cell>> cells_;
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CUT_LOCUS_H
