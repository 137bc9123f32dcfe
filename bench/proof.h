#pragma once
// What the long proof found, as tests/proof/run.py keeps it in bench/proof.json, and as a section of the report.

#include <string>
#include <vector>

namespace isect::bench {

struct Proof {
  struct Judged {
    std::string test;
    long cases = 0;   ///< distinct inputs
    long judged = 0;  ///< answers to them: several where a test has several exact calls
  };
  struct Fuzzed {
    std::string target;
    long minutes = 0, inputs = 0, wrong = 0;
  };

  std::string commit, date;
  long seeds = 0, wrong_verdicts = 0;
  std::vector<Judged> judged;
  /// Counts of the tests in a long run; `again`: how many had failed and were run again once they were mended.
  long tests = 0, skipped = 0, failed = 0, again = 0, seconds = 0;
  std::vector<Fuzzed> fuzzed;
};

/// Throws std::runtime_error where the text is not a valid proof.
Proof proof_of(const std::string& json);
/// The proof as a section with its heading.
std::string proof_text(const Proof&);

}  // namespace isect::bench
