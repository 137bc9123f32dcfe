#include "viz/compose/labels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

struct Candidate {
  Vec2 middle;
  Vec2 anchor;    ///< the point named
  double effort;  ///< how unusual this place is
  bool far;
};

/// Differences below this are ties, however a machine rounds: in pixels, in costs, and for a direction's part.
constexpr double tie = 1e-6;

struct Fit {
  double cost;
  bool crossed;
};

double overlap(const TextBox& a, const TextBox& b) {
  const double w = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double h = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return w > tie && h > tie ? w * h : 0;
}

/// Returns half the extent of a box along a direction.
double support(const Vec2& half, const Vec2& direction) {
  return half.x() * std::abs(direction.x()) + half.y() * std::abs(direction.y());
}

std::vector<Candidate> beside_point(const Wanted& wanted, const Vec2& half, const Sizes& sizes) {
  // NE, NW, SE, SW, N, S, then E and W; y runs down
  static const Vec2 compass[] = {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}};
  static const double rings[] = {0.16, 0.45, 0.9, 1.6, 2.6};
  std::vector<Candidate> candidates;
  double effort = 0;
  if (wanted.at_place) candidates.push_back({wanted.from, wanted.from, effort++, false});
  for (const double ring : rings) {
    if (wanted.at_place && ring < 0.9) continue;  // no room for a leader
    const double gap = wanted.keep_off + ring * sizes.label_offset;
    for (const Vec2& d : compass) {
      const bool diagonal = d.x() != 0 && d.y() != 0;
      const double reach = diagonal ? 0.72 * gap : gap;
      const Vec2 middle = wanted.from + Vec2(d.x() * (half.x() + reach), d.y() * (half.y() + reach));
      candidates.push_back({middle, wanted.from, effort, wanted.at_place || ring > 1});
      effort += 0.6;
    }
    effort += 4;
  }
  return candidates;
}

std::vector<Candidate> beside_segment(const Wanted& wanted, const Vec2& half, const Sizes& sizes) {
  const Vec2 along = (wanted.to - wanted.from).normalized();
  const Vec2 across = {along.y(), -along.x()};
  std::vector<Candidate> candidates;
  double effort = 0;
  for (const double ring : {0.08, 0.25, 0.6, 1.4}) {
    for (const double share : {0.5, 0.38, 0.62, 0.25, 0.75}) {
      const double above = across.y() <= tie ? 1 : -1;
      for (const double side : {above, -above}) {
        const Vec2 anchor = wanted.from + share * (wanted.to - wanted.from);
        const double reach = support(half, across) + wanted.keep_off + ring * sizes.label_offset;
        candidates.push_back({anchor + side * reach * across, anchor, effort, ring > 1});
        effort += 0.4;
      }
    }
    effort += 8;
  }
  return candidates;
}

double distance(const Vec2& p, const TextBox& box) {
  return std::hypot(std::max({box.left - p.x(), p.x() - box.right, 0.0}),
                    std::max({box.top - p.y(), p.y() - box.bottom, 0.0}));
}

/// Whether a label without a leader stands about as near to another point as to its own point.
bool is_ambiguous(const Candidate& candidate, const TextBox& box, const std::vector<Vec2>& others, const Sizes& sizes) {
  const double near = distance(candidate.anchor, box) + sizes.label_clear;
  return !candidate.far && std::ranges::any_of(others, [&](const Vec2& p) { return distance(p, box) < near - tie; });
}

/// Whether the label or its leader meets another label's leader, or its leader meets another label.
bool is_tangled(const Candidate& candidate, const TextBox& box, const PlacedLabel& other) {
  const Vec2 from = nearest_in(box, candidate.anchor);
  if (candidate.far && length_inside(from, candidate.anchor, other.box) > 0) return true;
  if (!other.leads_to) return false;
  const Vec2 begin = nearest_in(other.box, *other.leads_to);
  return length_inside(begin, *other.leads_to, box) > 0 ||
         (candidate.far && cross(from, candidate.anchor, begin, *other.leads_to));
}

/// Returns the obstacles that may touch a label in any of the places.
std::vector<Obstacle> reached(const std::vector<Candidate>& candidates, const Vec2& half,
                              const std::vector<Obstacle>& obstacles, const Sizes& sizes) {
  if (candidates.empty()) return {};
  TextBox all = box_around(candidates.front().middle, half);
  for (const Candidate& candidate : candidates) {
    const TextBox box = box_around(candidate.middle, half);
    all = {std::min(all.left, box.left), std::min(all.top, box.top), std::max(all.right, box.right),
           std::max(all.bottom, box.bottom)};
  }
  std::vector<Obstacle> near;
  std::ranges::copy_if(obstacles, std::back_inserter(near), [&](const Obstacle& o) {
    return length_inside(o.from, o.to, grown(all, o.radius + 0.5 * sizes.label_clear)) > 0;
  });
  return near;
}

/// Returns what a label at this place disturbs; stops adding once the cost is at least `enough`.
Fit fit(const Candidate& candidate, const Vec2& half, const std::vector<Vec2>& others,
        const std::vector<PlacedLabel>& placed, const std::vector<Obstacle>& obstacles, const Bounds& bounds,
        const Sizes& sizes, double enough) {
  Fit result = {candidate.effort, false};
  if (!(result.cost < enough)) return result;
  const TextBox box = box_around(candidate.middle, half);
  if (is_ambiguous(candidate, box, others, sizes)) result.cost += 500;
  for (const PlacedLabel& other : placed)
    if (overlap(grown(box, sizes.label_clear), other.box) > 0)
      result.cost += 2000;
    else if (is_tangled(candidate, box, other))
      result.cost += 400;

  const double outside = std::max(
      {bounds.left - box.left, bounds.top - box.top, box.right - bounds.right, box.bottom - bounds.bottom, 0.0});
  if (outside > 0) result.cost += 5000 + outside;

  const double size = half.x() + half.y();
  for (const Obstacle& o : obstacles) {
    if (!(result.cost < enough)) return result;
    const double touched = length_inside(o.from, o.to, grown(box, o.radius + 0.5 * sizes.label_clear));
    if (touched <= 0) continue;
    result.cost += (o.firm ? 14 : 6) + (o.firm ? 20 : 8) * touched / size;
    const bool inside = length_inside(o.from, o.to, grown(box, o.radius)) > 0;
    result.crossed = result.crossed || inside;
    if (inside && o.firm && o.from == o.to && o.from != candidate.anchor) result.cost += 60;  // a marker hides letters
  }
  return result;
}

}  // namespace

TextBox box_around(const Vec2& middle, const Vec2& half) {
  return {middle.x() - half.x(), middle.y() - half.y(), middle.x() + half.x(), middle.y() + half.y()};
}

TextBox grown(const TextBox& b, double by) { return {b.left - by, b.top - by, b.right + by, b.bottom + by}; }

Vec2 nearest_in(const TextBox& b, const Vec2& p) {
  return {std::clamp(p.x(), b.left, b.right), std::clamp(p.y(), b.top, b.bottom)};
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x();
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Slabs, N12 per axis.
double length_inside(const Vec2& from, const Vec2& to, const TextBox& b) {
  const double low[2] = {b.left - tie, b.top - tie}, high[2] = {b.right + tie, b.bottom + tie};
  for (int i = 0; i < 2; ++i)  // most are far off
    if ((from[i] < low[i] && to[i] < low[i]) || (from[i] > high[i] && to[i] > high[i])) return 0;
  double lo = 0, hi = 1;
  const Vec2 d = to - from;
  for (int i = 0; i < 2; ++i) {
    if (d[i] == 0) {
      if (from[i] < low[i] || from[i] > high[i]) return 0;
      continue;
    }
    const double t0 = (low[i] - from[i]) / d[i], t1 = (high[i] - from[i]) / d[i];
    lo = std::max(lo, std::min(t0, t1));
    hi = std::min(hi, std::max(t0, t1));
  }
  if (lo > hi) return 0;
  return std::max((hi - lo) * d.norm(), 1.0);  // a point inside counts too
}

std::vector<PlacedLabel> place_labels(const std::vector<Wanted>& labels, const std::vector<Obstacle>& obstacles,
                                      const Bounds& bounds, const Theme& theme, std::vector<Shape>& out,
                                      std::vector<PlacedLabel> placed) {
  const Sizes& sizes = theme.sizes;
  std::vector<Shape> leaders, texts;
  for (const Wanted& wanted : labels) {
    Text text = {wanted.markup, Vec2::Zero(), sizes.label, wanted.colour, 0, false, 0, theme.background};
    const TextBox extent = measure(text);  // around the anchor at the origin
    const Vec2 half = {(extent.right - extent.left) / 2, (extent.bottom - extent.top) / 2};
    const Vec2 to_middle = {(extent.right + extent.left) / 2, (extent.bottom + extent.top) / 2};

    const bool segment = (wanted.to - wanted.from).norm() > 1e-6;
    const std::vector<Candidate> candidates =
        segment ? beside_segment(wanted, half, sizes) : beside_point(wanted, half, sizes);
    const std::vector<Obstacle> near = reached(candidates, half, obstacles, sizes);
    const Candidate* best = nullptr;
    Fit best_fit = {std::numeric_limits<double>::infinity(), false};
    for (const Candidate& candidate : candidates) {
      const double enough = best_fit.cost - tie;  // of equal places the first one wins
      const Fit f = fit(candidate, half, wanted.others, placed, near, bounds, sizes, enough);
      if (f.cost < enough) best = &candidate, best_fit = f;
    }
    if (best == nullptr) continue;  // the position is NaN

    text.at = best->middle - to_middle;
    if (best_fit.crossed) text.halo = sizes.label_halo;
    text.object = wanted.object;
    texts.emplace_back(text);
    placed.push_back({plain(wanted.markup), box_around(best->middle, half)});
    if (best->far) placed.back().leads_to = best->anchor;
    if (best->far && wanted.at_place)  // no other place is allowed
      leaders.emplace_back(Fill{.path = circle(best->anchor, 0.4 * sizes.disc),
                                .colour = theme.ink(Role::construction),
                                .hatch_colour = {},
                                .object = wanted.object});
    if (best->far) {
      const Vec2 d = (best->middle - best->anchor).normalized();
      const double room = (best->middle - best->anchor).norm() - support(half, d) - sizes.label_clear / 2;
      leaders.emplace_back(Stroke{polyline({best->anchor + wanted.keep_off * d, best->anchor + room * d}),
                                  theme.ink(Role::construction),
                                  sizes.leader,
                                  {0, 0},
                                  true,
                                  wanted.object});
    }
  }
  out.insert(out.end(), leaders.begin(), leaders.end());
  out.insert(out.end(), texts.begin(), texts.end());
  return placed;
}

}  // namespace isect::viz
