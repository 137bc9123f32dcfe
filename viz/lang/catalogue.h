#pragma once
// The translations that the program was built with: viz/lang/<language>.po for what the program says of itself, and
// lessons/<subject>/<language>.po for what a lesson says.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viz/lang/message.h"

namespace isect::viz {

/// A file of translations, as it was when the program was built, without comments.
struct PoText {
  const char *subject, *language;  ///< subject: a lesson's folder, "sphere_sphere"; empty: the program's own
  const char* text;
};
/// Returns all of them; the template with every key of the program, viz/lang/isect.pot, has no language.
const std::vector<PoText>& po_texts();

/// Returns the translation of a message; null if the language has none. `count`: of a message that counts.
const std::string* translation(const std::string& language, const Message&, std::optional<std::size_t> count = {});
/// Returns the translation of a lesson's whole text; null if its file has none.
const std::string* translation_in(const std::string& subject, const std::string& language, const std::string& english);
/// Whether a lesson has a file for this language. English needs none.
bool speaks(const std::string& subject, const std::string& language);

/// How many of some texts a language has.
struct Coverage {
  std::size_t translated = 0, all = 0;
};
/// Returns it for the program's own texts.
Coverage coverage(const std::string& language);

}  // namespace isect::viz
