#pragma once
// Which deliberate fault this run has: the number in ISECT_FAULT, none without it. See tests/mutation/study.py.

#include <cstdlib>

inline bool isect_fault(int number) {
  static const char* const asked = std::getenv("ISECT_FAULT");
  return asked != nullptr && std::atoi(asked) == number;
}
