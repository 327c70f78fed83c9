// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_H
#define CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_H

#include <CGAL/Cut_loci/geodesics/Geodesic_batches.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_slim_edges.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_windows.h>
#include <CGAL/Cut_loci/geodesics/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/separate_compilation.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is shown the windows while they are propagated.
class Geodesic_window_observer
{
public:
  virtual ~Geodesic_window_observer() = default;
  /// the windows up to the distance `d` have been shown, up to some that come late
  virtual void advance(double /* d */) {}
  /// gets the windows of the halfedge `h`, in order, when they cross its face. It may keep the list, which it then says by
  /// returning `true`, until it hands it back to `Exact_geodesic_propagation::release()`.
  virtual bool take(Index h, Geodesic_window_list& list) = 0;
  /// gets, to keep, windows that reach the border halfedge `h` from its face, in the frame of the opposite that it has not
  virtual void take_on_border(Index h, Geodesic_window_list* list) = 0;
};

/*!
 * computes exact geodesic distances on a triangle mesh by propagating windows.
 *
 * Windows \cgalCite{mmp-dgp-87} cross the faces in batches, one per halfedge, in the order of the distance
 * \cgalCite{xu-fwp-15}. In the face entered, only the window with the shortest path to the apex goes on to both other
 * edges \cgalCite{ch-spp-90}; the ends of a batch lose the windows to which a path through a vertex of the face is
 * preferable \cgalCite{Xin2009Improvingchenandhan}. Neighboring windows are trimmed as described in `geodesic_window_trimming.h`.
 * Batches are forgotten once they have been propagated. If an error is allowed, neighboring windows are merged as
 * described in `Geodesic_merging.h`; what is the direction otherwise, is then the error, unless both are asked for.
 *
 * The mesh geometry is read by the constructor. All memory is reused from one run to the next. Queries after a run
 * are const.
 */
class Exact_geodesic_propagation : public Geodesic_results
{
public:
  /// \throws Invalid_input see `Geodesic_faces`
  ///
  /// `positions` are the numbers by which messages name the vertices, if not by their index.
  explicit Exact_geodesic_propagation(const Indexed_triangle_mesh& mesh, const std::vector<Index>* positions = nullptr,
                                      const Progress& progress = {})
    : Exact_geodesic_propagation(std::make_shared<const Geodesic_faces>(mesh, positions, progress))
  {
  }

  /// for a mesh that has been read: several of them may share it, also in several threads
  explicit Exact_geodesic_propagation(std::shared_ptr<const Geodesic_faces> faces)
    : Geodesic_results(std::move(faces)),
      batches_(faces_.number_of_halfedges(), faces_.number_of_vertices(), finest_order * faces_.mean_edge_length()),
      slim_edges_(faces_)
  {
  }

  /// \throws Invalid_input if there is no source, or a location is none on the mesh
  void run(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options = {})
  {
    run(sources, options, nullptr);
  }

  /// the same with directions, and shows the windows to an observer
  void run(const std::vector<Indexed_location>& sources, Exact_geodesic_options options,
           Geodesic_window_observer& observer)
  {
    options.directions = true;
    run(sources, options, &observer);
  }

  /// hands back a list that an observer has kept
  void release(Geodesic_window_list* list) { batches_.release(list); }
  /// a list with room for `n` windows as the observer gets them
  Geodesic_window_list* allocate(std::size_t n)
  {
    return is_approximate() ? batches_.allocate<9>(n) : batches_.allocate<7>(n);
  }
  /// whether windows wait to cross the face of `h`
  bool waits(Index h) const { return batches_.waits(h); }

  /// with a vertex as the only source
  void run(Index source, const Exact_geodesic_options& options = {}) { run({vertex_location(source)}, options); }

  /// the number of windows that have been propagated across a face in the last run
  std::size_t number_of_windows() const { return number_of_windows_; }

private:
  using Mesh = Indexed_triangle_mesh;

  struct Path_beside
  {
    Index vertex;
    double distance;
    Geodesic_arrival arrival;
  };

  /// the face of a halfedge, as windows see it that cross it from there
  struct Crossing
  {
    Index halfedge, left,
      right; // `left` leads from the apex to the source of `halfedge`, `right` from its target there
    Index source, target, apex_vertex;
    Plane_point apex;
    Geodesic_step to_left, to_right;
  };

  /// which windows of a list pass the apex on its left, cover it or pass it on its right. The first ones pass it on its left,
  /// the last ones on its right; those in `[first, last)` need a closer look.
  struct Apex_view
  {
    std::size_t first, last;
    std::size_t behind_left, first_right; // behind the last that passes on the left; the first that does on the right
    std::size_t winner;                   // has the shortest path to the apex, or is the end of the list
    double shortest;
    std::size_t number_left, number_right; // of the windows that go on to these edges
    bool is_sorted; // whether those on the left come before the winner, those on the right behind it
  };

  void run(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options,
           Geodesic_window_observer* observer);
  void start(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options);
  template <int columns>
  void propagate();
  template <int columns>
  void start_at_vertex(std::size_t number);
  /// for sources that are edges
  template <int columns>
  void start_at_line(std::size_t number);
  /// for sources on edges and in faces
  template <int columns>
  void start_in_face(std::size_t number);
  /// starts across all halfedges but `skipped` of the face of `h`, in whose frame the source is given
  template <int columns>
  void start_in_face(std::size_t number, Index h, const Plane_point& p, double turn, Index skipped);
  /// sends the paths through the corner at the source of `h` with angles in `[from, to]` into the next face; `start` has
  /// all but the frame
  template <int columns>
  void emit(Index h, double from, double to, Geodesic_arrival start);
  /// hands a window that leaves the face of `g` to the opposite of `g`, in whose frame it is given
  template <int columns>
  void send(Index g, const Geodesic_window& w);
  /// the same for a list of windows; `side` and `key` as for `Geodesic_batches::store()`
  template <int columns>
  void send(Index g, std::size_t side, Geodesic_window_list* list, double key);
  /// continues the shortest path to `v`, at which it may bend, into its shadow
  template <int columns>
  void bend(Index v);
  /// a path of length `d` to the vertex `v` has been found
  void reach(Index v, double d, const Geodesic_arrival& arrival);
  /// notes the path by the window `i` to its end `t` and from there to the apex, if it is straight up to rounding: it counts
  /// if no window covers the apex, or only those of longer paths
  template <int columns>
  void note_path_beside(const Crossing& crossing, const Geodesic_window_list& list, std::size_t i, double t);
  bool is_shorter(const Path_beside& path) const;
  /// reaches the vertices that rounding has left between windows; whether there were any
  bool reach_beside_windows();
  void prefetch(Index far, Index near) const;
  /// tells the progress, and when to do so again
  void report_progress();
  /// takes the windows of `h` across the face of `h`
  template <int columns>
  void cross_face(Index h);
  Crossing crossing_of(Index h) const;
  template <int columns>
  Apex_view look_at_apex(const Geodesic_window_list& list, const Crossing& crossing);
  template <int columns>
  void reach_apex(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view);
  template <int columns>
  void reach_as_soon(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view);
  double bound_at_apex(const Crossing& crossing) const;
  /// what goes on to the two other edges
  template <int columns>
  void go_left(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view);
  template <int columns>
  void go_right(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view);
  bool goes_left(std::size_t w, const Apex_view& view) const;
  bool goes_right(std::size_t w, const Apex_view& view) const;

  // In the order of the distance, windows that take the same way wait for each other, in long lists, however short some of
  // the edges are.
  static constexpr double finest_order = 1. / 1024.;

  Geodesic_batches batches_;
  Geodesic_slim_edges slim_edges_;
  Geodesic_window_observer* observer_ = nullptr; // in the run in work
  std::vector<Crossing_window>* windows_ = nullptr;
  std::vector<unsigned char> sides_; // of the apex, for the windows in work
  std::vector<Path_beside> beside_;  // see `note_path_beside()`
  double maximum_distance_ = infinity, tolerance_ = 0., merging_angle_ = 0.;
  std::size_t number_of_windows_ = 0, next_report_ = 0; // and at which number of them the progress is told
  Progress progress_;
};

} // namespace CGAL::Cut_loci::internal

#ifndef CGAL_CUT_LOCI_SEPARATE_COMPILATION
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation_impl.h>
#endif

#endif // CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_H
