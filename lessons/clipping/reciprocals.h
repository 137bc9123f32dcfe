#pragma once
// The walk of a segment against a box by slabs with reciprocals, as ray tracers write it.

#include <cmath>
#include <optional>
#include <string>

#include <isect/methods/ray_aabb.h>
#include "lessons/clipping/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::clipping_lesson {

class SlabTeller {
 public:
  SlabTeller(const Segment<double, 2>&, const Box&, bool range_first);
  viz::Walk tell();

 private:
  using Part = std::optional<Interval<double>>;

  static bool no_number(const Interval<double>& i) { return std::isnan(i.lo) || std::isnan(i.hi); }

  // reciprocals.cpp
  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                 const std::string& formula);
  void begin();
  std::string letter() const { return std::string(1, "xy"[axis_]); }
  void say(const ray_aabb::Reciprocal<double>& e) { axis_ = e.axis, inverse_ = e.value; }
  void say(const ray_aabb::Planes<double>&);
  void say(const ray_aabb::Crossing<double>&);
  void say(const ray_aabb::Remains<double>&);
  /// Adds the two sides of the axis, and where the line crosses theirs.
  void add_slab(viz::Scene&) const;
  bool is_a_point() const { return known_.segment.p == known_.segment.q; }
  void end();

  // reciprocals_words.cpp
  std::string planes_caption() const;
  std::string crossing_caption() const;
  std::string remains_caption(const Interval<double>& before) const;
  std::string verdict_text() const;
  std::string end_caption() const;
  /// The answer where a product was not a number.
  std::string what_it_is_worth() const;
  /// Whether the part that the method keeps goes beyond the segment.
  bool beyond() const { return found_ && (found_->lo < 0 || found_->hi > 1); }

  const Box box_;
  const bool range_first_;
  const Part truth_;
  Script script_;
  Narrowing known_;
  Part found_, exchanged_;  ///< what the method keeps; what it would keep with the arguments exchanged
  int axis_ = 0;
  double inverse_ = 0;
  Interval<double> slab_ = {0, 0}, crossing_ = {0, 0}, range_ = {0, 1};
  bool asked_t_ = false, no_number_seen_ = false, hidden_ = false;
};

}  // namespace isect::lessons::clipping_lesson
