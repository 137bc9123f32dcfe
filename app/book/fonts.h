#pragma once
// The fonts that a book brings along: the letters of its formulas and pictures, and no others.

#include <string>

namespace isect::program::book {

class Letters {
 public:
  /// All that stands on a page, tags included: they are letters, too.
  void add(const std::string& page);
  /// A style sheet that holds the fonts, with their licence. Empty where the font of figures is another than usual.
  std::string fonts() const;

 private:
  std::string known_;  ///< UTF-8, each once
};

/// The same for one page.
std::string fonts_text(const std::string& page);

}  // namespace isect::program::book
