#pragma once
// Pictures and drawings as files. A file is written beside its place and renamed, so no file is ever half written.

#include <map>
#include <stdexcept>
#include <string>

#include "viz/drawing.h"
#include "viz/text/text.h"

namespace isect::viz {

/// The message names the file and the reason.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Keyword -> text, carried inside the file: lesson, preset, step, parameters, version.
using Metadata = std::map<std::string, std::string>;

/// Replaces a file in one step, links followed and mode kept; makes its folder if needed. A device, a pipe or our own
/// stdout is written to in place. Throws FileError; a file that was there stays on failure.
void write_file(const std::string& path, const std::string& bytes);
/// Reads the file or pipe that a reader named. Throws FileError, also where there are more than `most` bytes.
std::string read_file(const std::string& path, std::size_t most = std::size_t{64} << 20);
/// Reads a file that is merely expected to be one of ours. Throws FileError, also where it is no regular file: a pipe
/// may never be written to, and a device may have no end.
std::string read_regular_file(const std::string& path);
/// Whether anything has this name. A name that can't be examined, say in a loop of links, counts: it is not ours.
bool is_there(const std::string& path);

/// How a drawing is put into a file, and what the file tells its readers.
struct Imprint {
  double width_pt = 0;               ///< on paper; 0: one unit is a pixel of CSS, 96 an inch
  std::string title = {}, alt = {};  ///< plain text; the picture in words, for whoever can't see it
  enum class Letters { as_usual, glyphs, outlines };
  double dpi = 0;                       ///< of a picture of pixels; 0: 96, the pixels of CSS
  Letters letters = Letters::as_usual;  ///< glyphs of a font, which can be searched and edited, or mere outlines
  std::string faces = {};  ///< of TikZ: the name of the picture of its faces, beside it; empty: they are paths in it
};

/// PNG with the metadata as iTXt chunks (keyword "isect:<key>"), title and alt text as "Title" and "Description"; same
/// input, same bytes. Keys are printable ASCII without spaces, at most 73 characters: std::invalid_argument otherwise.
std::string png(const Picture&, const Metadata& = {}, const Imprint& = {});
/// Reads a picture. Throws FileError on anything that is no PNG, and on pictures above 2^26 pixels.
Picture read_png(const std::string& bytes);
/// Reads our metadata from any of PNG's text chunks, compressed or not: a program that saves a picture again may choose
/// another one. Empty if there is none. Throws FileError.
Metadata png_metadata(const std::string& bytes);

/// Returns SVG in groups with the names of the objects, text as outlines unless glyphs are asked for, metadata as the
/// attribute `data-isect` of the root, in JSON; same input, same bytes.
std::string svg(const Drawing&, const Metadata& = {}, const Imprint& = {});
/// Reads our metadata, also from a file that another program has saved since, if it kept them, and from files of an
/// older isect. Empty if there is none. Throws FileError on anything that is no well-formed SVG.
Metadata svg_metadata(const std::string& bytes);
/// Returns one page of PDF 1.4 by cairo and Pango, fonts embedded; title and alt text among the document's properties,
/// metadata as their keywords, in JSON. No date: same input, same bytes.
std::string pdf(const Drawing&, const Metadata& = {}, const Imprint& = {});
/// Reads our metadata; empty if there is none. Throws FileError on anything that is no PDF.
Metadata pdf_metadata(const std::string& bytes);

/// The gate of picture comparison; its limits were measured in the snapshot tests' own notes.
struct Difference {
  bool same_size = true;
  int over_8 = 0, over_1 = 0;  ///< pixels that differ by more than 8 / by more than 1 in any channel, beyond the slack
  bool passes() const { return same_size && over_8 <= 24 && over_1 <= 256; }
};
/// A colour of `a` stands for all within `slack` of it in every channel: only what lies beyond them counts. So what
/// passes without a slack passes if `a` gave up colours by no more than it.
Difference compare(const Picture& a, const Picture& b, int slack = 0);
/// Returns the picture without its ground, from how it looks on black and on white.
Picture see_through(const Picture& on_black, const Picture& on_white);
/// Returns a picture that is grey where the two are equal, and strong where not.
Picture difference_picture(const Picture& a, const Picture& b, int slack = 0);

}  // namespace isect::viz
