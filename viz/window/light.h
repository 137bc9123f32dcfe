#pragma once
// One name, one light: the name at the pointer or the keyboard focus is lit wherever it occurs.

#include <string>
#include <vector>

#include "viz/window/layout.h"

namespace isect::viz {

class Light {
 public:
  /// Says that the pointer is at these names, which stand in `at`. Of several such places in a frame the smallest
  /// counts. `tells`: what is known of them may be shown there.
  void point(const std::vector<std::string>& names, const Rect& at, bool tells = true) {
    take(pointed_, names, at, tells);
  }
  /// Says that the keyboard focus is on these names.
  void hold(const std::vector<std::string>& names, const Rect& at) { take(held_, names, at, true); }
  /// Ends a frame that took this long. Whichever moved last decides, pointer or keyboard.
  void end_frame(double seconds, bool at_once, bool pointer_moved, bool keyboard_moved);

  /// Returns how brightly a name is lit, from 0 to 1.
  double of(const std::string& name) const;
  double of(const std::vector<std::string>& names) const;  ///< the brightest
  bool on() const { return strength_ > 0; }
  /// Whether the next frame will look different.
  bool changing() const { return changing_ || strength_ != (wanted_.names.empty() ? 0 : 1); }
  /// Returns the one name that is asked for; empty: none or several. at() is its place.
  std::string name() const { return wanted_.names.size() == 1 && wanted_.tells ? wanted_.names[0] : std::string(); }
  const Rect& at() const { return wanted_.at; }
  bool by_keyboard() const { return by_keyboard_; }

 private:
  struct Asked {
    std::vector<std::string> names = {};
    Rect at = {};
    bool tells = false;
  };
  static void take(Asked&, const std::vector<std::string>& names, const Rect& at, bool tells);

  Asked pointed_, held_, wanted_;  ///< asked for in this frame; what is or was last lit
  std::vector<std::string> lit_;
  double strength_ = 0;
  bool by_keyboard_ = false, changing_ = false;
};

}  // namespace isect::viz
