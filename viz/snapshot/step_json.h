#pragma once
// What a step says, as JSON, and the differences between two steps, in words.

#include <string>
#include <vector>

#include "viz/lesson.h"
#include "viz/snapshot/json.h"
#include "viz/snapshot/snapshot.h"

namespace isect::viz::snap {

/// Returns everything but the scene. What is empty or false is left out; texts keep their markup.
Json json_of(const Step&);
Json json_of(const std::vector<Opinion>&);
Json json_of(const std::vector<Exercise>&);
Json json_of(const std::vector<Erratum>&);

/// Collects the changes of one step, or of none.
class Changes {
 public:
  void of_step(int step) { step_ = step; }
  void are_of(Change::Of what) { of_ = what; }
  /// Adds a change, unless it was said already (a value that is also compared). `cause`: as in Change; empty: the same.
  void add(const std::string& what, const std::string& cause = {});
  void compare(const std::string& name, const Json& was, const Json& is);
  /// Compares texts with markup: shows the words around the difference.
  void compare_texts(const std::string& name, const Json& was, const Json& is);
  /// Compares every key of either object.
  void compare_all(const std::string& prefix, const Json& was, const Json& is);
  std::size_t count() const { return found_.size(); }
  std::vector<Change> take() { return std::move(found_); }

 private:
  int step_ = -1;
  Change::Of of_ = Change::Of::course;
  std::vector<Change> found_;
};

void compare_steps(const Json& was, const Json& is, Changes&);

}  // namespace isect::viz::snap
