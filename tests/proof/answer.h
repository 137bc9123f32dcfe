#pragma once
// What `isect scene --json` must answer about two objects, field by field, from rationals alone.

#include <functional>

#include "tests/proof/truth.h"

namespace isect::proof {

/// An object as a scene writes it, and as a set.
struct Posed {
  Json json;
  Thing thing;

  const std::string& type() const { return thing.type; }
};

/// Whether the question [a, b] can be asked in its own order: a query of two types names what contains what in the
/// order of its fields.
bool in_order(const std::string& type_of_a, const std::string& type_of_b);

/// Finding the double nearest to each t takes most of the time.
enum class Times { nearest, left_out };

/// The fields of "result" that state the truth: "relation", "meet", "location", "evenodd", "on", "hit", "meeting" and
/// others, with each "t" as the double nearest to it ("inf" beyond the largest). The two must be in order. Nothing if
/// the question has no answer (whether a point lies within a surface that is not closed), or the pair no test.
/// Times::left_out: any number stands for each t.
std::optional<Json> answer(const Posed& a, const Posed& b, Times = Times::nearest);

/// The double nearest to the least number from which on `holds` is true, if it stays true for all greater ones;
/// infinite beyond the largest.
double nearest_border(const std::function<bool(const Rational&)>& holds);

}  // namespace isect::proof
