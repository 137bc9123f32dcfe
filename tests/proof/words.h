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

/// `verdict`: in words, about two objects whose names are capital letters, in either order.
Judged judge(const std::string& verdict, const Named& a, const Named& b);

/// Whether the fields of the result say the same: which contains which, as the question names them, or as the query
/// does that it is of; and whether each t is within 4 ulp of the true one. What is wrong, or empty.
std::string wrong_in_result(const Json& result, bool of_query, const Named& a, const Named& b);

/// All that the judge knows of two objects, to be printed.
std::string truth_of(const Named& a, const Named& b);

}  // namespace isect::proof
