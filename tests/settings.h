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

}  // namespace isect::tests
