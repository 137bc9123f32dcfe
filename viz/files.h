#pragma once
// Pictures and drawings as files. A file is written beside and renamed, so none is ever half written.

#include <map>
#include <stdexcept>
#include <string>

#include "viz/drawing.h"
#include "viz/text.h"

namespace isect::viz {

/// Names the file and the reason.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Keyword -> text, carried inside the file: lesson, preset, step, parameters, version.
using Metadata = std::map<std::string, std::string>;

/// Replaces a file in one step, links followed and mode kept; makes its folder if needed. What is no file (a
/// device, a pipe, our own stdout) is written to. Throws FileError; a file that was there stays on failure.
void write_file(const std::string& path, const std::string& bytes);
/// What a reader named, be it a pipe. Throws FileError, also where there are more than `most` bytes.
std::string read_file(const std::string& path, std::size_t most = std::size_t{64} << 20);
/// What merely lies where a file of ours is looked for. Throws FileError, also where it is no regular file: a pipe may
/// never be written to, and a device may have no end.
std::string read_regular_file(const std::string& path);
/// Whether anything has this name. What can't be asked, as behind links that go in circles, has: it is not ours.
bool is_there(const std::string& path);

/// How a drawing is put into a file, and what the file tells its readers.
struct Imprint {
  double width_pt = 0;               ///< on paper; 0: one unit is a pixel of CSS, 96 an inch
  std::string title = {}, alt = {};  ///< plain text; the picture in words, for whoever can't see it
  enum class Letters { as_usual, glyphs, outlines };
  double dpi = 0;                       ///< of a picture of pixels; 0: 96, the pixels of CSS
  Letters letters = Letters::as_usual;  ///< glyphs of a font, which can be searched and edited, or mere outlines
};

/// PNG with the metadata as iTXt chunks (keyword "isect:<key>"), title and alt text as "Title" and "Description"; same
/// input, same bytes. Keys are printable ASCII without spaces, at most 73 characters: std::invalid_argument otherwise.
std::string png(const Picture&, const Metadata& = {}, const Imprint& = {});
/// Throws FileError on anything that is no PNG, and on pictures above 2^26 pixels.
Picture read_png(const std::string& bytes);
/// From any of PNG's text chunks, compressed or not: what saves a picture again may choose another one. Throws
/// FileError; empty if it carries none of ours.
Metadata png_metadata(const std::string& bytes);

/// SVG in groups that are called as the objects are, text as outlines unless glyphs are asked for, metadata as the
/// attribute `data-isect` of the root, in JSON; same input, same bytes.
std::string svg(const Drawing&, const Metadata& = {}, const Imprint& = {});
/// Also where another program has saved the file since, if that kept it, and where an older version of ours wrote it.
/// Throws FileError on anything that is no well-formed SVG; empty if it carries none of ours.
Metadata svg_metadata(const std::string& bytes);
/// One page of PDF 1.4 by cairo and Pango, fonts embedded; title and alt text among the document's properties, metadata
/// as their keywords, in JSON. No date: same input, same bytes.
std::string pdf(const Drawing&, const Metadata& = {}, const Imprint& = {});
/// Throws FileError on anything that is no PDF; empty if it carries none of ours.
Metadata pdf_metadata(const std::string& bytes);

/// The gate of picture comparison: measured in the snapshot tests' own notes.
struct Difference {
  bool same_size = true;
  int over_8 = 0, over_1 = 0;  ///< pixels that differ by more than 8 / by more than 1 in any channel
  bool passes() const { return same_size && over_8 <= 24 && over_1 <= 256; }
};
Difference compare(const Picture& a, const Picture& b);
/// The picture as it is without a ground, from how it looks on black and on white.
Picture see_through(const Picture& on_black, const Picture& on_white);
Picture difference_picture(const Picture& a, const Picture& b);  ///< grey where equal, strong where not

}  // namespace isect::viz
