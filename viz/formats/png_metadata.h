#pragma once
// Text chunks of PNG, which libpng's simplified interface lacks. png.cpp writes pictures with them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "viz/formats/files.h"

namespace isect::viz {

bool is_png(const std::string& bytes);
/// Returns one iTXt chunk for each entry, and for title and alt text. Throws std::invalid_argument on a key that PNG
/// can't hold.
std::string png_text_chunks(const Metadata&, const Imprint&);
/// Returns one chunk with its length and checksum.
std::string png_chunk(const std::string& type, const std::string& data);
/// Returns four bytes.
std::string big_endian(std::uint32_t);
/// Returns a pHYs chunk: pixels per metre, both ways.
std::string png_density_chunk(double dpi);

constexpr std::size_t png_signature_size = 8;
inline constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", png_signature_size);

/// A chunk and its place in a file.
struct PngChunk {
  std::size_t at = 0;  ///< of its length
  std::string_view type, data;
};
/// Returns all chunks up to IEND. Throws FileError on what is no PNG or ends early.
std::vector<PngChunk> png_chunks(const std::string& bytes);

}  // namespace isect::viz
