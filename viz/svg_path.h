#pragma once
// Numbers, colours and paths as SVG writes them. Short: no digit that could not be seen.

#include <string>
#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// To a thousandth of a unit, without trailing zeros.
std::string svg_number(double);
/// "#0b60c8"
std::string svg_colour(const Colour&);
/// "fill:#0b60c8;fill-opacity:0.14;" for what = "fill"
std::string svg_paint(const std::string& what, const Colour&);
/// The `d` of a <path>, in absolute coordinates.
std::string svg_path(const Path&);
/// The outlines of letters: many and small, so each point is told from the one before, to a hundredth of a unit.
std::string svg_letters(const std::vector<Path>&);
/// For data inside an address.
std::string base64(const std::string& bytes);
/// A whole SVG as an image's `src`: as an image of its own, no id in it meets another picture's.
std::string svg_address(const std::string& svg);
/// For text and for attributes in either quotes. XML has no control characters; they become spaces.
std::string xml_escaped(const std::string&);

}  // namespace isect::viz
