#include <algorithm>
#include <cmath>
#include <set>

#include "tests/catch.h"
#include "viz/formats/files.h"

namespace svg_test {
using namespace isect::viz;

namespace {

constexpr Colour blue = {0, 0, 1, 1};

Drawing drawing(std::vector<Shape> shapes = {}) { return {200, 100, {1, 1, 1, 1}, std::move(shapes)}; }

/// One of each kind of shape.
Drawing everything() {
  return drawing({Fill{circle({50, 50}, 30), blue.with_alpha(0.14), 2, 0.2, blue},
                  Stroke{polyline({{0, 0}, {200, 100}}), blue, 0.5, {1.5, 1.1}, false},
                  Gradient{{150, 50}, {30, 0}, {0, 20}, {140, 40}, blue, blue.with_alpha(0.2)},
                  Text{.markup = "*t*_{1,2} = √2", .at = {100, 90}, .size = 6.6, .colour = blue, .halo = 0.6}});
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// All texts between `before` and the next `after`.
std::vector<std::string> between(const std::string& text, const std::string& before, const std::string& after) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != text.npos; at = text.find(before, at)) {
    at += before.size();
    found.push_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

std::string first(const std::vector<std::string>& found) { return found.empty() ? "" : found.front(); }
std::string attribute(const std::string& text, const std::string& name) {
  return first(between(text, " " + name + "=\"", "\""));
}
std::string style(const std::string& text, const std::string& name) { return first(between(text, name + ":", ";")); }

/// Every opened element is closed in order.
bool balanced(const std::string& xml) {
  std::vector<std::string> open;
  for (const std::string& tag : between(xml, "<", ">")) {
    if (tag.front() == '?' || tag.back() == '/') continue;
    if (tag.front() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
      continue;
    }
    if (open.empty() || open.back() != tag.substr(1)) return false;
    open.pop_back();
  }
  return open.empty();
}

}  // namespace

TEST_CASE("every kind of shape reaches the SVG", "[svg]") {
  const std::string fill = svg(drawing({Fill{circle({50, 50}, 30), blue.with_alpha(0.25), 0, 0, {}}}));
  CHECK(contains(fill, "fill-opacity:0.25"));
  CHECK_FALSE(contains(fill, "clip-path"));

  const std::string hatched = svg(drawing({Fill{circle({50, 50}, 30), blue, 2, 0.2, blue}}));
  CHECK(contains(hatched, "clip-path"));
  CHECK(style(hatched, "stroke-width") == "0.2");

  const std::string stroke = svg(drawing({Stroke{polyline({{0, 0}, {9, 9}}), blue, 0.75, {1.5, 1.1}, true}}));
  CHECK(style(stroke, "stroke-width") == "0.75");
  CHECK(style(stroke, "stroke-dasharray") == "1.5,1.1");
  CHECK(style(stroke, "stroke-linecap") == "round");
  CHECK_FALSE(contains(svg(drawing({Stroke{polyline({{0, 0}, {9, 9}}), blue}})), "stroke-dasharray"));

  CHECK(contains(svg(drawing({Gradient{{50, 50}, {30, 0}, {0, 20}, {50, 50}, blue, blue}})), "<radialGradient"));
  CHECK(contains(svg(drawing({Text{.markup = "*t*", .at = {5, 5}, .colour = blue}})), "<path d=\"M"));
  CHECK(balanced(svg(everything(), {{"key", "value"}})));
}

TEST_CASE("hatch lines lie at the gap asked for", "[svg]") {
  const Path square = polyline({{0, 0}, {40, 0}, {40, 40}, {0, 40}}, true);
  const auto lines = [&](double gap) {
    const std::string text = svg(drawing({Fill{square, blue, gap, 0.2, blue}}));
    const std::size_t at = text.find("<path clip-path=");
    const std::string path = text.substr(at, text.find("/>", at) - at);
    return std::count(path.begin(), path.end(), 'M');
  };
  // The square's diagonal, 40 sqrt 2 long, is crossed once a gap.
  CHECK(lines(2) == 29);
  CHECK(lines(4) == 15);
}

TEST_CASE("the same drawing gives the same bytes, whatever was drawn before", "[svg]") {
  const Metadata metadata = {{"lesson", "x"}};
  const std::string first = svg(everything(), metadata);
  svg(drawing({Text{.markup = "**other**", .at = {5, 5}, .size = 30, .colour = blue}}));
  raster(Text{.markup = "*q*", .at = {5, 5}, .size = 9, .colour = blue}, 4);
  CHECK(svg(everything(), metadata) == first);
}

TEST_CASE("every reference within an SVG has its id, and no id stands twice", "[svg]") {
  const std::string text = svg(everything());
  const std::vector<std::string> all = between(text, " id=\"", "\"");
  const std::set<std::string> ids(all.begin(), all.end());
  CHECK(ids.size() == all.size());

  const std::vector<std::string> urls = between(text, "url(#", ")");
  CHECK(urls.size() == 2);  // the gradient and the hatch's clip
  for (const std::string& id : urls) CHECK(ids.count(id) == 1);
}

TEST_CASE("an SVG has the width of its paper, and keeps its shape", "[svg]") {
  const std::string plain = svg(drawing());
  CHECK(attribute(plain, "width") == "200");
  CHECK(attribute(plain, "height") == "100");
  Imprint imprint;
  imprint.width_pt = 226.772;
  const std::string paper = svg(drawing(), {}, imprint);
  CHECK(attribute(paper, "width") == "226.772pt");
  CHECK(attribute(paper, "height") == "113.386pt");
  CHECK(attribute(paper, "viewBox") == attribute(plain, "viewBox"));
}

TEST_CASE("an SVG carries its metadata, escaped", "[svg]") {
  const Metadata metadata = {{"lesson", "ray_sphere"},
                             {"title", "q = √(r² − m²) & <more> \"quoted\" ]]> -- </metadata> &amp;lt;"},
                             {"empty", ""},
                             {"control", "a\nb\tc\x01"}};
  const std::string text = svg(everything(), metadata);
  CHECK(svg_metadata(text) == metadata);
  CHECK(balanced(text));
  CHECK(svg_metadata(svg(everything())).empty());
}

TEST_CASE("text in an SVG is outlines, not references to fonts", "[svg]") {
  const std::string text = svg(everything());
  CHECK_FALSE(contains(text, "<text"));
  CHECK_FALSE(contains(text, "font-family"));
  CHECK_FALSE(contains(text, "<image"));
}

TEST_CASE("text in an SVG stays text where that is asked for, scripts and all", "[svg]") {
  Imprint imprint;
  imprint.letters = Imprint::Letters::glyphs;
  const std::string text =
      svg(drawing({Text{.markup = "*t*_1^2 < √2 & **o**", .at = {9, 9}, .size = 10, .colour = blue, .align = 0.5}}), {},
          imprint);
  CHECK(balanced(text));
  CHECK(contains(text, "text-anchor=\"middle\""));
  CHECK(contains(text, "<tspan style=\"font-style:italic;\">t</tspan>"));
  CHECK(contains(text, "<tspan dy=\"1.6\" style=\"font-size:7;\">1</tspan>"));
  CHECK(contains(text, "<tspan dy=\"-5\" style=\"font-size:7;\">2</tspan>"));
  CHECK(contains(text, "<tspan dy=\"3.4\"> &lt; √2 &amp; </tspan>"));
  CHECK(contains(text, "<tspan style=\"font-weight:bold;\">o</tspan>"));
}

TEST_CASE("groups of an SVG are called as the objects are, each id once", "[svg]") {
  Drawing d = everything();
  d.objects = {{"ball", "*b*"}, {"label", "t₁"}, {"label", "t1"}};
  const auto own = [&](std::size_t shape, int object) {
    std::visit([&](auto& s) { s.object = object; }, d.shapes[shape]);
  };
  own(0, 0), own(1, 1), own(2, 0), own(3, 2);
  const std::string text = svg(d);
  CHECK(balanced(text));
  const std::vector<std::string> ids = between(text, "<g id=\"", "\"");
  CHECK(ids == std::vector<std::string>{"ball-b", "label-t1", "ball-b-2", "label-t1-2"});
  CHECK(contains(text, "inkscape:label=\"label t₁\""));
}

TEST_CASE("an SVG tells its title and the picture in words, to whoever can't see it", "[svg]") {
  Imprint imprint;
  imprint.title = "Ray & sphere";
  imprint.alt = "A ray <b> meets a ball.";
  const std::string text = svg(everything(), {}, imprint);
  CHECK(contains(text, "<title id=\"title\">Ray &amp; sphere</title>"));
  CHECK(contains(text, "<desc id=\"alt\">A ray &lt;b&gt; meets a ball.</desc>"));
  CHECK(contains(text, "role=\"img\" aria-labelledby=\"title\" aria-describedby=\"alt\""));
  CHECK(balanced(text));
  CHECK_FALSE(contains(svg(everything()), "<title"));
}

TEST_CASE("a drawing without a ground has none in the SVG either", "[svg]") {
  Drawing d = everything();
  CHECK(contains(svg(d), "<rect"));
  d.background.a = 0;
  CHECK_FALSE(contains(svg(d), "<rect"));
}

TEST_CASE("degenerate shapes leave the rest of the drawing whole", "[svg]") {
  const Stroke line{polyline({{0, 0}, {9, 9}}), blue, 0.625};
  const std::string text = svg(drawing({Gradient{{5, 5}, {0, 0}, {0, 0}, {5, 5}, blue, blue},
                                        Gradient{{5, 5}, {3, 0}, {0, 2}, {50, 50}, blue, blue},  // focus far outside
                                        Fill{polyline({{1, 1}}), blue, 2, 0.2, blue}, Fill{{}, blue, 2, 0.2, blue},
                                        Text{.markup = "", .at = {1, 1}, .colour = blue},
                                        Text{.markup = "t", .at = {1, 1}, .size = 0, .colour = blue}, line}));
  CHECK(contains(text, "stroke-width:0.625"));
  CHECK(balanced(text));
}

TEST_CASE("a drawing without size is refused", "[svg]") {
  CHECK_THROWS_AS(svg({}), FileError);
  CHECK_THROWS_AS(svg({-1, 5, blue, {}}), FileError);
  CHECK_THROWS_AS(svg({std::nan(""), 5, blue, {}}), FileError);
}

}  // namespace svg_test
