#pragma once
// The motion from one step's scene to the next.

#include <memory>

#include "viz/scene.h"

namespace isect::viz {

/// The time in which a step's picture, and its view, become the next.
constexpr double seconds_to_move = 0.220;

class StepMotion {
 public:
  /// `reduced`: all is there at once.
  explicit StepMotion(bool reduced = false) : reduced_(reduced) {}

  /// Returns the scene that the one on show is coming from; null at rest.
  const Scene* before() const { return before_.get(); }
  /// Returns how far the motion has come: 0 at the old scene, 1 at the new one.
  double share() const;
  /// Returns how far the lights have come up, which is faster.
  double light() const;

  void begin(std::shared_ptr<const Scene> from);
  void advance(double seconds);
  void end() { before_.reset(); }
  void reduce(bool);
  bool reduced() const { return reduced_; }
  /// Comes as far as another motion has come.
  void follow(const StepMotion&);

 private:
  std::shared_ptr<const Scene> before_;
  double since_step_ = 1e9;  ///< seconds
  bool reduced_;
};

}  // namespace isect::viz
