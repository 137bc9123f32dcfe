#pragma once
// What a formula is made of before it is set in one line, and the spaces between.

#include <string>
#include <string_view>
#include <vector>

#include "viz/text/rich_text.h"
#include "viz/text/tex_math_signs.h"

namespace isect::viz::tex_math {

using Runs = std::vector<Run>;

/// A sign, a letter or a number with its scripts, and how it is spaced.
struct Atom {
  enum class Kind { letter, binary, relation, open, close, comma, word, fraction, space };
  Kind kind = Kind::letter;
  Runs runs = {};
};
using Atoms = std::vector<Atom>;
using Kind = Atom::Kind;

Kind kind_of(TexSign::Kind);
Atom atom(Kind, std::string_view text, bool italic = false);

/// Appends runs; those of one style become one.
void append(Runs& to, const Runs& more);
void append(Runs& to, const std::string& text);
std::string text_of(const Runs&);
Runs styled(Runs, bool italic, bool bold);

/// Returns the atoms side by side, spaced as in TeX. `tight`: as in scripts, without spaces.
Runs laid_out(Atoms, bool tight = false);

}  // namespace isect::viz::tex_math
