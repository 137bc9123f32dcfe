#include "viz/formats/png_metadata.h"

#include <glib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "viz/formats/metadata_limit.h"

namespace isect::viz {
namespace {

constexpr std::size_t around_data = 12;  ///< bytes of a chunk: length and type before, CRC after
/// Far more than any figure has; a text that unpacks to more is hostile.
constexpr std::size_t most_text = std::size_t{1} << 20;

std::uint32_t read_big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::uint32_t crc(std::string_view bytes) {
  return static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// Returns an iTXt chunk: keyword, 0, uncompressed, method 0, no language, no translated keyword, UTF-8 text.
std::string text_chunk(const std::string& key, const std::string& text) {
  const std::string keyword = std::string(metadata_mark) + key;
  const bool printable = std::all_of(key.begin(), key.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (key.empty() || keyword.size() > 79 || !printable)
    throw std::invalid_argument("metadata keyword '" + key + "': 1 to 73 printable ASCII characters, no space");
  return png_chunk("iTXt", keyword + std::string(5, '\0') + text);
}

std::string unpacked(std::string_view packed) {
  z_stream stream = {};
  if (::inflateInit(&stream) != Z_OK) throw FileError("no memory for a PNG's text");
  const std::unique_ptr<z_stream, decltype(&::inflateEnd)> end(&stream, ::inflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string text;
  std::array<char, 4096> block;
  for (int status = Z_OK; status != Z_STREAM_END;) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = block.size();
    status = ::inflate(&stream, Z_NO_FLUSH);
    if (status != Z_OK && status != Z_STREAM_END) throw FileError("broken PNG: a text cannot be unpacked");
    text.append(block.data(), block.size() - stream.avail_out);
    if (text.size() > most_text) throw FileError("broken PNG: a text is too long");
  }
  return text;
}

/// Converts text to UTF-8. tEXt and zTXt are Latin-1 by the standard, but some programs write UTF-8.
std::string as_utf8(const std::string& text) {
  if (g_utf8_validate(text.data(), static_cast<gssize>(text.size()), nullptr)) return text;
  std::string utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xC0 | byte >> 6);
      utf8 += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return utf8;
}

/// Cuts the text up to the next 0 off the front, together with that 0.
std::string_view cut(std::string_view& data) {
  const std::size_t end = data.find('\0');
  if (end == data.npos) throw FileError("broken PNG: a text lacks its keyword");
  const std::string_view part = data.substr(0, end);
  data.remove_prefix(end + 1);
  return part;
}

/// Returns the text after the keyword of a chunk of this type.
std::string text_of(std::string_view type, std::string_view data) {
  if (type == "tEXt") return as_utf8(std::string(data));
  const std::size_t flags = type == "zTXt" ? 1 : 2;
  if (data.size() < flags) throw FileError("broken PNG: a text ends within its header");
  const bool packed = type == "zTXt" || data[0] != 0;
  if (packed && data[flags - 1] != 0) throw FileError("broken PNG: a text is packed in an unknown way");
  data.remove_prefix(flags);
  if (type == "zTXt") return as_utf8(unpacked(data));
  cut(data);  // the language
  cut(data);  // the keyword, translated
  return packed ? unpacked(data) : std::string(data);
}

}  // namespace

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(crc(body));
}

bool is_png(const std::string& bytes) { return bytes.starts_with(png_signature); }

std::string png_text_chunks(const Metadata& metadata, const Imprint& imprint) {
  std::string chunks;
  // Keywords that the standard gives; for those who read the file, not for us.
  if (!imprint.title.empty()) chunks += png_chunk("iTXt", "Title" + std::string(5, '\0') + imprint.title);
  if (!imprint.alt.empty()) chunks += png_chunk("iTXt", "Description" + std::string(5, '\0') + imprint.alt);
  for (const auto& [key, text] : metadata) chunks += text_chunk(key, text);
  return chunks;
}

std::string png_density_chunk(double dpi) {
  const std::string a_metre = big_endian(static_cast<std::uint32_t>(std::lround(dpi / 0.0254)));
  return png_chunk("pHYs", a_metre + a_metre + '\x01');
}

std::vector<PngChunk> png_chunks(const std::string& bytes) {
  if (!is_png(bytes)) throw FileError("not a PNG file");
  std::vector<PngChunk> chunks;
  for (std::size_t at = png_signature_size;;) {
    const std::string_view rest = std::string_view(bytes).substr(at);
    if (rest.size() < around_data || read_big_endian(rest) > rest.size() - around_data)
      throw FileError("broken PNG: it ends within a chunk");
    const std::size_t length = read_big_endian(rest);
    chunks.push_back({at, rest.substr(4, 4), rest.substr(8, length)});
    if (chunks.back().type == "IEND") return chunks;
    at += length + around_data;
  }
}

Metadata png_metadata(const std::string& bytes) {
  Metadata metadata;
  for (const auto& [at, type, whole] : png_chunks(bytes)) {
    const bool text = type == "iTXt" || type == "tEXt" || type == "zTXt";
    if (!text || !whole.starts_with(metadata_mark)) continue;
    const std::string_view checked = std::string_view(bytes).substr(at + 4);
    if (crc(checked.substr(0, 4 + whole.size())) != read_big_endian(checked.substr(4 + whole.size())))
      throw FileError("broken PNG: a text is damaged");
    std::string_view data = whole;
    const std::string_view key = cut(data).substr(metadata_mark.size());
    metadata[std::string(key)] = text_of(type, data);
  }
  return metadata;
}

}  // namespace isect::viz
