#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/picking/picture.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::picking_lesson {

using namespace viz;
using namespace viewing;

namespace {

const std::vector<std::string> pseudocode = {
    "ray ← from the eye through the pointer",          // 0
    "for each object whose bounding ball it meets",    // 1
    "    t ← where it meets the object itself first",  // 2
    "    keep it if t is less; at a tie, the first",   // 3
    "return the object kept, if any"                   // 4
};

class Teller {
 public:
  explicit Teller(const Vec3& pointer)
      : s_(pointer),
        script_(
            {"Lecture note, picking, bounding volumes and rays",
             "The eye's image of a crate, a gem and two balls, in pixels, with a ring at the pointer. Its viewing ray, "
             "drawn below as a *t*-axis, picks " +
                 (s_.truth ? std::string(s_.world.object(s_.truth->primitive).name) : std::string("nothing")) + ".",
             pseudocode}) {}

  Walk tell() {
    step("pointer", "What is under the pointer?", 0,
         "The user points at the image plane and means what the eye sees there.");
    known_.ray = true;
    const Vec2 at = s_.eye.pixel(s_.pointer);
    const double half = s_.eye.rows / 2.0, right = tidy(at.x() - s_.eye.columns / 2.0), up = tidy(half - at.y());
    step(
        "viewing-ray", "The pointer's pick ray", 0,
        fmt::format(
            "The pointer is {} pixels {} of the image's centre and {} {} it. Half the field of view, *φ*/2, spans half "
            "the image's height: {} pixels.\n"
            "Everything seen at this point lies on the ray from the eye **o** along **d**, through the pointer.\n"
            "**forward** is the way the eye looks; **right** and **up** are the image's axes. All three have length 1.",
            shown(std::abs(right)), right < 0 ? "left" : "right", shown(std::abs(up)), up < 0 ? "below" : "above",
            shown(half)),
        fmt::format("**d** ∥ **forward** + tan(*φ*/2) (({}/{}) **right** + ({}/{}) **up**)", shown(right), shown(half),
                    shown(up), shown(half)));
    volumes();
    for (int i = 0; i < s_.size(); ++i)
      if (s_.met(i)) object(i);
    picked();
    return std::move(script_.walk());
  }

 private:
  /// Removes the rounding of the eye's view; a thousandth of a pixel is fine enough.
  static double tidy(double pixels) { return std::round(1000 * pixels) / 1000 + 0.0; }

  std::string name(int i) const { return s_.world.object(i).name; }

  Step& step(const std::string& slug, const std::string& title, int line, const std::string& caption,
             const std::string& formula = {}) {
    Step& s = script_.add(slug, title, line, caption, formula);
    s.scene = picture(s_, known_);
    return s;
  }

  /// The ray tests, bounding balls first. A ball is its own bounding ball, so it takes one test.
  int tests(const Ray3& ray) const {
    int sum = 0;
    for (int i = 0; i < s_.size(); ++i) {
      const int own = tests_of(s_.world.object(i).shape);
      sum += 1 + (own > 1 && first_hit(ray, s_.balls[i]) ? own : 0);
    }
    return sum;
  }

  void volumes() {
    known_.volumes = true;
    int all = 0, left = 0;
    for (int i = 0; i < s_.size(); ++i) all += tests_of(s_.world.object(i).shape), left += s_.met(i);
    const int few = tests(s_.ray);
    script_.value("tests, balls first", few, "tests", Role::hit);
    script_.value("tests without", all, "tests");
    if (left == 0) script_.leave_early();
    const std::string cost = few < all ? fmt::format("\nThat takes {} tests, and {} without the balls.", few, all)
                                       : "\nBoth large objects are left: here the balls cost more than they save.";
    Step& s = step(
        "volumes", "Bounding balls first", 1,
        (left == 0 ? "The ray meets no bounding ball: nothing is there."
                   : fmt::format("A ray that misses the ball around an object, drawn as a circle, misses the object. "
                                 "{} of {} objects {} left.",
                                 left, s_.size(), left == 1 ? "is" : "are")) +
            cost);
    s.decides = true;
    s.question = {fmt::format("The bounding balls' radii, and how far their centres are off the ray: {}. How many "
                              "objects need a closer look?",
                              radii_and_distances()),
                  {},
                  left,
                  "Those whose bounding ball the ray meets."};
    for (int i = 0; i <= s_.size(); ++i) s.question->choices.push_back(std::to_string(i));
    ask_for_number(*s.question, left, 0,
                   {{static_cast<double>(s_.size() - left), "That is how many are ruled out."},
                    {static_cast<double>(left - touched()), "A ball that the ray only touches is met, too."},
                    {static_cast<double>(s_.size()), "That looks at every object: the balls would rule out none."},
                    {left > 1 ? 1.0 : left, "Only one is picked, but each whose ball is met may be it."}});
    keep_picture(script_.walk());
  }

  /// How far the centre of a bounding ball is off the ray.
  double off_ray(const Sphere<double, 3>& ball) const {
    const Vec3 d = s_.ray.direction, l = ball.center - s_.ray.origin;
    return (l - std::max(l.dot(d) / d.squaredNorm(), 0.0) * d).norm();
  }
  /// How many bounding balls the ray meets, but only touches, as far as one can read.
  int touched() const {
    int sum = 0;
    for (int i = 0; i < s_.size(); ++i) sum += s_.met(i) && shown(off_ray(s_.balls[i])) == shown(s_.balls[i].radius);
    return sum;
  }

  /// "1.5 and 0.3 (the crate), ..."
  std::string radii_and_distances() const {
    std::string all;
    for (int i = 0; i < s_.size(); ++i) {
      const Sphere<double, 3>& ball = s_.balls[i];
      const double off = off_ray(ball);
      all += fmt::format("{}{} and {} ({})", i > 0 ? ", " : "", digits(ball.radius, off), digits(off, ball.radius),
                         name(i));
    }
    return all;
  }

  void object(int i) {
    const std::optional<double> t = first_hit(s_.ray, s_.world.object(i).shape);
    const bool first = t && (known_.kept < 0 || *t < known_.kept_t);
    const bool tie = t && known_.kept >= 0 && *t == known_.kept_t;
    if (t) script_.value(fmt::format("*t* of {}", name(i)), *t, "t", first ? Role::hit : Role::muted);
    if (t) known_.hits.emplace_back(i, *t);
    const double before = known_.kept_t;
    const bool had = known_.kept >= 0;
    if (first) known_.kept = i, known_.kept_t = *t;
    Step& s = step(fmt::format("object-{}", i), fmt::format("Does it meet {}?", name(i)), first ? 3 : 2,
                   !t      ? "The ray passes through the bounding ball's void, and misses the object."
                   : tie   ? "The ray hits it at the same *t* as the one kept: a tie. The first of the two, in their "
                             "order, is kept."
                   : !had  ? "The first one met. It is kept, until one is met at a smaller *t*."
                   : first ? "This one is nearer: it hides the one kept so far, and takes its place."
                           : "The ray hits it too, but farther away. The one kept hides it.",
                   t ? "*t* = " + shown(*t) : "no *t*");
    if (t && had)
      Script::decide(s, {"*t* < smallest *t*", *t, before, first, first ? "nearer" : tie ? "a tie" : "farther"});
    // misconceptions: the last one met is kept; a bounding ball that is met is enough
    Question q = {fmt::format("The ray meets the bounding ball of {}{}. Which object is kept then?", name(i),
                              t ? "" : ", but not the object itself"),
                  {},
                  0,
                  !t ? "It misses the object itself." : "Its *t* is compared with the smallest so far."};
    for (int k = 0; k <= i; ++k)
      if (s_.met(k)) q.choices.push_back(name(k));
    q.choices.emplace_back("none yet");
    const std::string kept = known_.kept < 0 ? "none yet" : name(known_.kept);
    q.answer = static_cast<int>(std::ranges::find(q.choices, kept) - q.choices.begin());
    if (t) q.given = {{fmt::format("*t* of {}", name(i)), *t, "t", Role::text}};
    s.question = q;
  }

  void picked() {
    if (s_.truth) {
      const int i = s_.truth->primitive;
      const bool tie = std::ranges::count_if(known_.hits, [&](const auto& h) { return h.second == s_.truth->t; }) > 1;
      script_.settle(tie ? Verdict::Kind::on : Verdict::Kind::yes, "picked: " + name(i) + (tie ? ", after a tie" : ""));
      last(tie ? "Both objects are met in one point, where they touch. A rule must choose: the first in "
                 "their list.\n"
                 "With *t* alone, whichever is tested first would stay, and that may change."
               : "The nearest object is the one that the eye sees under the pointer, at the ring.\n" + hidden(),
           "least *t* = " + shown(s_.truth->t));
    } else {
      script_.settle(Verdict::Kind::no, "nothing is picked");
      last("No object is hit, so the pointer is on the background: a click there may deselect.", "");
    }
  }

  /// A sentence on what the ray meets behind the object kept.
  std::string hidden() const {
    const auto behind = static_cast<int>(known_.hits.size()) - 1;
    if (behind == 0) return "The ray meets no other, so nothing is hidden behind it here.";
    if (behind > 1) return "Those behind it cannot be picked here, though the ray meets them.";
    const int other = known_.hits[known_.hits[0].first == known_.kept ? 1 : 0].first;
    return fmt::format("The ray meets {} too, but behind it: so {} cannot be picked here.", name(other), name(other));
  }

  /// The mean over all pixels. Computed once, as neither eye nor objects move.
  double mean_tests() const {
    static const double mean = [&] {
      int sum = 0;
      for (int y = 0; y < s_.eye.rows; ++y)
        for (int x = 0; x < s_.eye.columns; ++x) sum += tests(s_.eye.through(s_.eye.on_plane({x + 0.5, y + 0.5})));
      return 1.0 * sum / (s_.eye.rows * s_.eye.columns);
    }();
    return mean;
  }

  void last(const std::string& caption, const std::string& formula) {
    script_.value("tests, mean of all pixels", mean_tests(), "tests");
    script_.add("picked", "What the eye sees there", 4, caption, formula).scene = seen(s_, known_);
  }

  const Pointed s_;
  Script script_;
  Known known_;
};

}  // namespace

Walk tell(const Vec3& pointer) { return Teller(pointer).tell(); }

}  // namespace isect::lessons::picking_lesson
