#pragma once
// Two bodies that move, what is true of them by the core's exact tests, and how they are drawn.

#include <isect/many/motion.h>
#include <isect/methods/motion.h>
#include "viz/lesson.h"

namespace isect::lessons::moving_bodies_lesson {

/// What is true of two bodies for the duration; the order is that of the branches of the map.
enum class Meeting { past, met, at_first, late, unseen, rest, grazing };

struct Setup {
  std::string method;           ///< "boxes", "balls", "discrete", "conservative"
  Point<double, 2> a, b;        ///< centres at t = 0
  Vector<double, 2> v_a, v_b;   ///< velocities
  double r_a = 0, r_b = 0;      ///< radii of balls, half the sides of boxes
  double duration = 0;          ///< seconds
  int tests = 1;                ///< of `discrete`, besides that at t = 0
  double tolerance = 0;         ///< of `conservative`
  motion::Bound bound = {};     ///< of `conservative`
  motion::Approach signs = {};  ///< of balls
  bool touching = false;        ///< they touch at t = 0
  Meeting truth = Meeting::past;
  std::optional<double> first;  ///< when they first meet, within the duration

  bool balls() const { return method == "balls" || method == "conservative"; }
  std::string body() const { return balls() ? "ball" : "box"; }
  std::string bodies() const { return balls() ? "balls" : "boxes"; }
  Moving<Aabb, double, 2> box_a() const { return {around(a, r_a), v_a}; }
  Moving<Aabb, double, 2> box_b() const { return {around(b, r_b), v_b}; }
  Moving<Sphere, double, 2> ball_a() const { return {{a, r_a}, v_a}; }
  Moving<Sphere, double, 2> ball_b() const { return {{b, r_b}, v_b}; }

  /// The velocity of b, seen from a; each coordinate is rounded.
  Vector<double, 2> d() const { return v_b - v_a; }
  /// The centre of b at this time, seen from a.
  Point<double, 2> b_at(double t) const { return b + t * d(); }
  /// From when to when they would meet if the motion had no end; boxes only.
  std::optional<Interval<double>> without_end() const;
  /// When they would first meet if the motion had no end.
  std::optional<double> first_without_end() const;

  static Aabb<double, 2> around(const Point<double, 2>& c, double r) {
    return {c - Vector<double, 2>::Constant(r), c + Vector<double, 2>::Constant(r)};
  }
};
Setup setup(const viz::Parameters&);

/// Times drawn as a row below the bodies.
struct Row {
  std::string name;
  Interval<double> times;
  viz::Role role;
};

/// What a step shows.
struct Known {
  bool from_a = false;                          ///< a stays where it is, and b moves by d
  bool expanded = false;                        ///< a is expanded by b, and b shrinks to its centre
  bool clock = false;                           ///< the duration as a line below the bodies, with the rows above it
  std::vector<Row> rows = {};                   ///< from the top
  std::vector<double> at = {};                  ///< b is outlined at these times
  std::optional<double> gap = {};               ///< the distance at this time is drawn
  std::vector<viz::Axis::Tick> ticks = {};      ///< on the axis of time
  std::optional<Interval<double>> shared = {};  ///< on the axis of time: when they meet
  bool settled = false;
  bool found = false;              ///< first contact is told
  std::optional<double> now = {};  ///< the bodies are drawn as they are at this time; none: at the start
};
/// The scene, with the time in which its bodies move.
viz::Scene picture(const Setup&, const Known&);

/// Where the centre of b lies at t = 0, seen from a. (cases.cpp)
const viz::CaseMap& cases();
/// What each method says: whether the bodies meet. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::moving_bodies_lesson
