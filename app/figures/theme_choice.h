#pragma once
// The theme that --theme names: a built-in one, or one's own in a file.

#include <string>

#include "app/figures/theme_text.h"
#include "viz/theme.h"

namespace isect::program {

/// Whether the word is meant as a file: it ends in .json, has a slash, or names a file that has a dot.
bool is_theme_file(const std::string& word);
/// Reads a theme's file, once in a run: it may be a pipe. The file's name is the theme's, unless it has one. Throws
/// viz::BadInput, which names the file, and viz::FileError.
const ReadTheme& read_theme_file(const std::string& path);

/// Returns the theme of a word of --theme: a built-in one's name, a file, or the text itself, "{...}", as figures carry
/// it. Throws viz::BadInput, also if readers could not read the theme, and viz::FileError.
viz::ThemeChoice theme_choice(const std::string& word);

}  // namespace isect::program
