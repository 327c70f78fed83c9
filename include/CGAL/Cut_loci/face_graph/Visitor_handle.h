// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_VISITOR_HANDLE_H
#define CGAL_CUT_LOCI_FACE_GRAPH_VISITOR_HANDLE_H

#include <CGAL/Cut_loci/Default_visitor.h>
#include <CGAL/Cut_loci/internal/Progress.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL::Cut_loci::internal {

// Holds a visitor of any type, or a reference to one. What a visitor is told within a stage it need not have a function
// for; `Default_visitor` itself costs nothing there.
class Visitor_handle
{
  enum class Event { START, END, PROGRESS };

public:
  Visitor_handle() = default;
  template <typename Visitor>
  explicit Visitor_handle(const Visitor& visitor)
    : tell_(
        [told = Visitor(visitor)](Event event, Stage stage, double share) mutable
        {
    auto& v = unwrapped(told);
    if(event == Event::START)
      v.start_stage(stage);
    else if(event == Event::END)
      v.end_stage(stage);
    else if constexpr(has_progress<decltype(v)>)
      tell_progress(v, stage, share);
      }),
  wants_progress_(has_progress<decltype(unwrapped(std::declval<Visitor&>()))> &&
                  !std::is_same<decltype(unwrapped(std::declval<Visitor&>())), Default_visitor&>::value)
  {
  }

  // for a stage; it must not outlive the handle
  Progress progress(Stage stage) const
  {
    return wants_progress_ ? Progress([this, stage](double share) { tell_(Event::PROGRESS, stage, share); })
                           : Progress();
  }

  // A stage lasts as long as its scope.
  class Scope
  {
  public:
    Scope(const Visitor_handle& handle, Stage stage) : handle_(handle), stage_(stage)
    {
      handle_.tell_(Event::START, stage_, 0.);
    }
    ~Scope() { handle_.tell_(Event::END, stage_, 1.); }
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

  static constexpr auto tell_progress =
    [](auto& v, Stage stage, double share) -> decltype(void(v.progress(stage, share))) { v.progress(stage, share); };
  template <typename Visitor>
  static constexpr bool has_progress = std::is_invocable<decltype(tell_progress), Visitor, Stage, double>::value;

  std::function<void(Event, Stage, double)> tell_; // has the visitor, and copies it with itself
  bool wants_progress_ = false;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_VISITOR_HANDLE_H
