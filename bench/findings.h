#pragma once
// What the rows of one test say together: which calls are compared, which is the best of the others, what to choose.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bench/report_text.h"
#include "bench/rows.h"

namespace isect::bench {

/// All rows of a test in one scalar, with the two that are compared.
struct Findings {
  std::vector<const Row*> rows, ordinary;
  const Row *naive = nullptr, *exact = nullptr;
  double noise = 0;  ///< of the machine

  Findings(const Report&, const std::string& test, const std::string& scalar);
  /// One method's rows over all families.
  std::vector<const Row*> of(const Row& method) const;
  const Row* same_family(const Row&, const Row& method) const;
  bool comparable() const { return naive != nullptr && exact != nullptr && naive != exact; }
  /// Whether an oracle judged any hard case.
  bool judged_hard() const;
};

long total_wrong(const std::vector<const Row*>&);
long total_judged(const std::vector<const Row*>&);
/// Whether some hard case was judged.
bool is_judged_on_hard(const std::vector<const Row*>& method);
/// "24 %", "none".
std::string wrong_share(const std::vector<const Row*>&);
/// The hard families on which a method is wrong, the worst first.
std::vector<const Row*> broken_by(std::vector<const Row*> method);
/// "24 % of far small": at most `most` such texts, the worst first.
std::vector<std::string> wrong_on(const std::vector<const Row*>& method, std::size_t most);

/// A method's row on the hard family where it takes longest; null if there is none.
const Row* slowest_hard(const std::vector<const Row*>& method);

/// The median with its interval, as text.
std::string time_of(const Row&);
std::string ratio_text(const Row&, const Row& divided_by);

/// Whether a is certainly faster, and by a tenth at least: the next build may place a loop in another way.
inline bool clearly_faster(const Row& a, const Row& b, double noise) {
  return faster(a, b, std::max(noise, most_noise));
}

/// The exact call, or another method of isect that is as exact, says as much and is clearly faster.
const Row& best_exact(const Findings&);

/// Where another method of isect that is as exact and says as much takes less than half of its time: on hard families
/// that take longer than ordinary input, the slowest first.
struct Better {
  const Row *row, *chosen;  ///< of one family
};
std::vector<Better> better_where(const Findings&);

/// The hard families that the exact call was tested on and `method` was not: " (not asked: invalid, scale)".
std::string not_asked(const Findings&, const Row& method);

/// The best inexact or foreign method: of those than which nothing is certainly faster, the one that is least often
/// wrong.
struct Rival {
  Findings in;  ///< of its run: other libraries come from the run beside them
  const Row* row;
  const Row* exact;  ///< of isect in that run, as best_exact()
  bool is_faster() const { return clearly_faster(*row, *exact, in.noise); }
};
std::optional<Rival> rival(const Measured&, const std::string& test);
/// The rival within one run: among other libraries only if `foreign`, else among isect's own methods only.
std::optional<Rival> rival(const Report&, const std::string& test, const std::string& scalar, bool foreign);

/// What to choose.
struct Choice {
  enum Why {
    nothing_faster,    ///< the exact call: nothing is certainly faster
    errs_on_ordinary,  ///< the exact call: what is faster is wrong on ordinary cases
    not_judged,        ///< no advice: what is faster met no hard case
    as_exact,          ///< another library's method, which promises as much
    never_broken,      ///< the faster one where time matters: nothing broke it here
    breaks             ///< the faster one where no input is like `families`
  };
  Why why;
  std::string exact, other;           ///< names; `other` is the faster one
  std::vector<std::string> families;  ///< the worst first
  bool all_families = false;          ///< it breaks on most of them
  const Row* peer = nullptr;          ///< `exact` of another library, which promises and says as much and is faster
  bool no_value = false;              ///< the faster one answers yes or no only
};
/// Returns nothing where there is no exact call.
std::optional<Choice> choice(const Measured&, const std::string& test);

}  // namespace isect::bench
