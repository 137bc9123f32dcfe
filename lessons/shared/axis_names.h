#pragma once

namespace isect::lessons {

inline constexpr const char* axis_names[] = {"*x*", "*y*", "*z*"};

}  // namespace isect::lessons
