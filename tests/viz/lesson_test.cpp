// Parameters and names: what goes in by text, by hand and by JSON, and how a wrong one is refused.

#include "viz/lesson.h"

#include <cmath>
#include <limits>

#include "tests/catch.h"
#include "tests/viz/toy_lesson.h"

namespace lesson_test {
using namespace isect::viz;
using isect::test::Contains;
using isect::test::toy;

TEST_CASE("the nearest name is the one with the fewest edits", "[lesson]") {
  CHECK(nearest("tangnt", {"two-roots", "tangent", "miss"}) == "tangent");
  CHECK(nearest("Tangent", {"two-roots", "tangent", "miss"}) == "tangent");
  CHECK(nearest("ceter", {"center", "meter"}) == "center");
  CHECK(nearest("gray", {"screen", "print", "grey", "dark"}) == "grey");
  CHECK(nearest("pirnt", {"point", "print"}) == "print");     // swapped neighbours count once
  CHECK(nearest("poly", {"point", "polygon"}) == "polygon");  // its beginning
  CHECK(nearest("eg", {"osmesa", "egl"}) == "egl");
  CHECK(nearest("KDOPS", {"kdop"}) == "kdop");
  CHECK(nearest("anything", {}).empty());
}

TEST_CASE("no name is offered that is far from the word", "[lesson]") {
  CHECK(nearest("", {"a"}).empty());
  CHECK(nearest("list", {"points", "rays", "clipping"}).empty());
  CHECK(nearest("C", {"A", "B"}).empty());
  CHECK(nearest("png", {"pdf", "svg"}).empty());
  CHECK(nearest("purple", {"screen", "print", "grey", "dark"}).empty());
  CHECK(nearest("x", {"points"}).empty());
  CHECK(nearest(std::string(100'000, 'x'), {"point", "print"}).empty());
  CHECK_THAT(unknown("lesson", "list", {"points", "rays"}).what(),
             Contains("\"list\" is unknown; allowed: points, rays"));
}

TEST_CASE("an unknown name is answered with field, word, nearest and all that is allowed", "[lesson]") {
  const std::string what = unknown("theme", "gray", {"print", "grey"}).what();
  CHECK_THAT(what, Contains("theme") && Contains("\"gray\"") && Contains("mean \"grey\"") && Contains("print, grey"));
  CHECK_THAT(unknown("lesson", "x", {}).what(), Contains("lesson") && Contains("none"));
}

TEST_CASE("a preset is found by its id", "[lesson]") {
  CHECK(preset(toy(), "far").title == "far away");
  CHECK_THROWS_WITH(preset(toy(), "fra"), Contains("\"fra\"") && Contains("mean \"far\""));
}

TEST_CASE("set reads numbers, points and choices", "[lesson]") {
  Parameters p = toy().presets[0].parameters;
  set(toy(), p, "radius", "2.5");
  set(toy(), p, "origin", "1,-2e1,+0.5");
  set(toy(), p, "method", "exact");
  CHECK(std::get<double>(p["radius"]) == 2.5);
  CHECK(std::get<Vec3>(p["origin"]) == Vec3(1, -20, 0.5));
  CHECK(std::get<std::string>(p["method"]) == "exact");
}

TEST_CASE("set refuses what is no value of the parameter and changes nothing", "[lesson]") {
  const Parameters before = toy().presets[0].parameters;
  Parameters p = before;
  for (const char* text : {"", "abc", "1,2,3", "1x", " 1", "nan", "inf", "-inf", "1e999", "-1", "101", "0x10", "+-1"}) {
    INFO(text);
    CHECK_THROWS_WITH(set(toy(), p, "radius", text), Contains("radius") && Contains("from 0 to 100"));
  }
  for (const char* text : {"", "1", "1,2", "1,2,3,4", "1,,3", "1,2,x", "1,2,nan", "1,2,51", "1, 2, 3"}) {
    INFO(text);
    CHECK_THROWS_WITH(set(toy(), p, "origin", text), Contains("origin") && Contains("three numbers"));
  }
  CHECK_THROWS_WITH(set(toy(), p, "method", "exat"), Contains("method") && Contains("mean \"exact\""));
  CHECK_THROWS_WITH(set(toy(), p, "radus", "1"), Contains("parameter") && Contains("mean \"radius\""));
  CHECK_THROWS_WITH(set(toy(), p, "r", "1"), "parameter: \"r\" is unknown; r in the pictures is called \"radius\"");
  CHECK(p == before);
}

TEST_CASE("set reads back exactly what to_text writes", "[lesson]") {
  Parameters p = toy().presets[0].parameters;
  for (const double x : {0.1, 1.0 / 3, 5e-324, 99.99999999999999, 1e-17}) {
    set(toy(), p, "radius", to_text(Setting(x)));
    CHECK(std::get<double>(p["radius"]) == x);
  }
  const Vec3 v(0.1, -1.0 / 3, 1e-300);
  set(toy(), p, "origin", to_text(Setting(v)));
  CHECK(std::get<Vec3>(p["origin"]) == v);
  CHECK(to_text(Setting(2.0)) == "2");
  CHECK(to_text(Setting(Vec3(1, 0.5, -2))) == "1,0.5,-2");
}

TEST_CASE("validate wants every parameter, its type and its range, and nothing else", "[lesson]") {
  const Parameters good = toy().presets[0].parameters;
  CHECK_NOTHROW(validate(toy(), good));
  const auto changed = [&](const std::string& name, const Setting& value) {
    Parameters p = good;
    p.insert_or_assign(name, value);
    return p;
  };
  Parameters missing = good;
  missing.erase("origin");
  CHECK_THROWS_WITH(validate(toy(), missing), Contains("origin") && Contains("missing"));
  CHECK_THROWS_WITH(validate(toy(), changed("radius", std::string("x"))), Contains("radius"));
  CHECK_THROWS_WITH(validate(toy(), changed("radius", NAN)), Contains("radius"));
  CHECK_THROWS_WITH(validate(toy(), changed("radius", 100.5)), Contains("radius"));
  CHECK_THROWS_WITH(validate(toy(), changed("origin", 1.0)), Contains("origin"));
  CHECK_THROWS_WITH(validate(toy(), changed("method", std::string("fast"))), Contains("method"));
  CHECK_THROWS_WITH(validate(toy(), changed("method", 1.0)), Contains("method") && Contains("exact"));
  CHECK_THROWS_WITH(validate(toy(), changed("orign", Vec3(0, 0, 0))), Contains("mean \"origin\""));
}

TEST_CASE("dragging a handle moves its parameter and stops at the range's end", "[lesson]") {
  Parameters p = toy().presets[0].parameters;
  const Vec3 anchor(1, 1, 1);
  drag(toy(), p, {"origin", Handle::Kind::point, {}}, Vec3(3, 4, -60));
  CHECK(std::get<Vec3>(p["origin"]) == Vec3(3, 4, -50));
  drag(toy(), p, {.parameter = "origin", .kind = Handle::Kind::vector, .at = {}, .anchor = anchor, .scale = 0.5},
       Vec3(2, 3, 4));
  CHECK(std::get<Vec3>(p["origin"]) == 2 * (Vec3(2, 3, 4) - anchor));
  drag(toy(), p, {"origin", Handle::Kind::vector, {}, anchor}, Vec3(3, 4, 5));
  CHECK(std::get<Vec3>(p["origin"]) == Vec3(2, 3, 4));
  drag(toy(), p, {"radius", Handle::Kind::length, {}, anchor}, Vec3(1, 4, 5));
  CHECK(std::get<double>(p["radius"]) == 5);
  drag(toy(), p, {"radius", Handle::Kind::length, {}, anchor}, Vec3(1, 400, 1));
  CHECK(std::get<double>(p["radius"]) == 100);

  const Parameters before = p;
  drag(toy(), p, {"origin", Handle::Kind::point, {}}, Vec3(NAN, 0, 0));
  CHECK(p == before);
  CHECK_THROWS_AS(drag(toy(), p, {"nothing", Handle::Kind::point, {}}, anchor), BadInput);
}

TEST_CASE("a handle on a line moves one coordinate or a number, within its ends", "[lesson]") {
  Parameters p = toy().presets[0].parameters;
  Handle handle = {.parameter = "origin",
                   .kind = Handle::Kind::on_line,
                   .at = {},
                   .anchor = Vec3(0, 1, 0),
                   .direction = Vec3(0, 2, 0),
                   .axis = 1,
                   .lo = -3,
                   .hi = 7};
  drag(toy(), p, handle, Vec3(9, 3, 9));
  CHECK(std::get<Vec3>(p["origin"]) == Vec3(0.5, 4, 0));
  drag(toy(), p, handle, Vec3(9, 30, 9));
  CHECK(std::get<Vec3>(p["origin"]) == Vec3(0.5, 7, 0));
  handle.parameter = "radius";
  drag(toy(), p, handle, Vec3(9, 2, 9));
  CHECK(std::get<double>(p["radius"]) == 2);
  drag(toy(), p, handle, Vec3(9, -9, 9));  // the parameter's own end comes first
  CHECK(std::get<double>(p["radius"]) == 0);
  const Parameters before = p;
  drag(toy(), p, handle, Vec3(0, 1e308, 0));
  CHECK(std::get<double>(p["radius"]) == 7);
  handle.direction = Vec3(1e308, -1e308, 0);
  p = before;
  drag(toy(), p, handle, Vec3(1e308, 1e308, 0));  // no number
  CHECK(p == before);
}

TEST_CASE("a handle that shifts moves several points as far, and one that turns keeps their lengths", "[lesson]") {
  Lesson lesson = toy();
  lesson.parameters.push_back({.name = "to", .label = "", .help = "Another.", .initial = Vec3(0, 0, 0)});
  Parameters p = lesson.presets[0].parameters;
  p["origin"] = Vec3(0.1, 0.2, 0.3), p["to"] = Vec3(0.7, 5, -1);
  const Vec3 middle(0.5, 2.6, -0.35);
  const Handle whole = {.parameter = "origin",
                        .kind = Handle::Kind::shift,
                        .at = middle,
                        .anchor = middle - Vec3(0.1, 0.2, 0.3),
                        .with = {"to"}};
  const Parameters before = p;
  drag(lesson, p, whole, middle);
  CHECK(p == before);
  drag(lesson, p, whole, Vec3(1.5, 2.6, -0.35));
  CHECK(std::get<Vec3>(p["origin"]) == Vec3(1.1, 0.2, 0.3));  // y and z to the last bit
  CHECK(std::get<Vec3>(p["to"]) == Vec3(1.7, 5, -1));

  p["origin"] = Vec3(2, 0, 0), p["to"] = Vec3(0, 3, 0);
  Handle knob = {.parameter = "origin", .kind = Handle::Kind::turn, .at = {}, .anchor = Vec3(1, 1, 1), .with = {"to"}};
  drag(lesson, p, knob, Vec3(1, 8, 1));
  CHECK(std::get<Vec3>(p["origin"]).isApprox(Vec3(0, 2, 0), 1e-15));
  CHECK(std::get<Vec3>(p["to"]).isApprox(Vec3(-3, 0, 0), 1e-15));
  const Parameters turned = p;
  drag(lesson, p, knob, knob.anchor);  // no direction
  CHECK(p == turned);
  knob.with = {"radius"};  // d of a plane that stays on the anchor
  p["origin"] = Vec3(0, -2, 0), p["radius"] = 0.0;
  drag(lesson, p, knob, Vec3(0, 1, 1));
  CHECK(std::get<Vec3>(p["origin"]).isApprox(Vec3(-2, 0, 0), 1e-15));
  CHECK(std::get<double>(p["radius"]) == Approx(2));

  const Handle opening = {.parameter = "radius",
                          .kind = Handle::Kind::angle,
                          .at = {},
                          .anchor = Vec3(1, 0, 0),
                          .direction = Vec3::UnitX(),
                          .across = Vec3::UnitY(),
                          .scale = 2};
  drag(lesson, p, opening, Vec3(3, 2, 5));
  CHECK(std::get<double>(p["radius"]) == Approx(90));
  drag(lesson, p, opening, Vec3(3, -2, 5));
  CHECK(std::get<double>(p["radius"]) == 0);
}

TEST_CASE("what a lesson's conditions forbid is refused once all is set, and a drag does not go there", "[lesson]") {
  Lesson lesson = toy();
  lesson.conditions = {{"origin", "a point that is not 0",
                        [](const Parameters& p) { return std::get<Vec3>(p.at("origin")).norm() > 0; }}};
  Parameters p = lesson.presets[0].parameters;
  CHECK_NOTHROW(validate(lesson, p));
  set(lesson, p, "origin", "0,0,0");  // what is set next may mend it
  CHECK_THROWS_WITH(validate(lesson, p), "origin: \"0,0,0\" is not allowed; give a point that is not 0");

  p = lesson.presets[0].parameters;
  drag(lesson, p, {"origin", Handle::Kind::point, {}}, Vec3(0, 0, 0));
  CHECK(p == lesson.presets[0].parameters);
  drag(lesson, p, {"origin", Handle::Kind::point, {}}, Vec3(0, 0, 1));
  CHECK(std::get<Vec3>(p["origin"]) == Vec3(0, 0, 1));
}

TEST_CASE("a flat lesson opens straight on, whatever its camera says", "[lesson]") {
  Lesson lesson = toy();
  lesson.camera.perspective = true;
  CHECK(opening(lesson).azimuth == lesson.camera.azimuth);
  CHECK(opening(lesson).perspective);
  lesson.flat = true;
  CHECK(opening(lesson).azimuth == 0);
  CHECK(opening(lesson).elevation == 0);
  CHECK_FALSE(opening(lesson).perspective);
}

TEST_CASE("what a parameter takes is told in words", "[lesson]") {
  CHECK(wanted(toy().parameters[0]) == "a number from 0 to 100");
  CHECK(wanted(toy().parameters[1]) == "three numbers, each from -50 to 50, such as 0,0,0");
  CHECK(wanted(toy().parameters[2]) == "one of quick, exact");
}

TEST_CASE("numbers are shown with about five digits, a real minus and thin spaces", "[lesson]") {
  CHECK(shown(0) == "0");
  CHECK(shown(-0.0) == "0");
  CHECK(shown(2) == "2");
  CHECK(shown(-1.5) == "−1.5");
  CHECK(shown(1.0 / 3) == "0.33333");
  CHECK(shown(4.4721359) == "4.4721");
  CHECK(shown(100) == "100");
  CHECK(shown(9.99999) == "10");
  CHECK(shown(99999.7) == "100\u2009000");
  CHECK(shown(26654) == "26\u2009654");
  CHECK(shown(1234567) == "1\u2009234\u2009567");
  CHECK(shown(0.00012345) == "0.00012345");
  CHECK(shown(1.5e-7) == "1.5\u2009·\u200910⁻⁷");
  CHECK(shown(-1e300) == "−1\u2009·\u200910³⁰⁰");
  CHECK(shown(std::numeric_limits<double>::infinity()) == "∞");
  CHECK(shown(-std::numeric_limits<double>::infinity()) == "−∞");
  CHECK(shown(NAN) == "NaN");
}

}  // namespace lesson_test
