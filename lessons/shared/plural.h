#pragma once

#include <string>

namespace isect::lessons {

/// "1 test", "3 tests", "2 boxes", "4 vertices"
inline std::string plural(long long n, const std::string& one) {
  std::string word = one;
  if (n != 1 && word.ends_with("ex"))
    word.replace(word.size() - 2, 2, "ices");
  else if (n != 1)
    word += word.ends_with("x") ? "es" : "s";
  return std::to_string(n) + " " + word;
}

}  // namespace isect::lessons
