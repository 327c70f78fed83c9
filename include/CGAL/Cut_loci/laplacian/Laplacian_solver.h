// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_SOLVER_H
#define CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_SOLVER_H

#include <CGAL/Cut_loci/graph/Edges_off_sources.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/lone_nodes.h>
#include <CGAL/Cut_loci/graph/short_branches.h>
#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/laplacian/Branch_filter.h>
#include <CGAL/Cut_loci/laplacian/Branch_tips.h>
#include <CGAL/Cut_loci/laplacian/Differential_operators.h>
#include <CGAL/Cut_loci/laplacian/Tangent_directions.h>
#include <CGAL/Cut_loci/laplacian/gradient_angles.h>
#include <CGAL/Cut_loci/laplacian/homology.h>
#include <CGAL/Cut_loci/laplacian/region_growing_tree.h>
#include <CGAL/Cut_loci/laplacian/smoothing.h>
#include <CGAL/Cut_loci/laplacian/thinning.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/method/distances_from_curves.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/checked_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>
#include <CGAL/Cut_loci/ways/Straight_waves.h>
#include <CGAL/Cut_loci/ways/Way_arrival.h>
#include <CGAL/Cut_loci/ways/Way_forest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The pipeline of the paper on one connected component: the stages in their order, on dense indices. Sources are points,
// and parts of the border, which are numbered behind them.
class Laplacian_solver
{
public:
  // once per mesh
  Laplacian_solver(const Indexed_triangle_mesh& mesh, Laplacian_operator type, const Threads& threads = {},
                   const Progress& progress = {})
    : Laplacian_solver(mesh, std::make_shared<const Surface>(mesh, type, threads, progress))
  {
  }

  // another one for the same mesh, which shares what depends on it alone, also in another thread
  std::unique_ptr<Laplacian_solver> for_other_sources() const
  {
    return std::unique_ptr<Laplacian_solver>(new Laplacian_solver(mesh_, surface_));
  }

  void report_to(const Progress& progress) { progress_ = progress; }

  // once per source, in three parts; `nearest` are the nearest sources of the vertices, if they are known
  void set_distance(const Source_roots& roots, std::vector<double> distance, std::vector<Index> nearest = {},
                    bool is_approximate = false)
  {
    is_approximate_ = is_approximate;
    roots_ = roots;
    nearest_source_ = std::move(nearest);
    roots_.check_faces(remedy());
    distance_ = std::move(distance);
    is_source_.assign(distance_.size(), 0);
    for(const Indexed_source& source : roots_.points())
      if(source.vertex != null_index)
        is_source_[source.vertex] = 1;
    for(Index v = 0; v < distance_.size(); ++v)
      if(roots_.parts().is_at_source(v))
        is_source_[v] = 1;
  }
  void set_distance(const std::vector<Indexed_source>& points, std::vector<double> distance,
                    std::vector<Index> nearest = {}, bool is_approximate = false)
  {
    set_distance(Source_roots(mesh_, connectivity_, points), std::move(distance), std::move(nearest), is_approximate);
  }

  void compute_strengths()
  {
    grow_forest(progress_.part(0., 0.3));
    find_farthest();
    // Half the square of the distance d is smooth at sources, where quadrics do not fit d. Its gradient is d times that of
    // d, its Laplacian 1 + d times that of d.
    const Eigen::Map<const Eigen::VectorXd> d(distance_.data(), static_cast<Eigen::Index>(distance_.size()));
    const Eigen::VectorXd half_square = 0.5 * d.array().square();
    Eigen::VectorXd gradient = operators_.gradient * half_square;
    for(Index v = 0; v < distance_.size(); ++v)
      for(Index i = 2 * v; i < 2 * v + 2; ++i)
        gradient[i] = is_at_source(v) ? 0. : gradient[i] / distance_[v];
    angle_ = gradient_angles(mesh_, connectivity_, tangent_, gradient, progress_.part(0.3, 0.8));
    progress_(0.8);
    const Eigen::VectorXd laplacian = operators_.laplacian * half_square;
    laplacian_.resize(distance_.size());
    const double h = connectivity_.mean_edge_length; // makes the Laplacian free of the unit of length
    for(std::size_t v = 0; v < distance_.size(); ++v)
      laplacian_[v] = static_cast<float>(h * (laplacian[static_cast<Eigen::Index>(v)] - 1.) / distance_[v]);
    for(Index v = 0; v < distance_.size(); ++v)
      if(is_at_source(v))
      {
        // not on the cut locus, however the operators see this singularity
        angle_[v] = -1.f;
        laplacian_[v] = (std::numeric_limits<float>::max)();
      }
    laplacian_noise_ = Branch_tips::noise_of(connectivity_, laplacian_);
    slope_error_.resize(distance_.size());
    for(std::size_t v = 0; v < distance_.size(); ++v)
    {
      const Eigen::Index i = 2 * static_cast<Eigen::Index>(v);
      slope_error_[v] = static_cast<float>(std::abs(std::hypot(gradient[i], gradient[i + 1]) - 1.));
    }
  }

  void grow_tree()
  {
    spanning_tree_ = region_growing_tree(connectivity_, laplacian_, choose_root(), roots_.elements(), crossed_,
                                         progress_.part(0., 0.5));
    tree_ = spanning_tree_;
    thin(tree_, connectivity_, laplacian_, 2, progress_.part(0.5, 1.));
  }

  // What the homology demands is found once per source, whatever the thresholds.
  void close_cycles()
  {
    const std::vector<Index> generators = homology_generators(mesh_, connectivity_, spanning_tree_, distance_, roots_,
                                                              crossed_, progress_.part(0., 0.7), &source_of_face_);
    filter_ = Branch_filter(mesh_, connectivity_, tree_, spanning_tree_, generators, angle_, laplacian_,
                            progress_.part(0.7, 1.), roots_.parts().loops_with_rest(connectivity_));
  }

  // once per threshold
  Indexed_cut_locus filter(const Branch_thresholds& thresholds) const
  {
    Branch_filter::Result filtered = filter_(mesh_, connectivity_, thresholds);
    // Growth ends where branches are weak, and who asks for a wider angle than the default wants strong parts only.
    if(thresholds.policy == Filter_policy::PRUNING &&
       thresholds.gradient_angle <= Laplacian_method().gradient_angle_threshold())
      Branch_tips(connectivity_, distance_, laplacian_, laplacian_noise_, slope_error_, filter_)(filtered);
    Indexed_cut_locus result = Branch_filter::mesh_edge_graph(connectivity_, filtered);
    for(Indexed_cut_locus::Node& node : result.nodes)
      node.distance = distance_[node.vertex];
    if(!roots_.parts().empty())
      leave_sources(thresholds, result);
    name_sources(result);
    return result;
  }

  Indexed_cut_locus smoothed(const Indexed_cut_locus& cut_locus, const Smoothing_parameters& parameters) const
  {
    if(cut_locus.edges.empty())
      return cut_locus;
    // A point keeps its faces; the border, which no node gets to, is enough for what is a part of it.
    std::vector<Index> owners = roots_.owners();
    for(Index& owner : owners)
      if(owner != null_index && owner >= roots_.points().size())
        owner = null_index;
    return Cut_locus_smoother(mesh_, connectivity_, distance_, arrivals_, crossed_, cut_locus, owners)(parameters,
                                                                                                       progress_);
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Differential_operators& operators() const { return operators_; }
  const std::vector<double>& distance() const { return distance_; }
  const std::vector<float>& gradient_angle() const { return angle_; }
  const std::vector<float>& laplacian() const { return laplacian_; }
  Index number_of_border_loops() const { return connectivity_.number_of_border_loops; }
  Index genus() const { return surface_->genus; }
  Index farthest() const { return farthest_; }
  // by the numbers under which they are known; empty if there is one
  std::vector<Index> nearest_sources() const
  {
    std::vector<Index> result = nearest_source_;
    for(Index f = 0; f < mesh_.number_of_faces() && !result.empty(); ++f) // where no way has been found
      for(Index v : mesh_.triangles[f])
        if(result[v] == null_index)
          result[v] = source_of_face_[f];
    for(Index& i : result)
      if(i != null_index)
        i = roots_.name(i);
    return result;
  }
  const Source_roots& roots() const { return roots_; }

  // where edges of the mesh do not separate sources
  static const char* remedy()
  {
    return "ask for cut_locus_method(Cut_loci::Default_method()) and cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)";
  }

private:
  void grow_forest(const Progress& progress)
  {
    Way_forest forest(mesh_, connectivity_, roots_, distance_);
    forest.grow(progress);
    crossed_ = forest.ways([](Index) { return true; }).is_crossed;
    if(nearest_source_.empty() && roots_.number_of_sources() > 1)
      nearest_source_ = forest.nearest_sources();
    if(is_approximate_)
      measure_ways(forest);
    arrivals_.resize(distance_.size());
    for(Index v = 0; v < distance_.size(); ++v)
      arrivals_[v] = forest.arrival_at(v, distance_[v]);
  }

  bool is_at_source(Index v) const { return is_source_[v] || distance_[v] == 0.; }

  // Distances of heat are smoothed, at the cut locus most of all, and those on a graph are longer: the lengths of the ways to
  // which they lead tell more, and take their place, straightened.
  void measure_ways(const Way_forest& forest)
  {
    std::vector<double> lengths = forest.lengths(), before(lengths.size(), Straight_waves::infinity());
    for(Index v = 0; v < lengths.size(); ++v)
      if(is_source_[v])
        lengths[v] = before[v] = distance_[v];
      else if(forest.starts_at(v))
      {
        const Way_arrival way = forest.arrival_at(v, lengths[v]);
        before[v] = way.length - way.straight;
      }
    Straight_waves(mesh_, connectivity_, std::move(before), lengths).straighten();
    distance_ = std::move(lengths);
  }

  // A source is not it even if all distances are equal, unless all vertices are sources.
  void find_farthest()
  {
    farthest_ = null_index;
    for(Index v = 0; v < distance_.size(); ++v)
      if(!is_source_[v] && (farthest_ == null_index || distance_[v] > distance_[farthest_]))
        farthest_ = v;
    if(farthest_ == null_index)
      farthest_ = first_that_may_be_root();
  }

  // A vertex that does not have all faces around it as a source. There is one: each source has faces.
  Index first_that_may_be_root() const
  {
    std::vector<unsigned char> is_enclosed(distance_.size(), 0);
    for(const Source_element& element : roots_.elements())
      if(element.vertex != null_index)
        is_enclosed[element.vertex] = 1;
    return static_cast<Index>(std::find(is_enclosed.begin(), is_enclosed.end(), 0) - is_enclosed.begin());
  }

  // Edges between the disks of two sources are no branch, and have no strength of one.
  void name_sources(Indexed_cut_locus& graph) const
  {
    for(Indexed_cut_locus::Edge& e : graph.edges)
    {
      const Index o = mesh_.opposite[e.halfedge], left = roots_.name(source_of_face_[e.halfedge / 3]);
      const Index right = o != null_index ? roots_.name(source_of_face_[o / 3]) : left;
      e.sources = {{(std::min)(left, right), (std::max)(left, right)}};
      if(left != right)
        e.strength = gap_between_sources;
    }
  }

  // Parts of the border that are sources are nodes of the tree, and no part of the curve.
  void leave_sources(const Branch_thresholds& thresholds, Indexed_cut_locus& graph) const
  {
    const Nodes_with_sources nodes(mesh_, connectivity_, roots_.parts());
    std::vector<unsigned char> is_removed(graph.edges.size(), 0);
    std::vector<Index> halfedges, edges; // that are inside
    for(Index e = 0; e < graph.edges.size(); ++e)
    {
      const Index h = graph.edges[e].halfedge;
      const bool is_along = mesh_.is_border_edge(h);
      is_removed[e] = is_along && (is_source_[mesh_.source(h)] || is_source_[mesh_.target(h)]);
      if(is_along)
        continue;
      halfedges.push_back(h);
      edges.push_back(e);
    }
    const Edges_off_sources off(nodes, halfedges, remedy());
    for(std::size_t i = 0; i < edges.size(); ++i)
      is_removed[edges[i]] |= off.is_dropped()[i];
    remove_loose_ends(thresholds, off.number_at_sources() > 0, graph, is_removed);
    if(std::count(is_removed.begin(), is_removed.end(), 0) > 0)
      remove_edges(mesh_, connectivity_, graph, is_removed);
    else
    {
      graph = Indexed_cut_locus();
      if(add_lone_nodes(
           mesh_, connectivity_, distance_, {}, [this](Index h) { return roots_.parts().is_on_source(h); }, graph))
        set_distances_from_curves(mesh_, roots_.points(), {roots_.parts().all()}, graph);
    }
    for(Index i = 0; i < graph.edges.size(); ++i)
      graph.edges[i].origin = i;
  }

  // Edges along the border, from which no branch goes on any more, and branches that led to a source alone.
  void remove_loose_ends(const Branch_thresholds& thresholds, bool was_at_source, const Indexed_cut_locus& graph,
                         std::vector<unsigned char>& is_removed) const
  {
    std::vector<Index> left;
    for(Index e = 0; e < graph.edges.size(); ++e)
      if(!is_removed[e])
        left.push_back(e);
    const auto ends = [&](Index i) -> Edges_left::Nodes {
      return {{graph.edges[left[i]].source, graph.edges[left[i]].target}};
    };
    const auto is_strong = [&](Index v)
    { return angle_[v] >= thresholds.gradient_angle && -laplacian_[v] >= thresholds.laplacian; };
    Edges_left peeled(graph.nodes.size(), left.size(), ends);
    peeled.peel(ends,
                [&](Index i, Index node)
                {
      const Index v = graph.nodes[node].vertex;
      const bool is_along = mesh_.is_border_edge(graph.edges[left[i]].halfedge);
      const bool is_loose = is_along || (was_at_source && !connectivity_.is_border(v) && !is_strong(v));
      is_removed[left[i]] = is_loose;
      return is_loose;
    });
  }

  // The farthest vertex is on the cut locus of a closed surface. A border vertex may be farthest without being on it:
  // then the lowest Laplacian is the best guess.
  Index choose_root() const
  {
    if(!connectivity_.is_border(farthest_))
      return farthest_;
    Index best = null_index;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(!connectivity_.is_border(v) && !is_source_[v] && (best == null_index || laplacian_[v] < laplacian_[best]))
        best = v;
    return best != null_index ? best : farthest_;
  }

  // what depends on the mesh alone
  struct Surface
  {
    Surface(const Indexed_triangle_mesh& mesh, Laplacian_operator type, const Threads& threads,
            const Progress& progress)
      : connectivity(mesh, progress.part(0., 0.1)),
        tangent(checked_mesh(mesh, connectivity), connectivity, progress.part(0.1, 0.3)),
        operators(mesh, connectivity, type, threads, progress.part(0.3, 0.9)), genus(connectivity.genus(mesh))
    {
      tangent.align(mesh, connectivity, operators.frames, progress.part(0.9, 1.));
    }

    Mesh_connectivity connectivity;
    Tangent_directions tangent;
    Differential_operators operators;
    Index genus;
  };

  Laplacian_solver(const Indexed_triangle_mesh& mesh, std::shared_ptr<const Surface> surface)
    : mesh_(mesh), surface_(std::move(surface)), connectivity_(surface_->connectivity), tangent_(surface_->tangent),
      operators_(surface_->operators)
  {
  }

  const Indexed_triangle_mesh& mesh_;
  std::shared_ptr<const Surface> surface_;
  const Mesh_connectivity& connectivity_; // these are of it
  const Tangent_directions& tangent_;
  const Differential_operators& operators_;

  Source_roots roots_;
  std::vector<unsigned char> is_source_; // vertices
  std::vector<double> distance_;
  bool is_approximate_ = false;
  Index farthest_ = null_index;
  std::vector<float> angle_, laplacian_;
  std::vector<float> slope_error_;
  float laplacian_noise_ = 0.f;
  std::vector<unsigned char> crossed_; // edges, by short ways to vertices
  std::vector<Way_arrival> arrivals_;  // of these ways, by vertex
  Spanning_tree spanning_tree_;
  Spanning_tree tree_; // the same, thinned
  Branch_filter filter_;
  std::vector<Index> source_of_face_; // in whose disk it is
  std::vector<Index> nearest_source_; // of each vertex, if there are several
  Progress progress_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_SOLVER_H
