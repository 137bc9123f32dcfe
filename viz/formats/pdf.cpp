// Drawings as PDF through cairo, and what a PDF of ours says about itself.

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "viz/formats/cairo_drawing.h"
#include "viz/formats/files.h"
#include "viz/formats/metadata_limit.h"
#include "viz/formats/metadata_text.h"

namespace isect::viz {
namespace {

/// Points per pixel of CSS: an inch has 72 points and 96
/// pixels.
constexpr double points_a_unit = 0.75;

cairo_status_t append(void* out, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Returns the keywords in ASCII: cairo then writes them byte by byte, or as UTF-16 if they contain a bracket.
std::string keywords(const Metadata& metadata) { return std::string(metadata_mark) + metadata_text(metadata); }

void tell(cairo_surface_t* surface, const Metadata& metadata, const Imprint& imprint) {
  const auto set = [&](cairo_pdf_metadata_t what, const std::string& text) {
    if (!text.empty()) cairo_pdf_surface_set_metadata(surface, what, text.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, imprint.title);
  set(CAIRO_PDF_METADATA_SUBJECT, imprint.alt);
  set(CAIRO_PDF_METADATA_CREATOR, "isect");
  if (!metadata.empty()) set(CAIRO_PDF_METADATA_KEYWORDS, keywords(metadata));
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, nullptr);  // so that the bytes stay the same
}

/// Returns the string of a PDF that begins at `at`: "(...)" with escapes, or "<...>" in hexadecimal.
std::string string_at(std::string_view pdf, std::size_t at) {
  std::string text;
  if (pdf[at] == '(') {
    int open = 1;
    for (++at; at < pdf.size(); ++at) {
      if (pdf[at] == '\\' && at + 1 < pdf.size())
        ++at;
      else if (pdf[at] == '(')
        ++open;
      else if (pdf[at] == ')' && --open == 0)
        return text;
      text += pdf[at];
    }
  } else if (pdf[at] == '<') {
    const std::size_t end = std::min(pdf.find('>', at), pdf.size());
    for (++at; at + 1 < end; at += 2) {
      int byte = 0;
      if (std::from_chars(pdf.data() + at, pdf.data() + at + 2, byte, 16).ec != std::errc{}) return {};
      text += static_cast<char>(byte);
    }
    return text;
  }
  return {};
}

/// Converts UTF-16 with its byte order mark to the ASCII it holds; ASCII text stays.
std::string as_ascii(const std::string& text) {
  if (!text.starts_with("\xFE\xFF")) return text;
  std::string ascii;
  for (std::size_t i = 3; i < text.size(); i += 2)
    if (text[i - 1] == 0) ascii += text[i];
  return ascii;
}

}  // namespace

std::string pdf(const Drawing& drawing, const Metadata& metadata, const Imprint& imprint) {
  if (!(drawing.width > 0 && drawing.height > 0 && std::isfinite(drawing.width * drawing.height)))
    throw FileError(fmt::format("cannot write PDF: a drawing of {} x {}", drawing.width, drawing.height));
  const double scale = imprint.width_pt > 0 ? imprint.width_pt / drawing.width : points_a_unit;
  std::string bytes;
  cairo_surface_t* surface =
      cairo_pdf_surface_create_for_stream(append, &bytes, drawing.width * scale, drawing.height * scale);
  cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_4);  // its properties are not compressed
  tell(surface, metadata, imprint);
  cairo_t* cr = cairo_create(surface);
  cairo_scale(cr, scale, scale);
  draw(cr, drawing,
       imprint.letters == Imprint::Letters::outlines ? TypesetLine::As::outlines : TypesetLine::As::glyphs);
  const cairo_status_t drawn = cairo_status(cr);
  cairo_destroy(cr);
  cairo_surface_finish(surface);
  const cairo_status_t written = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  if (drawn != CAIRO_STATUS_SUCCESS || written != CAIRO_STATUS_SUCCESS)
    throw FileError(std::string("cannot write PDF: ") + cairo_status_to_string(drawn ? drawn : written));
  return bytes;
}

Metadata pdf_metadata(const std::string& bytes) {
  if (!bytes.starts_with("%PDF-")) throw FileError("not a PDF file");
  constexpr std::string_view key = "/Keywords";
  for (std::size_t at = bytes.find(key); at != bytes.npos; at = bytes.find(key, at)) {
    at = bytes.find_first_not_of(" \r\n", at + key.size());
    if (at == bytes.npos) break;
    const std::string text = as_ascii(string_at(bytes, at));
    if (!text.starts_with(metadata_mark)) continue;
    if (text.size() > metadata_limit) throw FileError("broken PDF: its metadata is too long");
    return metadata_of_text(text.substr(metadata_mark.size()), "PDF");
  }
  return {};
}

}  // namespace isect::viz
