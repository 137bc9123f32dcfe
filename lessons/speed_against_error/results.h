#pragma once
// The measurements that the lesson reads: bench/results.json, as it was when the program was built.

#include "bench/report.h"

namespace isect::lessons::speed_against_error_lesson {

const bench::Report& results();

}  // namespace isect::lessons::speed_against_error_lesson
