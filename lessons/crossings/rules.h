#pragma once
// The two rules, walked: which edges count.

#include "lessons/crossings/situations.h"
#include "viz/lesson.h"

namespace isect::lessons::crossings_lesson {

/// The core's rule: a vertex at the height of the point counts as below it.
viz::Walk half_open(const Setup&);
/// Each edge with a point at that height counts, its ends included: what the note's sentence says when it is read
/// plainly.
viz::Walk closed(const Setup&);

}  // namespace isect::lessons::crossings_lesson
