#include "lessons/course.h"

#include "lessons/glossary.h"

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
    return c;
  }();
  return course;
}

}  // namespace isect::lessons
