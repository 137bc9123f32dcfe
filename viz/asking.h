#pragma once
// Which questions a walk asks, and what is drawn while one is open.

#include "viz/lesson.h"

namespace isect::viz {

/// What the question before `step` is about, without its answer: the question's own scene or, where it has none, the
/// step's scene but for what is new in it and tells: hits, misses, what is left out, numbers in headings. What such an
/// item replaces stays as it was. Before a chart or a raster the scene before it stays.
Scene question_scene(const Walk&, int step);
/// Takes away each question that asks, in nearly the same words, what an earlier one of the walk did, and has its
/// answer.
void ask_once(Walk&);
/// What is drawn before a first step that has a question: nothing that it has found.
Scene opening_scene(const Step& first);

}  // namespace isect::viz
