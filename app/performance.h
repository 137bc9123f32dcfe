#pragma once
// Times that a user waits, measured by starting this program again: its start, a figure, all figures, frames.

#include <functional>

#include "app/program.h"
#include "bench/report.h"

namespace isect::program {

/// `told` is called with what comes next. With `quick`, slow measurements are skipped. What can't be measured here, for
/// lack of a rendering back end, is left out.
std::vector<bench::Duty> performance(const Program&, bool quick, const std::function<void(const std::string&)>& told);

}  // namespace isect::program
