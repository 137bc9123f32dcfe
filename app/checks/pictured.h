#pragma once
// One picture of a walk and its baseline, as Baselines compares them, and the failures that this can find.

#include <string>

#include "app/checks/baselines.h"

namespace isect::program {

/// A step's picture in one look.
struct Pictured {
  const Excerpt* excerpt;
  int step;            ///< from 0
  const Guard* guard;  ///< null: the usual look
  std::string baseline;
  std::string style;  ///< to draw the look again, as figures carry it; empty for the usual one
};

/// Returns what an accepted picture carries: neither a scene's texts nor the version, which change where no pixel does.
viz::Metadata kept_metadata(const Pictured&);

/// Returns a failure with the cause of its kind, of no preset yet.
Failure failure(Failure::Kind, const std::string& what, const std::string& baseline);
/// Returns the failure that a pointer stands in place of the file itself.
Failure lfs_pointer(const std::string& baseline);
/// Returns it as a failure of this walk, or of one of its steps (-1: of none).
Failure about(const Excerpt&, int step, Failure);
Failure about(const Pictured&, Failure);

}  // namespace isect::program
