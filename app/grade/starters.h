#pragma once
// Programs to begin with: they read the cases of a task as plain numbers and answer each; what is left to write is the
// test itself.

#include <string>
#include <vector>

#include "app/grade/task.h"

namespace isect::grade {

struct Language {
  std::string name, ending;
};
const std::vector<Language>& languages();
/// Returns the language of this name or ending. Throws viz::BadInput with the nearest name.
const Language& language_named(const std::string& name);

/// Returns the name of a starter's file: "ray-sphere.py".
std::string starter_file(const Task&, const Language&);
/// Returns the commands that build it, if any, and judge it, a line each.
std::vector<std::string> commands_for(const Task&, const Language&);
/// Returns the program, some 30 lines at most.
std::string starter(const Task&, const Language&);

}  // namespace isect::grade
