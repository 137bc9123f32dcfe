#pragma once
// `ask` of isect/ask.h for two AnyShapes in doubles, compiled in core/compiled/ask_any.cpp (isect::core_compiled): a
// file that includes this header does not compile the table of pairs again.

#include <optional>

#include <isect/answer.h>
#include <isect/any_shape.h>

namespace isect {

Answer ask_any(const AnyShape<double, 2>&, const AnyShape<double, 2>&);
/// Empty where no test decides the pair.
std::optional<Answer> ask_any(const AnyShape<double, 3>&, const AnyShape<double, 3>&);

}  // namespace isect
