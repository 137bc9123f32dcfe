#pragma once
// The interesting place on the way of a drag: where the lesson's case changes, found by asking the lesson's own exact
// answer down to neighbouring doubles.

#include <functional>
#include <optional>
#include <string>

#include "viz/lesson.h"

namespace isect::viz {

/// Which case a setting is, in plain words without numbers: its region on the lesson's map or, where it has no place
/// there, its verdict.
std::string case_of(const Lesson&, const Parameters&);

struct Snapped {
  Parameters setting;
  bool exact = false;  ///< the setting is the border itself; else that lies between two neighbouring doubles
  std::string told;    ///< plain: "touching, exactly", or which cases meet here
};

/// Settings along a way, from 0 on; nothing where the lesson forbids one.
using Way = std::function<std::optional<Parameters>(double)>;
/// The border nearest to `wish` on a part of the way; nothing if the case does not change there, as far as some forty
/// places tell, nor where the lesson takes long over one setting.
std::optional<Snapped> find_border(const Lesson&, const Way&, double begin, double end, double wish);

/// The way of a handle from one point to another; a coordinate that changes much less than another is kept.
Way way_of(const Lesson&, const Parameters&, const Handle&, const Vec3& from, const Vec3& to);
/// The way of a setting over the lesson's map.
Way way_of(const Lesson&, const Parameters&, const Vec2& from, const Vec2& to);

}  // namespace isect::viz
