#include "lessons/course.h"

#include <algorithm>

#include "lessons/glossary.h"
#include "lessons/lessons.h"

namespace isect::lessons {

const viz::Course& course() {
  static const viz::Course course = [] {
    viz::Course c;
    c.parts = {{"Ideas", "relations"},
               {"Pairs of shapes", "aabb-aabb"},
               {"Bounds and hierarchies", "bounding-volumes"},
               {"Polygons", "crossings"},
               {"Uses", "collision"},
               {"Speed and rounding", "rules-of-thumb"}};
    for (const Term& t : glossary()) c.terms.push_back({t.name, t.meaning, t.lesson});
    for (const Letter& l : letters()) c.terms.push_back({l.name, l.meaning, l.lesson});
    return c;
  }();
  return course;
}

std::vector<viz::SharedIdea> shared_ideas(const viz::Lesson& lesson) {
  std::vector<viz::SharedIdea> all;
  for (const std::string& idea : lesson.ideas) {
    viz::SharedIdea shared = {idea, {}};
    for (const viz::Lesson* other : all_lessons())
      if (other->id != lesson.id && std::ranges::count(other->ideas, idea) > 0) shared.others.push_back(other);
    if (!shared.others.empty()) all.push_back(shared);
  }
  return all;
}

}  // namespace isect::lessons
