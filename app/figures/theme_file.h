#pragma once
// Themes of one's own, as JSON: colours of roles, widths of lines, a font, on top of a built-in theme; or two colours,
// from which the roles get theirs.
//
//   {"name": "Coast", "based on": "print", "roles": {"first": "#00549f"}, "lines": {"ray": 1}, "font": "Lato"}
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
/// Reads a theme; `name` is its name unless it has one. Throws viz::BadInput with the line if it is no JSON, a field is
/// unknown or has a value of the wrong kind, or if no theme can be made from the two colours.
ReadTheme read_theme(const std::string& text, const std::string& name);
/// Reads a theme's file, once in a run: it may be a pipe. Throws viz::BadInput, which names the file, and
/// viz::FileError.
const ReadTheme& read_theme_file(const std::string& path);

/// Whether the word is meant as a file: it ends in .json, has a slash, or names a file that has a dot.
bool is_theme_file(const std::string& word);
/// Returns the theme of a word of --theme: a built-in one's name, a file, or the text itself, "{...}", as figures carry
/// it. Throws viz::BadInput, also if readers could not read the theme, and viz::FileError.
viz::ThemeChoice theme_choice(const std::string& word);

/// Returns the values on one line, as read_theme reads them; each colour and width, so that no theme need be known.
std::string theme_text(const viz::OwnTheme&);
/// Returns the same to be edited, a role and a line each on a line of its own.
std::string theme_text_by_lines(const viz::OwnTheme&);

}  // namespace isect::program
