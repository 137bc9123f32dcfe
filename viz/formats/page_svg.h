#pragma once
// Drawings as SVG inside a web page: texts stay text, colours follow the page's theme, light or dark, and what several
// pictures of a page share is written once.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// One paint in both themes.
struct PageColour {
  Colour light, dark;
  bool operator==(const PageColour&) const = default;
};

/// The colours of a book: those of roles have names, all others are numbered. Use one object for all pages of one style
/// sheet.
class PageColours {
 public:
  PageColours();
  /// Returns the class of an element with this fill ("fill-first") or stroke ("line-first"), whatever its opacity.
  std::string of(const std::string& what, const PageColour&);
  /// Returns "--first: #0b60c8; ..." for one theme.
  std::string variables(bool dark) const;
  /// Returns a rule for each class that was used: ".fill-first { fill: var(--first); }".
  std::string rules() const;

 private:
  struct Named {
    std::string name, light, dark;
    std::set<std::string> used = {};  ///< for which properties
  };
  std::vector<Named> all_;
};

/// The pictures of one page.
class PagePictures {
 public:
  explicit PagePictures(PageColours& colours) : colours_(&colours) {}
  /// Returns an <svg> of one step, drawn in the light and in the dark theme: the same shapes, except that either may
  /// have some of its own. `alt`: plain text, the picture in words. What an earlier picture of the page has drawn alike
  /// is referenced.
  std::string svg(const Drawing& light, const Drawing& dark, const std::string& alt);
  /// Whether the last picture looks like the one before it.
  bool repeated() const { return last_ == before_; }
  /// Returns what the pictures refer to besides each other; it must stand on the page once, before them.
  std::string shared() const;

 private:
  friend class PageWriter;
  friend std::string lone_svg(const Drawing&, const std::string&, const std::string&);
  PagePictures() = default;  // for a picture that stands alone
  PageColours* colours_ = nullptr;
  std::map<std::string, std::string> groups_;     ///< what an object draws -> its id
  std::map<std::string, std::string> gradients_;  ///< without the id -> the id

  std::string definitions_, last_, before_;
  std::string id_;  ///< the prefix of ids
};

/// Returns an <svg> of one drawing that refers to nothing outside it, in the drawing's own colours. `id` is the prefix
/// of the ids in it: no other picture of its page may use it.
std::string lone_svg(const Drawing&, const std::string& alt, const std::string& id);

}  // namespace isect::viz
