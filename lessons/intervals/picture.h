#pragma once
// Two intervals, how they lie, and how they are drawn; and the lesson's walk and map.

#include <isect/interval_interval.h>
#include "viz/lesson.h"

namespace isect::lessons::intervals_lesson {

struct Setup {
  Interval<double> a, b;
  Relation truth;
};

Setup setup(const viz::Parameters&);

/// The two intervals above their number line. `looked_at`: the two ends that a step compares.
viz::Scene picture(const Setup&, const std::optional<viz::Vec2>& looked_at, bool settled);

/// The lower and the upper end of b, where a runs from 0 to 1. (cases.cpp)
const viz::CaseMap& cases();
/// Whether the intervals meet, by each method. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();
/// (telling.cpp)
viz::Walk tell(const Setup&);

}  // namespace isect::lessons::intervals_lesson
