#pragma once
// What the window knows of all lessons together: the parts of the course, and the terms that are explained.

#include <string>
#include <vector>

namespace isect::viz {

struct Course {
  struct Part {
    std::string title;
    std::string first;  ///< id of its first lesson
  };
  struct Term {
    std::string name;     ///< plain text
    std::string meaning;  ///< markup
    std::string lesson;   ///< id
  };
  std::vector<Part> parts = {};
  std::vector<Term> terms = {};
};

}  // namespace isect::viz
