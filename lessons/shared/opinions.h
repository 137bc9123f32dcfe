#pragma once
// Methods that should agree, asked side by side on the setting that is shown. The window rings an alarm where one
// differs.

#include <string>
#include <utility>
#include <vector>

#include "viz/lesson.h"

namespace isect::lessons {

/// What a yes/no test of two sets says.
inline std::string says_meet(bool meet) { return meet ? "they meet" : "disjoint"; }
/// The same in the words of the note's pseudocode.
inline std::string says_overlap(bool overlap) { return overlap ? "OVERLAP" : "DISJOINT"; }

/// Gathers what the methods say. The exact one comes first, and the others are held against it.
class Opinions {
 public:
  explicit Opinions(std::string exact) : said_{{"exact", std::move(exact)}} {}

  /// A method whose words are those of the exact one where it is right.
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
