#include "lessons/crossings/telling.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;

Teller::Teller(const Setup& setup, const std::string& title, const std::string& source, std::vector<std::string> lines)
    : setup_(setup), script_({source, alt_text(setup), std::move(lines), title}) {}

Step& Teller::add(const std::string& slug, const std::string& title, int line, const std::string& caption) {
  Step& step = script_.add(slug, title, line, caption);
  step.scene = picture(setup_, known_);
  return step;
}

void Teller::first_step(const std::string& rule) {
  script_.value("count", 0, {}, Role::hit);
  add("ray", "A ray to the right", 0,
      std::string("Count the edges that it crosses: an odd number means inside (Jordan's curve theorem).\n") +
          setup_.situation.note);
  add("rule", "The rule", 1, rule);
}

std::string Teller::slug(const EdgeOf& e) const {
  int number = e.index + 1;
  for (int r = 0; r < e.ring; ++r) number += static_cast<int>(setup_.situation.polygon.rings[r].size());
  return "edge-" + std::to_string(number);
}

void Teller::meet(const EdgeOf& e, bool counts) {
  if (counts) ++count_;
  known_.meetings.push_back({meeting(setup_, e), counts ? count_ : 0});
  if (counts) script_.value("count", count_, {}, Role::hit);
}

void Teller::ask(Step& step, bool counts, const std::string& because) {
  if (asked_) return;
  asked_ = true;
  step.question = Question{"Does the edge **a** **b** count?", {"yes", "no"}, counts ? 0 : 1, because};
}

Question Teller::where_question() const {
  const int answer = static_cast<int>(setup_.truth.even_odd);
  return {"Where does **p** lie, by the even-odd rule?",
          {"inside", "on the boundary", "outside"},
          answer,
          answer == 1 ? "An edge holds the point." : "The true count of crossings decides."};
}

}  // namespace isect::lessons::crossings_lesson
