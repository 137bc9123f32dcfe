#pragma once
// accept.json: the files that a person has ticked in the report of a check, each with the digest of what was looked at,
// for `isect check --accept`:
//
//   {"accept": [{"file": "ray-sphere/tangent/03-foot.png", "digest": "9c1185a5c5e9fc54"},
//               {"file": "ray-sphere/tangnt/03-foot.png", "digest": "af63dc4c8601ec8c", "remove": true}]}

#include <string>
#include <vector>

namespace isect::program {

/// A file among the baselines, as it was reviewed.
struct Reviewed {
  std::string file;     ///< below the folder of the baselines
  std::string digest;   ///< of what it would be; of what it is if it is to be removed
  bool remove = false;  ///< no step has it any more
};

/// Returns the list alone: [{"file": ..., "digest": ...}].
std::string reviewed_json(const std::vector<Reviewed>&);
/// Reads such a file. Throws viz::BadInput, which names the entry, from 1, and the field.
std::vector<Reviewed> read_accept_file(const std::string& text);

/// Such a list while it is worked off: what becomes of each of its files.
class Acceptance {
 public:
  explicit Acceptance(std::vector<Reviewed>);

  /// Whether the list names this file, to be written.
  bool names(const std::string& file) const;
  /// Whether it names a file below this folder, "ray-sphere/tangent".
  bool names_some_in(const std::string& folder) const;
  /// Whether any file is to be removed.
  bool removes() const;

  /// What the check knows of a file.
  struct Found {
    std::string now, there;      ///< digests of what it would be, and of what it is; empty if there is none
    bool differs = false;        ///< the check complains of it
    std::string hindrance = {};  ///< why it may not be written all the same
  };
  /// Whether the file is to be written: the list names it, and what it would be is what was reviewed.
  bool takes(const std::string& file, const Found&);
  /// Whether a file that no step has is to be removed: the list says so, and it is what was reviewed.
  bool takes_away(const std::string& file, const std::string& there);
  /// To be called at the end: files that nothing was said of belong to no step here. `folder`: that of the baselines.
  void close(const std::string& folder);

  struct Outcome {
    enum class Is { open, accepted, removed, already, refused } is = Is::open;
    std::string file, why;  ///< why it is refused
  };
  const std::vector<Outcome>& outcomes() const { return outcomes_; }

 private:
  std::size_t find(const std::string& file, bool remove) const;
  void end(std::size_t, Outcome::Is, const std::string& why = {});

  std::vector<Reviewed> files_;
  std::vector<Outcome> outcomes_;  ///< one for each file
};

/// Returns a line for each file, and how many were accepted.
std::string to_text(const Acceptance&);
/// {"accepted": [file...], "removed": [...], "already": [...], "refused": [{"file", "why"}...]}
std::string to_json(const Acceptance&);
/// Returns the exit status: check_failed if a file was refused.
int status(const Acceptance&);

}  // namespace isect::program
