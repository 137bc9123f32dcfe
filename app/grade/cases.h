#pragma once
// The cases of a task, by families: drawn from a seed, the same on every machine.

#include <cstdint>
#include <string>
#include <vector>

#include "app/grade/task.h"
#include "bench/random.h"

namespace isect::grade {

using Numbers = std::vector<double>;  ///< a case, in the order of the task's fields

/// Cases that are hard, or not, for one reason.
struct Family {
  std::string name, what;
  Numbers (*draw)(bench::Random&);
};
/// Returns a task's families, "ordinary" first.
std::vector<Family> families(const Task&);

struct Case {
  std::string family;
  Numbers numbers;
};
/// Returns `count` cases of each family, in order. Yes and no, hit and miss, take turns where a family has both. No
/// case is one to which the core gives no answer.
std::vector<Case> cases(const Task&, std::uint64_t seed, int count);

/// Returns a case as a line of JSON, without its end: where the task is a kind of a query, a line of a query. `id`
/// below 0: none.
std::string json_line(const Task&, const Numbers&, long long id = -1);
/// Returns its numbers, each the shortest that is read as the same number, with blanks between.
std::string plain_line(const Numbers&);

std::vector<Family> volume_families(const std::string& task);
std::vector<Family> ray_families(const std::string& task);
std::vector<Family> polygon_families(const std::string& task);

}  // namespace isect::grade
