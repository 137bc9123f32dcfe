#pragma once
// Numbers, paints and paths as SVG writes them. Short: no digit that makes no visible difference.

#include <string>
#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// Returns a number to a thousandth of a unit, without trailing zeros.
std::string svg_number(double);
/// Returns "fill:#0b60c8;fill-opacity:0.14;" for what = "fill".
std::string svg_paint(const std::string& what, const Colour&);
/// Returns the `d` of a <path>, in absolute coordinates.
std::string svg_path(const Path&);
/// Returns outlines of letters: many and small, so each point is relative to the one before, to hundredths of a unit.
std::string svg_letters(const std::vector<Path>&);
/// Encodes data for use inside an address.
std::string base64(const std::string& bytes);
/// Returns a whole SVG as an image's `src`: as an image of its own, it shares no id with another picture.
std::string svg_address(const std::string& svg);
/// Escapes text, also for attributes in either quotes. XML has no control characters; they become spaces.
std::string xml_escaped(const std::string&);

}  // namespace isect::viz
