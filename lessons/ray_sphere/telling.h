#pragma once
// What the three walks share: the run on counting scalars, and the questions and verdicts that come from the
// exact test.

#include <optional>

#include <isect/counted.h>
#include "lessons/ray_sphere/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::ray_sphere_lesson {

viz::Walk haines(const viz::Parameters&);
viz::Walk quadratic(const viz::Parameters&);
viz::Walk half_b(const viz::Parameters&);

/// Shows one run of one method. Each method's own teller adds what to say about each event.
class Teller {
 protected:
  Teller(const Setup& setup, const std::string& title, const std::string& source, std::vector<std::string> pseudocode)
      : setup_(setup), script_({source, alt_text(setup), std::move(pseudocode), title}) {}

  /// Runs `method(ray, sphere, record)` with every operation counted, and says each event.
  template <class Event, class Method, class Say>
  viz::Walk tell(const Method& method, const Say& say) {
    using C = Counted<double>;
    const Ray<double, 3>& r = setup_.ray;
    const Ray<C, 3> ray = {r.origin.cast<C>(), r.direction.cast<C>(), {r.range.lo, r.range.hi}};
    const Sphere<C, 3> sphere = {setup_.sphere.center.cast<C>(), setup_.sphere.radius};
    script_.tell<Event>([&](auto& record) { method(ray, sphere, record); }, say);
    return std::move(script_.walk());
  }

  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, Focus focus,
                 const std::string& formula = {});
  static void decide(viz::Step& step, const viz::Comparison& comparison) { Script::decide(step, comparison); }
  /// Whether the method found the truth, as far as rounding allows; no `found`: it rejected.
  bool right(const std::optional<double>& found) const;
  /// A sentence if it did not: "Rounding made this method wrong here: ..."
  std::string astray() const;
  /// A sentence if fewer digits are right than are shown: " Exactly it is ...".
  static std::string lost_digits(double found, double truth);
  /// A sentence on what the line shares with the sphere, if the computed sign says otherwise.
  std::string astray_line() const;
  void settle(viz::Verdict::Kind);

  const Setup& setup_;
  Script script_;
  Known known_;
};

/// How many leading decimal digits are right: at most 16, 0 if the error is as large as the number.
int digits_right(double found, double truth);
/// "How many points does the line share with the sphere?" `is_told`: what is shown decides it, so it is a count to
/// type.
viz::Question roots_question(const Setup&, bool is_told);
/// "Which is the first hit?" with the names of the two roots; nothing for a double root. It asks for its t where there
/// is one and what is shown gives it: the roots as `read` there, if their digits are right.
std::optional<viz::Question> first_hit_question(const Setup&, const std::vector<std::string>& roots,
                                                const std::optional<Interval<double>>& read);
std::string verdict_text(const Setup&);
std::string miss_caption(const Setup&);
/// A sentence on what the solid ball adds to the answer for its surface.
std::string solid_caption(const Setup&);

}  // namespace isect::lessons::ray_sphere_lesson
