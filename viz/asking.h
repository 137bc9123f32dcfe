#pragma once
// Which questions a walk asks, and what is drawn while one is open.

#include "viz/lesson.h"

namespace isect::viz {

/// A value that the next step may change, as it is before: "count before". A question is given it under this name.
Value before(Value);

/// What is shown while the question before `step` is open, as a step of its own. All of it belongs to `step`, or holds
/// whatever the answer:
///  - its scene: see question_scene;
///  - its values: of those of `step` the ones that are known before it and change nowhere in the walk, but for what the
///    question is given, which comes last; none is new;
///  - of the lines that were refused or not taken so far those that still are at `step`, but for its own: what it will
///    do is the question; no line is current;
///  - the verdict, where it is the same before and after; the operations counted before it;
///  - no title, caption, formula and comparison: they would tell the answer, or speak of another step.
Step asking_step(const Walk&, int step);
/// What the question before `step` is about, without its answer: the question's own scene or, where it has none, the
/// step's scene but for what is new in it and tells: hits, misses, what is left out, numbers in headings. What such an
/// item replaces stays as it was. Before a chart or a raster the scene before it stays. Before the first step it is
/// the opening scene.
Scene question_scene(const Walk&, int step);
/// Takes away each question that asks, in nearly the same words, what an earlier one of the walk did, and has its
/// answer.
void ask_once(Walk&);
/// What is drawn before a first step that has a question: nothing that it has found.
Scene opening_scene(const Step& first);

}  // namespace isect::viz
