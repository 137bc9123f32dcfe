#pragma once
// What a listener may hear of how a sign is found: which arithmetics were asked, and what each of them found.
//
// Most listeners are told no more than Fallback, where doubles leave a sign open. One that derives from HearsStages is
// told every stage of every sign, the deciding one last. For the others, and where nobody listens, no code is added.

#include <optional>
#include <type_traits>

namespace isect {

/// What one stage of a sign found: |truth - value| <= bound, but for the rounding of value to a double.
struct Stage {
  /// The stages, in the order of the table in isect/numbers/README.md; Fused counts as Compensated.
  enum class Kind { doubles, grid, compensated, triple_double, medium_exact, short_exact, exact };
  Kind kind;
  double value;             ///< 0 for a grid; NaN where it needs more bits than the stage has
  double bound;             ///< 0 where nothing is rounded; infinite or NaN where something overflowed
  double step;              ///< the truth is a multiple of it; 0 where the stage doesn't ask
  std::optional<int> sign;  ///< of the truth: 1, 0, -1, or nothing where the stage leaves it open
};

/// A listener that derives from this is told each Stage.
struct HearsStages {};
template <class Trace>
inline constexpr bool hears_stages = std::is_base_of_v<HearsStages, std::remove_cvref_t<Trace>>;

}  // namespace isect
