// Pictures as PNG, through libpng's simplified interface: it reports errors by value, so that no longjmp
// crosses C++ frames.

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "viz/formats/animation.h"
#include "viz/formats/colour_table.h"
#include "viz/formats/png_metadata.h"

namespace isect::viz {
namespace {

constexpr std::size_t header_chunk_size = 25;  ///< IHDR with length, type and CRC
/// 256 MB as RGBA: far above any figure, low enough that a forged header cannot exhaust memory.
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 26;

/// What libpng holds for one picture; freed on every way out.
struct Image {
  png_image image = {};
  Image() { image.version = PNG_IMAGE_VERSION; }
  ~Image() { png_image_free(&image); }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
};

std::vector<std::uint8_t> without_alpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
    rgb.insert(rgb.end(), rgba.begin() + static_cast<std::ptrdiff_t>(i),
               rgba.begin() + static_cast<std::ptrdiff_t>(i + 3));
  return rgb;
}

bool opaque(const Picture& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
    if (picture.rgba[i] != 255) return false;
  return true;
}

std::string density(const Imprint& imprint) {
  return png_density_chunk(imprint.dpi > 0 ? imprint.dpi : 96);  // as in CSS: as wide on a page as an SVG of its size
}

std::string encode(const Picture& picture, const Imprint& imprint, bool rgb) {
  const std::vector<std::uint8_t> pixels = rgb ? without_alpha(picture.rgba) : picture.rgba;
  Image png;
  png.image.width = static_cast<png_uint_32>(picture.width);
  png.image.height = static_cast<png_uint_32>(picture.height);
  png.image.format = rgb ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png.image, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
    throw FileError(std::string("cannot write PNG: ") + png.image.message);
  bytes.resize(size);
  return bytes.insert(png_signature_size + header_chunk_size, density(imprint));
}

std::string packed(const std::string& bytes) {
  uLongf size = ::compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  if (::compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK)
    throw FileError("cannot write PNG: no memory");
  out.resize(size);
  return out;
}

/// Returns a PNG with a table of colours, without filters, which rather hinder there. libpng's simplified interface
/// does not compress as well.
std::string encode(const Picture& picture, const Imprint& imprint, const ColourTable& table) {
  std::string colours, rows;
  for (const auto& colour : table.colours) colours.append(colour.begin(), colour.end());
  for (auto row = table.places.begin(); row != table.places.end(); row += picture.width)
    rows.append(1, '\0').append(row, row + picture.width);
  const std::string header = big_endian(static_cast<std::uint32_t>(picture.width)) +
                             big_endian(static_cast<std::uint32_t>(picture.height)) + std::string("\10\3\0\0\0", 5);
  return std::string(png_signature) + png_chunk("IHDR", header) + density(imprint) +
         png_chunk("sRGB", std::string(1, '\0')) + png_chunk("PLTE", colours) + png_chunk("IDAT", packed(rows)) +
         png_chunk("IEND", {});
}

void need_size(const Picture& picture) {
  const auto width = static_cast<std::uint64_t>(std::max(picture.width, 0));
  const auto height = static_cast<std::uint64_t>(std::max(picture.height, 0));
  if (width == 0 || height == 0 || height > most_pixels / width || picture.rgba.size() != 4 * width * height)
    throw FileError("cannot write PNG: a picture of " + std::to_string(picture.width) + " x " +
                    std::to_string(picture.height) + " pixels with " + std::to_string(picture.rgba.size()) + " bytes");
}

/// Describes how a picture of an animation follows the one before: number, size, place, time as a fraction, and that it
/// replaces all of it.
std::string frame_control(std::uint32_t number, const Picture& picture, double seconds) {
  const auto size = [](int pixels) { return big_endian(static_cast<std::uint32_t>(pixels)); };
  const auto two_bytes = [](long n) { return big_endian(static_cast<std::uint32_t>(n)).substr(2); };
  return png_chunk("fcTL", big_endian(number) + size(picture.width) + size(picture.height) + size(0) + size(0) +
                               two_bytes(std::lround(100 * seconds)) + two_bytes(100) + std::string(2, '\0'));
}

}  // namespace

std::string png(const Picture& picture, const Metadata& metadata, const Imprint& imprint) {
  need_size(picture);
  const bool rgb = opaque(picture);
  const std::optional<ColourTable> table = rgb ? own_colours(picture) : std::nullopt;
  return (table ? encode(picture, imprint, *table) : encode(picture, imprint, rgb))
      .insert(png_signature_size + header_chunk_size, png_text_chunks(metadata, imprint));
}

std::string apng(const std::vector<Picture>& pictures, const Timing& timing, const Metadata& metadata,
                 const Imprint& imprint) {
  need_alike(pictures);
  std::ranges::for_each(pictures, need_size);
  const bool rgb = std::ranges::all_of(pictures, opaque);
  std::string bytes;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Picture& picture = pictures[i];
    const std::string still = encode(picture, imprint, rgb);
    const std::vector<PngChunk> chunks = png_chunks(still);
    const auto data = std::ranges::find(chunks, "IDAT", &PngChunk::type);
    const bool first = bytes.empty();
    if (first)
      bytes =
          still.substr(0, data->at).insert(png_signature_size + header_chunk_size, png_text_chunks(metadata, imprint)) +
          png_chunk("acTL", big_endian(static_cast<std::uint32_t>(pictures.size())) + big_endian(0));
    bytes += frame_control(number++, picture, timing.of(i));
    for (auto chunk = data; chunk->type == "IDAT"; ++chunk)
      bytes += first ? png_chunk("IDAT", std::string(chunk->data))
                     : png_chunk("fdAT", big_endian(number++) + std::string(chunk->data));
  }
  return bytes + png_chunk("IEND", {});
}

Picture read_png(const std::string& bytes) {
  if (!is_png(bytes)) throw FileError("not a PNG file");
  Image png;
  if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()))
    throw FileError(std::string("broken PNG: ") + png.image.message);
  if (std::uint64_t{png.image.height} > most_pixels / png.image.width)
    throw FileError("PNG too large: " + std::to_string(png.image.width) + " x " + std::to_string(png.image.height));
  png.image.format = PNG_FORMAT_RGBA;
  Picture picture{static_cast<int>(png.image.width), static_cast<int>(png.image.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(png.image));
  if (!png_image_finish_read(&png.image, nullptr, picture.rgba.data(), 0, nullptr))
    throw FileError(std::string("broken PNG: ") + png.image.message);
  return picture;
}

}  // namespace isect::viz
