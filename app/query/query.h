#pragma once
// The core as an exact oracle: one JSON case in, one JSON answer out. `isect query` is a loop around answer().
//
// To add a kind: a function template of a handler file, and a line in its table. The kinds and their fields are listed
// in `isect query --help`.

#include <string>
#include <string_view>
#include <vector>

namespace isect::query {

struct Answer {
  std::string text;    ///< one line of JSON, without its end
  bool error = false;  ///< the line says what is wrong
};

/// Returns {"id", "result"[, "trace"]} or {"id", "error"}; the id is the text that was sent. Never throws, even for
/// lack of memory, as long as there is some for the error. No state, so any number may run at once. O(n log n) time for
/// a line of n bytes, and about 30 n bytes of memory at most, whatever it holds; what would take more is refused. A
/// trace takes as many bytes more as it is long. An error without an id has the line's `number`; 0: none. `strict`: a
/// shape without points, such as a box whose lo is above its hi, is an error that names it.
Answer answer(const std::string& line, std::size_t number = 0, bool strict = false);

/// Whether a line has nothing but blanks: no case, and no answer.
bool blank(std::string_view line);

/// Returns the most levels of nested lists and objects that a line may have, the case itself included.
int most_levels();
/// Return the most bytes of a line, and the answer to a longer one.
std::size_t most_bytes();
Answer too_long(std::size_t number = 0);
/// Returns the answer to a line for which there is not enough memory.
Answer out_of_memory(std::size_t number = 0);

/// The kinds in order, each with its inputs, [optional] ones in brackets, and its variants, the exact default first.
struct Kind {
  std::string name, inputs;
  std::vector<std::string> variants;
};
std::vector<Kind> kinds();
/// Returns fields that any case may have beside its inputs, with any content: they are ignored.
const std::vector<std::string>& notes();

}  // namespace isect::query
