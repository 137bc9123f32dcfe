#pragma once
// The walk through the axes of two boxes, in three groups, and how the boxes lie.

#include <isect/methods/obb_obb.h>
#include "lessons/obb_obb/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::obb_obb_lesson {

std::string in_words(Relation);

struct Group;  ///< of axes

class Teller {
 public:
  explicit Teller(const Setup&);
  viz::Walk tell();

 private:
  using Compared = obb_obb::Compared<Counted<double>>;

  // telling.cpp
  double length(const Compared&) const;
  /// The axis that separates, or else the one on which the boxes share least.
  const Compared& telling_one(const std::vector<Compared>&) const;
  void say(const Group&, const std::vector<Compared>&);
  std::string separated(const Group&, const Compared&, double l, int asked) const;
  std::string passed(const Group&, const Compared&, const std::vector<Compared>& group) const;
  viz::Question question(const Group&, const Compared&) const;
  /// Whether one of the six normals separates in the core's numbers, without epsilon.
  bool a_normal_separates() const;
  /// Whether the axis separates by the core's numbers, but not with epsilon.
  bool widened(const Compared&) const;

  // relation.cpp
  void relation();
  std::string because() const;
  std::string end_caption() const;

  const Setup s_;
  Script script_;
  bool overlap_ = false;
  std::optional<obb_obb::Axis> gap_;  ///< the axis that separates
  int asked_ = 0;
};

}  // namespace isect::lessons::obb_obb_lesson
