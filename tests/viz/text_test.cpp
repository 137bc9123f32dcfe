#include "viz/text/text.h"

#include <cmath>
#include <limits>
#include <thread>

#include "tests/catch.h"

namespace text_test {
using namespace isect::viz;

namespace {

constexpr Colour ink = {0.9, 0.2, 0.1, 1};
constexpr Colour rim = {0, 0, 1, 1};

Text text(const std::string& markup, double size = 22, double align = 0) {
  return {.markup = markup, .at = {100, 50}, .size = size, .colour = ink, .align = align};
}

/// The box of all pixels with more than `least` alpha, in the drawing's units.
TextBox inked(const Rastered& r, double scale, int least = 16) {
  constexpr double far = std::numeric_limits<double>::infinity();
  TextBox box{far, far, -far, -far};
  for (int y = 0; y < r.picture.height; ++y) {
    for (int x = 0; x < r.picture.width; ++x) {
      if (r.picture.rgba[4 * (static_cast<std::size_t>(y) * r.picture.width + x) + 3] <= least) continue;
      box.left = std::min(box.left, r.corner.x() + x / scale);
      box.right = std::max(box.right, r.corner.x() + (x + 1) / scale);
      box.top = std::min(box.top, r.corner.y() + y / scale);
      box.bottom = std::max(box.bottom, r.corner.y() + (y + 1) / scale);
    }
  }
  return box;
}

/// The largest step between corresponding sides.
double apart(const TextBox& a, const TextBox& b) {
  return std::max(
      {std::abs(a.left - b.left), std::abs(a.top - b.top), std::abs(a.right - b.right), std::abs(a.bottom - b.bottom)});
}

double width(const TextBox& b) { return b.right - b.left; }

Paragraph paragraph(const std::string& markup, double wrap) { return {.markup = markup, .width = wrap, .colour = ink}; }

/// Rows of the picture that hold any ink, as [first, last] bands parted by empty rows.
std::vector<std::pair<int, int>> bands(const Picture& p) {
  std::vector<std::pair<int, int>> found;
  bool in_band = false;
  for (int y = 0; y < p.height; ++y) {
    bool any = false;
    for (int x = 0; x < p.width; ++x) any = any || p.rgba[4 * (static_cast<std::size_t>(y) * p.width + x) + 3] > 0;
    if (any && !in_band) found.emplace_back(y, y);
    if (any) found.back().second = y;
    in_band = any;
  }
  return found;
}

}  // namespace

TEST_CASE("a line ends before the left side of an equation, or after its sign", "[text]") {
  const std::string formula = "centre (1, 2), *r* = 3.6557";
  const auto width = [](const std::string& line) {
    const TextBox box = measure({.markup = line, .at = Vec2::Zero(), .size = 20, .colour = {}});
    return box.right - box.left;
  };
  CHECK(wrapped(formula, 20, false, width(formula)) == std::vector<std::string>{formula});
  CHECK(wrapped(formula, 20, false, width("centre (1, 2), *r*") + 1) ==
        std::vector<std::string>{"centre (1, 2),", "*r* = 3.6557"});
  CHECK(wrapped(formula, 20, false, 1) == std::vector<std::string>{"centre", "(1,", "2),", "*r* =", "3.6557"});
}

TEST_CASE("the fonts of figures and window are the designed ones", "[text]") {
  const Fonts f = fonts();
  CHECK(f.figure.starts_with("STIX"));
  CHECK(f.window == "DejaVu Sans");
  CHECK(f.exact == (f.figure == "STIXGeneral"));
}

TEST_CASE("a measured box is the box of the pixels drawn", "[text]") {
  const double scale = 16;
  for (const std::string markup : {"*t*_{1,2}", "**o**", "*m*^2 = *r*^2", "√(*q*) ≤ ∩", "*f*", "two roots", "0"}) {
    for (const double align : {0.0, 0.5, 1.0}) {
      INFO(markup << " align " << align);
      const Text t = text(markup, 22, align);
      CHECK(apart(measure(t), inked(raster(t, scale), scale)) <= 1.5 / scale);
    }
  }
}

TEST_CASE("extents are proportional to the size and the same at every resolution", "[text]") {
  const TextBox small = measure(text("*t*_{1,2} = 26 654", 6.6)), large = measure(text("*t*_{1,2} = 26 654", 66));
  CHECK(width(large) == Approx(10 * width(small)).epsilon(1e-9));
  CHECK(large.top - 50 == Approx(10 * (small.top - 50)).epsilon(1e-9));
}

TEST_CASE("alignment anchors the line's left, middle or right", "[text]") {
  const TextBox left = measure(text("HH", 22, 0)), middle = measure(text("HH", 22, 0.5)),
                right = measure(text("HH", 22, 1));
  CHECK(left.left == Approx(100).margin(1));
  CHECK((middle.left + middle.right) / 2 == Approx(100).margin(0.5));
  CHECK(right.right == Approx(100).margin(1));
  CHECK(left.bottom == Approx(50).margin(0.5));
}

TEST_CASE("subscripts hang below the baseline and superscripts stand above the letter, both smaller", "[text]") {
  const TextBox base = measure(text("1")), sub = measure(text("_1")), super = measure(text("^1"));
  const double height = base.bottom - base.top;
  CHECK(sub.bottom - sub.top == Approx(0.7 * height).epsilon(0.01));
  CHECK(sub.bottom == Approx(50 + 0.16 * 22).margin(0.1));
  CHECK(super.bottom == Approx(50 - 0.34 * 22).margin(0.1));
  CHECK(super.top < base.top);
}

TEST_CASE("italic, bold and plain text differ in shape, digits of italic text do not", "[text]") {
  CHECK(width(measure(text("**m**"))) != Approx(width(measure(text("m")))).epsilon(0.01));
  CHECK(width(measure(text("*a*"))) != Approx(width(measure(text("a")))).epsilon(0.01));
  CHECK(width(measure(text("*2*"))) == width(measure(text("2"))));
}

TEST_CASE("text without ink has an empty box at its anchor and an empty picture", "[text]") {
  for (const std::string markup : {"", " ", "_{}"}) {
    const TextBox box = measure(text(markup));
    CHECK(width(box) == 0);
    CHECK(box.left == Approx(100));
    CHECK(raster(text(markup), 2).picture.rgba.empty());
  }
  CHECK(raster(text("t", 0), 1).picture.rgba.empty());
  CHECK(raster(text("t"), 0).picture.rgba.empty());
}

TEST_CASE("a raster lies on the drawing's pixels", "[text]") {
  for (const double scale : {1.0, 1.5, 2.0}) {
    Text t = text("*q*");
    t.at = {100.3, 50.7};
    const Rastered r = raster(t, scale);
    CHECK(r.corner.x() * scale == Approx(std::round(r.corner.x() * scale)));
    CHECK(r.corner.y() * scale == Approx(std::round(r.corner.y() * scale)));
  }
}

TEST_CASE("pixels are straight alpha in the text's colour", "[text]") {
  const Picture p = raster(text("**W**"), 2).picture;
  for (std::size_t i = 0; i < p.rgba.size(); i += 4) {
    if (p.rgba[i + 3] < 32) continue;  // at low alpha, eight bits cannot hold the premultiplied colour better
    REQUIRE(std::abs(p.rgba[i] - 230) <= 6);
    REQUIRE(std::abs(p.rgba[i + 1] - 51) <= 6);
  }
}

TEST_CASE("a halo surrounds the text without moving it", "[text]") {
  const double scale = 8;
  Text t = text("*t*_1");
  const TextBox without = inked(raster(t, scale), scale);
  t.halo = 3;
  t.halo_colour = rim;
  CHECK(apart(measure(t), without) <= 1.5 / scale);
  const TextBox with = inked(raster(t, scale), scale);
  CHECK(without.left - with.left == Approx(3).margin(0.3));
  CHECK(with.bottom - without.bottom == Approx(3).margin(0.3));

  const Rastered r = raster(t, scale);
  int blue = 0, red = 0;
  for (std::size_t i = 0; i < r.picture.rgba.size(); i += 4) {
    if (r.picture.rgba[i + 3] < 255) continue;
    blue += r.picture.rgba[i + 2] > 250;
    red += r.picture.rgba[i] > 220;
  }
  CHECK(blue > 100);
  CHECK(red > 100);
}

TEST_CASE("the same text gives the same pixels, in any thread and after other texts", "[text]") {
  const Text t = text("*q* = √(*r*^2 − *m*^2)");
  const Picture first = raster(t, 2).picture;
  raster(text("**other**", 40), 3);
  CHECK(raster(t, 2).picture.rgba == first.rgba);

  std::vector<Picture> found(4);
  std::vector<std::thread> threads;
  for (Picture& p : found) threads.emplace_back([&p, &t] { p = raster(t, 2).picture; });
  for (std::thread& thread : threads) thread.join();
  for (const Picture& p : found) CHECK(p.rgba == first.rgba);
}

TEST_CASE("text too large for a picture is refused", "[text]") {
  CHECK_THROWS_AS(raster(text("wide", 1e6), 100), std::invalid_argument);
}

TEST_CASE("broken UTF-8 is drawn as something and does no harm", "[text]") {
  CHECK_NOTHROW(raster(text("a\xff\xe2\x88"), 1));
  CHECK_NOTHROW(raster(paragraph("a\xff\xe2\x88", 100)));
}

TEST_CASE("a paragraph wraps at its width on a baseline grid", "[text]") {
  const std::string words = "nnn nnn nnn nnn nnn nnn";
  const Picture one = raster(paragraph(words, 0)), wrapped = raster(paragraph(words, 100));
  CHECK(one.height == 23);
  CHECK(wrapped.width == 100);
  REQUIRE(wrapped.height % 23 == 0);
  const auto lines = bands(wrapped);
  REQUIRE(lines.size() == static_cast<std::size_t>(wrapped.height / 23));
  REQUIRE(lines.size() >= 2);
  for (std::size_t i = 1; i < lines.size(); ++i) CHECK(lines[i].second - lines[i - 1].second == 23);
}

TEST_CASE("a word wider than the paragraph is broken, never cut", "[text]") {
  const Picture p = raster(paragraph("nnnnnnnnnnnnnnnnnnnnnnnnnnnnnn", 60));
  CHECK(p.width == 60);
  CHECK(bands(p).size() >= 4);
}

TEST_CASE("no line ends before a per cent sign, after the sign of an option, or within a product or an interval",
          "[text]") {
  const auto width_of = [](const Picture& p, std::pair<int, int> rows) {
    int right = 0;
    for (int y = rows.first; y <= rows.second; ++y)
      for (int x = 0; x < p.width; ++x)
        if (p.rgba[4 * (static_cast<std::size_t>(y) * p.width + x) + 3] > 60) right = std::max(right, x);
    return right;
  };
  for (const auto& [words, kept] : {std::pair{"noise of 50 %", "50 %"},
                                    {"GCC 12, -O3", "-O3"},
                                    {"where **o** + *t* **d**", "*t* **d**"},
                                    {"range [0.25, 0.75]", "[0.25, 0.75]"}}) {
    INFO(words);
    const int whole = raster(paragraph(words, 0)).width, last = raster(paragraph(kept, 0)).width;
    const Picture wrapped = raster(paragraph(words, whole - 3));
    const auto lines = bands(wrapped);
    REQUIRE(lines.size() == 2);
    CHECK(width_of(wrapped, lines.back()) > last - 6);
  }
}

TEST_CASE("paragraphs are parted by a gap", "[text]") {
  const auto lines = bands(raster(paragraph("nnn\nnnn", 200)));
  REQUIRE(lines.size() == 2);
  CHECK(lines[1].second - lines[0].second == 30);
}

TEST_CASE("mathematics within a paragraph leaves the baseline where it is", "[text]") {
  const auto plain_line = bands(raster(paragraph("nn", 0)));
  const auto with_math = bands(raster(paragraph("nn *m*", 0)));
  REQUIRE(plain_line.size() == 1);
  REQUIRE(with_math.size() == 1);
  CHECK(std::abs(plain_line[0].second - with_math[0].second) <= 1);
}

TEST_CASE("a formula on a generous pitch keeps all its ink", "[text]") {
  Paragraph formula = paragraph("*f*_1 = √(*r*^2 − *m*^2)", 0);
  formula.math = true;
  formula.size = 22;
  formula.line_pitch = 36;
  for (const double scale : {1.0, 2.0}) {
    const Picture p = raster(formula, scale);
    const auto ink_at = [&p](int x, int y) { return p.rgba[4 * (static_cast<std::size_t>(y) * p.width + x) + 3]; };
    int on_border = 0;
    for (int x = 0; x < p.width; ++x) on_border += (ink_at(x, 0) > 0) + (ink_at(x, p.height - 1) > 0);
    CHECK(on_border == 0);
    CHECK(p.height == static_cast<int>(36 * scale));
  }
}

TEST_CASE("a paragraph's extent is the size of its picture, which is not drawn for it", "[text]") {
  for (const char* markup : {"", "void", "The sphere **c** and *r*^2 of it, on several lines, one after the other",
                             "a\nb", "averylongwordthatfitsintonoline *d*^2 ≤ *r*^2"})
    for (const double wrap : {0.0, 40.0, 130.5})
      for (const double scale : {1.0, 1.25, 2.0, 3.0}) {
        const Paragraph p = paragraph(markup, wrap);
        const Picture picture = raster(p, scale);
        INFO(markup << ", " << wrap << ", " << scale);
        CHECK(extent(p, scale) == Vec2(picture.width, picture.height));
      }
  CHECK(extent(paragraph("void", 0), 0) == Vec2(0, 0));
}

TEST_CASE("an empty paragraph is an empty picture", "[text]") {
  CHECK(raster(paragraph("", 100)).rgba.empty());
  CHECK(raster(paragraph("a", 100), 0).rgba.empty());
}

}  // namespace text_test
