#pragma once
// Requirements of a fuzz target: a failure prints and aborts, so that the fuzzer keeps the input.

#include <cstdio>
#include <cstdlib>
#include <string>

inline void require(bool holds, const char* what, const std::string& input) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\nfor %s\n", what, input.c_str());
  std::abort();
}
