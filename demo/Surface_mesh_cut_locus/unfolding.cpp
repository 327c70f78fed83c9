// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "unfolding.h"
#include "output_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <vector>

namespace {

constexpr double width_of_picture = 900., margin = 20., largest_label = 15., least_label = 5.;
constexpr double least_fold = 1e-6; // radians: below, two faces are one

using Point_2 = Unfolding::Point_2;

// Edges of the polygon in a line that are glued to edges in a line: a side of a branch of the cut locus.
struct Chain
{
  std::size_t first, last; // edges
  std::size_t label = 0;   // the same for what it is glued to; none on the border
};

class Net
{
public:
  explicit Net(const Unfolding& unfolding) : u_(unfolding), n_(unfolding.corners.size())
  {
    std::size_t start = 0;
    while(start + 1 < n_ && goes_on(start == 0 ? n_ - 1 : start - 1))
      ++start;
    chain_of_edge_.resize(n_);
    for(std::size_t k = 0; k < n_; ++k)
    {
      const std::size_t i = (start + k) % n_;
      if(k == 0 || !goes_on((i + n_ - 1) % n_))
        chains_.push_back({i, i});
      chains_.back().last = i;
      chain_of_edge_[i] = chains_.size() - 1;
    }
    for(Chain& c : chains_)
      if(u_.corners[c.first].glued_to != Unfolding::no_edge && c.label == 0)
        c.label = chains_[chain_of_edge_[u_.corners[c.first].glued_to]].label = ++number_of_labels_;
  }

  const std::vector<Chain>& chains() const { return chains_; }
  std::size_t number_of_labels() const { return number_of_labels_; }
  const Point_2& point(std::size_t i) const { return u_.corners[i % n_].point; }

private:
  // whether the next edge continues the chain of edge `i`
  bool goes_on(std::size_t i) const
  {
    const std::size_t j = (i + 1) % n_, a = u_.corners[i].glued_to, b = u_.corners[j].glued_to;
    if((a == Unfolding::no_edge) != (b == Unfolding::no_edge) || a == j)
      return false;
    if(a != Unfolding::no_edge && (b + 1) % n_ != a)
      return false;
    const Kernel::Vector_2 u = point(j) - point(i), v = point(j + 1) - point(j);
    return std::fabs(std::atan2(u.x() * v.y() - u.y() * v.x(), u * v)) < 1e-5;
  }

  const Unfolding& u_;
  const std::size_t n_;
  std::vector<Chain> chains_;
  std::vector<std::size_t> chain_of_edge_;
  std::size_t number_of_labels_ = 0;
};

void write_unfolding_svg(std::ostream& os, const Unfolding& unfolding)
{
  double left = 0., right = 0., bottom = 0., top = 0.;
  for(const Unfolding::Corner& c : unfolding.corners)
  {
    left = (std::min)(left, c.point.x());
    right = (std::max)(right, c.point.x());
    bottom = (std::min)(bottom, c.point.y());
    top = (std::max)(top, c.point.y());
  }
  const double scale = (width_of_picture - 2. * margin) / (std::max)(right - left, top - bottom);
  const auto x = [&](const Point_2& p) { return margin + scale * (p.x() - left); };
  const auto y = [&](const Point_2& p) { return margin + scale * (top - p.y()); };

  os.precision(8);
  os << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << 2. * margin + scale * (right - left) << R"(" height=")"
     << 2. * margin + scale * (top - bottom) << R"(" font-family="sans-serif" text-anchor="middle">)" << '\n'
     << R"(<rect width="100%" height="100%" fill="white"/>)" << '\n'
     << R"(<path fill="#f3f0e6" stroke="#cc0d29" stroke-width="1.5" stroke-linejoin="round" d=")";
  for(std::size_t i = 0; i < unfolding.corners.size(); ++i)
    os << (i == 0 ? 'M' : 'L') << x(unfolding.corners[i].point) << ' ' << y(unfolding.corners[i].point);
  os << R"(Z"/>)" << '\n' << R"(<path fill="none" stroke="#555" stroke-width="0.8" stroke-dasharray="5 3" d=")";
  for(const Unfolding::Fold_line& f : unfolding.fold_lines)
    if(std::fabs(f.angle) > least_fold)
      os << 'M' << x(f.source) << ' ' << y(f.source) << 'L' << x(f.target) << ' ' << y(f.target);
  os << R"(Z"/>)" << '\n';

  const Net net(unfolding);
  for(const Chain& c : net.chains())
  {
    const Point_2 &p = net.point(c.first), &q = net.point(c.last + 1);
    const double dx = x(q) - x(p), dy = y(q) - y(p), l = std::hypot(dx, dy);
    const double size = (std::min)(largest_label, 0.25 * l);
    if(c.label == 0 || size < least_label)
      continue;
    // beside the middle, on the inside, which is on the left; the text stands on its baseline
    const double away = 0.8 * size / l;
    os << R"(<text font-size=")" << size << R"(" x=")" << 0.5 * (x(p) + x(q)) + away * dy << R"(" y=")"
       << 0.5 * (y(p) + y(q)) - away * dx + 0.35 * size << R"(">)" << c.label << "</text>\n";
  }
  os << R"(<circle fill="#1454cc" r="5" cx=")" << x(Point_2(0., 0.)) << R"(" cy=")" << y(Point_2(0., 0.)) << R"("/>)"
     << "\n</svg>\n";
}

// The polygon is star-shaped: triangles from the source.
void write_unfolding_obj(std::ostream& os, const Unfolding& unfolding)
{
  os.precision(17);
  const auto vertex = [&](const Point_2& p) { os << "v " << p.x() << ' ' << p.y() << " 0\n"; };
  const std::size_t n = unfolding.corners.size();
  vertex(Point_2(0., 0.));
  for(const Unfolding::Corner& c : unfolding.corners)
    vertex(c.point);
  for(std::size_t i = 0; i < n; ++i)
  {
    const Point_2 &p = unfolding.corners[i].point, &q = unfolding.corners[(i + 1) % n].point;
    if(p.x() * q.y() - p.y() * q.x() > 0.) // not along a path from the source
      os << "f 1 " << i + 2 << ' ' << (i + 1) % n + 2 << '\n';
  }
  std::size_t number = n + 1;
  for(const Unfolding::Fold_line& f : unfolding.fold_lines)
    if(std::fabs(f.angle) > least_fold)
    {
      vertex(f.source);
      vertex(f.target);
      os << "l " << number + 1 << ' ' << number + 2 << '\n';
      number += 2;
    }
}

} // namespace

void write_unfolding(const std::string& filename, const Unfolding& unfolding)
{
  const auto write = std::filesystem::path(filename).extension() == ".svg" ? write_unfolding_svg : write_unfolding_obj;
  write_file(filename, [&](std::ostream& os) { write(os, unfolding); });
}

std::string summary(const Unfolding& unfolding)
{
  std::ostringstream text;
  text << "unfolding: " << unfolding.corners.size() << " corners, " << Net(unfolding).number_of_labels()
       << " pairs of glued sides" << (unfolding.is_source_moved ? "; the source is moved a little" : "");
  return text.str();
}
