#pragma once
// Whether what the program says of two objects is true of their sets.

#include <string>

#include "tests/proof/truth.h"

namespace isect::proof {

struct Named {
  std::string name;
  const Thing& thing;
};

enum class Judged { right, wrong, undecided, unknown };

/// `verdict` is in words, about two objects whose names are capital letters, in either order.
Judged judge(const std::string& verdict, const Named& a, const Named& b);

/// What is wrong in the fields of the result; empty if all is right. They must say which contains which, in the order
/// of the question or of its query, and each t must be within 4 ulp of the true one.
std::string wrong_in_result(const Json& result, bool of_query, const Named& a, const Named& b);

/// All that the judge knows about two objects, for printing.
std::string truth_of(const Named& a, const Named& b);

}  // namespace isect::proof
