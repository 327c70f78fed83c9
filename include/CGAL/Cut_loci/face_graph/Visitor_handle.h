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
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Cut_loci::internal {

// Holds a visitor of any type, or a reference to one. What a visitor is told within a stage it need not have a function
// for; `Default_visitor` itself costs nothing there.
class Visitor_handle
{
  struct Concept
  {
    virtual ~Concept() = default;
    virtual std::unique_ptr<Concept> copy() const = 0;
    virtual void start_stage(Stage stage) = 0;
    virtual void end_stage(Stage stage) = 0;
    virtual bool wants_progress() const = 0;
    virtual void progress(Stage stage, double share) = 0;
  };

public:
  Visitor_handle() = default;

  template <typename Visitor>
  explicit Visitor_handle(const Visitor& visitor) : model_(new Model<Visitor>(visitor))
  {
  }

  Visitor_handle(const Visitor_handle& other) : model_(other.model_ ? other.model_->copy() : nullptr) {}
  Visitor_handle& operator=(Visitor_handle&&) = default;

  // for a stage; it must not outlive the handle
  Progress progress(Stage stage) const
  {
    Concept* const model = model_.get();
    return model != nullptr && model->wants_progress()
             ? Progress([model, stage](double share) { model->progress(stage, share); })
             : Progress();
  }

  // A stage lasts as long as its scope.
  class Scope
  {
  public:
    Scope(const Visitor_handle& handle, Stage stage) : visitor_(*handle.model_), stage_(stage)
    {
      visitor_.start_stage(stage_);
    }
    ~Scope() { visitor_.end_stage(stage_); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    Concept& visitor_;
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

  template <typename Visitor>
  struct Model : public Concept
  {
    using Unwrapped = typename std::remove_reference<decltype(unwrapped(std::declval<Visitor&>()))>::type;

    explicit Model(const Visitor& v) : visitor(v) {}
    std::unique_ptr<Concept> copy() const override { return std::unique_ptr<Concept>(new Model(visitor)); }
    void start_stage(Stage stage) override { unwrapped(visitor).start_stage(stage); }
    void end_stage(Stage stage) override { unwrapped(visitor).end_stage(stage); }
    static constexpr auto tell = [](auto& v, Stage stage, double share) -> decltype(void(v.progress(stage, share)))
    { v.progress(stage, share); };
    static constexpr bool has_progress = std::is_invocable<decltype(tell), Unwrapped&, Stage, double>::value;
    bool wants_progress() const override { return has_progress && !std::is_same<Unwrapped, Default_visitor>::value; }
    void progress(Stage stage, double share) override
    {
      if constexpr(has_progress)
        tell(unwrapped(visitor), stage, share);
    }
    Visitor visitor;
  };

  std::unique_ptr<Concept> model_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_VISITOR_HANDLE_H
