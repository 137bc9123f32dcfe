#include "viz/formats/files.h"
#include "viz/formats/writable.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

#include "tests/catch.h"

namespace files_test {
using namespace isect::viz;
namespace fs = std::filesystem;

namespace {

/// A folder of its own for each test, gone afterwards.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("isect-files-" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(path_), fs::directory_iterator()); }

 private:
  fs::path path_;
};

/// While it lives, writing more than `bytes` to a file fails.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    rlimit limit = old_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_ = {};
  void (*handler_)(int);
};

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const FileError& e) {
    return e.what();
  }
  return "no FileError";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

Picture noise(int width, int height, bool opaque = false) {
  std::mt19937 random(7);
  Picture p{width, height, {}};
  for (int i = 0; i < width * height * 4; ++i) p.rgba.push_back(static_cast<std::uint8_t>(random() & 255));
  for (std::size_t i = 3; opaque && i < p.rgba.size(); i += 4) p.rgba[i] = 255;
  return p;
}

Picture plain_picture(int width, int height, std::uint8_t level) {
  Picture p{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, level)};
  for (std::size_t i = 3; i < p.rgba.size(); i += 4) p.rgba[i] = 255;
  return p;
}

/// The check sum of PNG chunks, bit by bit.
std::uint32_t crc(const std::string& bytes) {
  std::uint32_t c = 0xFFFFFFFF;
  for (const char byte : bytes) {
    c ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) c = c >> 1 ^ (c & 1 ? 0xEDB88320 : 0);
  }
  return ~c;
}

void put(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

}  // namespace

TEST_CASE("a PNG has 96 pixels an inch, as an SVG without a width on paper", "[files]") {
  const std::string bytes = png(plain_picture(3, 2, 9), {{"lesson", "toy"}});
  const std::size_t at = bytes.find("pHYs");
  REQUIRE(at < bytes.find("IDAT"));
  const std::string chunk = bytes.substr(at, 4 + 9), per_metre("\0\0\x0e\xc4", 4);  // 3780
  CHECK(chunk == "pHYs" + per_metre + per_metre + '\1');
  std::string sum(4, '\0');
  put(sum, 0, crc(chunk));
  CHECK(bytes.substr(at + 4 + 9, 4) == sum);
}

TEST_CASE("what is written is read, in a folder made for it", "[files]") {
  const Folder folder;
  const std::string bytes("zero \0 and \xff\n", 13);
  write_file(folder / "a/b/c.bin", bytes);
  CHECK(read_file(folder / "a/b/c.bin") == bytes);
  write_file(folder / "empty", "");
  CHECK(read_file(folder / "empty").empty());
}

TEST_CASE("writing replaces the old file and leaves nothing beside it", "[files]") {
  const Folder folder;
  const std::string path = folder / "figure.svg";
  write_file(path, "old");
  write_file(path, std::string(100000, 'n'));
  CHECK(read_file(path) == std::string(100000, 'n'));
  CHECK(folder.entries() == 1);
}

TEST_CASE("a write that fails half-way leaves the old file and no other, and says why", "[files]") {
  const Folder folder;
  const std::string path = folder / "figure.svg";
  write_file(path, "old");
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = message_of([&] { write_file(path, std::string(100000, 'n')); });
  }
  CHECK(contains(message, path));
  CHECK(contains(message, "too large"));
  CHECK(read_file(path) == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a write sweeps up what a killed write of this file left, and nothing else", "[files]") {
  const Folder folder;
  const std::string left = folder / "a.txt.tmp-4711-0", held = folder / "a.txt.tmp-4711-1";
  const std::vector<std::string> others = {folder / "a.txt.tmp-notes", folder / "b.txt.tmp-4711-0"};
  for (const std::string& file : {left, held, others[0], others[1]}) std::ofstream(file) << "half";
  const int lock = ::open(held.c_str(), O_RDONLY);  // as the process that writes it holds it
  REQUIRE(::flock(lock, LOCK_EX) == 0);

  write_file(folder / "a.txt", "whole");
  CHECK(read_file(folder / "a.txt") == "whole");
  CHECK_FALSE(fs::exists(left));
  CHECK(fs::exists(held));
  for (const std::string& file : others) CHECK(fs::exists(file));

  ::close(lock);
  write_file(folder / "a.txt", "again");
  CHECK_FALSE(fs::exists(held));
}

TEST_CASE("a file is read up to a limit only", "[files]") {
  const Folder folder;
  write_file(folder / "a", std::string(100000, 'x'));
  CHECK(read_file(folder / "a", 100000).size() == 100000);
  CHECK_THROWS_WITH(read_file(folder / "a", 99999), isect::test::Contains("File too large"));
  CHECK_THROWS_AS(read_file("/dev/zero", 1 << 20), FileError);
}

TEST_CASE("a path that cannot be written is named with the reason", "[files]") {
  const Folder folder;
  write_file(folder / "file", "x");
  CHECK(contains(message_of([&] { write_file(folder / "file/below", "y"); }), "Not a directory"));
  write_file(folder / "full/inner", "x");
  CHECK(contains(message_of([&] { write_file(folder / "full", "y"); }), "Is a directory"));
  CHECK(folder.entries() == 2);
  CHECK(contains(message_of([] { write_file("", "y"); }), "cannot write ''"));
}

TEST_CASE("whether a file can be written is known before there is anything to write", "[files]") {
  const Folder folder;
  write_file(folder / "file", "x");
  fs::create_directory(folder / "full");
  for (const std::string& path : {folder / "file/below", folder / "full", std::string()})
    CHECK(message_of([&] { need_writable(path); }) == message_of([&] { write_file(path, "y"); }));
  for (const std::string& path : {folder / "file", folder / "new", folder / "made/new", std::string("/dev/full")})
    need_writable(path);
  CHECK(read_file(folder / "file") == "x");
  CHECK(folder.entries() == 3);  // the folder, which is made, and nothing in it
  CHECK(fs::is_empty(folder / "made"));
}

TEST_CASE("a link is written through and stays, to a file, to a link, and to a file yet to be made", "[files]") {
  const Folder folder;
  write_file(folder / "real/figure.svg", "old");
  fs::create_symlink("real/figure.svg", folder / "first");
  fs::create_symlink(folder / "first", folder / "second");
  write_file(folder / "second", "new");
  CHECK(read_file(folder / "real/figure.svg") == "new");
  CHECK(fs::read_symlink(folder / "first") == "real/figure.svg");
  CHECK(fs::is_symlink(folder / "second"));

  fs::create_symlink("real/later.svg", folder / "dangling");
  write_file(folder / "dangling", "made");
  CHECK(fs::is_symlink(folder / "dangling"));
  CHECK(read_file(folder / "real/later.svg") == "made");
  CHECK(std::distance(fs::directory_iterator(folder / "real"), fs::directory_iterator()) == 2);
}

TEST_CASE("a link that leads nowhere, in a circle or to a folder is refused and stays", "[files]") {
  const Folder folder;
  fs::create_symlink("no/such/folder", folder / "nowhere");
  fs::create_symlink("a", folder / "b");
  fs::create_symlink("b", folder / "a");
  fs::create_directory(folder / "full");
  fs::create_symlink("full", folder / "to-folder");
  const std::string nowhere = message_of([&] { write_file(folder / "nowhere", "x"); });
  CHECK(contains(nowhere, folder / "nowhere"));
  CHECK(contains(nowhere, "no/such/folder"));
  CHECK(contains(message_of([&] { write_file(folder / "a", "x"); }), "Too many levels"));
  CHECK(contains(message_of([&] { write_file(folder / "to-folder", "x"); }), "Is a directory"));
  for (const std::string link : {"nowhere", "a", "b", "to-folder"}) CHECK(fs::is_symlink(folder / link));
  CHECK(folder.entries() == 5);
}

TEST_CASE("a device and a pipe are written to, never replaced", "[files]") {
  const Folder folder;
  CHECK(contains(message_of([] { write_file("/dev/full", "x"); }), "No space left"));
  CHECK(fs::is_character_file("/dev/full"));
  fs::create_symlink("/dev/null", folder / "null");
  write_file(folder / "null", "x");
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(fs::is_symlink(folder / "null"));

  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const std::string sent(200000, 'x');  // more than a pipe holds at once
  std::string got;
  std::thread reader([&] { got = read_file(folder / "pipe"); });
  write_file(folder / "pipe", sent);
  reader.join();
  CHECK(got == sent);
  CHECK(fs::is_fifo(folder / "pipe"));
}

TEST_CASE("an old file keeps its mode", "[files]") {
  const Folder folder;
  const std::string path = folder / "figure.svg";
  for (const auto mode : {fs::perms(0600), fs::perms(0664), fs::perms(0755)}) {
    write_file(path, "old");
    fs::permissions(path, mode);
    write_file(path, "new");
    CHECK(fs::status(path).permissions() == mode);
  }
}

TEST_CASE("a path that cannot be read is named with the reason", "[files]") {
  const Folder folder;
  const std::string message = message_of([&] { read_file(folder / "nothing"); });
  CHECK(contains(message, folder / "nothing"));
  CHECK(contains(message, "No such file"));
  CHECK(contains(message_of([&] { read_file(folder / "."); }), "Is a directory"));
}

TEST_CASE("a picture survives as PNG, with and without transparency", "[files]") {
  for (const bool opaque : {false, true}) {
    const Picture p = noise(31, 17, opaque);
    const Picture q = read_png(png(p));
    CHECK(q.width == 31);
    CHECK(q.height == 17);
    CHECK(q.rgba == p.rgba);
  }
  CHECK(read_png(png(noise(1, 1))).rgba == noise(1, 1).rgba);
}

TEST_CASE("a picture of at most 256 colours survives as PNG with a table, which weighs less", "[files]") {
  Picture p = noise(64, 48, true);
  const std::size_t weight = png(p).size();
  for (std::uint8_t& channel : p.rgba) channel |= 63;  // four levels a channel, alpha stays
  for (std::size_t i = 0; i < p.rgba.size(); i += 4) p.rgba[i + 2] = 9;
  for (int width : {64, 1}) {
    const Picture cut{width, 48, {p.rgba.begin(), p.rgba.begin() + std::ptrdiff_t{4} * width * 48}};
    const std::string bytes = png(cut, {{"step", "3"}});
    CHECK(bytes[25] == 3);  // IHDR's type of colours
    CHECK(read_png(bytes).rgba == cut.rgba);
    CHECK(png_metadata(bytes) == Metadata{{"step", "3"}});
    CHECK(bytes.size() < weight / 3);
  }
  p.rgba[3] = 254;
  CHECK(png(p)[25] == 6);
  CHECK(read_png(png(p)).rgba == p.rgba);
}

TEST_CASE("the same picture and metadata give the same bytes", "[files]") {
  const Metadata metadata = {{"lesson", "ray_sphere"}, {"step", "3"}};
  CHECK(png(noise(20, 20), metadata) == png(noise(20, 20), metadata));
}

TEST_CASE("a PNG carries its metadata, and its pixels are not changed by it", "[files]") {
  const Metadata metadata = {
      {"lesson", "ray_sphere"}, {"title", "q = √(r² − m²) & <more>"}, {"empty", ""}, {"lines", "a\nb\n"}};
  const std::string bytes = png(noise(9, 5), metadata);
  CHECK(png_metadata(bytes) == metadata);
  CHECK(read_png(bytes).rgba == noise(9, 5).rgba);
  CHECK(png_metadata(png(noise(9, 5))).empty());
}

TEST_CASE("a metadata keyword that PNG cannot hold is refused", "[files]") {
  for (const std::string& key : {std::string(), std::string("a b"), std::string("é"), std::string(74, 'k')})
    CHECK_THROWS_AS(png(noise(2, 2), {{key, "x"}}), std::invalid_argument);
  CHECK_NOTHROW(png(noise(2, 2), {{std::string(73, 'k'), "x"}}));
}

TEST_CASE("a picture that is none is not written", "[files]") {
  CHECK_THROWS_AS(png({}), FileError);
  CHECK_THROWS_AS(png({2, 2, {1, 2, 3}}), FileError);
  CHECK_THROWS_AS(png({-1, 2, {}}), FileError);
}

TEST_CASE("what is no PNG is refused", "[files]") {
  for (const std::string bytes : {"", "P6 2 2 255 ", "<svg></svg>", "\x89PNG", "\x89PNG\r\n\x1a\n"}) {
    CHECK_THROWS_AS(read_png(bytes), FileError);
    if (bytes.size() != 8) CHECK_THROWS_AS(png_metadata(bytes), FileError);
  }
}

TEST_CASE("a PNG cut short anywhere is refused", "[files]") {
  const std::string bytes = png(noise(8, 8), {{"lesson", "x"}});
  const std::size_t end_chunk = 12;
  for (std::size_t n = 0; n + end_chunk < bytes.size(); ++n) {
    INFO(n << " of " << bytes.size() << " bytes");
    REQUIRE_THROWS_AS(read_png(bytes.substr(0, n)), FileError);
  }
}

TEST_CASE("a damaged PNG gives a FileError or a picture of its size, never a crash", "[files]") {
  const std::string good = png(noise(8, 8), {{"lesson", "x"}});
  std::mt19937 random(11);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bad = good;
    for (int j = 0; j < 3; ++j) bad[random() % bad.size()] = static_cast<char>(random());
    try {
      const Picture p = read_png(bad);
      REQUIRE(p.rgba.size() == std::size_t{4} * p.width * p.height);
    } catch (const FileError&) {
      ++refused;
    }
    try {
      png_metadata(bad);
    } catch (const FileError&) {
    }
  }
  CHECK(refused > 1000);
}

TEST_CASE("a PNG whose header claims a giant picture is refused before memory is taken", "[files]") {
  std::string bytes = png(noise(4, 4));
  const std::size_t width_at = 16, crc_at = 29;
  put(bytes, width_at, 900000);
  put(bytes, width_at + 4, 900000);
  put(bytes, crc_at, crc(bytes.substr(12, 17)));
  CHECK(contains(message_of([&] { read_png(bytes); }), "too large"));
}

TEST_CASE("equal pictures have no difference", "[files]") {
  const Difference d = compare(noise(40, 30), noise(40, 30));
  CHECK(d.same_size);
  CHECK(d.over_1 == 0);
  CHECK(d.passes());
}

TEST_CASE("a difference counts pixels, by their worst channel", "[files]") {
  const Picture a = plain_picture(40, 30, 100);
  Picture b = a;
  const auto change = [&b](int pixel, int channel, int by) {
    b.rgba[4 * pixel + channel] = static_cast<std::uint8_t>(b.rgba[4 * pixel + channel] + by);
  };
  change(0, 0, 1);                     // within 1
  change(1, 1, 2), change(1, 2, -8);   // more than 1
  change(2, 2, -9), change(2, 0, 50);  // more than 8
  change(3, 3, -100);                  // alpha counts too
  const Difference d = compare(a, b);
  CHECK(d.over_1 == 3);
  CHECK(d.over_8 == 2);
  CHECK(compare(b, a).over_8 == 2);
}

TEST_CASE("the gate lets 24 strong and 256 weak pixels pass, and not one more", "[files]") {
  const Picture a = plain_picture(40, 30, 100);
  const auto changed = [&a](int pixels, int by) {
    Picture b = a;
    for (int i = 0; i < pixels; ++i) b.rgba[4 * i] = static_cast<std::uint8_t>(100 + by);
    return b;
  };
  CHECK(compare(a, changed(24, 9)).passes());
  CHECK_FALSE(compare(a, changed(25, 9)).passes());
  CHECK(compare(a, changed(256, 2)).passes());
  CHECK_FALSE(compare(a, changed(257, 2)).passes());
  CHECK(compare(a, changed(1200, 1)).passes());
}

TEST_CASE("with a slack only what lies beyond it is a difference", "[files]") {
  const Picture a = plain_picture(40, 30, 100);
  Picture b = a;
  for (const std::size_t pixel : {0, 1, 2}) b.rgba[4 * pixel] = static_cast<std::uint8_t>(111 + 4 * pixel);
  const Difference d = compare(a, b, 10);  // by 11, 15, 19
  CHECK(d.over_1 == 2);
  CHECK(d.over_8 == 1);
  CHECK(compare(a, b, 19).over_1 == 0);
  CHECK(difference_picture(a, b, 19).rgba == difference_picture(a, b, 20).rgba);
  CHECK_FALSE(difference_picture(a, b, 18).rgba == difference_picture(a, b, 19).rgba);
}

TEST_CASE("pictures of different size never pass", "[files]") {
  const Difference d = compare(plain_picture(4, 6, 9), plain_picture(6, 4, 9));
  CHECK_FALSE(d.same_size);
  CHECK_FALSE(d.passes());
}

TEST_CASE("the difference picture is grey where equal and strong where not", "[files]") {
  const Picture a = plain_picture(3, 2, 100);
  Picture b = a;
  b.rgba[0] = 200;
  const Picture d = difference_picture(a, b);
  const auto saturation = [&d](std::size_t pixel) {
    const auto [lo, hi] = std::minmax({d.rgba[4 * pixel], d.rgba[4 * pixel + 1], d.rgba[4 * pixel + 2]});
    return hi - lo;
  };
  CHECK(saturation(0) > 150);
  for (std::size_t i = 1; i < 6; ++i) CHECK(saturation(i) == 0);

  const Picture uneven = difference_picture(plain_picture(2, 3, 9), plain_picture(3, 2, 9));
  CHECK(uneven.width == 3);
  CHECK(uneven.height == 3);
  CHECK(uneven.rgba.size() == 36);
}

}  // namespace files_test
