#pragma once
// The interesting place on the way of a drag: where the lesson's case changes, found by asking the lesson's own exact
// answer down to neighbouring doubles.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

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

/// A setting of a way that may be unlike all others about it: where the handle is level with another point.
struct Landmark {
  double share = 0;
  Parameters setting;
};

/// Looks for the border nearest to `wish` on a part of a way, or the landmark that is a case of its own. It asks the
/// lesson about a hundred settings: a window does that over several frames. A setting that the lesson refuses counts as
/// none. The lesson must outlive it.
class BorderSearch {
 public:
  BorderSearch(const Lesson&, Way, double begin, double end, double wish, std::vector<Landmark> = {});
  /// Asks about one setting more; false: all is asked.
  bool go_on();
  /// In the end: nothing if the case does not change there, as far as some forty places tell, nor where the lesson
  /// takes long over one setting.
  const std::optional<Snapped>& found() const { return found_; }

 private:
  /// A setting of the way, with its case.
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
  bool tell();  // a step of its own: it asks about both sides
  bool end();

  const Lesson& lesson_;
  Way way_;
  double begin_, end_, wish_;
  bool (BorderSearch::*next_)() = &BorderSearch::look_for_change;
  std::vector<Landmark> landmarks_;
  std::vector<int> order_;                     ///< the parts of the way, then landmarks; the nearest to `wish` first
  std::map<int, Place> places_;                ///< what was asked at the ends of such parts
  std::size_t looked_at_ = 0;                  ///< of `order_`
  std::vector<Place> about_;                   ///< a landmark and what lies right before and behind it
  bool slow_ = true;                           ///< as far as the first two settings tell
  Place near_, far_;                           ///< two settings of different cases, brought together
  std::string beyond_;                         ///< the case of `far_` at first
  std::optional<std::size_t> only_different_;  ///< the only number in which they differ
  std::optional<Snapped> found_;
};

/// All of such a search at once.
std::optional<Snapped> find_border(const Lesson&, const Way&, double begin, double end, double wish,
                                   std::vector<Landmark> = {});

/// The way of a handle from one point to another; a coordinate that changes much less than another is kept.
Way way_of(const Lesson&, const Parameters&, const Handle&, const Vec3& from, const Vec3& to);
/// The landmarks on that way: level with another handle, or with what the scene marks. Of thousands, those nearest to
/// `wish`.
std::vector<Landmark> landmarks(const Lesson&, const Parameters&, const Handle&, const Vec3& from, const Vec3& to,
                                const Scene&, double wish);
/// The way of a setting over the lesson's map.
Way way_of(const Lesson&, const Parameters&, const Vec2& from, const Vec2& to);

}  // namespace isect::viz
