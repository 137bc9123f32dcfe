#pragma once
// A small box that flies at a thin wall: how they are drawn, also at any time of the flight.

#include <optional>
#include <vector>

#include <isect/interval_interval.h>
#include <isect/many/motion.h>
#include "viz/lesson.h"

namespace isect::lessons::collision_lesson {

constexpr double duration = 1.5;  ///< of the flight, in seconds

/// The box is centred at `p`.
Moving<Aabb, double, 2> bullet_at(const viz::Vec3& p, double speed);
Moving<Aabb, double, 2> the_wall();

class FlightPicture {
 public:
  FlightPicture(const viz::Vec3& p, double speed)
      : bullet_(bullet_at(p, speed)), wall_(the_wall()), truth_(contact(bullet_, wall_, duration)) {}

  /// Returns what is known so far, with the time in which the box flies.
  viz::Scene picture() const;

 protected:
  Aabb<double, 2> place(double t) const;
  bool rests() const { return bullet_.velocity.x() == 0; }

  Moving<Aabb, double, 2> bullet_, wall_;
  std::optional<Interval<double>> truth_;  ///< when they are in contact
  std::vector<double> seen_;               ///< the times tested so far
  double at_ = -1;                         ///< the one tested now; < 0: none
  bool swept_ = false;                     ///< the box around the whole path is shown
  bool grown_ = false;                     ///< the wall is expanded, and the box its centre

 private:
  /// `now`: the box is drawn as it is at this time; none: at the one tested now.
  viz::Scene drawn(std::optional<double> now) const;
  void draw_contact(viz::Scene&) const;
  void draw_now(viz::Scene&, double now) const;
};

}  // namespace isect::lessons::collision_lesson
