#pragma once
// The core as an exact oracle: one JSON case in, one JSON answer out. `isect query` is a loop around answer().
//
// To add a kind: a function template of a handler file, and a line in its table. The kinds and their fields are listed in
// `isect query --help`.

#include <string>
#include <vector>

namespace isect::query {

struct Answer {
  std::string text;    ///< one line of JSON, without its end
  bool error = false;  ///< the line says what is wrong
};

/// {"id", "result"[, "trace"]} or {"id", "error"}. Never throws but for lack of memory. No state, so any number may run
/// at once.
Answer answer(const std::string& line);

/// What a line longer than the reader allows gets.
Answer too_long(std::size_t limit);

/// The kinds in order, each with its variants, the exact default first.
struct Kind {
  std::string name;
  std::vector<std::string> variants;
};
std::vector<Kind> kinds();

}  // namespace isect::query
