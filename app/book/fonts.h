#pragma once
// The fonts that a book contains: the letters of its formulas and pictures, and no others.

#include <string>

namespace isect::program::book {

class Letters {
 public:
  /// Adds all letters of a page, including those of its tags.
  void add(const std::string& page);
  /// Returns a style sheet that holds the fonts, with their licence. Empty if the font of figures is not the usual one.
  std::string fonts() const;

 private:
  std::string known_;  ///< UTF-8, each once
};

/// Returns such a style sheet for one page.
std::string fonts_text(const std::string& page);

}  // namespace isect::program::book
