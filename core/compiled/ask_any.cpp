// The one file that compiles the table of pairs for shapes whose types are known only at run time.

#include <isect/ask_any.h>

#include <isect/ask.h>

namespace isect {

Answer ask_any(const AnyShape<double, 2>& a, const AnyShape<double, 2>& b) { return ask(a, b); }
std::optional<Answer> ask_any(const AnyShape<double, 3>& a, const AnyShape<double, 3>& b) { return ask(a, b); }

}  // namespace isect
