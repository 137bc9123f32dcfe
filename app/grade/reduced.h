#pragma once
// The simplest case on which a program is still wrong in the same way.

#include <string>

#include "app/grade/judge.h"

namespace isect::grade {

/// Returns a case with fewer and rounder numbers that still has the fault: the program is run again on many simpler
/// cases at once, some rounds long. `from` itself if there is none, or if the program does not answer them all. The
/// simpler cases are within the task's bounds.
Numbers reduced(const Task&, const Asked&, const Numbers& from, const std::string& fault);

}  // namespace isect::grade
