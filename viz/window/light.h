#pragma once
// One name, one light: what the pointer or the keyboard is at is lit wherever it is named.

#include <string>
#include <vector>

#include "viz/window/layout.h"

namespace isect::viz {

class Light {
 public:
  /// The pointer is at these names, which stand in `at`. Of several such places in a frame the smallest counts.
  /// `tells`: what is known of them may be told there.
  void point(const std::vector<std::string>& names, const Rect& at, bool tells = true) {
    take(pointed_, names, at, tells);
  }
  /// The keyboard holds them.
  void hold(const std::vector<std::string>& names, const Rect& at) { take(held_, names, at, true); }
  /// Ends a frame that took so long. Whichever moved last decides, pointer or keyboard.
  void end_frame(double seconds, bool at_once, bool pointer_moved, bool keyboard_moved);

  /// How brightly a name is lit, from 0 to 1.
  double of(const std::string& name) const;
  double of(const std::vector<std::string>& names) const;  ///< the brightest
  bool on() const { return strength_ > 0; }
  /// It is not yet what the next frame shows.
  bool changing() const { return changing_ || strength_ != (wanted_.names.empty() ? 0 : 1); }
  /// The one name that is asked for, and where; empty: none or several.
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

  Asked pointed_, held_, wanted_;  ///< asked for in this frame; what is lit, or last was
  std::vector<std::string> lit_;
  double strength_ = 0;
  bool by_keyboard_ = false, changing_ = false;
};

}  // namespace isect::viz
