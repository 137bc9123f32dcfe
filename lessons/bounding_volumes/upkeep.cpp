#include "lessons/bounding_volumes/upkeep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "viz/chart/chart.h"

namespace isect::lessons::bounding_volumes_lesson {

using namespace viz;

namespace {

using Number = Counted<double>;
using Three = Vector<Number, 3>;

/// The operations of a run.
template <class Run>
int operations_of(const Run& run) {
  const Tally before = tally();
  tally() = {};
  run();
  const Tally t = tally();
  tally() = before;
  return t.mul + t.add + t.div + t.sqrt + t.compare;
}

/// The vector turned by a matrix with these rows. What turn it is makes no difference to the count.
Three turned(const Three& v) {
  const Three rows[] = {
      {Number(0.6), Number(-0.8), Number(0)}, {Number(0.8), Number(0.6), Number(0)}, {Number(0), Number(0), Number(1)}};
  return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)};
}

const Vec3 shift = {0.5, 0.25, -0.125};

}  // namespace

Upkeep upkeep(const Obb<double, 3>& box, const Measured& m) {
  const Three center = box.center.cast<Number>();
  const auto turn = [&] {
    turned(center);
    for (int i = 0; i < 3; ++i) turned(box.axes.col(i).cast<Number>());
  };
  const auto move = [&] {
    for (int i = 0; i < 3; ++i) static_cast<void>(center[i] + Number(shift[i]));
  };
  return {m.name, operations_of(turn), operations_of(move), m.operations()};
}

Upkeep upkeep(const Kdop<double, 3>& kdop, const std::vector<Vec3>& vertices, const Measured& m) {
  const auto turn = [&] {
    for (const Vec3& normal : kdop.normals) {
      const Three n = turned(normal.cast<Number>());  // into the frame of the object, whose vertices stay
      Number lo = n.dot(vertices.front().cast<Number>()), hi = lo;
      for (std::size_t i = 1; i < vertices.size(); ++i) {
        const Number along = n.dot(vertices[i].cast<Number>());
        lo = std::min(lo, along), hi = std::max(hi, along);
      }
    }
  };
  const auto move = [&] {
    for (std::size_t i = 0; i < kdop.slabs.size(); ++i) {
      const Number by = Three(kdop.normals[i].cast<Number>()).dot(Three(shift.cast<Number>()));
      static_cast<void>(Number(kdop.slabs[i].lo) + by), static_cast<void>(Number(kdop.slabs[i].hi) + by);
    }
  };
  return {m.name,
          operations_of(turn),
          operations_of(move),
          m.operations(),
          static_cast<int>(kdop.normals.size()),
          static_cast<int>(vertices.size())};
}

int tests_to_pay(int early_update, int early_test, int late_update, int late_test) {
  return std::max(0, late_update - early_update) / (early_test - late_test) + 1;
}

namespace {

/// The operations of both over the tests to each update, where the object turns.
Chart upkeep_chart(const Upkeep& obb, const Upkeep& kdop) {
  const double most = 2.0 * tests_to_pay(obb.turn, obb.test, kdop.turn, kdop.test);
  Plot plot;
  plot.series = {{"", Glyph::square, Role::second, 0}, {"", Glyph::disc, Role::first, 1}};
  Panel panel;
  int series = 0;
  double greatest = 0;
  for (const Upkeep* x : {&obb, &kdop}) {
    const double end = x->turn + x->test * most;
    panel.curves.push_back({series++, {Vec2(0, 1.0 * x->turn), Vec2(most, end)}, x->name});
    greatest = std::max(greatest, end);
  }
  plot.x = {Scale::Kind::linear, 0, most, "tests to each update"};
  plot.y = {Scale::Kind::linear, 0, 1.1 * greatest, "operations: one update and the tests"};
  plot.panels = {panel};
  return {plot};
}

}  // namespace

void tell_upkeep(Script& script, const Upkeep& obb, const Upkeep& dop) {
  const int turning = tests_to_pay(obb.turn, obb.test, dop.turn, dop.test);
  const int shifting = tests_to_pay(obb.shift, obb.test, dop.shift, dop.test);
  Step& step = script.add("upkeep", "Update against test", 3,
                          fmt::format("The object turns. The OBB turns its centre and axes: {}. The {} finds its "
                                      "extremes anew among {} hull vertices, along {} normals: {}.\n"
                                      "A test that finds an overlap takes {} and {}. So the {} costs less from {} to "
                                      "each update on; below that, the OBB does.\n"
                                      "An object that is only shifted takes {} and {}: there {} will do.",
                                      plural(obb.turn, "operation"), dop.name, dop.vertices, dop.normals,
                                      plural(dop.turn, "operation"), obb.test, dop.test, dop.name,
                                      plural(turning, "test"), obb.shift, dop.shift, plural(shifting, "test")));
  step.scene.chart = std::make_shared<const Chart>(upkeep_chart(obb, dop));
  step.question =
      which_count(fmt::format("The object turns between tests that find overlaps. From how many tests to each update "
                              "on does the {} cost less than the OBB?",
                              dop.name),
                  turning,
                  {{1, "One test does not save what the update costs more."},
                   {std::round(1.0 * dop.turn / dop.test), "That divides one update by one test of the same volume."},
                   {std::round(1.0 * dop.turn / obb.turn), "That compares the updates alone, without the tests."}},
                  fmt::format("Its update costs {} more, and each test saves {}.", shown(1.0 * dop.turn - obb.turn),
                              shown(1.0 * obb.test - dop.test)));
  for (const Upkeep* x : {&obb, &dop}) {
    step.question->given.push_back({x->name + ": update", 1.0 * x->turn});
    step.question->given.push_back({x->name + ": test", 1.0 * x->test});
  }
  keep_picture(script.walk());
}

}  // namespace isect::lessons::bounding_volumes_lesson
