#pragma once
// Documents for LaTeX: a template with named places, and what goes to each of them.

#include <string>

namespace isect::program {

/// What a page puts into the places of a template; all is LaTeX.
struct PageParts {
  std::string metadata;  ///< before \documentclass: what makes tags for screen readers; may be empty
  std::string title;
  std::string preamble;  ///< the packages and macros that the body needs
  std::string body;
};

/// Returns the template that is used if none is given, with its places; `kind`: "handout", "quiz" or "deck".
std::string built_in_template(const std::string& kind);
/// Reads a template; "-" is the standard input. Throws viz::BadInput, which names the line, if a place is unknown,
/// missing, doubled, or on the wrong side of \documentclass or \begin{document}; and viz::FileError.
std::string read_template(const std::string& path);
/// Puts the parts into their places.
std::string filled(const std::string& page_template, const PageParts&);

}  // namespace isect::program
