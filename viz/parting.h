#pragma once
// Where two walks of one lesson part, told as far as a reader has come.

#include "viz/lesson.h"

namespace isect::viz {

/// -1: they don't, or only the other has such a place.
struct Parting {
  int line_a = -1, line_b = -1;  ///< the first line whose text differs or, in the same text, that only one of them runs
  int value_a = -1, value_b = -1;  ///< the first value of the steps shown that has another name or number
  bool operator==(const Parting&) const = default;
};

/// `at_a`, `at_b`: the steps shown. Nothing that comes later is told, except that two texts differ.
Parting parting(const Walk& a, int at_a, const Walk& b, int at_b);

}  // namespace isect::viz
