#pragma once
// Pages of the book as HTML: the shell that all of them share.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::program::book {

/// What the first line of a file says, by which it is known to be isect's: a copy under another name is not.
std::string mark(const std::string& file);

/// Where a page stands in the book; null at its ends. In an edition of one page there is no other to go to.
struct Neighbours {
  const viz::Lesson *before = nullptr, *after = nullptr;
  bool alone = false;
};

struct Page {
  std::string file;   ///< "ray-sphere.html"
  std::string title;  ///< plain text
  std::string summary;
  std::string body;  ///< all within <main>
  Neighbours neighbours;
  bool is_contents = false;
};

/// A whole file, from the end of its first line on. `style` and `script` are inside it where the page stands alone, and
/// beside it otherwise.
struct Looks {
  std::string style, script;
};
std::string html(const Page&, const Looks&);

/// The files of a lesson, "ray-sphere.html".
std::string file_of(const viz::Lesson&);

/// What stands in book.css and book.js, and the licence of the fonts.
const std::string& style_text();
const std::string& script_text();
const std::string& licence_text();

}  // namespace isect::program::book
