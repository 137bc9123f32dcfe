#include "lessons/ray_sphere/telling.h"

#include <cmath>
#include <utility>

#include "lessons/shared/questions.h"

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

bool Teller::right(const std::optional<double>& found) const {
  const std::optional<double>& truth = setup_.truth.surface;
  if (!found || !truth) return found.has_value() == truth.has_value();
  const double speed = setup_.ray.direction.stableNorm();
  return std::abs(*found - *truth) <= 1e-6 * (std::abs(*truth) + setup_.sphere.radius / speed);
}

std::string Teller::astray() const {
  return "Rounding made this method wrong here: " +
         (setup_.truth.surface ? "exactly, the first hit is at " + told(setup_, *setup_.truth.surface) + "."
                               : std::string("exactly, there is no hit."));
}

std::string Teller::lost_digits(double found, double truth) {
  if (digits_right(found, truth) >= 5) return {};
  return " Exactly it is " + shown(truth) + ".";
}

std::string Teller::astray_line() const {
  static const char* const shares[] = {"no point", "one point", "two points"};
  return std::string("Rounding decides wrongly here: exactly, the line shares ") + shares[setup_.truth.line_roots] +
         " with the sphere.";
}

int digits_right(double found, double truth) {
  if (found == truth) return 16;
  const double error = std::abs(found - truth) / std::abs(truth);
  return error < 1 ? static_cast<int>(-std::log10(error)) : 0;
}

Question roots_question(const Setup& s, bool is_told) {
  static const char* const because[] = {"It passes farther than *r* from the centre.",
                                        "It passes at exactly *r* from the centre: a double root.",
                                        "It passes nearer than *r* to the centre."};
  const int roots = s.truth.line_roots;
  const std::string prompt = "How many points does the whole line share with the sphere?";
  if (!is_told) return {prompt, {"none", "one", "two"}, roots, because[roots]};
  Question q = {prompt, {"0", "1", "2"}, roots, because[roots]};
  ask_for_number(q, roots, 0,
                 {{0, roots == 1 ? "Touching counts: they share a point."
                                 : "It passes nearer than *r* to the centre, so it enters the ball."},
                  {1, roots == 0 ? "To touch, it would have to pass at exactly *r* from the centre."
                                 : "The line enters the ball and leaves it again: each gives a point."},
                  {2, roots == 0 ? "It passes farther than *r* from the centre."
                                 : "Both roots are the same: a double root is one point."}});
  return q;
}

namespace {

/// Asks for the *t* of the first hit instead of its root, where the roots as read from what is shown give it.
void ask_for_t(Question& q, const Setup& s, const Interval<double>& read) {
  const double lo = s.truth.roots.lo, hi = s.truth.roots.hi, t = *s.truth.surface;
  const bool first = q.answer == 0;
  if (shown(lo) == shown(hi) || !read_well(first ? read.lo : read.hi, t)) return;
  Question asked = {
      "At which *t* does the ray first meet the sphere?", {shown(lo), shown(hi), "neither"}, q.answer, q.because};
  ask_for_number(asked, t, 3,
                 {{first ? hi : lo, first ? "There the line leaves the ball. It has entered it before, in the range."
                                          : "There the line enters the ball, but before the ray begins."},
                  {(lo + hi) / 2, "That is half way between the roots, at the foot of the perpendicular."}});
  if (asked.number) q = std::move(asked);
}

}  // namespace

std::optional<Question> first_hit_question(const Setup& s, const std::vector<std::string>& roots,
                                           const std::optional<Interval<double>>& read) {
  if (s.truth.line_roots == 1) return {};
  const bool first = s.truth.surface && *s.truth.surface == s.truth.roots.lo;
  const int answer = !s.truth.surface ? 2 : first ? 0 : 1;
  const std::string because = answer == 2 ? "Neither root lies in the ray's range."
                              : answer == 0
                                  ? "The smaller root lies in the ray's range."
                                  : "The smaller root lies behind the origin, and the larger one in the range.";
  Question q = {"Which root is the ray's first hit?", {roots[0], roots[1], "neither"}, answer, because};
  if (answer != 2 && read) ask_for_t(q, s, *read);
  return q;
}

std::string verdict_text(const Setup& s) {
  if (s.truth.surface) return "hit at " + told(s, *s.truth.surface);
  if (s.truth.solid) return "inside the ball, surface not met";
  if (s.truth.line_roots == 0) return "miss: the line passes by";
  return s.segment() && s.truth.roots.lo > s.ray.range.hi ? "miss: the segment ends before"
                                                          : "miss: the ball lies behind";
}

std::string miss_caption(const Setup& s) {
  if (s.truth.solid)
    return "The segment lies wholly inside. It shares points with the solid ball, but none with its surface.";
  if (s.truth.line_roots == 0) return "The line has no point in common with the sphere, so the ray has none.";
  const char* const what = s.segment() ? "segment" : "ray";
  if (s.is_a_point())
    return std::string("The sphere is a point of the line, but not of the ") + what + ". A real root alone is no hit.";
  return s.truth.line_roots == 1
             ? std::string("The line touches the sphere, but outside the ") + what + ". A real root alone is no hit."
             : std::string("The line meets the sphere, but outside the ") + what + ". Real roots alone are no hit.";
}

std::string solid_caption(const Setup& s) {
  if (s.truth.origin == Location::on)
    return "The origin lies on the surface: the first hit is the origin itself, at *t* = 0.";
  if (s.truth.origin == Location::in) return "For a solid ball, first contact is at *t* = 0: the origin lies in it.";
  return "The point lies on the sphere, as far as rounding allows.";
}

}  // namespace isect::lessons::ray_sphere_lesson
