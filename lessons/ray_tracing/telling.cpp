#include <fmt/format.h>

#include "lessons/ray_tracing/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::ray_tracing_lesson {

using namespace viz;
using namespace viewing;

namespace {

const std::vector<std::string> pseudocode = {
    "for each pixel: ray ← from the eye through the pixel",  // 0
    "    hit ← the object met at the least t ≥ 0",           // 1
    "    if there is none: the colour of the sky",           // 2
    "    n ← its normal at the hit, l ← towards the lamp",   // 3
    "    if n · l ≤ 0: dim, it faces away from the lamp",    // 4
    "    if anything stands between hit and lamp: dim",      // 5
    "    else: as bright as n · l says"                      // 6
};

class Teller {
 public:
  Teller(const Vec3& pixel, const Vec3& lamp)
      : s_(pixel, lamp),
        script_({"Note, N01, N16; Whitted (1980)",
                 "An eye looks through a picture plane at balls, a box and a floor. " + outcome() + ".", pseudocode}) {}

  Walk tell() {
    step("picture-plane", "A picture of pixels", 0,
         "The eye looks at a scene through a plane of 48 × 36 pixels. Each pixel asks: what is seen through "
         "me?",
         {});
    shown_.ray = true;
    step("ray", "One ray through one pixel", 0,
         "The ray starts at the eye **o** and runs through the middle of the pixel. On the picture plane *t* "
         "= 1.\n"
         "Light travels the other way, but few of a lamp's rays reach the eye. So rays are traced backwards.",
         "**p** = **o** + *t* **d**,  *t* ≥ 0");
    closest();
    if (s_.traced.hit) shade();
    image();
    return std::move(script_.walk());
  }

 private:
  std::string name() const { return s_.world.object(s_.traced.hit->primitive).name; }

  std::string outcome() const {
    if (!s_.traced.hit) return "The pixel shows the sky";
    if (!(s_.traced.cosine > 0)) return "The pixel shows a side that faces away from the lamp";
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
    for (const Object& o : s_.world.objects)
      if (const std::optional<double> t = first_hit(s_.ray, o.shape)) {
        ++met;
        script_.value(std::string("*t* of ") + o.name, *t, "t", o.role);
      }
    shown_.hits = true;
    script_.value("objects met", met);
    if (!s_.traced.hit) script_.settle(Verdict::Kind::no, "the ray meets nothing: sky");
    Step& s =
        step("closest", "The closest hit", s_.traced.hit ? 1 : 2,
             !s_.traced.hit ? "The ray meets none of the objects, so the pixel shows the sky."
             : met == 1     ? "The ray meets one object only. The least *t* ≥ 0 is what the eye sees."
                        : fmt::format("The ray meets {} objects. The least *t* ≥ 0 hides the others: the eye sees "
                                      "the first one only.",
                                      met),
             s_.traced.hit ? "*t* = " + shown(s_.traced.hit->t) : "");
    s.decides = true;
    Question q = {"What does the pixel show?", {}, 0, "The object met at the least *t* ≥ 0."};
    for (const Object& o : s_.world.objects) q.choices.emplace_back(o.name);
    q.choices.emplace_back("the sky");
    q.answer = s_.traced.hit ? s_.traced.hit->primitive : static_cast<int>(s_.world.objects.size());
    s.question = q;
  }

  void shade() {
    shown_.normal = true;
    const bool away = !(s_.traced.cosine > 0);
    script_.value("**n** · **l**", s_.traced.cosine, "light");
    Step& s = step("normal", away ? "It faces away" : "How it faces the lamp", away ? 4 : 3,
                   away ? "The angle between normal and lamp exceeds a right angle. No ray to the lamp is needed."
                        : "The normal **n** and the way **l** to the lamp, both of length 1, tell how steeply "
                          "light falls "
                          "in.",
                   "**n** · **l** = " + shown(s_.traced.cosine));
    Script::decide(s, {"**n** · **l** > 0", 0, s_.traced.cosine, !away, away ? "it faces away" : "it faces the lamp"});
    if (!away) shadow();
    script_.value("brightness", s_.traced.light, "light", Role::highlight);
    const bool lit = !away && !s_.traced.blocker;
    script_.settle(lit ? Verdict::Kind::yes : Verdict::Kind::no,
                   away ? fmt::format("{}, turned away from the lamp", name())
                   : s_.traced.blocker
                       ? fmt::format("{}, in the shadow of {}", name(), s_.world.object(*s_.traced.blocker).name)
                       : fmt::format("{}, lit", name()));
  }

  void shadow() {
    shown_.shadow_ray = true;
    Step& s = step("shadow", "A ray to the lamp", s_.traced.blocker ? 5 : 6,
                   s_.traced.blocker
                       ? "Something stands in the way, so the point is in shadow. Which object it is does not matter.\n"
                         "So the search ends with any hit: yes or no suffices."
                       : "Nothing stands between the point and the lamp, so its light arrives.\n"
                         "The object itself is left out. It is convex, and this side faces the lamp.",
                   "**p** + *t* (lamp − **p**),  0 ≤ *t* ≤ 1");
    s.decides = true;
    s.question = {"Does the lamp's light reach the point?",
                  {"yes", "no"},
                  s_.traced.blocker ? 1 : 0,
                  "A segment from the point to the lamp is tested, not a ray without end."};
  }

  void image() {
    const Image all = trace(s_.world, s_.eye, s_.lamp);
    script_.value("eye rays", all.work.eye_rays, "rays");
    script_.value("shadow rays", all.work.shadow_rays, "rays");
    script_.value("objects asked", all.work.tests);
    const int each = static_cast<int>(s_.world.objects.size());
    Step& s = script_.add("image", "All pixels", 0,
                          fmt::format("{} eye rays and {} shadow rays make the picture.\nA hierarchy of "
                                      "boxes spares most tests: {} objects "
                                      "were asked, not {}.",
                                      all.work.eye_rays, all.work.shadow_rays, all.work.tests,
                                      each * (all.work.eye_rays + all.work.shadow_rays)));
    s.scene = picture(s_, shown_, all);
  }

  const OnePixel s_;
  Script script_;
  Shown shown_;
};

}  // namespace

Walk tell(const Vec3& pixel, const Vec3& lamp) { return Teller(pixel, lamp).tell(); }

}  // namespace isect::lessons::ray_tracing_lesson
