// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_VISITOR_HANDLE_H
#define CGAL_CUT_LOCI_FACE_GRAPH_VISITOR_HANDLE_H

#include <CGAL/Cut_loci/Default_visitor.h>

#include <functional>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Holds a visitor of any type, or a reference to one.
class Visitor_handle
{
public:
  Visitor_handle() = default;

  template <typename Visitor>
  explicit Visitor_handle(Visitor visitor)
    : visit_(
        [visitor](Stage stage, bool starts) mutable
        {
    auto& v = unwrapped(visitor);
    if(starts)
      v.start_stage(stage);
    else
      v.end_stage(stage);
      })
  {
  }

  // A stage lasts as long as its scope.
  class Scope
  {
  public:
    Scope(const Visitor_handle& handle, Stage stage) : handle_(handle), stage_(stage) { handle_.visit_(stage_, true); }
    ~Scope() { handle_.visit_(stage_, false); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    const Visitor_handle& handle_;
    Stage stage_;
  };

private:
  template <typename T>
  static T& unwrapped(T& t)
  {
    return t;
  }
  template <typename T>
  static T& unwrapped(std::reference_wrapper<T>& t)
  {
    return t.get();
  }

  std::function<void(Stage, bool)> visit_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_FACE_GRAPH_VISITOR_HANDLE_H
