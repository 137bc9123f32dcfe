#pragma once
// What failures have in common: most changes show in many pictures.

#include <string>
#include <vector>

#include "app/checks/baselines.h"

namespace isect::program {

struct Report;

/// The cause of a difference of which the trace tells nothing.
inline constexpr const char* only_pixels = "only pixels differ";

/// Returns the cause of a trace's changes, which are sorted by what they are of: the first.
std::string cause_of_trace(const std::vector<viz::Change>& sorted);
/// Returns the cause of a difference in a step's picture: a setting that changed, else the first of what the step says
/// or shows that did; only pixels, if what it shows is the same.
std::string cause_of_picture(const std::vector<viz::Change>& sorted, int step);
/// Returns the cause of a failure that has none of its own: "no baseline yet".
std::string cause_of(Failure::Kind);
/// Returns the failure's own cause, else that of its kind.
std::string cause_of(const Failure&);

/// Failures with one cause, in the order of the report.
struct CauseGroup {
  std::string cause;
  std::vector<const Failure*> failures;
};
/// Returns the failures that are not accepted, the largest group first, of two equal ones the one that begins first.
std::vector<CauseGroup> by_cause(const Report&);

/// Returns "11 pictures and 1 trace".
std::string counted(const std::vector<const Failure*>&);
/// Returns "11 pictures and 1 trace: the label r moved".
std::string heading(const CauseGroup&);

}  // namespace isect::program
