#pragma once
// Text chunks of PNG, which libpng's simplified interface does not know. png.cpp writes pictures with them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "viz/files.h"

namespace isect::viz {

bool is_png(const std::string& bytes);
/// One iTXt chunk for each entry, and for title and alt text. Throws std::invalid_argument on a key that PNG can't
/// hold.
std::string png_text_chunks(const Metadata&, const Imprint&);
/// One chunk with its length and checksum.
std::string png_chunk(const std::string& type, const std::string& data);
/// Four bytes.
std::string big_endian(std::uint32_t);
/// pHYs: pixels a metre, both ways.
std::string png_density_chunk(double dpi);

constexpr std::size_t png_signature_size = 8;

/// A chunk where it stands in a file.
struct PngChunk {
  std::size_t at = 0;  ///< of its length
  std::string_view type, data;
};
/// All up to IEND. Throws FileError on what is no PNG or ends early.
std::vector<PngChunk> png_chunks(const std::string& bytes);

}  // namespace isect::viz
