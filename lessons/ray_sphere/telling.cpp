#include "lessons/ray_sphere/telling.h"

namespace isect::lessons::ray_sphere_lesson {

using namespace viz;

Step& Teller::add(const std::string& slug, const std::string& title, int line, const std::string& caption, Focus focus,
                  const std::string& formula) {
  known_.focus = focus;
  Step& step = script_.add(slug, title, line, caption, formula);
  step.scene = picture(setup_, known_);
  return step;
}

void Teller::settle(viz::Verdict::Kind kind) {
  known_.settled = true;
  script_.settle(kind, verdict_text(setup_));
}

Question roots_question(const Setup& s) {
  static const char* const because[] = {"It passes further than *r* from the centre.",
                                        "It passes at exactly *r* from the centre: a double root.",
                                        "It passes nearer than *r* to the centre."};
  return {"How many points does the whole line share with the sphere?",
          {"none", "one", "two"},
          s.truth.line_roots,
          because[s.truth.line_roots]};
}

Question first_hit_question(const Setup& s, const std::vector<std::string>& roots) {
  const bool first = s.truth.surface && *s.truth.surface == s.truth.roots.lo;
  const int answer = !s.truth.surface ? 2 : first ? 0 : 1;
  const std::string because = answer == 2 ? "Neither root lies in the ray's range."
                              : answer == 0
                                  ? roots[0] + " is the smaller root, and it lies in the ray's range."
                                  : roots[0] + " lies behind the origin, so " + roots[1] + " is the first hit.";
  return {"Which root is the ray's first hit?", {roots[0], roots[1], "none"}, answer, because};
}

Question behind_question(bool rejected) {
  return {"Can this ball be rejected already?",
          {"yes", "no"},
          rejected ? 0 : 1,
          rejected ? "The centre lies behind an origin that is outside."
                   : "That takes a centre behind an origin that is outside."};
}

std::string verdict_text(const Setup& s) {
  if (s.truth.surface) return "hit at *t* = " + shown(*s.truth.surface);
  if (s.truth.solid) return "inside the ball, surface not met";
  if (s.truth.line_roots == 0) return "miss: the line passes by";
  return s.segment() && s.truth.roots.lo > s.ray.range.hi ? "miss: the segment ends before"
                                                          : "miss: the ball lies behind";
}

std::string miss_caption(const Setup& s) {
  if (s.truth.solid)
    return "The segment lies wholly inside. It shares points with the solid ball, but none with its surface.";
  if (s.truth.line_roots == 0) return "The line has no point in common with the sphere, so the ray has none.";
  return "The line meets the sphere, but not where the ray is. Real roots alone are no hit.";
}

std::string solid_caption(const Setup& s) {
  if (s.truth.origin == Location::on)
    return "The origin lies on the surface: the first hit is the origin itself, at *t* = 0.";
  if (s.truth.origin == Location::in)
    return "Taken as a solid, the ball was met at *t* = 0 already: the origin lies in it.";
  return "The point lies on the sphere, as far as rounding allows.";
}

}  // namespace isect::lessons::ray_sphere_lesson
