#pragma once
// Hard cases of every pair of a scene's objects, in the plane and in space: lines of `isect query` with the true
// answer.

#include "tests/proof/answer.h"

namespace isect::cases {

using SceneJson = proof::Json;
using Posed2 = std::array<proof::Posed, 2>;

/// Two objects of a scene as sets; a frustum is what the six planes bound that its numbers are rounded to. Nothing
/// where one is empty, or a hull has no volume, in the plane no area. Throws viz::BadInput where the program refuses
/// one.
std::optional<Posed2> posed(const SceneJson& objects, bool flat);

/// A part of the "result" that the program gives such a line, with all that can be true or false in it. Nothing where
/// the question has no answer.
std::optional<SceneJson> expected(const Posed2&, proof::Times = proof::Times::nearest);

/// Without the numbers: what cases are told apart by.
std::string kind_of_answer(const SceneJson& expected);

/// The lines, each {"id", "note", "objects", "ask", "expected"}, and "conventions" with the planes of each frustum
/// (normal and d, normal . x + d >= 0 within), by their types. Of each pair of types there are all kinds of answer and
/// all families that random draws find (tests/proof/draw.h), and cases where an ulp changes the answer.
std::vector<SceneJson> scenes(bool flat);

}  // namespace isect::cases
