#pragma once
// What a run of the tests may ask for: ISECT_SEED=n draws other random shapes, ISECT_LONG=1 draws many more.

#include <cstdint>
#include <cstdlib>
#include <string>

namespace isect::tests {

inline std::uint64_t seed() {
  const char* text = std::getenv("ISECT_SEED");
  return text ? std::strtoull(text, nullptr, 10) : 1;
}

inline bool long_run() {
  const char* text = std::getenv("ISECT_LONG");
  return text && std::string(text) == "1";
}

/// How many random cases to draw: few in an ordinary run, many in a long one.
inline int cases(int few, int many) { return long_run() ? many : few; }

}  // namespace isect::tests

/// Parameters of TEMPLATE_TEST_CASE_SIG: the shapes of the plane and of space, in both precisions.
#define FLOATS_AND_DIMENSIONS ((class S, int N), S, N), (float, 2), (double, 2), (float, 3), (double, 3)
