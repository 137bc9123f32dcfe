#pragma once
// How time runs in a scene whose shapes move: evenly, and slower where they touch first.

#include <string>

#include "viz/lesson.h"

namespace isect::viz {

/// The seconds in which a whole motion is played, but for what is slowed down.
inline constexpr double seconds_of_motion = 4;
/// Within this share of the motion before and after first contact, time runs so many times slower.
inline constexpr double slow_share = 0.1, slower = 4;

/// Returns the time at which play is `seconds` after `from`; it ends with the motion.
double time_after(const Scene::Time&, double from, double seconds);
/// Returns the time of the motion nearest to t, and first contact itself if that is no further than `reach`.
double time_near(const Scene::Time&, double t, double reach = 0);
/// Returns the time a fortieth of the motion after `now`, or before it; it does not leap over first contact.
double time_beside(const Scene::Time&, double now, int way);
/// Returns the next of the stills that stand for the motion where nothing is to move by itself: its quarters and first
/// contact; after the end, the begin.
double next_still(const Scene::Time&, double now);
/// Returns "*t* = 0.37 (contact at *t* = 0.5)", and in `brief` the first of it.
std::string time_words(const Scene::Time&, double now, bool brief = false);

/// Returns the walk with a step, from 0, drawn at time t of its motion, or at the nearest one: its caption says so.
/// What questions show stays as it was, and so does all of a walk in whose step nothing moves.
Walk at_time(Walk, int step, double t);

}  // namespace isect::viz
