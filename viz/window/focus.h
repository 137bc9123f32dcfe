#pragma once
// What the keyboard holds: one of the widgets of a frame, in the order in which they are read.

#include <string>
#include <vector>

namespace isect::viz {

class Focus {
 public:
  /// Called for every widget of a frame, in order; `group`: the part of the window that it belongs to. True: the
  /// keyboard holds this one.
  bool offer(const std::string& name, int group, bool in_popup);
  /// Ends a frame. What is gone is no longer held; while a popup is open its widgets are all there are, and when it has
  /// closed the keyboard holds again what it held before.
  void end_frame();

  /// The next one, or one before; round and round.
  void move(int by);
  /// The first one of the next part of the window.
  void next_group();
  /// This one, which may appear only in the next frames.
  void take(const std::string& name) { name_ = name, patience_ = 3, moved_ = true; }
  /// Presses what is held, in this frame.
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
  int patience_ = 0;  ///< frames in which what is held may be missing
  bool in_popup_ = false, pressed_ = false, moved_ = false;
};

}  // namespace isect::viz
