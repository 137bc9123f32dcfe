#pragma once
// The commands of LaTeX's mathematics that stand for one sign or word.

#include <string_view>

namespace isect::viz {

struct TexSign {
  /// How it is spaced: an operator between two sides, a relation, a word such as sin, or none of them.
  enum class Kind { letter, binary, relation, open, close, comma, word };
  std::string_view command;  ///< without its backslash
  std::string_view text;
  Kind kind = Kind::letter;
  bool italic = false;
};

/// Returns the sign of a command; null if there is none.
const TexSign* tex_sign(std::string_view command);
/// Returns the sign that is this character; null if it is none of them.
const TexSign* tex_sign_of(std::string_view character);

}  // namespace isect::viz
