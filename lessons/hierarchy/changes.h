#pragma once
// Values of a walk that are marked as new only where they have changed.

#include <map>
#include <string>

#include "lessons/shared/script.h"

namespace isect::lessons::hierarchy_lesson {

class Changes {
 public:
  void tell(Script& script, const std::string& name, double number, const std::string& unit = {},
            viz::Role role = viz::Role::muted) {
    const auto [known, added] = told_.try_emplace(name, number);
    if (!added && known->second == number) return;
    known->second = number;
    script.value(name, number, unit, role);
  }

 private:
  std::map<std::string, double> told_;
};

}  // namespace isect::lessons::hierarchy_lesson
