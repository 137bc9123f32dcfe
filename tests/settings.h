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

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// How many random cases to draw: few in an ordinary run, many in a long one. The sanitizers need a quarter of the few:
/// they see what a line does in any case, not whether its answer is right.
inline int cases(int few, int many) { return long_run() ? many : sanitized ? (few + 3) / 4 : few; }

}  // namespace isect::tests

/// Parameters of TEMPLATE_TEST_CASE_SIG: the shapes of the plane and of space, in both precisions.
#define FLOATS_AND_DIMENSIONS ((class S, int N), S, N), (float, 2), (double, 2), (float, 3), (double, 3)
