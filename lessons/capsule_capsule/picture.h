#pragma once
// The picture of two capsules in the plane: their segments, and the way from each end to the other segment.

#include <vector>

#include <isect/capsule_capsule.h>
#include "viz/lesson.h"

namespace isect::lessons::capsule_capsule_lesson {

using Capsule2 = Capsule<double, 2>;
using capsule_capsule::End;

struct Setup {
  Capsule2 a, b;
  Relation truth;

  bool thin() const { return a.radius == 0 || b.radius == 0; }
  bool segments() const { return a.radius == 0 && b.radius == 0; }
  /// The points of both segments that are nearest to each other, rounded.
  std::pair<viz::Vec2, viz::Vec2> closest() const;
  /// An end, and the point of the other segment nearest to it, rounded.
  std::pair<viz::Vec2, viz::Vec2> way(const End&) const;
};
Setup setup(const viz::Parameters&);

/// What a step shows.
struct Shown {
  bool radii = false;        ///< how far both reach
  bool crossing = false;     ///< the segments cross
  std::vector<End> earlier;  ///< the ways of earlier steps
  std::vector<End> ways;     ///< those of this one
  bool settled = false;      ///< what they share
};
viz::Scene picture(const Setup&, const Shown&);

/// The map of all cases by where the middle of b lies about that of a. (cases.cpp)
const viz::CaseMap& cases();
/// Whether the capsules meet, by each method. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// Why they lie as they do, and what follows. (relation.cpp)
std::string because(const Setup&);
std::string end_caption(const Setup&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();
/// (telling.cpp)
viz::Walk tell(const Setup&);

}  // namespace isect::lessons::capsule_capsule_lesson
