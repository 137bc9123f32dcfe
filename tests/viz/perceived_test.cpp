// How much of a difference an eye sees, held to the values that CSS Color 4 gives for OKLab.

#include "viz/snapshot/perceived.h"

#include <cmath>
#include <vector>

#include "tests/catch.h"
#include "viz/colour/measures.h"

namespace perceived_test {
using Catch::Matchers::WithinAbs;
using isect::test::Contains;
using isect::viz::in_words;
using isect::viz::oklab;
using isect::viz::Perceived;
using isect::viz::perceived;
using isect::viz::Picture;
using isect::viz::Vec3;

namespace {

/// A row of grey pixels.
Picture greys(const std::vector<std::uint8_t>& lights) {
  Picture row{static_cast<int>(lights.size()), 1, {}};
  for (const std::uint8_t light : lights) row.rgba.insert(row.rgba.end(), {light, light, light, 255});
  return row;
}

}  // namespace

TEST_CASE("colours have the places in OKLab that its definition states", "[perceived]") {
  struct Known {
    double r, g, b, lightness, green_red, blue_yellow;
  };
  for (const Known& k : {Known{0, 0, 0, 0, 0, 0}, Known{1, 1, 1, 1, 0, 0}, Known{1, 0, 0, 0.62796, 0.22486, 0.12585},
                         Known{0, 1, 0, 0.86644, -0.23389, 0.17950}, Known{0, 0, 1, 0.45201, -0.03246, -0.31153}}) {
    const Vec3 place = oklab({k.r, k.g, k.b});
    INFO(k.r << ' ' << k.g << ' ' << k.b);
    CHECK_THAT(place[0], WithinAbs(k.lightness, 1e-5));
    CHECK_THAT(place[1], WithinAbs(k.green_red, 1e-5));
    CHECK_THAT(place[2], WithinAbs(k.blue_yellow, 1e-5));
  }
}

TEST_CASE("changed pixels are counted, and among them those that an eye sees", "[perceived]") {
  const Perceived p = perceived(greys({0, 128, 128, 200, 255}), greys({255, 128, 129, 170, 255}));
  CHECK(p.pixels == 5);
  CHECK(p.changed == 3);
  CHECK(p.seen == 2);  // by one level nothing is seen
  CHECK_THAT(p.share_seen(), WithinAbs(0.4, 1e-12));
  CHECK_THAT(p.largest, WithinAbs(1, 1e-6));  // from black to white
  const double step =
      oklab({129 / 255.0, 129 / 255.0, 129 / 255.0})[0] - oklab({128 / 255.0, 128 / 255.0, 128 / 255.0})[0];
  const double fade =
      oklab({200 / 255.0, 200 / 255.0, 200 / 255.0})[0] - oklab({170 / 255.0, 170 / 255.0, 170 / 255.0})[0];
  CHECK_THAT(p.mean, WithinAbs((1 + step + fade) / 3, 1e-6));

  const Perceived same = perceived(greys({7, 8}), greys({7, 8}));
  CHECK(same.changed == 0);
  CHECK(same.largest == 0);
  CHECK(same.mean == 0);
}

TEST_CASE("a dark step is seen as one between light greys is, which are farther apart in numbers", "[perceived]") {
  const auto between = [](std::uint8_t a, std::uint8_t b) { return perceived(greys({a}), greys({b})).largest; };
  CHECK(between(10, 20) > between(240, 250));
  CHECK_THAT(between(30, 90), WithinAbs(between(90, 30), 1e-12));
}

TEST_CASE("within the slack nothing differs, and beyond it only the rest is measured", "[perceived]") {
  CHECK(perceived(greys({100}), greys({110}), 10).changed == 0);
  CHECK(perceived(greys({100}), greys({111}), 10).changed == 1);
  CHECK_THAT(perceived(greys({100}), greys({160}), 10).largest,
             WithinAbs(perceived(greys({110}), greys({160})).largest, 1e-12));
}

TEST_CASE("see-through pixels are seen on white, and pictures of two sizes are not compared", "[perceived]") {
  Picture clear = greys({0});
  clear.rgba[3] = 0;
  CHECK(perceived(clear, greys({255})).changed == 0);
  CHECK_THAT(perceived(clear, greys({0})).largest, WithinAbs(1, 1e-6));
  const Perceived none = perceived(greys({0, 0}), greys({0}));
  CHECK(none.pixels == 0);
  CHECK(none.share_seen() == 0);
  CHECK(in_words(none).empty());
}

TEST_CASE("the measure is told in words, a little as a little", "[perceived]") {
  Picture was{100, 100, std::vector<std::uint8_t>(40'000, 255)}, is = was;
  CHECK(in_words(perceived(was, is)) == "no pixel has another colour");
  is.rgba[0] = 254;
  CHECK_THAT(in_words(perceived(was, is)), Contains("none of the pixels changed visibly"));
  is.rgba[0] = is.rgba[1] = is.rgba[2] = 0;
  CHECK_THAT(in_words(perceived(was, is)), Contains("less than 0.1 % of the pixels changed visibly") &&
                                               Contains("by up to 1.00, by 1.00 on average"));
  for (std::size_t i = 0; i < 4 * 123; ++i) is.rgba[i] = i % 4 == 3 ? 255 : 0;
  CHECK_THAT(in_words(perceived(was, is)), Contains("1.2 % of the pixels changed visibly"));
  for (std::size_t i = 0; i < 4 * 5000; ++i) is.rgba[i] = i % 4 == 3 ? 255 : 0;
  CHECK_THAT(in_words(perceived(was, is)), Contains("50 % of the pixels changed visibly"));
}

}  // namespace perceived_test
