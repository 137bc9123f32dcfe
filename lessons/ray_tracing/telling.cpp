#include <fmt/format.h>

#include <cmath>

#include "lessons/ray_tracing/picture.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::ray_tracing_lesson {

using namespace viz;
using namespace viewing;

namespace {

const std::vector<std::string> pseudocode = {
    "for each pixel: ray ← from the eye through the pixel",  // 0
    "    hit ← the object met at the least t ≥ 0",           // 1
    "    if there is none: the colour of the sky",           // 2
    "    n ← its normal at the hit, l ← towards the light",  // 3
    "    if n · l ≤ 0: dim, it faces away from the light",   // 4
    "    if anything stands between hit and light: dim",     // 5
    "    else: as bright as n · l says"                      // 6
};

class Teller {
 public:
  explicit Teller(const OnePixel& one)
      : s_(one),
        script_({"Lecture note, ray tracing; Appel, AFIPS Spring Joint Computer Conference (1968)",
                 "What the eye sees of balls, a box and a floor, in pixels, with a frame round the one asked about. " +
                     outcome() + ".",
                 pseudocode}) {}

  Walk tell() {
    step("picture-plane", "A picture of pixels", 0,
         "The eye looks at a scene through a plane of 48 × 36 pixels. What is seen through each of them?", {});
    shown_.ray = true;
    const Vec3 d = s_.ray.direction / s_.ray.direction.x();  // forward by 1
    const double across = (s_.column + 0.5) / (columns / 2.0) - 1, up = 1 - (s_.row + 0.5) / (rows / 2.0);
    step("ray", "One primary ray through one pixel", 0,
         fmt::format(
             "Pixel ({}, {}) has its middle {} half widths {} of the centre, and {} half heights {} it. With the field "
             "of view *φ*, from top to bottom, **d** = **forward** + *u* **right** + *v* **up**.\n"
             "Light travels the other way, but little of it reaches the eye. So rays are traced backwards.",
             s_.column, s_.row, shown(std::abs(across)), across < 0 ? "left" : "right", shown(std::abs(up)),
             up < 0 ? "below" : "above"),
         fmt::format("*u* = {} · tan(*φ*/2) · {}/{} = {},  *v* = {} · tan(*φ*/2) = {}", shown(across), columns, rows,
                     shown(d.z()), shown(up), shown(d.y())));
    closest();
    if (s_.traced.hit) shade();
    image();
    return std::move(script_.walk());
  }

 private:
  std::string name() const { return s_.world.object(s_.traced.hit->primitive).name; }

  std::string outcome() const {
    if (!s_.traced.hit) return "The pixel shows the sky";
    if (!(s_.traced.cosine > 0)) return "The pixel shows a side that does not face the light source";
    if (s_.acne) return "The pixel shows a point that rounding puts into its own object's shadow";
    return s_.traced.blocker ? "The pixel shows a point in shadow" : "The pixel shows a point that is lit";
  }

  Step& step(const std::string& slug, const std::string& title, int line, const std::string& caption,
             const std::string& formula) {
    Step& s = script_.add(slug, title, line, caption, formula);
    s.scene = picture(s_, shown_);
    return s;
  }

  void closest() {
    int met = 0;
    std::vector<Value> given;
    for (const Object& o : s_.world.objects)
      if (const std::optional<double> t = first_hit(s_.ray, o.shape)) {
        ++met;
        given.push_back({std::string("*t* of ") + o.name, *t, "t", o.role});
        script_.value(std::string("*t* of ") + o.name, *t, "t", o.role);
      }
    shown_.hits = true;
    script_.value("objects met", met);
    if (!s_.traced.hit) script_.settle(Verdict::Kind::no, "the ray meets nothing: sky");
    Step& s = step(
        "closest", "The closest hit", s_.traced.hit ? 1 : 2,
        !s_.traced.hit ? "The ray meets none of the objects, so the pixel shows the sky."
        : met == 1
            ? "The ray hits only one object: the eye sees it at the smallest *t* ≥ 0."
            : fmt::format("The ray meets {} objects. The one at the smallest *t* ≥ 0 hides the others: the eye sees "
                          "the first one only.",
                          met),
        s_.traced.hit ? "*t* = " + shown(s_.traced.hit->t) : "");
    s.decides = true;
    Question q = {
        met > 0 ? "What does the pixel show?" : "The ray meets none of the objects. What does the pixel show?",
        {},
        0,
        "The object hit at the smallest *t* ≥ 0."};
    q.given = std::move(given);
    for (const Object& o : s_.world.objects) q.choices.emplace_back(o.name);
    q.choices.emplace_back("the sky");
    q.answer = s_.traced.hit ? s_.traced.hit->primitive : static_cast<int>(s_.world.objects.size());
    s.question = q;
    keep_picture(script_.walk());
  }

  void shade() {
    shown_.normal = true;
    const double cosine = s_.traced.cosine;
    const bool away = !(cosine > 0);
    script_.value("**n** · **l**", cosine, "light");
    Step& s = step("normal", away ? "It does not face the light" : "How it faces the light", away ? 4 : 3,
                   away ? "Normal **n** and direction **l** to the light make a right angle or more. No shadow ray is "
                          "needed."
                        : "**n** and **l** have length 1, so **n** · **l** is the cosine of the angle of incidence.\n"
                          "A matt surface reflects light in proportion to it (Lambert's law).",
                   "**n** · **l** = " + shown(cosine));
    Script::decide(
        s, {"**n** · **l** ≤ 0", cosine, 0, away, away ? "it does not face the light" : "it faces the light source"});
    // misconception: what faces the light is lit
    s.question =
        Question{fmt::format("**n** = {} points away from the surface, **l** = {} to the light source. What does "
                             "**n** · **l** tell?",
                             coordinates(s_.traced.normal), coordinates(s_.traced.to_lamp.normalized())),
                 {"dim: it faces away", "a shadow ray is needed", "lit: it faces the light source"},
                 away ? 0 : 1,
                 "The sign of **n** · **l** decides."};
    if (!away) shadow();
    script_.value("brightness", s_.traced.brightness, "light", Role::highlight);
    const bool lit = !away && !s_.traced.blocker;
    script_.settle(lit ? Verdict::Kind::yes : Verdict::Kind::no,
                   away      ? fmt::format("{}, turned away from the light", name())
                   : s_.acne ? fmt::format("{}, in its own shadow: wrong, by rounding", name())
                   : s_.traced.blocker
                       ? fmt::format("{}, in the shadow of {}", name(), s_.world.object(*s_.traced.blocker).name)
                       : fmt::format("{}, lit", name()));
  }

  /// The number of objects that the line from the point towards the light meets up to t = `far` (the light is at 1).
  /// The object itself counts only if the shadow ray tests it.
  int between(double far) const {
    const int own = s_.start == ShadowRay::naive ? -1 : s_.traced.hit->primitive;
    int met = 0;
    for (int i = 0; i < static_cast<int>(s_.world.objects.size()); ++i)
      met +=
          i != own && first_hit({s_.traced.point, s_.traced.to_lamp, {0, far}}, s_.world.object(i).shape).has_value();
    return met;
  }

  void shadow() {
    shown_.shadow_ray = true;
    const bool blocked = s_.traced.blocker.has_value();
    Step& s = step("shadow", "A shadow ray", blocked ? 5 : 6, shadow_caption(),
                   blocked ? "*I* = *I*_a = " + shown(ambient)
                           : "*I* = *I*_a + (1 − *I*_a) **n** · **l** = " + shown(s_.traced.brightness) +
                                 ", ambient light *I*_a = " + shown(ambient));
    s.decides = true;
    s.question = which_count(
        fmt::format("How many {}objects does the segment from the point {} to the light source, {}, meet?",
                    s_.start == ShadowRay::naive ? "" : "other ", coordinates(s_.traced.point), coordinates(s_.lamp)),
        between(1),
        {{1.0 * between(INFINITY), "That counts objects beyond the light source, too."},
         {between(1) > 0 ? 0.0 : 1.0,
          between(1) > 0 ? "At least one object lies in between." : "No object lies in between."},
         {static_cast<double>(s_.world.objects.size()) - 1, "That counts objects wherever they lie."}},
        "The range is 0 ≤ *t* ≤ 1. The search may stop at the first one found.");
    keep_picture(script_.walk());
    const Vec3& from = s_.traced.point;
    s.question->over->items.emplace_back(
        Line{from, Vec3(from + s_.traced.to_lamp), Role::highlight, Pen::construction});
  }

  std::string shadow_caption() const {
    const bool naive = s_.start == ShadowRay::naive;
    if (s_.acne)
      return "After rounding, the point lies on or in its own object, which then seems to shadow it: *shadow acne*.\n"
             "The brightness *I* falls to the ambient light *I*_a alone.\n"
             "Remedies: leave the object out if it is convex, or start the ray a little off the surface.\n"
             "A little is several spacings of floats there: a constant is too small far out, too large nearby.";
    if (s_.traced.blocker)
      return "Something blocks the light: the brightness *I* is ambient light *I*_a alone. Which object it is does not "
             "matter.\n"
             "So the search ends with any hit.";
    return naive
               ? "Nothing lies between the point and the light source, so its light adds to the brightness *I*. Here "
                 "rounding did no harm: look at the picture."
               : "Nothing lies between the point and the light source, so its light adds to the brightness *I*.\n"
                 "The object itself is left out, as rounding may put the point inside. It is convex, so that is right.";
  }

  void image() {
    const Image all = trace(s_.world, s_.eye, s_.lamp, s_.start);
    script_.value("primary rays", all.work.eye_rays, "rays");
    script_.value("shadow rays", all.work.shadow_rays, "rays");
    script_.value("tests of objects", all.work.tests, "tests");
    script_.value("visits of nodes", all.work.nodes, "tests");
    const bool naive = s_.start == ShadowRay::naive;
    const auto objects = static_cast<int>(s_.world.objects.size());
    const int asked_of_a_shadow_ray = naive ? objects : objects - 1;  // not the object itself
    const int without = objects * all.work.eye_rays + asked_of_a_shadow_ray * all.work.shadow_rays;
    script_.value("tests without hierarchy", without, "tests");
    const bool pays = all.work.tests + all.work.nodes < without;
    Step& s = script_.add(
        "image", "All pixels", 0,
        fmt::format(
            "{} primary and {} shadow rays make the picture. The hierarchy tests {} objects and {} nodes; without it, "
            "{} objects would be tested{}.\n",
            counted(all.work.eye_rays), counted(all.work.shadow_rays), counted(all.work.tests), counted(all.work.nodes),
            counted(without), pays ? "" : ". For so few objects it does not pay") +
            (naive ? "Dim spots on lit surfaces are shadow acne."
                   : "Whitted (1980) added recursion: at mirrors and glass, further rays are traced in the same way."));
    s.scene = picture(s_, shown_, all);
  }

  const OnePixel& s_;
  Script script_;
  Shown shown_;
};

}  // namespace

Walk tell(const OnePixel& one) { return Teller(one).tell(); }

}  // namespace isect::lessons::ray_tracing_lesson
