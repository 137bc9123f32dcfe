// Cone against the half-spaces of a k-DOP: whether they meet, exactly.

#include <isect/cone_half_spaces.h>

#include "bench/cylinder_half_spaces/compete.h"

namespace isect::bench::cone_half_spaces_suite {

void measure(Session& session) { solid_and_kdop::measure<Cone>(session, "cone-half-spaces"); }

}  // namespace isect::bench::cone_half_spaces_suite
