#pragma once
// Themes of one's own, as JSON: colours of roles, widths of lines, a font, on top of a built-in theme; or two colours,
// from which the roles get theirs.
//
//   {"name": "Coast", "based on": "print", "roles": {"highlight": "#f6a800"}, "lines": {"ray": 1}, "font": "Lato"}
//   {"colors": ["#00549f", "#f6a800"]}

#include <string>
#include <vector>

#include "viz/theme.h"

namespace isect::program {

/// What a theme's text says, before it is known whether readers can read it.
struct ReadTheme {
  viz::OwnTheme theme;
  std::vector<std::string> faults;  ///< "line 3: roles.second: 2.1 to 1 against ...; #8c5e00 would do, ..."
  std::vector<std::string> notes;   ///< what became of the two colours, if it is made from two
};
/// Reads a theme; `name` is its name unless it has one: "own" if that is no text of one line in UTF-8. Throws
/// viz::BadInput with the line if it is no JSON, a field is unknown or has a value of the wrong kind, or if no theme
/// can be made from the two colours.
ReadTheme read_theme(const std::string& text, const std::string& name);
/// Returns the values on one line, as read_theme reads them; each colour and width, so that no theme need be known.
std::string theme_text(const viz::OwnTheme&);
/// Returns the same to be edited, a role and a line each on a line of its own.
std::string theme_text_by_lines(const viz::OwnTheme&);

}  // namespace isect::program
