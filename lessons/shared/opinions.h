#pragma once
// Methods that should agree, compared side by side on the setting that is shown. The window shows an alarm where one
// differs.

#include <string>
#include <utility>
#include <vector>

#include <isect/conventions.h>
#include "viz/lesson.h"

namespace isect::lessons {

/// What a yes/no test of two sets says.
inline std::string says_meet(bool meet) { return meet ? "they meet" : "disjoint"; }
/// The words of the note's pseudocode for the same.
inline std::string says_overlap(bool overlap) { return overlap ? "OVERLAP" : "DISJOINT"; }
inline std::string says_overlap(Relation relation) { return says_overlap(relation != Relation::disjoint); }

/// Collects the methods' answers. The exact one comes first, and the others are compared with it.
class Opinions {
 public:
  explicit Opinions(std::string exact) : said_{{"exact", std::move(exact)}} {}

  /// Adds a method that is right where its words are those of the exact one.
  void add(std::string method, std::string says) {
    const bool agrees = says == said_.front().says;
    add(std::move(method), std::move(says), agrees);
  }
  void add(std::string method, std::string says, bool agrees) {
    said_.push_back({std::move(method), std::move(says), agrees});
  }

  std::vector<viz::Opinion> take() { return std::move(said_); }

 private:
  std::vector<viz::Opinion> said_;
};

}  // namespace isect::lessons
