// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FUZZ_SURFACES_H
#define CGAL_CUT_LOCI_FUZZ_SURFACES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Small surfaces at random, for programs that look for faults.
namespace fuzz_surfaces {

class Random
{
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
  template <typename Range>
  const auto& of(const Range& range)
  {
    return range[below(std::size(range))];
  }

private:
  std::mt19937 engine_;
};

using Point = std::array<double, 3>;
using Face = std::array<std::size_t, 3>;

struct Surface
{
  std::vector<Point> points;
  std::vector<Face> faces;
};

inline Point between(const Point& p, const Point& q, double s)
{
  return {{(1. - s) * p[0] + s * q[0], (1. - s) * p[1] + s * q[1], (1. - s) * p[2] + s * q[2]}};
}

/// a torus, a tube or a sheet, by a grid that is shaken
inline Surface grid(Random& random)
{
  constexpr double pi = 3.14159265358979323846;
  const std::size_t kind = random.below(3), n = 3 + random.below(8), m = 3 + random.below(6);
  const std::size_t columns = kind == 2 ? n + 1 : n, rows = kind == 0 ? m : m + 1;
  const double r = random.between(0.2, 0.6), jitter = random.one_in(4) ? 0. : random.between(0., 0.3);
  Surface result;
  for(std::size_t i = 0; i < columns; ++i)
    for(std::size_t j = 0; j < rows; ++j)
    {
      const double u = (double(i) + random.between(-jitter, jitter)) / double(n),
                   w = (double(j) + random.between(-jitter, jitter)) / double(m), a = 2. * pi * u, b = 2. * pi * w;
      if(kind == 0)
        result.points.push_back(
          {{(1. + r * std::cos(b)) * std::cos(a), (1. + r * std::cos(b)) * std::sin(a), r * std::sin(b)}});
      else if(kind == 1)
        result.points.push_back({{std::cos(a), std::sin(a), 4. * r * w}});
      else
        result.points.push_back({{u, w, r * std::sin(a) * std::sin(0.5 * b)}});
    }
  const auto at = [&](std::size_t i, std::size_t j) { return (i % columns) * rows + j % rows; };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < m; ++j)
    {
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if(random.one_in(2))
        result.faces.insert(result.faces.end(), {{{a, b, c}}, {{a, c, d}}});
      else
        result.faces.insert(result.faces.end(), {{{a, b, d}}, {{b, c, d}}});
    }
  return result;
}

/// a rough ball: an octahedron whose faces are divided
inline Surface ball(Random& random)
{
  Surface result;
  result.points = {{{1, 0, 0}}, {{-1, 0, 0}}, {{0, 1, 0}}, {{0, -1, 0}}, {{0, 0, 1}}, {{0, 0, -1}}};
  result.faces = {{{0, 2, 4}}, {{2, 1, 4}}, {{1, 3, 4}}, {{3, 0, 4}},
                  {{2, 0, 5}}, {{1, 2, 5}}, {{3, 1, 5}}, {{0, 3, 5}}};
  for(std::size_t level = random.below(3); level > 0; --level)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle;
    const auto divided = [&](std::size_t a, std::size_t b)
    {
      const auto [found, is_new] = middle.insert({{(std::min)(a, b), (std::max)(a, b)}, result.points.size()});
      if(is_new)
        result.points.push_back(between(result.points[a], result.points[b], 0.5));
      return found->second;
    };
    std::vector<Face> faces;
    for(const Face& f : result.faces)
    {
      const std::size_t p = divided(f[0], f[1]), q = divided(f[1], f[2]), r = divided(f[2], f[0]);
      faces.insert(faces.end(), {{{f[0], p, r}}, {{f[1], q, p}}, {{f[2], r, q}}, {{p, q, r}}});
    }
    result.faces = faces;
  }
  const double rough = random.one_in(4) ? 0. : random.between(0., 0.4);
  const bool is_round = random.one_in(2);
  for(Point& p : result.points)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for(double& x : p)
      x *= (is_round ? 1. / length : 1.) * (1. + 0.5 * random.between(-rough, rough));
  }
  return result;
}

inline Surface surface(Random& random)
{
  return random.one_in(2) ? ball(random) : grid(random);
}

/// points beside corners and edges of faces, or on edges, which leave faces of an area down to 1e-12 of the square of their
/// longest edge, or of none; each in another face, as what is beside such a point in such a face may be thinner
inline void add_thin_faces(Surface& s, Random& random)
{
  std::vector<std::size_t> undivided(s.faces.size());
  std::iota(undivided.begin(), undivided.end(), std::size_t(0));
  for(std::size_t i = 1 + random.below(6); i > 0 && !undivided.empty(); --i)
  {
    const std::size_t k = random.below(undivided.size()), f = undivided[k], v = s.points.size();
    undivided.erase(undivided.begin() + static_cast<std::ptrdiff_t>(k));
    const Face t = s.faces[f];
    const double share = random.one_in(6) ? 0. : std::pow(10., random.between(-11., -2.)),
                 along = random.one_in(3) ? 0. : random.between(0.05, 0.95);
    const double third = share * random.between(0.2, 0.8), second = along * (1. - third) + (along == 0. ? share : 0.);
    if(share == 0. && along == 0.)
      continue;
    s.points.push_back(between(between(s.points[t[0]], s.points[t[1]], second / (1. - third)), s.points[t[2]], third));
    s.faces[f] = {{t[0], t[1], v}};
    s.faces.insert(s.faces.end(), {{{t[1], t[2], v}}, {{t[2], t[0], v}}});
  }
}

/// the same, with vertices that are doubled along seams at random: some faces get vertices of their own
inline Surface with_seams(const Surface& s, Random& random)
{
  Surface result = s;
  const std::size_t patches = 2 + random.below(3);
  std::vector<std::size_t> patch(s.faces.size());
  for(std::size_t& p : patch)
    p = random.below(patches);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> copy; // of each vertex, in each patch
  std::set<std::size_t> is_taken;
  for(std::size_t f = 0; f < s.faces.size(); ++f)
    for(std::size_t& v : result.faces[f])
    {
      const auto found = copy.find({v, patch[f]});
      if(found != copy.end())
      {
        v = found->second;
        continue;
      }
      const std::size_t old = v;
      if(!is_taken.insert(v).second)
      {
        v = result.points.size();
        result.points.push_back(s.points[old]);
      }
      copy[{old, patch[f]}] = v;
    }
  return result;
}

inline std::string off(const Surface& s)
{
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << s.points.size() << ' ' << s.faces.size() << " 0\n";
  for(const Point& p : s.points)
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const Face& f : s.faces)
    text << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  return text.str();
}

/// walks along edges at random, each a line with its vertices
inline std::string curves(const Surface& s, Random& random)
{
  std::vector<std::set<std::size_t>> neighbors(s.points.size());
  for(const Face& f : s.faces)
    for(std::size_t i = 0; i < 3; ++i)
    {
      neighbors[f[i]].insert(f[(i + 1) % 3]);
      neighbors[f[(i + 1) % 3]].insert(f[i]);
    }
  std::ostringstream text;
  for(std::size_t i = 1 + random.below(2); i > 0; --i)
  {
    std::size_t v = random.of(random.of(s.faces));
    text << v;
    for(std::size_t k = 1 + random.below(5); k > 0; --k)
    {
      v = *std::next(neighbors[v].begin(), static_cast<std::ptrdiff_t>(random.below(neighbors[v].size())));
      text << ' ' << v;
    }
    text << '\n';
  }
  return text.str();
}

} // namespace fuzz_surfaces

#endif // CGAL_CUT_LOCI_FUZZ_SURFACES_H
