#pragma once
// What a user waits for, measured by starting this program again: its start, a figure, all figures, frames.

#include <functional>

#include "app/program.h"
#include "bench/report.h"

namespace isect::program {

/// `told` hears what comes next. Without the slow ones when `quick`. What can't be measured here, for want of a
/// rendering back end, is left out.
std::vector<bench::Duty> duties(const Program&, bool quick, const std::function<void(const std::string&)>& told);

}  // namespace isect::program
