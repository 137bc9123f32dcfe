#pragma once
// Pages of the book as HTML: the shell that all of them share.

#include <optional>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::program::book {

/// Returns the first line of a file, by which isect knows it as its own: a copy under another name is not.
std::string mark(const std::string& file);

/// The place of a page in the book; null at its ends. An edition of one page has no others.
struct Neighbours {
  const viz::Lesson *before = nullptr, *after = nullptr;
  bool alone = false;
};

/// The files with the compiled lessons, beside the pages; the page of scenes has one of its own.
inline constexpr const char* live_file = "isect.js";
inline constexpr const char* live_scenes_file = "scenes.js";
/// What such a script takes from beside it, as load.js names it: "isect.wasm", which a server sends, and for a page
/// from disk the same as a script, "isect-packed.js".
inline std::string wasm_of(const std::string& script) { return script.substr(0, script.size() - 3) + ".wasm"; }
inline std::string packed_of(const std::string& script) { return script.substr(0, script.size() - 3) + "-packed.js"; }

struct Page {
  std::string file;   ///< "ray-sphere.html"
  std::string title;  ///< plain text
  std::string summary;
  std::string body;  ///< all within <main>
  Neighbours neighbours;
  bool is_contents = false;
  std::string lesson = {};  ///< the lesson's id; empty: the page has none
  std::string live = live_file;
  /// The names of its questions, which it reports to a learning platform (scorm.js); none: it reports to none.
  std::optional<std::vector<std::string>> reported = {};
};

/// What a page needs: inside it if it stands alone, and beside it otherwise, where only `live` counts: whether there is
/// any.
struct Looks {
  std::string fonts, style, script;
  std::string live = {};  ///< the script that makes settings changeable; empty: they are not
};
/// Returns a whole file, from the end of its first line on.
std::string html(const Page&, const Looks&);

/// Returns the file of a lesson, "ray-sphere.html".
std::string file_of(const viz::Lesson&);

/// Return the contents of book.css, of the scripts that make book.js, and the licence of the fonts.
const std::string& style_text();
const std::string& script_text();
const std::string& live_script_text();
const std::string& licence_text();

}  // namespace isect::program::book
