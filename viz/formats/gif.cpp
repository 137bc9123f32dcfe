// GIF through giflib.

#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "viz/formats/animation.h"
#include "viz/formats/colour_table.h"
#include "viz/formats/metadata_limit.h"
#include "viz/formats/metadata_text.h"

namespace isect::viz {
namespace {

/// The most colours of a picture, and the number that stands for none.
constexpr int most_colours = 256;
constexpr int no_colour = -1;

void need(bool done, int error) {
  if (!done) throw FileError(fmt::format("GIF: {}", GifErrorString(error) ? GifErrorString(error) : "out of memory"));
}

int append(GifFileType* file, const GifByteType* bytes, int count) {
  static_cast<std::string*>(file->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
  return count;
}

class Writer {
 public:
  Writer(int width, int height) : width_(width), height_(height) {
    int error = 0;
    file_ = EGifOpen(&bytes_, append, &error);
    need(file_ != nullptr, error);
    EGifSetGifVersion(file_, true);
    check(EGifPutScreenDesc(file_, width, height, 8, 0, nullptr));
    for_ever();
  }
  ~Writer() { close(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void comment(const std::string& text) { check(EGifPutComment(file_, text.c_str())); }

  void add(const Picture& picture, double seconds) {
    ColourTable image = colour_table(picture, most_colours);
    const GraphicsControlBlock control = {DISPOSE_DO_NOT, false, static_cast<int>(std::lround(100 * seconds)),
                                          no_colour};
    std::array<GifByteType, 4> block = {};
    check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(EGifGCBToExtension(&control, block.data())),
                           block.data()));
    std::vector<GifColorType> table;
    for (const auto& [r, g, b] : image.colours) table.push_back({r, g, b});
    table.resize(
        std::max<std::size_t>(std::size_t{1} << GifBitSize(static_cast<int>(table.size())), 2));  // 2, 4, 8, ...
    ColorMapObject* colours = GifMakeMapObject(static_cast<int>(table.size()), table.data());
    need(colours != nullptr, E_GIF_ERR_NOT_ENOUGH_MEM);
    const int described = EGifPutImageDesc(file_, 0, 0, width_, height_, false, colours);
    GifFreeMapObject(colours);
    check(described);
    for (int y = 0; y < height_; ++y)
      check(EGifPutLine(file_, &image.places[static_cast<std::size_t>(y) * width_], width_));
  }

  std::string made() {
    check(close());
    return std::move(bytes_);
  }

 private:
  void check(int status) { need(status == GIF_OK, file_ ? file_->Error : E_GIF_ERR_WRITE_FAILED); }

  int close() {
    if (!file_) return GIF_OK;
    int error = 0;
    const int status = EGifCloseFile(file_, &error);
    file_ = nullptr;
    return status;
  }

  void for_ever() {
    check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
    const std::array<GifByteType, 3> loop = {1, 0, 0};
    check(EGifPutExtensionBlock(file_, 3, loop.data()));
    check(EGifPutExtensionTrailer(file_));
  }

  int width_, height_;
  std::string bytes_;
  GifFileType* file_ = nullptr;
};

/// The bytes that a file is read from.
struct Source {
  const std::string& bytes;
  std::size_t at = 0;
};

int read(GifFileType* file, GifByteType* to, int count) {
  auto& source = *static_cast<Source*>(file->UserData);
  const std::size_t got = std::min(static_cast<std::size_t>(count), source.bytes.size() - source.at);
  std::copy_n(source.bytes.begin() + static_cast<std::ptrdiff_t>(source.at), got, to);
  source.at += got;
  return static_cast<int>(got);
}

class GifReader {
 public:
  explicit GifReader(const std::string& bytes) : source_{bytes} {
    int error = 0;
    file_ = DGifOpen(&source_, read, &error);
    if (!file_) throw FileError("not a GIF file");
  }
  ~GifReader() {
    int error = 0;
    DGifCloseFile(file_, &error);
  }
  GifReader(const GifReader&) = delete;
  GifReader& operator=(const GifReader&) = delete;

  /// Returns the first comment that is ours; empty if there is none.
  std::string comment() {
    for (GifRecordType kind = UNDEFINED_RECORD_TYPE;;) {
      check(DGifGetRecordType(file_, &kind));
      if (kind == TERMINATE_RECORD_TYPE) return {};
      if (kind == IMAGE_DESC_RECORD_TYPE) skip_image();
      if (kind == EXTENSION_RECORD_TYPE)
        if (const std::string text = extension(); text.starts_with(metadata_mark))
          return text.substr(metadata_mark.size());
    }
  }

 private:
  void check(int status) const {
    if (status != GIF_OK) throw FileError("broken GIF: it ends early, or a part of it is none of GIF's");
  }

  void skip_image() {
    int size = 0;
    GifByteType* block = nullptr;
    check(DGifGetImageDesc(file_));
    check(DGifGetCode(file_, &size, &block));
    while (block) check(DGifGetCodeNext(file_, &block));
  }

  /// Returns the extension's text, if it is a comment.
  std::string extension() {
    int code = 0;
    GifByteType* block = nullptr;
    check(DGifGetExtension(file_, &code, &block));
    std::string text;
    for (; block; check(DGifGetExtensionNext(file_, &block)))
      if (code == COMMENT_EXT_FUNC_CODE && text.size() <= metadata_limit)
        text.append(reinterpret_cast<const char*>(block) + 1, block[0]);
    return text;
  }

  Source source_;
  GifFileType* file_ = nullptr;
};

}  // namespace

void need_alike(const std::vector<Picture>& pictures) {
  if (pictures.empty()) throw FileError("cannot write an animation of no pictures");
  const Picture& first = pictures.front();
  for (const Picture& p : pictures)
    if (p.width != first.width || p.height != first.height)
      throw FileError(fmt::format("cannot write an animation: {} x {} pixels follow {} x {}", p.width, p.height,
                                  first.width, first.height));
}

std::string gif(const std::vector<Picture>& pictures, const Timing& timing, const Metadata& metadata,
                const Imprint& imprint) {
  need_alike(pictures);
  Writer writer(pictures.front().width, pictures.front().height);
  if (!metadata.empty()) writer.comment(std::string(metadata_mark) + metadata_text(metadata));
  if (!imprint.alt.empty()) writer.comment(imprint.alt);
  for (std::size_t i = 0; i < pictures.size(); ++i) writer.add(pictures[i], timing.of(i));
  return writer.made();
}

Metadata gif_metadata(const std::string& bytes) {
  const std::string text = GifReader(bytes).comment();
  if (text.empty()) return {};
  if (text.size() > metadata_limit) throw FileError("broken GIF: its metadata is too long");
  return metadata_of_text(text, "GIF");
}

}  // namespace isect::viz
