#pragma once
// What a run of the tests may ask for: ISECT_SEED=n draws other random shapes, ISECT_LONG=1 draws many more.

#include <algorithm>
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

#ifdef __SANITIZE_ADDRESS__
constexpr int fewer = 4;  // each case costs several times as much, and what sanitizers find lies on a path, not in a number
#else
constexpr int fewer = 1;
#endif

/// How many random cases to draw: few in an ordinary run, a quarter of them under the sanitizers, many in a long run.
inline int cases(int few, int many) { return long_run() ? many : std::max(few / fewer, std::min(few, 20)); }

}  // namespace isect::tests

/// Parameters of TEMPLATE_TEST_CASE_SIG: the shapes of the plane and of space, in both precisions.
#define FLOATS_AND_DIMENSIONS ((class S, int N), S, N), (float, 2), (double, 2), (float, 3), (double, 3)
