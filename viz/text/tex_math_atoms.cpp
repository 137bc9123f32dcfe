#include "viz/text/tex_math_atoms.h"

namespace isect::viz::tex_math {

Kind kind_of(TexSign::Kind kind) {
  switch (kind) {
    case TexSign::Kind::letter:
      return Kind::letter;
    case TexSign::Kind::binary:
      return Kind::binary;
    case TexSign::Kind::relation:
      return Kind::relation;
    case TexSign::Kind::open:
      return Kind::open;
    case TexSign::Kind::close:
      return Kind::close;
    case TexSign::Kind::comma:
      return Kind::comma;
    case TexSign::Kind::word:
      return Kind::word;
  }
  return Kind::letter;
}

Atom atom(Kind kind, std::string_view text, bool italic) {
  return {kind, {Run{.text = std::string(text), .italic = italic}}};
}

void append(Runs& to, const Runs& more) {
  for (const Run& run : more) {
    const bool same =
        !to.empty() && to.back().italic == run.italic && to.back().bold == run.bold && to.back().script == run.script;
    same ? static_cast<void>(to.back().text += run.text) : to.push_back(run);
  }
}
void append(Runs& to, const std::string& text) { append(to, Runs{Run{.text = text}}); }

namespace {

/// Whether a plus or minus behind it is a sign, not an operation.
bool begins_side(Kind kind) {
  return kind == Kind::binary || kind == Kind::relation || kind == Kind::open || kind == Kind::comma ||
         kind == Kind::word;
}

/// Returns the space before atom i, as TeX's tables have it, in whole spaces.
std::string gap(const Atoms& atoms, std::size_t i) {
  const Kind left = atoms[i - 1].kind, right = atoms[i].kind;
  if (left == Kind::space || right == Kind::space) return "";
  const auto spaced = [](Kind kind) { return kind == Kind::binary || kind == Kind::relation; };
  if (spaced(left) || spaced(right) || left == Kind::comma) return " ";
  if (left == Kind::word) return right == Kind::open || right == Kind::close || right == Kind::comma ? "" : " ";
  if (right == Kind::word) return left == Kind::open ? "" : " ";
  const bool fraction = left == Kind::fraction || right == Kind::fraction;
  return fraction && left != Kind::open && right != Kind::close && right != Kind::comma ? "\u2009" : "";
}

}  // namespace

Runs laid_out(Atoms atoms, bool tight) {
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (atoms[i].kind != Kind::binary) continue;
    const bool first = i == 0 || begins_side(atoms[i - 1].kind), last = i + 1 == atoms.size();
    const Kind next = last ? Kind::letter : atoms[i + 1].kind;
    if (first || last || next == Kind::relation || next == Kind::close || next == Kind::comma)
      atoms[i].kind = Kind::letter;
  }
  Runs runs;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (i > 0 && !tight) append(runs, gap(atoms, i));
    append(runs, atoms[i].runs);
  }
  std::erase_if(runs, [](const Run& run) { return run.text.empty(); });
  return runs;
}

std::string text_of(const Runs& runs) {
  std::string text;
  for (const Run& run : runs) text += run.text;
  return text;
}

Runs styled(Runs runs, bool italic, bool bold) {
  for (Run& run : runs) run.italic = italic, run.bold = bold;
  return runs;
}

}  // namespace isect::viz::tex_math
