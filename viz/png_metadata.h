#pragma once
// Text chunks of PNG, which libpng's simplified interface does not know. png.cpp writes pictures with them.

#include <string>

#include "viz/files.h"

namespace isect::viz {

bool is_png(const std::string& bytes);
/// One iTXt chunk for each entry, and for title and alt text. Throws std::invalid_argument on a key that PNG can't
/// hold.
std::string png_text_chunks(const Metadata&, const Imprint&);
/// pHYs: pixels a metre, both ways.
std::string png_density_chunk(double dpi);

constexpr std::size_t png_signature_size = 8;

}  // namespace isect::viz
