// Pictures inside a web page: one set of shapes in two themes, texts that stay text, what is shared.

#include "viz/formats/page_svg.h"

#include "tests/catch.h"
#include "viz/formats/svg_path.h"
#include "viz/theme.h"

namespace page_svg_test {
using isect::test::Contains;
using namespace isect::viz;

const Theme light = theme(ThemeName::screen, 960, 600), dark = theme(ThemeName::dark, 960, 600);

Stroke line(const Colour& c, double y, double width = 2) { return {polyline({{0, y}, {90, y}}), c, width}; }
Drawing drawing(std::vector<Shape> shapes) { return {100, 50, {}, std::move(shapes), {}}; }

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST_CASE("a role's colour is a class, whatever the theme", "[page]") {
  PageColours colours;
  PagePictures page(colours);
  const std::string svg = page.svg(drawing({line(light.ink(Role::first), 10)}),
                                   drawing({line(dark.ink(Role::first), 10)}), "a line & \"more\"");
  CHECK_THAT(svg, Contains("class=\"line-first\"") && Contains("viewBox=\"0 0 100 50\"") && Contains("role=\"img\"") &&
                      Contains("aria-label=\"a line &amp; &quot;more&quot;\""));
  CHECK_THAT(svg, !Contains("#0b60c8"));
  CHECK_THAT(colours.rules(), Contains(".line-first { stroke: var(--first); }") && !Contains(".fill-first"));
  CHECK_THAT(colours.variables(false), Contains("--first: #0b60c8; "));
  CHECK_THAT(colours.variables(true), Contains("--first: #5fa8ff; "));
}

TEST_CASE("an area and its outline are one element, unless something stands between", "[page]") {
  const Path triangle = polyline({{0, 0}, {9, 0}, {0, 9}}, true);
  const Shape area = Fill{triangle, light.ink(Role::first)}, outline = Stroke{triangle, light.ink(Role::second), 2};
  const Shape text = Text{"a", {5, 5}, 10, light.ink(Role::text), 0};
  const auto lone = [](std::vector<Shape> shapes) { return lone_svg(drawing(std::move(shapes)), "", ""); };
  CHECK_THAT(lone({area, outline}),
             Contains("<path fill=\"#0b60c8\" stroke=\"#a34e00\" stroke-width=\"2\" d=\"M0 0l9 0l-9 9z\"/>"));
  CHECK(count(lone({area, outline}), "<path") == 1);
  CHECK(count(lone({area, text, outline}), "<path") == 2);
  CHECK(count(lone({area, text, outline}), "<text") == 1);
  CHECK(count(lone({outline, area}), "<path") == 2);
  CHECK(count(lone({area, line(light.ink(Role::second), 10), outline}), "<path") == 2);  // the lines are one

  PageColours colours;
  PagePictures page(colours);
  CHECK_THAT(page.svg(drawing({area, outline}), drawing({area, outline}), ""),
             Contains(" d=\"M0 0l9 0l-9 9z\"/>") && Contains("class=\"fill-") && !Contains("\" class="));
}

TEST_CASE("facets of one colour that cover one another nowhere are one element, with their seams", "[page]") {
  const Facets facets = {.corners = {{0, 0}, {9, 0}, {0, 9}, {9, 0}, {9, 9}, {0, 9}},
                         .colours = {hex(0x123456), hex(0x654321)},
                         .seam = 0.5};
  const std::string svg = lone_svg(drawing({facets}), "", "");
  CHECK_THAT(svg,
             Contains("<path fill=\"#123456\" stroke=\"#123456\" stroke-width=\"0.5\" d=\"M0 0l9 0l-9 9z\"/>") &&
                 Contains("<path fill=\"#654321\" stroke=\"#654321\" stroke-width=\"0.5\" d=\"M9 0l0 9l-9 0z\"/>"));
  Facets alike = facets;  // its third lies on the first, in the colour of the second
  alike.corners.insert(alike.corners.end(), {{1, 1}, {4, 1}, {1, 4}});
  alike.colours = {hex(0x123456), hex(0x123456), hex(0x123456)};
  CHECK_THAT(lone_svg(drawing({alike}), "", ""),
             Contains("d=\"M0 0l9 0l-9 9zm9 0l0 9l-9 0z\"/>") && Contains("d=\"M1 1l3 0l-3 3z\"/>"));

  Facets smooth = facets;
  smooth.seam = 0;
  CHECK_THAT(lone_svg(drawing({smooth}), "", ""), Contains("<path fill=\"#123456\" d=") && !Contains("stroke=\""));

  PageColours colours;
  PagePictures page(colours);
  Facets night = facets;
  night.colours = {hex(0x223344), hex(0x334455)};
  CHECK(count(page.svg(drawing({facets}), drawing({night}), ""), "<path") == 2);
  night.corners[0] = {1, 1};
  CHECK(count(page.svg(drawing({facets}), drawing({night}), ""), "<path") == 4);
}

TEST_CASE("lines that fade into the background are as many paths as shades, each where its grid is drawn", "[page]") {
  const auto faint = [](const Theme& in, double share, double y) {
    const Colour &full = in.ink(Role::grid), &ground = in.background;
    const auto part = [&](double Colour::*p) { return ground.*p + share * (full.*p - ground.*p); };
    return line({part(&Colour::r), part(&Colour::g), part(&Colour::b)}, y, 0.4);
  };
  for (const Theme* in : {&light, &dark}) {
    const auto lone = [&](std::vector<Shape> shapes) {
      return count(lone_svg(drawing(std::move(shapes)), "", ""), "<path");
    };
    const Shape a = faint(*in, 0.48, 1), b = faint(*in, 0.2, 2), like_a = faint(*in, 0.45, 3);
    CHECK(lone({a, b, like_a}) == 2);
    CHECK(lone({a, b, line(in->ink(Role::second), 5), like_a}) == 4);
    CHECK(lone({line(in->background, 5)}) == 1);  // a rim, which hides what it crosses
    CHECK(lone({faint(*in, 0.999, 1), line(in->ink(Role::grid), 2, 0.4)}) == 2);
  }
  PageColours colours;
  PagePictures page(colours);
  const std::string svg = page.svg(drawing({faint(light, 0.48, 1), faint(light, 0.2, 2), faint(light, 0.45, 3)}),
                                   drawing({faint(dark, 0.48, 1), faint(dark, 0.2, 2), faint(dark, 0.45, 3)}), "");
  CHECK(count(svg, "<path class=\"line-grid\"") == 2);
  CHECK_THAT(svg, Contains("stroke-opacity=\"0.5\"") && Contains("stroke-opacity=\"0.25\""));
}

TEST_CASE("steps of an outline are told to the hundredth, however far away it lies", "[page]") {
  const auto told = [](const Vec2& to) { return svg_letters({polyline({{0, 0}, to})}); };
  CHECK(told({0.004, -0.006}) == "M0 0l0-0.01");
  CHECK(told({-0.5, 12.25}) == "M0 0l-0.5 12.25");
  CHECK(told({1e6, -1e6}) == "M0 0l1000000-1000000");
  CHECK(told({1e14, 0}) == "M0 0l100000000000000 0");
  CHECK(svg_letters({polyline({{0.333, 0}, {0.666, 0}, {0.999, 0}})}) == "M0.33 0l0.34 0l0.33 0");  // no error grows
}

TEST_CASE("a colour of no role has a number, and the same pair has the same one", "[page]") {
  PageColours colours;
  const PageColour pair = {hex(0x123456), hex(0x654321)}, other = {hex(0x123456), hex(0x654322)};
  CHECK(colours.of("fill", pair) == "fill-paint-11");
  CHECK(colours.of("line", pair) == "line-paint-11");
  CHECK(colours.of("fill", other) == "fill-paint-12");
  CHECK_THAT(colours.variables(false), Contains("--paint-11: #123456; "));
  CHECK_THAT(colours.variables(true), Contains("--paint-11: #654321; "));
}

TEST_CASE("what only one theme draws is seen through in the other, and nothing else is lost", "[page]") {
  PageColours colours;
  PagePictures page(colours);
  const Stroke edge = line(light.ink(Role::text), 20, 7);  // round the highlight, on white only
  const std::string svg =
      page.svg(drawing({line(light.ink(Role::first), 10), edge, line(light.ink(Role::highlight), 20, 5),
                        line(light.ink(Role::second), 30)}),
               drawing({line(dark.ink(Role::first), 10), line(dark.ink(Role::highlight), 20, 5),
                        line(dark.ink(Role::second), 30)}),
               "");
  CHECK(count(svg, "<path") == 4);
  CHECK_THAT(svg, Contains("class=\"line-highlight\"") && Contains("class=\"line-second\""));
  CHECK_THAT(colours.variables(true), Contains(": transparent; "));
  CHECK_THAT(colours.variables(false), !Contains("transparent"));

  PagePictures another(colours);
  const std::string turned = another.svg(drawing({line(light.ink(Role::first), 10)}),
                                         drawing({line(dark.ink(Role::miss), 5), line(dark.ink(Role::first), 10)}), "");
  CHECK(count(turned, "<path") == 2);
  CHECK_THAT(turned, Contains("class=\"line-first\""));
  CHECK_THAT(colours.variables(false), Contains("transparent"));
}

TEST_CASE("opacity is told once where the themes agree, and in the paint where they don't", "[page]") {
  PageColours colours;
  PagePictures page(colours);
  const auto fill = [](const Colour& c) { return Fill{circle({50, 25}, 20), c, 0, 0, {}, {}}; };
  CHECK_THAT(page.svg(drawing({fill(light.ink(Role::hit).with_alpha(0.3))}),
                      drawing({fill(dark.ink(Role::hit).with_alpha(0.3))}), ""),
             Contains("class=\"fill-hit\" fill-opacity=\"0.3\""));
  const std::string svg =
      page.svg(drawing({fill(hex(0).with_alpha(0.2))}), drawing({fill(hex(0).with_alpha(0.6))}), "");
  CHECK_THAT(svg, !Contains("opacity"));
  CHECK_THAT(colours.variables(false), Contains("#00000033"));
  CHECK_THAT(colours.variables(true), Contains("#00000099"));
}

TEST_CASE("texts stay text, with their scripts, and neighbours that look alike are one path", "[page]") {
  PageColours colours;
  PagePictures page(colours);
  const Text text = {"*t*_1 < 2", {10, 20}, 10, light.ink(Role::text), 0.5};
  Text on_dark = text;
  on_dark.colour = dark.ink(Role::text);
  const Colour a = light.ink(Role::grid), b = dark.ink(Role::grid);
  const std::string svg = page.svg(drawing({line(a, 1), line(a, 2), line(a, 3), text}),
                                   drawing({line(b, 1), line(b, 2), line(b, 3), on_dark}), "");
  CHECK_THAT(svg, Contains("<tspan font-style=\"italic\">t</tspan><tspan font-size=\"7\" dy=\"1.6\">1</tspan>") &&
                      Contains("<tspan dy=\"-1.6\"> &lt; 2</tspan>") && Contains("text-anchor=\"middle\""));
  CHECK(count(svg, "<path") == 1);
}

TEST_CASE("an object that was drawn before is referred to, and so is a gradient", "[page]") {
  PageColours colours;
  PagePictures page(colours);
  const auto ball = [](const Theme& theme, double x) {
    const Colour ink = theme.ink(Role::second);
    Drawing d = drawing({Gradient{{x, 25}, {20, 0}, {0, 20}, {x - 5, 20}, ink.with_alpha(0.1), ink.with_alpha(0.3)},
                         Stroke{circle({x, 25}, 20), ink, 2}});
    d.objects = {{"ball", "c", Role::second}};
    assign(d.shapes, 0, 0);
    return d;
  };
  const std::string first = page.svg(ball(light, 50), ball(dark, 50), "");
  CHECK(!page.repeated());
  CHECK_THAT(first, Contains("<g id=\"g1\">") && Contains("fill=\"url(#gradient1)\""));
  const std::string again = page.svg(ball(light, 50), ball(dark, 50), "");
  CHECK(page.repeated());
  CHECK_THAT(again, Contains("<use href=\"#g1\"/>") && !Contains("<path"));
  CHECK_THAT(page.svg(ball(light, 51), ball(dark, 51), ""), Contains("<g id=\"g2\">") && Contains("#gradient2"));
  CHECK(!page.repeated());
  CHECK(count(page.shared(), "<radialGradient") == 2);
  CHECK_THAT(page.shared(), Contains("class=\"stop-second\" stop-opacity=\"0.1\""));
}

TEST_CASE("a picture that stands alone has its own colours and ids, and refers to nothing outside", "[page]") {
  Text name = {"*r*", {20, 20}, 9, light.ink(Role::first)};
  name.halo = 2, name.halo_colour = light.background;
  const Gradient ball = {{50, 25}, {10, 0}, {0, 10}, {50, 25}, hex(0xffffff), hex(0x123456)};
  const std::string svg =
      lone_svg(drawing({line(light.ink(Role::first).with_alpha(0.5), 10), ball, name}), "a > b", "x-");
  CHECK_THAT(svg, Contains("stroke=\"#0b60c8\" stroke-opacity=\"0.5\"") && Contains("fill=\"#0b60c8\"") &&
                      Contains("<defs>") && Contains("id=\"x-gradient1\"") && Contains("url(#x-gradient1)") &&
                      Contains("stop-color=\"#123456\""));
  CHECK(count(svg, "class=") == 1);  // of the whole
  CHECK_THAT(svg, !Contains("<use") && !Contains("var("));
  CHECK(svg.find("<defs>") > svg.find("aria-label"));
}

}  // namespace page_svg_test
