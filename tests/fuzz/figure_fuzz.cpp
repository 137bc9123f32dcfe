// Any bytes as a figure, of which isect reads what it wrote into it: metadata, or a refusal. Pictures of pixels are
// read, too, as baselines are.

#include <cstdint>
#include <string>

#include "tests/fuzz/require.h"
#include "tests/fuzz/seeds.h"
#include "viz/formats/animation.h"
#include "viz/formats/formats.h"
#include "viz/formats/metadata_text.h"
#include "viz/snapshot/baseline_picture.h"

namespace {

using namespace isect::viz;

/// The readers after those of the formats: of a picture, and of a baseline.
constexpr std::size_t further = 2;

void check_picture(const Picture& read, const std::string& bytes) {
  require(read.width > 0 && read.height > 0, "a size", bytes);
  require(
      read.rgba.size() == std::size_t{4} * static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height),
      "four numbers a pixel", bytes);
}

void check_metadata(const Metadata& metadata, const std::string& bytes) {
  const std::string text = metadata_text(metadata);
  require(metadata_text(metadata_of_text(text, "text")) == text, "written and read again it is the same", bytes);
}

void read(std::size_t reader, const std::string& bytes) {
  const std::size_t count = formats().size();
  if (reader < count) return check_metadata(formats()[reader].metadata(bytes), bytes);
  check_picture(reader == count ? read_png(bytes) : read_baseline_png(bytes).picture, bytes);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (seeds_folder().empty()) return 0;
  const Metadata data = {{"lesson", "ray-sphere"}, {"parameters", R"({"radius": 1})"}, {"version", "1"}};
  Picture small = {4, 4, std::vector<std::uint8_t>(64, 255)};
  for (std::size_t i = 0; i < small.rgba.size(); i += 5) small.rgba[i] = static_cast<std::uint8_t>(i);
  const Drawing drawing = {16, 16, {1, 1, 1, 1}, {Stroke{circle({8, 8}, 4), {0, 0, 0, 1}}}};
  const Imprint imprint = {.title = "A title", .alt = "In words"};
  const auto pixels = [&](const Drawing&) { return small; };
  int reader = 0;
  for (const Format& format : formats()) {
    if (format.write)
      write_seed(format.name, reader, format.write(drawing, data, imprint, pixels));
    else if (!format.can_write || format.can_write())
      write_seed(format.name, reader, format.film({small, small}, 1, data, imprint));
    ++reader;
  }
  write_seed("picture", reader, png(small, data));
  write_seed("baseline", reader + 1, baseline_png(small, data));
  return 0;
}

/// The first byte selects the reader of the others.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    read(data[0] % (formats().size() + further), bytes);
  } catch (const FileError&) {
  }
  return 0;
}
