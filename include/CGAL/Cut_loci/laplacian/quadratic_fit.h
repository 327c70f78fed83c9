// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_QUADRATIC_FIT_H
#define CGAL_CUT_LOCI_LAPLACIAN_QUADRATIC_FIT_H

#include <CGAL/Cut_loci/internal/small_systems.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Fits z = a0 u + a1 v + (a2 u^2 + 2 a3 u v + a4 v^2) / 2 to the surface and to a function around a vertex, and turns
// the derivatives into the Riemannian gradient and the Laplacian: with the metric g of the graph of z and W^2 = det g,
//   grad f = g^ij f_j X_i   and   laplace f = g^ij f_ij - (g^ij z_ij) (z_k f_k) / W^2.
class Quadratic_fit
{
public:
  // what the value at `vertex` adds to the gradient (in e1, e2) and the Laplacian
  struct Coefficients
  {
    Index vertex;
    std::array<double, 2> gradient;
    double laplacian;
  };

  std::vector<Coefficients> row; // by increasing vertex
  Vector e1, e2;

  Quadratic_fit(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
    : mesh_(mesh), connectivity_(connectivity)
  {
  }

  void fit(Index v)
  {
    set_frame(v);
    gather(v);
    if(!solve_normal_equations())
    {
      // A border vertex may have too few neighbors for a quadric, or all of them on one conic.
      add_second_ring(v);
      solve_singular_equations();
    }
    set_row(v);
  }

private:
  // A point of the extended neighborhood: a barycentric combination of up to three vertices.
  struct Sample
  {
    std::array<Index, 3> local; // indices into `nodes_`
    std::array<double, 3> weight;
  };
  struct Node
  {
    Index vertex;
    double z;
    Small_vector<5> monomials; // u, v, u^2/2, u v, v^2/2
  };

  void set_frame(Index v)
  {
    const Index begin = connectivity_.ring_begin[v], end = connectivity_.ring_begin[v + 1];
    const Vector& p = mesh_.points[v];
    Vector normal = {{0., 0., 0.}};
    scale_ = 0.;
    for(Index entry = begin; entry < end; ++entry)
    {
      const Vector a = mesh_.points[connectivity_.ring_vertex[entry]] - p;
      scale_ += edge_length(mesh_, connectivity_.ring_halfedge[entry]);
      const Index following = entry + 1 < end ? entry + 1 : begin;
      if(following == begin && connectivity_.is_border(v))
        break;
      normal = normal + cross(a, mesh_.points[connectivity_.ring_vertex[following]] - p);
    }
    scale_ /= end - begin;
    orthonormalize(normal, mesh_.points[connectivity_.ring_vertex[begin]] - p);
  }

  // a right-handed basis (e1, e2, normal) with e1 above `direction`
  void orthonormalize(const Vector& normal, const Vector& direction)
  {
    const double length = norm(normal);
    normal_ = length > 0. ? (1. / length) * normal : Vector{{0., 0., 1.}};
    e1 = direction - dot(direction, normal_) * normal_;
    // The edge may be parallel to the normal where the surface folds over: any direction serves then.
    if(norm(e1) <= 1e-8 * norm(direction))
    {
      const Vector axis = std::abs(normal_[0]) < 0.5 ? Vector{{1., 0., 0.}} : Vector{{0., 1., 0.}};
      e1 = axis - dot(axis, normal_) * normal_;
    }
    e1 = (1. / norm(e1)) * e1;
    e2 = cross(normal_, e1);
  }

  Index node(Index vertex)
  {
    for(std::size_t i = 0; i < nodes_.size(); ++i)
      if(nodes_[i].vertex == vertex)
        return static_cast<Index>(i);
    // in units of the mean edge length, so that the normal equations are well conditioned at any scale
    const Vector d = (1. / scale_) * (mesh_.points[vertex] - center_);
    const double u = dot(d, e1), w = dot(d, e2);
    nodes_.push_back({vertex, dot(d, normal_), {{u, w, 0.5 * u * u, u * w, 0.5 * w * w}}});
    return static_cast<Index>(nodes_.size() - 1);
  }

  // the 2k points of the extended neighborhood
  void gather(Index v)
  {
    nodes_.clear();
    samples_.clear();
    center_ = mesh_.points[v];
    node(v); // local index 0
    const Index begin = connectivity_.ring_begin[v], end = connectivity_.ring_begin[v + 1];
    for(Index entry = begin; entry < end; ++entry)
      samples_.push_back({{{node(connectivity_.ring_vertex[entry]), 0, 0}}, {{1., 0., 0.}}});
    for(Index entry = begin; entry < end; ++entry)
    {
      const Index h = connectivity_.ring_halfedge[entry];
      if(mesh_.source(h) == v)
        samples_.push_back(bisector_point(h));
    }
  }

  // The end of a geodesic that leaves the source of `h` along the bisector of its face, for the mean length of the
  // edges around, clamped to the face on the far side of the opposite edge.
  Sample bisector_point(Index h)
  {
    const Index o = mesh_.target(h), l = mesh_.source(mesh_.previous(h)), across = mesh_.next(h);
    const double la = edge_length(mesh_, h), lb = edge_length(mesh_, mesh_.previous(h)),
                 le = edge_length(mesh_, across);
    // The bisector meets the opposite edge where it divides it in proportion to the two sides. Seen from o, with l on the
    // x-axis, it comes from the vertex, which is above.
    const double t = la / (la + lb);
    const Planar_vector down = Planar_vector{{t * le, 0.}} - apex(mesh_, across);
    const double lm = norm(down);
    const Index io = node(o), il = node(l);
    if(lm >= scale_)
    {
      const double s = scale_ / lm;
      return {{{io, il, 0}}, {{(1. - t) * s, t * s, 1. - s}}};
    }
    const Index twin = mesh_.opposite[across];
    if(twin == null_index)
      return {{{io, il, 0}}, {{1. - t, t, 0.}}};

    // on into the far face, with y away from the vertex
    const Planar_vector far = apex(mesh_, twin);
    const double qx = le - far[0], qy = far[1], rx = down[0] / lm, ry = -down[1] / lm;
    // the ray from (t le, 0) by (rx, ry) in barycentric coordinates of (0,0), (le,0), (qx,qy), linear in its length
    const double length = scale_ - lm;
    const double rate_q = ry / qy, rate_l = (rx - rate_q * qx) / le, rate_o = -rate_q - rate_l;
    double s = length;
    if(rate_l < 0.)
      s = (std::min)(s, t / -rate_l);
    if(rate_o < 0.)
      s = (std::min)(s, (1. - t) / -rate_o);
    return {{{io, il, node(mesh_.source(mesh_.previous(twin)))}}, {{1. - t + s * rate_o, t + s * rate_l, s * rate_q}}};
  }

  // The neighbors of the neighbors; of one in the middle of a fan those next to the vertex, as all of them would take
  // time and memory that grow with the square of the fan.
  void add_second_ring(Index v)
  {
    constexpr Index most = 8; // on either side: all of them where up to 17 edges meet
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
    {
      const Index w = connectivity_.ring_vertex[entry], at = connectivity_.ring_reverse[entry];
      const Index begin = connectivity_.ring_begin[w], end = connectivity_.ring_begin[w + 1], n = end - begin;
      for(Index e = begin; e < end; ++e)
      {
        const Index behind = e >= at ? e - at : e + n - at;
        if(connectivity_.ring_vertex[e] != v && (std::min)(behind, n - behind) <= most)
          samples_.push_back({{{node(connectivity_.ring_vertex[e]), 0, 0}}, {{1., 0., 0.}}});
      }
    }
  }

  Small_vector<5> equation(const Sample& s) const
  {
    Small_vector<5> result = {};
    for(int c = 0; c < 3; ++c)
      add_multiple(s.weight[c], nodes_[s.local[c]].monomials, result);
    return result;
  }

  // the equations of all samples, and the matrix of their normal equations
  Small_matrix<5> set_equations()
  {
    Small_matrix<5> normal = {};
    solution_.clear();
    for(const Sample& s : samples_)
    {
      solution_.push_back(equation(s));
      add_square(1., solution_.back(), normal);
    }
    return normal;
  }

  // `solution_` by the normal equations, or false if they are close to singular
  bool solve_normal_equations()
  {
    const Cholesky_factor<5> factor(set_equations());
    // Entries are distances of each monomial from the span of those before it, at coordinates of order 1: 1e-3 stands for
    // samples within a thousandth of an edge of a common conic.
    if(samples_.size() < 5 || factor.least_diagonal() < 1e-3)
      return false;
    for(Small_vector<5>& column : solution_)
      column = factor.solve(column);
    return true;
  }

  void solve_singular_equations()
  {
    // of singular values below 1e-4: a null direction stays zero instead of amplifying noise 10^4 times
    const Small_matrix<5> inverse = pseudo_inverse(set_equations(), 1e-8);
    for(Small_vector<5>& column : solution_)
      column = product(inverse, column);
  }

  void set_row(Index v)
  {
    // coefficients of the five derivatives, node by node
    const std::size_t n = nodes_.size();
    derivatives_.assign(n, Small_vector<5>{});
    for(std::size_t i = 0; i < samples_.size(); ++i)
      for(int c = 0; c < 3; ++c)
        if(samples_[i].weight[c] != 0.)
          add_multiple(samples_[i].weight[c], solution_[i], derivatives_[samples_[i].local[c]]);
    Small_vector<5> sum = {}, z = {};
    for(std::size_t i = 1; i < n; ++i)
    {
      add_multiple(-1., derivatives_[i], sum);
      add_multiple(nodes_[i].z, derivatives_[i], z);
    }
    derivatives_[0] = sum; // the fit interpolates the value at the vertex

    // inverse metric of the graph of z, and the slope terms of the Laplacian
    const double ww = 1. + z[0] * z[0] + z[1] * z[1];
    const double g00 = (1. + z[1] * z[1]) / ww, g01 = -z[0] * z[1] / ww, g11 = (1. + z[0] * z[0]) / ww;
    const double mean = (g00 * z[2] + 2. * g01 * z[3] + g11 * z[4]) / ww;

    const Vector xu = e1 + z[0] * normal_, xv = e2 + z[1] * normal_;
    orthonormalize(cross(xu, xv), mesh_.points[connectivity_.ring_vertex[connectivity_.ring_begin[v]]] - center_);
    const double u1 = dot(xu, e1), u2 = dot(xu, e2), v1 = dot(xv, e1), v2 = dot(xv, e2);

    row.clear();
    const double is = 1. / scale_;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Small_vector<5>& d = derivatives_[i];
      const double cu = g00 * d[0] + g01 * d[1], cv = g01 * d[0] + g11 * d[1];
      const double laplacian = g00 * d[2] + 2. * g01 * d[3] + g11 * d[4] - mean * (z[0] * d[0] + z[1] * d[1]);
      row.push_back({nodes_[i].vertex, {{is * (cu * u1 + cv * v1), is * (cu * u2 + cv * v2)}}, is * is * laplacian});
    }
    std::sort(row.begin(), row.end(), [](const Coefficients& a, const Coefficients& b) { return a.vertex < b.vertex; });
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  Vector center_, normal_;
  double scale_ = 1.;
  std::vector<Node> nodes_;
  std::vector<Sample> samples_;
  std::vector<Small_vector<5>> solution_;    // by sample: what its value adds to the derivatives
  std::vector<Small_vector<5>> derivatives_; // the same by node
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_LAPLACIAN_QUADRATIC_FIT_H
