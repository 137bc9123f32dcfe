#pragma once
// The parts of the walk, one after the other.

#include "lessons/rounding_bound/setup.h"
#include "lessons/shared/script.h"

namespace isect::lessons::rounding_bound_lesson {

/// From one rounded difference to the bound on the determinant. (derivation.cpp)
void tell_derivation(Script&, const Setup&, const Run&);
/// Whether the sign gets through the filter. (decision.cpp)
void tell_decision(Script&, const Setup&, const Run&);
/// The stages after doubles, up to the one that decides. (stages.cpp)
void tell_stages(Script&, const Run&);
/// What is true of the neighbours, which stage decides each, and what the filter lets through. (cells.cpp)
void tell_cells(Script&, const Setup&);

/// "**a** lies left of the line"
inline std::string where_a_lies(int sign) { return "**a** lies " + place(sign); }
inline viz::Verdict::Kind kind_of(int truth) { return truth == 0 ? viz::Verdict::Kind::on : viz::Verdict::Kind::yes; }

}  // namespace isect::lessons::rounding_bound_lesson
