#pragma once
// The interesting place on the way of a drag: where the lesson's case changes. It is found by asking the lesson's own
// exact answer, down to neighbouring doubles.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns the case of a setting, in plain words without numbers: its region on the lesson's map or, where it has no
/// place there, its verdict.
std::string case_of(const Lesson&, const Parameters&);

struct Snapped {
  Parameters setting;
  bool exact = false;  ///< the setting is the border itself; else the border lies between neighbouring doubles
  std::string told;    ///< plain: "touching, exactly", or which cases meet here
};

/// Settings along a way, from 0 on; nothing where the lesson forbids the setting.
using Way = std::function<std::optional<Parameters>(double)>;

/// A setting of a way that may differ from all others near it: where the handle is level with another point.
struct Landmark {
  double share = 0;
  Parameters setting;
};

/// Looks for the border nearest to `wish` on a part of a way, or for a landmark that is a case by itself. It asks the
/// lesson about a hundred settings: a window spreads that over several frames. A setting that the lesson refuses is
/// skipped. The lesson must outlive it.
class BorderSearch {
 public:
  BorderSearch(const Lesson&, Way, double begin, double end, double wish, std::vector<Landmark> = {});
  /// Asks about one more setting; returns false if none is left.
  bool go_on();
  /// Returns the result, at the end: nothing if the case does not change there, as far as some forty places tell, or if
  /// the lesson takes long over one setting.
  const std::optional<Snapped>& found() const { return found_; }

 private:
  /// A setting of the way, and its case.
  struct Place {
    double share = 0;
    std::optional<Parameters> setting = {};
    std::string is = {};
  };

  Place at(double share) const;
  Place of(double share, std::optional<Parameters> setting) const;
  bool ask_at(int i);
  bool ask_at(const Landmark&);
  bool look_for_change();
  bool bisect();
  bool bisect_number();
  bool tell();  // a separate step: it asks about both sides
  bool end();

  const Lesson& lesson_;
  Way way_;
  double begin_, end_, wish_;
  bool (BorderSearch::*next_)() = &BorderSearch::look_for_change;
  std::vector<Landmark> landmarks_;
  std::vector<int> order_;                     ///< the parts of the way, then landmarks; the nearest to `wish` first
  std::map<int, Place> places_;                ///< what was asked at the ends of such parts
  std::size_t looked_at_ = 0;                  ///< how many of `order_`
  std::vector<Place> about_;                   ///< a landmark and the settings right before and behind it
  bool slow_ = true;                           ///< judged by the first two settings
  Place near_, far_;                           ///< two settings of different cases, brought together
  std::string beyond_;                         ///< the case of `far_` at first
  std::optional<std::size_t> only_different_;  ///< the only number in which they differ
  std::optional<Snapped> found_;
};

/// Runs such a search to its end.
std::optional<Snapped> find_border(const Lesson&, const Way&, double begin, double end, double wish,
                                   std::vector<Landmark> = {});

/// Returns the way of a handle from one point to another; a coordinate that changes much less than another one is kept.
Way way_of(const Lesson&, const Parameters&, const Handle&, const Vec3& from, const Vec3& to);
/// Returns the landmarks on that way: settings level with another handle, or with what the scene marks. If there are
/// thousands, those nearest to `wish`.
std::vector<Landmark> landmarks(const Lesson&, const Parameters&, const Handle&, const Vec3& from, const Vec3& to,
                                const Scene&, double wish);
/// Returns the way of a setting over the lesson's map.
Way way_of(const Lesson&, const Parameters&, const Vec2& from, const Vec2& to);

}  // namespace isect::viz
