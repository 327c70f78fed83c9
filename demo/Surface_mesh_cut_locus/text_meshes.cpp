// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "text_meshes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#if defined(__cpp_lib_to_chars)

namespace {

bool is_blank(char c)
{
  return c == ' ' || c == '\t';
}

// The lines of a text without those that are empty or a comment.
class Lines
{
public:
  explicit Lines(std::string_view text) : rest_(text) {}

  // false at the end of the text; a line starts with its first word
  bool next(std::string_view& line)
  {
    while(!rest_.empty())
    {
      const std::size_t end = (std::min)(rest_.find('\n'), rest_.size());
      line = rest_.substr(0, end);
      rest_.remove_prefix((std::min)(end + 1, rest_.size()));
      if(!line.empty() && line.back() == '\r') // of a line end as on Windows
        line.remove_suffix(1);
      while(!line.empty() && is_blank(line.front()))
        line.remove_prefix(1);
      if(!line.empty() && line.front() != '#')
        return true;
    }
    return false;
  }

private:
  std::string_view rest_;
};

// The words of a line. std::from_chars() rounds as the streams do, to the nearest number.
class Words
{
public:
  explicit Words(std::string_view line) : rest_(line) {}

  bool is_at_end()
  {
    while(!rest_.empty() && is_blank(rest_.front()))
      rest_.remove_prefix(1);
    return rest_.empty();
  }

  // a number, up to a blank or one of `ends`
  template <typename Number>
  bool read(Number& number, std::string_view ends = {})
  {
    if(is_at_end())
      return false;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if(error != std::errc())
      return false;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return rest_.empty() || is_blank(rest_.front()) || ends.find(rest_.front()) != std::string_view::npos;
  }

  bool read(Kernel::Point_3& point)
  {
    double x = 0., y = 0., z = 0.;
    if(!read(x) || !read(y) || !read(z) || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      return false;
    point = {x, y, z};
    return true;
  }

  void skip_word()
  {
    while(!rest_.empty() && !is_blank(rest_.front()))
      rest_.remove_prefix(1);
  }

private:
  std::string_view rest_;
};

// `v`, `v/vt`, `v//vn` or `v/vt/vn`, where negative numbers count back
bool read_corners_OBJ(Words words, std::size_t number_of_points, std::vector<std::size_t>& polygon)
{
  while(!words.is_at_end())
  {
    long long i = 0;
    if(!words.read(i, "/"))
      return false;
    words.skip_word();
    const long long n = static_cast<long long>(number_of_points);
    if(i == 0 || i < -n || i > (std::numeric_limits<int>::max)())
      return false;
    polygon.push_back(static_cast<std::size_t>(i > 0 ? i - 1 : n + i));
  }
  return !polygon.empty();
}

bool has_all_points(const Polygon_soup& soup)
{
  return std::all_of(soup.polygons.begin(), soup.polygons.end(),
                     [&](const std::vector<std::size_t>& polygon) {
    return std::all_of(polygon.begin(), polygon.end(), [&](std::size_t v) { return v < soup.points.size(); });
  });
}

} // namespace

bool read_plain_OFF(const std::string& text, Polygon_soup& soup)
{
  Lines lines(text);
  std::string_view line;
  std::size_t number_of_points = 0, number_of_polygons = 0, number_of_edges = 0;
  if(!lines.next(line) || line.substr(0, 3) != "OFF" || !Words(line.substr(3)).is_at_end() || !lines.next(line))
    return false;
  Words counts(line);
  if(!counts.read(number_of_points) || !counts.read(number_of_polygons) || !counts.read(number_of_edges) ||
     !counts.is_at_end() || number_of_points > text.size() || number_of_polygons > text.size())
    return false;
  soup.points.resize(number_of_points);
  soup.polygons.resize(number_of_polygons);
  for(Kernel::Point_3& point : soup.points)
    if(!lines.next(line))
      return false;
    else if(Words words(line); !words.read(point) || !words.is_at_end())
      return false;
  for(std::vector<std::size_t>& polygon : soup.polygons)
  {
    std::size_t n = 0;
    if(!lines.next(line))
      return false;
    Words words(line);
    if(!words.read(n) || n < 3)
      return false;
    // A face may go on in the next lines; what follows its corners in the last one is a color, unless a corner is missing.
    bool goes_on = false;
    while(polygon.size() < n)
    {
      while(words.is_at_end())
      {
        if(!lines.next(line))
          return false;
        words = Words(line);
        goes_on = true;
      }
      std::size_t v = 0;
      if(!words.read(v))
        return false;
      polygon.push_back(v);
    }
    if(goes_on && !words.is_at_end())
      return false;
  }
  return number_of_points > 0 && number_of_polygons > 0 && has_all_points(soup);
}

bool read_plain_OBJ(const std::string& text, Polygon_soup& soup)
{
  if(text.find('\\') != std::string::npos) // a line may go on in the next one
    return false;
  Lines lines(text);
  for(std::string_view line; lines.next(line);)
  {
    if(line.size() < 2 || !is_blank(line[1]))
      continue; // neither a vertex nor a face
    if(line.front() == 'v')
    {
      soup.points.emplace_back();
      if(!Words(line.substr(1)).read(soup.points.back()))
        return false;
    }
    else if(line.front() == 'f')
    {
      soup.polygons.emplace_back();
      if(!read_corners_OBJ(Words(line.substr(1)), soup.points.size(), soup.polygons.back()))
        return false;
    }
  }
  return !soup.points.empty() && has_all_points(soup); // without faces, what is read has said so
}

#else // a library that reads no floating point numbers this way

bool read_plain_OFF(const std::string&, Polygon_soup&)
{
  return false;
}

bool read_plain_OBJ(const std::string&, Polygon_soup&)
{
  return false;
}

#endif
