#pragma once
// Which questions a walk asks, and what is drawn while a question is open.

#include "viz/lesson.h"

namespace isect::viz {

/// Returns a value that the next step may change, as it was before, under the name for questions: "count before".
Value before(Value);

/// Returns what is shown while the question before `step` is open, as a step of its own. All of it belongs to `step`,
/// or holds whatever the answer is:
///  - its scene: see question_scene; no time runs in it;
///  - its values: those of `step` that are known before it and never change in the walk; last, all that the question
///    is given; none is new;
///  - the lines that were refused or not taken so far and still are so at `step`, except its own: what that one will
///    do is the question; no line is current;
///  - the verdict, where it is the same before and after; the operations counted before it;
///  - no title, caption, formula and comparison: they would tell the answer, or belong to another step.
Step asking_step(const Walk&, int step);
/// Returns the values of that step.
std::vector<Value> known_values(const Walk&, int step);
/// Returns what the question before `step` is about, without its answer: the question's own scene or, where it has
/// none, the step's scene without what is new in it and tells: hits, misses, what is left out, numbers in headings.
/// What such an item replaces stays as it was. Before a chart or a raster the scene before it stays. Before the first
/// step it is the opening scene.
Scene question_scene(const Walk&, int step);
/// Removes each question that asks, in nearly the same words, what an earlier one of the walk asked, and has the same
/// answer.
void ask_once(Walk&);
/// Returns what is drawn before a first step that has a question: nothing that this step has found.
Scene opening_scene(const Step& first);

}  // namespace isect::viz
