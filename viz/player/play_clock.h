#pragma once
// Play: whether it runs, how fast, and for how long a step stays on show.

namespace isect::viz {

class PlayClock {
 public:
  bool playing() const { return playing_; }
  /// Starts or stops; the step on show gets its whole time again.
  void play(bool on);

  /// Whether play stops at questions, as it does at first, or passes over them.
  bool stops_at_questions() const { return stops_; }
  void stop_at_questions(bool wanted) { stops_ = wanted; }

  double speed() const { return speed_; }
  /// Goes through 0.5x, 1x, 1.5x, 2x and round again.
  void next_speed();
  void set_speed(double);

  /// Returns the time until play shows another step.
  double seconds_to_step() const;
  /// Lets time pass for a step; returns true when it is over, and begins the next one's time.
  bool advance(double seconds);
  void begin_step() { waited_ = 0; }
  /// Begins the time of a step that an answer has led to: it is longer, to read why the answer was right.
  void begin_answered_step();

 private:
  bool playing_ = false, stops_ = true;
  double speed_ = 1, waited_ = 0;
};

}  // namespace isect::viz
