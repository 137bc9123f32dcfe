// Figures side by side: what stands where, and nothing meets.

#include "viz/compose/strip.h"

#include <set>

#include "tests/catch.h"

namespace strip_test {
using namespace isect::viz;

namespace {

constexpr double gap = 10;

Frame frame(double width, double height, const std::string& caption) {
  Figure f = {{width, height, {}, {}}, {}, View({}, width, height)};
  Stroke line{polyline({{0, 0}, {width, height}}), {0, 0, 1, 1}, 1};
  line.object = add_object(f.drawing.objects, {"line", "a", Role::first});
  f.drawing.shapes.push_back(line);
  f.labels.push_back({"a", {1, 1, 5, 5}});
  return {f, caption};
}

Vec2 start(const Drawing& d, int line) {
  for (const Shape& shape : d.shapes)
    if (const Stroke* s = std::get_if<Stroke>(&shape); s && line-- == 0) return s->path.start;
  return {};
}

}  // namespace

TEST_CASE("a strip sets figures in rows on one line, captions below", "[strip]") {
  const Theme theme = paper_theme(ThemeName::print, 9);
  const Strip s = strip({frame(100, 60, "one"), frame(100, 40, "two"), frame(100, 50, "three")}, 2, theme, gap);
  CHECK(s.drawing.width == 210);
  CHECK(start(s.drawing, 0) == Vec2(0, 0));
  CHECK(start(s.drawing, 1) == Vec2(110, 20));  // it ends where its taller neighbour does
  const double second_row = start(s.drawing, 2).y();
  CHECK(second_row > 60 + theme.sizes.label + gap);
  CHECK(s.drawing.height > second_row + 50 + theme.sizes.label);
  CHECK(label_faults(s.drawing, s.labels).empty());
  CHECK(s.labels.size() == 6);
  CHECK(s.labels[2].box.left == 111);
  CHECK(s.labels[1].text == "(a) one");
}

TEST_CASE("objects of a strip keep their names and are numbered through", "[strip]") {
  const Theme theme = paper_theme(ThemeName::print, 9);
  const Strip s = strip({frame(50, 50, "x"), frame(50, 50, "y")}, 2, theme, gap);
  std::set<std::string> names;
  for (const Object& object : s.drawing.objects) names.insert(full_name(object));
  CHECK(names.size() == s.drawing.objects.size());
  CHECK(names.contains("line a"));
  CHECK(names.contains("line a #2"));
  std::set<int> used;
  for (const Shape& shape : s.drawing.shapes) used.insert(object_of(shape));
  CHECK(used.size() == 4);
  CHECK_FALSE(used.contains(no_object));
}

TEST_CASE("long captions wrap below their figure, and one figure alone has no letter", "[strip]") {
  const Theme theme = paper_theme(ThemeName::print, 9);
  const Strip s =
      strip({frame(90, 50, "a caption that goes on for more than ninety points of width"), frame(90, 50, "b")}, 2,
            theme, gap);
  CHECK(label_faults(s.drawing, s.labels).empty());
  CHECK(s.labels.size() > 5);
  for (const PlacedLabel& label : s.labels) CHECK((label.box.right <= 90 || label.box.left >= 100));
  CHECK(strip({frame(90, 50, "b")}, 1, theme, gap).labels[1].text == "b");
}

}  // namespace strip_test
