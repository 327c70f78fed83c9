// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_METHOD_PATH_FLOW_H
#define CGAL_CUT_LOCI_LAPLACIAN_METHOD_PATH_FLOW_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The paths to the source, each the sequence of the halfedges that it crosses.
//
// One that comes to a halfedge which an older path crosses goes on as that does, if it may. Where the shortest paths are
// known, it may if that makes it no longer: across a long edge there may be paths to different sides of something, which
// part behind it. So a halfedge may have several records, one for each way on, up to a number that keeps fans of slim
// faces from having one for each vertex behind. Else it always may.
class Path_flow
{
public:
  // where a path crosses a halfedge, and from what image of the source, or of a vertex on the way, it comes
  struct Step
  {
    Index halfedge = null_index;
    double place = 0.;          // from the source of `halfedge` on, as a part
    Planar_vector image{};      // in the frame of the opposite of `halfedge`
    double image_distance = 0.; // its own
  };

  Path_flow(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, bool has_images)
    : mesh_(mesh), connectivity_(connectivity), has_images_(has_images), first_(mesh.number_of_halfedges(), null_index)
  {
  }

  // the record with which a path goes on, or `null_index` if it has to be recorded itself
  Index find(const Step& step) const
  {
    Index r = first_[step.halfedge];
    if(r == null_index || !has_images_)
      return r;
    const double length = edge_length(mesh_, step.halfedge), own = distance_of(step, length);
    double least = (std::numeric_limits<double>::infinity)();
    Index nearest = null_index, number = 0;
    for(; r != null_index; r = records_[r].other, ++number)
    {
      const double difference = std::abs(distance_by(r, step, length) - own);
      if(difference <= tolerance * length)
        return r;
      if(difference < least)
      {
        least = difference;
        nearest = r;
      }
    }
    return number < most_records ? null_index : nearest;
  }

  // Records a path that starts at vertex `v`, and goes on as record `next` if that is not null.
  void add(Index v, const std::vector<Step>& path, Index next)
  {
    for(std::size_t i = path.size(); i-- > 0;)
    {
      const Index h = path[i].halfedge;
      records_.push_back({h, next, first_[h], 0});
      next = first_[h] = static_cast<Index>(records_.size() - 1);
      if(has_images_)
        images_.push_back({path[i].place, path[i].image, path[i].image_distance,
                           distance_of(path[i], edge_length(mesh_, h)), entrance(v, path, i)});
    }
    if(next != null_index)
      ++records_[next].count;
  }

  // of the paths that start at a record, until this is called; then of all that pass
  void count_all()
  {
    for(std::size_t r = records_.size(); r-- > 0;) // the youngest path first, and each from its start
      if(records_[r].next != null_index)
        records_[records_[r].next].count += records_[r].count;
  }

  bool has_images() const { return has_images_; }
  Index number_of_records() const { return static_cast<Index>(records_.size()); }
  Index count(Index r) const { return records_[r].count; }
  Index next(Index r) const { return records_[r].next; }
  Index halfedge(Index r) const { return records_[r].halfedge; }
  // the records of a halfedge: the first, and the one after another
  Index first(Index h) const { return first_[h]; }
  Index other(Index r) const { return records_[r].other; }

  // With images: the distance where record `r` leaves its face, that place, and the one where it has come in, in the
  // frame of the first halfedge of the face.
  double distance(Index r) const { return images_[r].distance; }
  Planar_vector exit(Index r, const std::array<Planar_vector, 3>& corners) const
  {
    return on_side(records_[r].halfedge % 3, images_[r].place, corners);
  }
  Planar_vector entrance(Index r, const std::array<Planar_vector, 3>& corners) const
  {
    return on_side(images_[r].entrance.side, images_[r].entrance.place, corners);
  }

  Index number_of_paths(Index e) const
  {
    const Index h = connectivity_.halfedge_of_edge[e];
    return mesh_.is_border_edge(h) ? 0 : number_across(h) + number_across(mesh_.opposite[h]);
  }
  Index number_across(Index h) const
  {
    Index result = 0;
    for(Index r = first_[h]; r != null_index; r = records_[r].other)
      result += records_[r].count;
    return result;
  }

private:
  struct Record
  {
    Index halfedge;
    Index next, other; // on the path, and at the same halfedge
    Index count;
  };
  struct Entrance // where a path comes into a face
  {
    Index side;
    double place;
  };
  struct Image
  {
    double place;
    Planar_vector position;
    double its_distance, distance; // its own, and that of the path by it
    Entrance entrance;
  };

  // Longer by less than a thousandth of the edge is no longer: that is far below what a curve of mesh edges is accurate
  // to, and far above what thin faces make of rounding errors. More lets paths share a way that part soon after.
  static constexpr double tolerance = 1e-3;
  // Of a halfedge: behind it are two edges, and few branches of the cut locus between the paths that cross it.
  static constexpr Index most_records = 8;

  // by record `r`, where `step` crosses the halfedge of both
  double distance_by(Index r, const Step& step, double length) const
  {
    const Planar_vector p = {{(1. - step.place) * length, 0.}};
    return images_[r].its_distance + norm(p - images_[r].position);
  }

  static double distance_of(const Step& step, double length)
  {
    const Planar_vector p = {{(1. - step.place) * length, 0.}};
    return step.image_distance + norm(p - step.image);
  }

  static Planar_vector on_side(Index side, double place, const std::array<Planar_vector, 3>& corners)
  {
    return (1. - place) * corners[side] + place * corners[(side + 1) % 3];
  }

  // Behind the step before, or at vertex `v`; at the exit itself if the face has nothing to do with either.
  Entrance entrance(Index v, const std::vector<Step>& path, std::size_t i) const
  {
    const Index h = path[i].halfedge, first = h - h % 3;
    if(i > 0)
    {
      const Index o = mesh_.opposite[path[i - 1].halfedge];
      if(o / 3 == h / 3)
        return {o % 3, 1. - path[i - 1].place};
    }
    for(Index side = 0; side < 3 && i == 0; ++side)
      if(mesh_.source(first + side) == v)
        return {side, 0.};
    return {h % 3, path[i].place};
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const bool has_images_;
  std::vector<Index> first_;    // of each halfedge
  std::vector<Record> records_; // each path from its end
  std::vector<Image> images_;   // of the records
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_METHOD_PATH_FLOW_H
