// What the lesson of moving bodies says on the way, step by step, is what rational arithmetic says.

#include <algorithm>
#include <cmath>

#include "lessons/moving_bodies/telling.h"
#include "tests/catch.h"
#include "tests/lessons/moving_oracle.h"

namespace moving_steps_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using namespace isect::tests::moving;

TEST_CASE("the times told of an axis are those at which its extents share points", "[words]") {
  int axes = 0, latest = 0, asked = 0;
  over_settings("boxes", 300, [&](const Parameters& p, const Walk& walk) {
    const Step& last = ending(walk);
    for (const int i : {0, 1}) {
      const std::string axis(1, "xy"[i]), name = "*" + axis + "*";
      const Times times = on_axis(p, i);
      if (const Step* s = find(walk, "times-" + axis)) {
        ++axes;
        const double begin = value(*s, "*t*_1 on " + name);
        CHECK(begin == Approx(static_cast<double>(times.in)).margin(1e-12));
        CHECK(value(*s, "*t*_2 on " + name) == Approx(static_cast<double>(times.out)).margin(1e-12));
        CHECK(says(s->caption, "A negative time") == (begin < 0));
      }
      if (const Step* s = find(walk, "level-" + axis)) CHECK(says(s->caption, "are apart") == !times.meet());
      if (!says(last.caption, "latest begin is that of " + name)) continue;
      ++latest;
      CHECK(times.in >= on_axis(p, 1 - i).in);
    }
    const Step* decision = find(walk, "decision");
    if (!decision || !decision->question) return;
    ++asked;
    const Times all = boxes(p, 0, number(p, "duration"));
    CHECK((answer(*decision) == "not within the motion") == !all.meet());
    if (all.meet()) CHECK(shows(answer(*decision), static_cast<double>(all.in)));
  });
  CHECK((axes > 200 && latest > 20 && asked > 30));
}

TEST_CASE("a distance is said to have fallen where it has", "[words]") {
  int fallen = 0, risen = 0;
  const auto look = [&](const Walk& walk) {
    for (int k = 2;; ++k) {
      const Step* const before = find(walk, "advance-" + std::to_string(k - 1));
      const Step* const now = find(walk, "advance-" + std::to_string(k));
      if (!before || !now) return;
      const bool falls = value(*now, "distance") < value(*before, "distance");
      CHECK(says(now->caption, "has fallen to") == falls);
      CHECK(says(now->caption, "has not fallen") == !falls);
      (falls ? fallen : risen) += 1;
    }
  };
  over_settings("conservative", 300, [&](const Parameters&, const Walk& walk) { look(walk); });
  look(with("moving-bodies", "steps", {{"v_a", "-1,0,0"}, {"v_b", "1,0,0"}}));
  CHECK((fallen > 5 && risen > 0));
}

TEST_CASE("the signs that lead to first contact of balls are told as they are, or rounding is owned", "[words]") {
  int rounded = 0;
  over_settings("balls", 400, [&](const Parameters& p, const Walk& walk) {
    const Balls truth(p);
    const auto sign_is = [&](const char* slug, int sign) {
      const Step* s = find(walk, slug);
      if (!s) return;
      INFO(slug << ": " << s->caption);
      if (says(s->caption, "Rounding")) {
        ++rounded;
        return;
      }
      CHECK(says(s->caption, "It is positive") == (sign > 0));
      CHECK(says(s->caption, "It is negative") == (sign < 0));
      CHECK(says(s->caption, "It is zero") == (sign == 0));
    };
    sign_is("coefficient-c", truth.c.sign());
    if (truth.c > 0) sign_is("coefficient-b", truth.b.sign());
    if (truth.c > 0) sign_is("discriminant", truth.discriminant().sign());
    const Step& last = ending(walk);
    if (last.line == 7 && !says(last.caption, "Rounding")) CHECK(truth.b >= 0);
    if (last.line == 10 && !says(last.caption, "Rounding")) CHECK(truth.discriminant() < 0);
  });
  CHECK(rounded > 0);
}

TEST_CASE("boxes are said to tunnel where their contact lies between two tests, and nowhere else", "[words]") {
  int tunnels = 0, seen = 0, none = 0;
  over_settings("discrete", 400, [&](const Parameters& p, const Walk& walk) {
    const int tests = static_cast<int>(std::round(number(p, "tests")));
    const double duration = number(p, "duration");
    const Times ever = boxes(p, -long_after, long_after), times = boxes(p, 0, duration);
    bool found = false;
    for (int k = 0; k <= tests; ++k) {
      const Rational t = Rational(duration) * k / tests;
      if (abs(t - ever.in) < Rational(1e-9) || abs(t - ever.out) < Rational(1e-9)) return;  // rounding decides
      found = found || (ever.in < t && t < ever.out);
    }
    const Step& last = ending(walk);
    CAPTURE(last.caption);
    CHECK(says(last.caption, "this is tunnelling") == (times.meet() && !found));
    if (const Step* s = find(walk, "how-close")) {
      const double length = value(*s, "*t*_{out} − *t*_{in}");
      CHECK(length == Approx(static_cast<double>(Rational(times.out - times.in))).margin(1e-9));
      CHECK(s->comparison->left == Approx(duration / tests));
      CHECK(says(s->caption, "Here one falls into it") ==
            (found && s->comparison->left > length && times.in > 0 && times.out < Rational(duration)));
    }
    ++(!times.meet() ? none : found ? seen : tunnels);
  });
  CHECK((tunnels > 5 && seen > 20 && none > 20));
}

TEST_CASE("conservative steps end within the tolerance before the contact, or where there is none", "[words]") {
  int near = 0, none = 0, near_misses = 0;
  over_settings("conservative", 300, [&](const Parameters& p, const Walk& walk) {
    const Balls truth(p);
    const bool met = meet(p, number(p, "duration"));
    const double reach = number(p, "r_a") + number(p, "r_b");
    const Step& last = ending(walk);
    CAPTURE(last.caption);
    if (last.line == 7 || last.line == 9) {
      CHECK((!met || says(last.caption, "Rounding")));
      ++none;
    }
    if (last.line != 4) return;
    double t = 0;
    for (const Value& v : find(walk, "near")->values)
      if (v.name == "*t*") t = v.value;
    const double distance = std::sqrt(std::max(0.0, static_cast<double>(truth.at(t)) + reach * reach)) - reach;
    CHECK(distance <= number(p, "tolerance") + 1e-9);
    if (met && truth.c > 0) CHECK(t <= truth.first() * (1 + 1e-9));
    CHECK(says(last.caption, "Yet they do not meet") == !met);
    ++(met ? near : near_misses);
  });
  CHECK((near > 20 && none > 20 && near_misses > 0));
}

TEST_CASE("along the centres there are fewer steps than with the whole speed, on the presets", "[words]") {
  namespace moving_bodies = lessons::moving_bodies_lesson;
  for (const char* preset_id : {"steps", "steps-graze"}) {
    const auto steps = [&](const char* bound) {
      Parameters p = preset(lesson(id), preset_id).parameters;
      p["bound"] = std::string(bound);
      const auto s = moving_bodies::setup(p);
      return advance_conservatively(s.ball_a(), s.ball_b(), s.duration, s.tolerance, s.bound, moving_bodies::most_steps)
          .steps;
    };
    INFO(preset_id);
    CHECK(steps("centres") < steps("speed"));
  }
}

}  // namespace moving_steps_words_test
