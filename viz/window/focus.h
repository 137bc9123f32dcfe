#pragma once
// The keyboard focus: one of the widgets of a frame, in reading order.

#include <string>
#include <vector>

namespace isect::viz {

class Focus {
 public:
  /// Called for every widget of a frame, in order; `group`: the part of the window to which it belongs. Returns whether
  /// the keyboard holds this one.
  bool offer(const std::string& name, int group, bool in_popup);
  /// Ends a frame. A widget that is gone is no longer held; while a popup is open only its widgets count, and when it
  /// has closed the keyboard holds again what it held before.
  void end_frame();

  /// Moves to the next widget, or to the one before, cyclically.
  void move(int by);
  /// Moves to the first widget of the next part of the window.
  void next_group();
  /// Moves to this widget, which may appear only in the next frames.
  void take(const std::string& name) { name_ = name, patience_ = 3, moved_ = true; }
  /// Lets the next move begin at this widget, which looks chosen, if none is held. Holds for this frame.
  void begin_at(const std::string& name) { begin_ = name; }
  /// Presses the held widget, in this frame.
  void press() { pressed_ = true; }
  void clear() { name_.clear(); }

  const std::string& name() const { return name_; }
  bool pressed() const { return pressed_ && !name_.empty(); }
  bool moved() const { return moved_; }

 private:
  struct Stop {
    std::string name;
    int group;
    bool in_popup;
  };
  std::vector<Stop> stops_, known_;  ///< of this frame; of the last one
  std::string name_, before_popup_;
  std::string begin_, known_begin_;  ///< of this frame; of the last one
  int patience_ = 0;                 ///< for how many frames the held widget may be missing
  bool in_popup_ = false, pressed_ = false, moved_ = false;
};

}  // namespace isect::viz
