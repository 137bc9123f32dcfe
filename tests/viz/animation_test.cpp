// Pictures in turn, as GIF and as animated PNG: what is read back is what was written.

#include "viz/formats/animation.h"

#include <gif_lib.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "tests/catch.h"
#include "tests/scratch.h"
#include "viz/formats/colour_table.h"

namespace animation_test {
using namespace isect::viz;
using isect::test::Contains;

namespace {

/// A picture with `colours` colours in stripes, the last one over half of it.
Picture stripes(int width, int height, int colours, int shift = 0) {
  Picture p{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const int c = std::min(i % (2 * colours), colours - 1) + shift;
    for (const int channel : {c % 7 * 36, c / 7 % 7 * 36, c / 49 % 7 * 36, 255})
      p.rgba.push_back(static_cast<std::uint8_t>(channel));
  }
  return p;
}

struct Bytes {
  const std::string& all;
  std::size_t at = 0;
};
int read_bytes(GifFileType* file, GifByteType* to, int count) {
  auto& bytes = *static_cast<Bytes*>(file->UserData);
  const std::size_t n = std::min(static_cast<std::size_t>(count), bytes.all.size() - bytes.at);
  std::memcpy(to, bytes.all.data() + bytes.at, n);
  bytes.at += n;
  return static_cast<int>(n);
}

/// The frames as giflib decodes them.
std::vector<Picture> frames_of(const std::string& gif) {
  Bytes bytes{gif};
  int error = 0;
  GifFileType* file = DGifOpen(&bytes, read_bytes, &error);
  REQUIRE(file);
  REQUIRE(DGifSlurp(file) == GIF_OK);
  std::vector<Picture> frames;
  for (int i = 0; i < file->ImageCount; ++i) {
    const SavedImage& image = file->SavedImages[i];
    frames.push_back({image.ImageDesc.Width, image.ImageDesc.Height, {}});
    for (int k = 0; k < image.ImageDesc.Width * image.ImageDesc.Height; ++k) {
      const GifColorType& c = image.ImageDesc.ColorMap->Colors[image.RasterBits[k]];
      frames.back().rgba.insert(frames.back().rgba.end(), {c.Red, c.Green, c.Blue, 255});
    }
    GraphicsControlBlock control;
    REQUIRE(DGifSavedExtensionToGCB(file, i, &control) == GIF_OK);
    CHECK(control.DelayTime == 150);
  }
  DGifCloseFile(file, &error);
  return frames;
}

}  // namespace

TEST_CASE("a GIF holds every picture as it is where its colours fit", "[animation]") {
  const std::vector<Picture> pictures = {stripes(40, 30, 256), stripes(40, 30, 1), stripes(40, 30, 90, 200)};
  const std::string bytes = gif(pictures, 1.5);
  CHECK_THAT(bytes, Contains("NETSCAPE2.0"));
  const std::vector<Picture> frames = frames_of(bytes);
  REQUIRE(frames.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(frames[i].rgba == pictures[i].rgba);
  CHECK(gif(pictures, 1.5) == bytes);
}

TEST_CASE("of many colours, few stand for all: what covers most stays, the rest errs little", "[animation]") {
  Picture shades{256, 64, {}};  // 8,192 colours on white
  for (int i = 0; i < 256 * 64; ++i) {
    const bool white = i % 256 >= 128;
    for (const int channel : {white ? 255 : i % 128, white ? 255 : 2 * (i / 256), white ? 255 : 60, 255})
      shades.rgba.push_back(static_cast<std::uint8_t>(channel));
  }
  const Picture frame = frames_of(gif({shades}, 1.5)).front();
  int worst = 0;
  for (std::size_t i = 0; i < shades.rgba.size(); ++i)
    worst = std::max(worst, std::abs(shades.rgba[i] - frame.rgba[i]));
  CHECK(worst > 0);
  CHECK(worst <= 8);  // 255 cells on 128 x 126 shades: 8 x 8 each
  CHECK(frame.rgba[4 * 200] == 255);
  for (const int most : {1, 2, 17, 256}) {
    const ColourTable table = colour_table(shades, most);
    CHECK(table.colours.size() == static_cast<std::size_t>(most));
    CHECK(std::ranges::all_of(table.places, [&](int place) { return place < most; }));
  }
}

TEST_CASE("an animation carries its metadata, and other files carry none", "[animation]") {
  const std::vector<Picture> pictures = {stripes(4, 3, 2), stripes(4, 3, 3)};
  const Metadata metadata = {{"lesson", "ray-sphere"}, {"q", std::string(700, '"') + "√ \x01 ;"}};
  Imprint imprint;
  imprint.alt = "A ray meets a ball.";
  const std::string moving = gif(pictures, 1.5, metadata, imprint);
  CHECK(gif_metadata(moving) == metadata);
  CHECK_THAT(moving, Contains("A ray meets a ball."));
  CHECK(gif_metadata(gif(pictures, 1.5, {}, imprint)).empty());
  CHECK(png_metadata(apng(pictures, 1.5, metadata, imprint)) == metadata);
  CHECK_THROWS_AS(gif_metadata("\x89PNG"), FileError);
  for (std::size_t n = 0; n < moving.size(); n += 7) try {
      gif_metadata(moving.substr(0, n));
    } catch (const FileError&) {
    }
}

TEST_CASE("each picture of an animation may have a time of its own", "[animation]") {
  const std::vector<Picture> pictures = {stripes(40, 30, 9), stripes(40, 30, 250)};
  const Timing timing = std::vector{0.04, 2.0};
  std::vector<std::string> hundredths;
  const std::string png = apng(pictures, timing);
  for (std::size_t at = png.find("fcTL"); at != png.npos; at = png.find("fcTL", at + 4))
    hundredths.push_back(png.substr(at + 24, 4));
  CHECK(hundredths == std::vector<std::string>{{"\0\x04\0\x64", 4}, {"\0\xC8\0\x64", 4}});
  CHECK_THAT(gif(pictures, timing),
             Contains(std::string("\x21\xF9\x04\x04\x04\0", 6)) && Contains(std::string("\x21\xF9\x04\x04\xC8\0", 6)));
}

TEST_CASE("an animated PNG has a frame a picture, numbered through, and opens as its first", "[animation]") {
  const std::vector<Picture> pictures = {stripes(40, 30, 9), stripes(40, 30, 250), stripes(40, 30, 3, 50)};
  const std::string bytes = apng(pictures, 1.5, {{"a", "b"}});
  CHECK(read_png(bytes).rgba == pictures.front().rgba);
  int controls = 0, numbered = 0;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const auto number = [&](std::size_t from) {
      std::size_t n = 0;
      for (std::size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<unsigned char>(bytes[from + i]);
      return n;
    };
    const std::string type = bytes.substr(at + 4, 4);
    if (type == "acTL") CHECK(number(at + 8) == 3);
    controls += type == "fcTL";
    if (type == "fcTL" || type == "fdAT") CHECK(number(at + 8) == static_cast<std::size_t>(numbered++));
    if (type == "fcTL") CHECK(bytes.substr(at + 8 + 20, 4) == std::string("\0\x96\0\x64", 4));  // 150 hundredths
    at += 12 + number(at);
  }
  CHECK(controls == 3);
  CHECK(numbered >= 5);
}

// A stand-in for ffmpeg: it writes its arguments and its input into atoms of an MP4.
constexpr const char* stand_in = R"(#!/bin/sh
for word; do
  case $before in -metadata) case $word in comment=*) comment=${word#comment=} ;; esac ;; -video_size) size=$word ;; esac
  before=$word
done
count=$(wc -c)
[ -z "$FFMPEG_FAILS" ] || { echo 'no such encoder' >&2; exit 3; }
n=$((16 + ${#comment}))
{ printf '\0\0\0\030ftypisom'
  printf "$(printf '\\0\\%03o\\%03o\\%03o' $((n / 65536)) $((n / 256 % 256)) $((n % 256)))data\0\0\0\001\0\0\0\0"
  printf '%s' "$comment"; echo "; $size $count"; } >"$word"
)";

/// Puts the stand-in first in the PATH, or leaves the PATH without any program.
class WithFfmpeg {
 public:
  explicit WithFfmpeg(bool there) : before_(std::getenv("PATH")) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "ffmpeg") << stand_in;
    if (there) std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
    setenv("PATH", (folder_.string() + (there ? ":" + before_ : "")).c_str(), 1);
  }
  ~WithFfmpeg() {
    setenv("PATH", before_.c_str(), 1), unsetenv("FFMPEG_FAILS");
    std::filesystem::remove_all(folder_);
  }
  WithFfmpeg(const WithFfmpeg&) = delete;
  WithFfmpeg& operator=(const WithFfmpeg&) = delete;

 private:
  std::filesystem::path folder_ = isect::test::scratch("isect-ffmpeg");
  std::string before_;
};

TEST_CASE("an MP4 is written by ffmpeg, which gets every picture for its time, with even sides", "[animation]") {
  const WithFfmpeg ffmpeg(true);
  CHECK(can_write_mp4());
  const std::vector<Picture> pictures = {stripes(41, 29, 9), stripes(41, 29, 3)};
  const Metadata metadata = {{"lesson", "ray-sphere"}, {"q", std::string(700, '"') + "√ \x01 ;"}};
  const std::string bytes = mp4(pictures, 1.5, metadata);
  CHECK_THAT(bytes, Contains("; 42x30 " + std::to_string(2 * 38 * 42 * 30 * 3)));  // 1.5 s are 38 of 25 a second
  CHECK(mp4_metadata(bytes) == metadata);
  CHECK(mp4_metadata(mp4(pictures, 1.5)).empty());
  CHECK_THAT(mp4(pictures, std::vector{0.04, 2.0}), Contains("; 42x30 " + std::to_string((1 + 50) * 42 * 30 * 3)));
  CHECK_THROWS_AS(mp4({}, 1), FileError);
  CHECK_THROWS_AS(mp4_metadata("GIF89a, and more"), FileError);
  for (std::size_t n = 0; n < bytes.size(); n += 7) try {
      mp4_metadata(bytes.substr(0, n));
    } catch (const FileError&) {
    }
}

TEST_CASE("an ffmpeg that fails or is not there is told", "[animation]") {
  const std::vector<Picture> pictures = {stripes(64, 64, 9), stripes(64, 64, 3)};
  {
    const WithFfmpeg ffmpeg(true);
    setenv("FFMPEG_FAILS", "yes", 1);
    CHECK_THROWS_WITH(mp4(pictures, 60), Contains("status 3: no such encoder"));
  }
  const WithFfmpeg none(false);
  CHECK_FALSE(can_write_mp4());
  CHECK_THROWS_WITH(mp4(pictures, 1), Contains("ffmpeg"));
}

TEST_CASE("pictures that do not go together are no animation", "[animation]") {
  CHECK_THROWS_AS(gif({}, 1), FileError);
  CHECK_THROWS_AS(apng({}, 1), FileError);
  CHECK_THROWS_AS(gif({stripes(4, 3, 2), stripes(3, 4, 2)}, 1), FileError);
  CHECK_THROWS_AS(apng({stripes(4, 3, 2), stripes(3, 4, 2)}, 1), FileError);
}

}  // namespace animation_test
