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

/// The files with the lessons' own code, beside the pages; the page of scenes has one of its own.
inline constexpr const char* live_file = "isect.js";
inline constexpr const char* live_scenes_file = "scenes.js";

struct Page {
  std::string file;   ///< "ray-sphere.html"
  std::string title;  ///< plain text
  std::string summary;
  std::string body;  ///< all within <main>
  Neighbours neighbours;
  bool is_contents = false;
  std::string lesson = {};  ///< its id; empty: the page is of none
  std::string live = live_file;
};

/// What a page brings along: inside it where it stands alone, and beside it otherwise, where only `live` counts:
/// whether there is any.
struct Looks {
  std::string fonts, style, script;
  std::string live = {};  ///< the script by which the page can be changed; empty: it can't
};
/// A whole file, from the end of its first line on.
std::string html(const Page&, const Looks&);

/// The files of a lesson, "ray-sphere.html".
std::string file_of(const viz::Lesson&);

/// What stands in book.css and book.js, and the licence of the fonts.
const std::string& style_text();
const std::string& script_text();
const std::string& live_script_text();
const std::string& licence_text();

}  // namespace isect::program::book
