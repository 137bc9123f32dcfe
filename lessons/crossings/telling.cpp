#include "lessons/crossings/telling.h"

#include <fmt/format.h>

#include <cctype>

#include "lessons/shared/line_question.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::crossings_lesson {

using namespace viz;

namespace {

/// A sentence on what is special about the point where it is now.
std::string special(const Setup& s) {
  if (s.as_given()) return s.situation.note;
  if (s.truth.even_odd == Location::on) return "The point lies on the boundary.";
  const int vertices = s.vertices_on_ray();
  return vertices == 0 ? "No vertex lies on the ray."
                       : fmt::format("{} {} on the ray.", vertices, vertices == 1 ? "vertex lies" : "vertices lie");
}

/// The number of edges that meet the whole line of the ray, by the half-open rule: left of the point, too.
int crossings_of_line(const Setup& s) {
  int count = 0;
  for (const Ring<double, 2>& ring : s.polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      count += (ring[i].y() > s.p.y()) != (ring[(i + 1) % ring.size()].y() > s.p.y());
  return count;
}

/// "Edge 3: both ends below"
std::string numbered(const std::string& slug, std::string title) {
  title.front() = static_cast<char>(std::tolower(title.front()));
  return "Edge " + slug.substr(slug.find('-') + 1) + ": " + title;
}

}  // namespace

Teller::Teller(const Setup& setup, const std::string& title, const std::string& source, std::vector<std::string> lines)
    : setup_(setup), script_({source, alt_text(setup), std::move(lines), title}) {}

Step& Teller::add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                  const std::string& formula) {
  const bool of_edge = slug.starts_with("edge-");
  Step& step = script_.add(slug, of_edge ? numbered(slug, title) : title, line, caption, formula);
  step.scene = picture(setup_, known_);
  return step;
}

void Teller::first_step() {
  script_.value("count", 0, {}, Role::hit);
  add("ray", "A ray to the right", 0,
      std::string(setup_.simple
                      ? "Count the edges that it crosses: an odd number means inside (Jordan curve theorem).\n"
                      : "Count the edges that it crosses: odd means inside.\n"
                        "Jordan's theorem speaks of simple closed curves only. Here this even-odd rule is a "
                        "definition.\n") +
          special(setup_));
}

Question Teller::how_many(const std::string& rule, int counted) const {
  int closed = 0, edges = 0;
  for (const Ring<double, 2>& ring : setup_.polygon.rings) {
    closed += point_polygon::crossings_closed(setup_.p, ring);
    edges += static_cast<int>(ring.size());
  }
  return which_count(
      rule + " How many edges count?", counted,
      {{1.0 * closed, "That counts each edge with both its ends."},
       {1.0 * setup_.truth.crossings, "That counts a vertex on the ray as below it."},
       {1.0 * crossings_of_line(setup_), "That counts edges on the left of **p**, too."},
       {1.0 * edges, "That counts all edges."}},
      "An edge counts if it is neither wholly above nor wholly below, and crosses the height of **p** on the right.");
}

std::string Teller::slug(const EdgeOf& e) const {
  int number = e.index + 1;
  for (int r = 0; r < e.ring; ++r) number += static_cast<int>(setup_.polygon.rings[r].size());
  return "edge-" + std::to_string(number);
}

void Teller::meet(const EdgeOf& e, bool counts) {
  if (counts) ++count_;
  known_.meetings.push_back({meeting(setup_, e), counts ? count_ : 0});
  if (counts) script_.value("count", count_, {}, Role::hit);
}

void Teller::ask(const EdgeOf& edge, const std::vector<WrongLine>& wrong, const std::string& because) {
  if (asked_) return;
  asked_ = true;
  const auto [a, b] = ends(setup_, edge);
  const auto pair = [](const Point<double, 2>& v) { return fmt::format("({}, {})", shown(v.x()), shown(v.y())); };
  ask_for_line(script_.walk(),
               fmt::format("**p** = {}. The next edge runs from {} to {}. Which line settles it?", pair(setup_.p),
                           pair(a), pair(b)),
               wrong, because);
  give_before(script_.walk(), {"count"});
}

}  // namespace isect::lessons::crossings_lesson
