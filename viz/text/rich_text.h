#pragma once
// The markup of every text: `*t*` italic, `**o**` bold upright, `_1` or `_{1,2}` subscript, `^2` superscript,
// `$\frac{a}{b}$` mathematics as LaTeX has it (viz/text/tex_math.h), `\*` `\_` `\^` `\$` `\\` the characters
// themselves. One text serves window, figures, alt text, terminal and TeX.

#include <optional>
#include <string>
#include <vector>

namespace isect::viz {

struct Run {
  enum class Script { base, sub, super };
  std::string text;
  bool italic = false, bold = false;
  Script script = Script::base;
  bool math = false;     ///< of mathematics between dollars
  std::string tex = {};  ///< of its first run: its source; else empty
};

/// Splits markup into runs. Never fails: an unclosed mark is ordinary text, and so is mathematics that LaTeX refuses.
/// Only letters slant: in italic text digits, signs and brackets stay upright. A script holds one character, a group in
/// braces, or marked text: `*t*_1`,
/// `*n*_{*i*}`, `*n*_*i*`, `*n_i*`.
std::vector<Run> parse_markup(const std::string& markup);
/// Returns digits and signs in Unicode's small forms, "₁₂"; none if a character has no such form.
std::optional<std::string> small_form(const std::string& text, Run::Script);
/// Returns plain text as markup that shows it as it is.
std::string as_markup(const std::string& text);
/// Returns a line of pseudocode without its indentation.
std::string unindented(const std::string& line);
/// Returns the text for terminals and screen readers: marks dropped, digits and signs in scripts as Unicode (t₁, m²)
/// where they exist.
std::string plain(const std::string& markup);
/// Turns hyphens before numbers into minus signs, "(−2, 1.5)".
std::string with_minus_signs(std::string text);
/// Returns the parts between which a line may break, without the space there: words, but marks that span several words
/// stay whole, and relations (=, ≤) end a line rather than begin one, as in print.
std::vector<std::string> unbreakable(const std::string& markup);
/// Scripts: how large they are, and how far above the baseline, in em of the text around them.
constexpr double script_size = 0.70, sub_rise = -0.16, super_rise = 0.34;
/// Returns Pango markup. Escapes &, < and >.
/// `math_font`: the family for italic and bold runs and for scripts, empty for the surrounding one,
/// `math_scale` times its size. `em`: the layout's font size in device units, which Pango needs for the
/// rises.
std::string pango(const std::string& markup, const std::string& math_font = {}, double math_scale = 1, double em = 10);

}  // namespace isect::viz
