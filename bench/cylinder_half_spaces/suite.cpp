// Cylinder against the half-spaces of a k-DOP: whether they meet, exactly.

#include <isect/cylinder_half_spaces.h>

#include "bench/cylinder_half_spaces/compete.h"

namespace isect::bench::cylinder_half_spaces_suite {

void measure(Session& session) { solid_and_kdop::measure<Cylinder>(session, "cylinder-half-spaces"); }

}  // namespace isect::bench::cylinder_half_spaces_suite
