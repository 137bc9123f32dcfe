#include "lessons/moving_bodies/telling.h"

#include <cmath>
#include <set>

#include "lessons/shared/axis_names.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"
#include "viz/text/rich_text.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;

namespace {

/// The end of "Two balls, a and b, which move: ...", as markup.
std::string outcome_text(const Setup& s) {
  switch (s.truth) {
    case Meeting::past:
    case Meeting::rest:
      return "they do not meet";
    case Meeting::late:
      return fmt::format("they do not meet by *t* = {}", shown(s.duration));
    case Meeting::at_first:
      return s.touching ? "they touch at *t* = 0" : "they share points at *t* = 0";
    case Meeting::grazing:
      return fmt::format("they touch at *t* = {}", shown(*s.first));
    case Meeting::unseen:
      return fmt::format("they meet at *t* = {}, between two tests", shown(*s.first));
    case Meeting::met:
      break;
  }
  return fmt::format("they first meet at *t* = {}", shown(*s.first));
}

Verdict::Kind kind_of(const Setup& s) {
  if (!s.first) return Verdict::Kind::no;
  return s.touching || s.truth == Meeting::grazing ? Verdict::Kind::on : Verdict::Kind::yes;
}

/// Asks for one component of the velocity of b, seen from a: the one in which the slips of a sign, of the other
/// difference and of no difference differ more. None where too few do.
std::optional<Question> velocity_question(const Setup& s) {
  const Vec2 d = s.d(), sum = s.v_a + s.v_b, other = s.v_a - s.v_b;
  const auto told_apart = [&](int i) -> std::size_t {
    const std::string right = shown(d[i]);
    if (right.size() > 1 && right == shown(s.duration)) return 0;  // the page before says it
    return std::set<std::string>{right, shown(sum[i]), shown(other[i]), shown(s.v_b[i])}.size();
  };
  const int i = told_apart(1) > told_apart(0) ? 1 : 0;
  if (told_apart(i) < 3) return {};
  return which_value(
      fmt::format("**v**_a = {} and **v**_b = {}. What is the {}-component of the velocity of b, seen from a?",
                  coordinates(s.v_a), coordinates(s.v_b), axis_names[i]),
      d[i],
      {{sum[i], "That adds the velocities. Seen from a, that of a is subtracted."},
       {other[i], "That is how a moves, seen from b: the sign is the opposite."},
       {s.v_b[i], "That is how b moves, seen by someone at rest. Seen from a, the velocity of a is subtracted."}},
      "Subtract **v**_a from both velocities: a is left with 0, and b with **v**_b − **v**_a.");
}

}  // namespace

Teller::Teller(const Setup& s, const std::string& title, const std::string& source, std::vector<std::string> pseudocode)
    : PictureTeller(s, {source, fmt::format("Two {}, a and b, which move: {}.", s.bodies(), plain(outcome_text(s))),
                        std::move(pseudocode), title}) {}

void Teller::two_bodies(int line) {
  script_.value("duration", s_.duration);
  add("two-bodies", fmt::format("Two {} that move", s_.bodies()), line,
      fmt::format("The {} a moves with velocity **v**_a, the {} b with **v**_b, for {} s.\n", s_.body(), s_.body(),
                  shown(s_.duration)) +
          (s_.duration > 0 ? "Each arrow shows how far one of them moves in that time."
                           : "In no time nothing moves: this is a test of bodies at rest."),
      fmt::format("**v**_a = {},  **v**_b = {}", coordinates(s_.v_a), coordinates(s_.v_b)));
}

void Teller::seen_from_a(int line) {
  known_.from_a = true;
  const bool rests = s_.v_a == s_.v_b;
  script_.value("|**d**|", s_.d().norm());
  Step& step = add("seen-from-a", "One body that moves", line,
                   "Move along with a: then a is at rest, and b moves with the difference **d** of the velocities.\n"
                   "At each time b lies relative to a as before. So they meet at the same times." +
                       std::string(rests ? "\nHere **d** is 0: seen from a, b is at rest, too." : ""),
                   fmt::format("**d** = **v**_b − **v**_a = {}", coordinates(s_.d())));
  step.question = velocity_question(s_);
  if (step.question) keep_picture(script_.walk());
}

void Teller::end(const std::string& slug, const std::string& title, int line, bool found, const std::string& told) {
  known_.settled = true;
  script_.settle(kind_of(s_), outcome_text(s_));
  if (s_.first) script_.value("first contact", *s_.first, {}, Role::hit);
  const bool right = found == s_.first.has_value();
  add(slug, title, line,
      right ? told
            : fmt::format("Rounding has misled this method: exactly, {}.\n"
                          "The exact test takes the true signs of polynomials in the given numbers.",
                          s_.first ? "they meet" : "they do not meet"));
}

std::string Teller::reason() const {
  switch (s_.truth) {
    case Meeting::rest:
      return "Seen from a, b is at rest. They are apart at first, and stay so.";
    case Meeting::past:
      return s_.balls() && s_.signs.receding >= 0 ? "From the start on, the distance of the centres does not fall."
                                                  : "On this course they do not meet at any later time, either.";
    case Meeting::late: {
      const std::optional<double> later = s_.first_without_end();
      return "The motion ends before they meet." +
             (later && std::isfinite(*later)
                  ? fmt::format(" On the same course they would first meet at *t* = {}.", shown(*later))
                  : std::string());
    }
    case Meeting::at_first:
      return s_.touching ? "They touch at the start. The bodies include their surfaces, so this is a contact, whether "
                           "they part after it or not."
                         : "They share points from the start. So first contact is at *t* = 0, however they move.";
    case Meeting::grazing:
      return s_.balls()
                 ? "They share one point at one time: b grazes a. Bodies include their surfaces, so touching counts."
                 : "On one axis they do not move against each other, and only touch: b slides along a face of a.\n"
                   "Bodies include their surfaces, so touching counts.";
    case Meeting::unseen:
    case Meeting::met:
      break;
  }
  return "Before that time they share no point.";
}

}  // namespace isect::lessons::moving_bodies_lesson
