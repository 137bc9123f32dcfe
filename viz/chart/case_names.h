#pragma once
// Where the names of a map's regions stand: each wholly in its region, or beside it with a leader that ends there.

#include <optional>
#include <utility>
#include <vector>

#include "viz/chart/chart.h"
#include "viz/compose/labels.h"

namespace isect::viz {

/// Whether a branch has no region, only a line or a point of the plane.
bool is_thin(const Cases&, int branch);

struct NamePlace {
  Vec2 middle;
  std::optional<Vec2> leads_to = {};  ///< a point of its region, where the name stands beside it
  bool on_border = false;             ///< there is no place off the borders
  double cost = 0;                    ///< 0 in its region; else the leader's length, plus penalties for obstacles
};

/// The plane as fine cells, each wholly of one branch or of none.
class CaseNames {
 public:
  /// A place of this cost or more has a leader across another one, or something over a name.
  static constexpr double crossed = 1500;

  CaseNames(const Cases&, const Bounds& plane);

  /// Names keep off this box, and leaders too, unless they `may_cross` it.
  void take(const TextBox&, bool may_cross = false);
  /// Names keep off this line, and their leaders do not cross it.
  void take_leader(const Vec2& from, const Vec2& to);
  /// Returns what a leader would cost for the names and leaders that it meets.
  double in_the_way(const Vec2& from, const Vec2& to) const;
  /// Returns where a name of this size has most room in its region; else the nearest place from which a leader reaches
  /// it. Of equally good places it takes the first in order, however a machine rounds.
  NamePlace place(int branch, const Vec2& size) const;

 private:
  static constexpr int columns = 120, rows = 72;
  struct Room {
    Vec2 middle = Vec2::Zero();  ///< in cells, from the lower left corner
    double scale = 0;            ///< of the largest box there to the one asked for
  };

  void rasterise(const Cases&);
  Room largest(int branch, const Vec2& name) const;
  /// Whether a box, in cells, lies wholly in this branch's region and off what is taken.
  bool filled(int branch, const Vec2& middle, const Vec2& half) const;
  /// Whether a box lies wholly in one region of any branch and off what is taken.
  bool filled(const Vec2& middle, const Vec2& half) const;
  Vec2 some_point_of(int branch) const;
  NamePlace beside(int branch, const Vec2& size) const;
  /// Returns the cheapest place beside `to` that costs less than `most`, searched every `step` cells (may be below 1).
  NamePlace beside(const Vec2& to, const Vec2& size, double step, double most) const;

  int& sum(int branch, int x, int y);
  int count(int branch, int x0, int y0, int x1, int y1) const;
  Vec2 drawn(const Vec2& cells) const;

  const Cases& cases_;
  Bounds plane_;
  Vec2 cell_;                           ///< its size
  std::vector<std::vector<int>> sums_;  ///< per branch: the number of its cells below and left of a corner
  std::vector<TextBox> taken_, crossable_;
  std::vector<std::pair<Vec2, Vec2>> leaders_;
};

}  // namespace isect::viz
