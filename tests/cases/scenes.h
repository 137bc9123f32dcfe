#pragma once
// Hard cases of every pair of a scene's objects, in the plane and in space: lines of `isect query` with the true
// answer.

#include "tests/proof/answer.h"

namespace isect::cases {

using SceneJson = proof::Json;
using Posed2 = std::array<proof::Posed, 2>;

/// Two objects of a scene as sets; a frustum is the solid bounded by the six planes to which its numbers are rounded.
/// Nothing if one is empty, or a hull has no volume, in the plane no area. Throws viz::BadInput where the program
/// refuses one.
std::optional<Posed2> posed(const SceneJson& objects, bool flat);

/// The part of the "result" that the program gives for such a line: all that can be true or false. Returns nothing
/// where the question has no answer.
std::optional<SceneJson> expected(const Posed2&, proof::Times = proof::Times::nearest);

/// The answer without the numbers, by which cases are distinguished.
std::string kind_of_answer(const SceneJson& expected);

/// The lines, each {"id", "note", "objects", "ask", "expected"}, and "conventions" with the planes of each frustum
/// (normal and d, normal . x + d >= 0 within), by their types. Each pair of types has all kinds of answer and all
/// families that random draws find (tests/proof/draw.h), and cases where an ulp changes the answer.
std::vector<SceneJson> scenes(bool flat);

}  // namespace isect::cases
