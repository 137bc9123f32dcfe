#include "app/scene/marks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/scene/answered.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

using viz::Pen;
using viz::Role;
using viz::tr;
using viz::Vec3;

namespace {

/// A mark's lengths, as shares of the scene's reach.
constexpr double share_beside = 0.12, share_of_arc = 0.18, share_of_brace = 0.05;

class MarkDrawer {
 public:
  MarkDrawer(const Context& c, const AuthorMark& mark, const viz::Camera& camera)
      : c_(c), mark_(mark), camera_(camera) {}

  MarkPicture draw() {
    for (const Spot& spot : mark_.spots) {
      FoundSpot place = find_spot(c_, spot);
      if (!place.at) return {.missing = not_drawn(place.why)};
      places_.push_back(std::move(place));
    }
    using enum AuthorMark::Kind;
    switch (mark_.kind) {
      case point:
        draw_point();
        break;
      case arrow:
        out_.items.push_back(viz::Arrow{at(0), at(1), mark_.role});
        name_between(at(0), at(1), mark_.label.value_or(""));
        break;
      case line:
        out_.items.push_back(viz::Line{at(0), at(1), mark_.role, Pen::construction});
        name_between(at(0), at(1), mark_.label.value_or(""));
        break;
      case dimension:
        draw_dimension();
        break;
      case brace:
        draw_brace();
        break;
      case angle:
      case right_angle:
        draw_angle();
        break;
    }
    if (!out_.missing.empty()) return {.missing = out_.missing};
    out_.said = called() + (told_.empty() ? "" : ": " + told_);
    if (mark_.label && !mark_.label->empty() && mark_.kind != point)
      out_.said += tr(", labelled {label}", {{"label", *mark_.label}});
    return std::move(out_);
  }

 private:
  const Vec3& at(std::size_t i) const { return *places_[i].at; }
  ExactPoint exact(std::size_t i) const { return places_[i].exact.value_or(exact_point(at(i))); }
  bool is_exact() const {
    return std::ranges::all_of(places_, [](const FoundSpot& p) { return p.exact.has_value(); });
  }

  /// Returns what sentences call it.
  std::string called() const {
    const auto place = [&](std::size_t i) { return mark_.spots[i].text; };
    using enum AuthorMark::Kind;
    switch (mark_.kind) {
      case point:
        return tr("the point {name}, {p}", {{"name", shown_name(mark_.name)}, {"p", place(0)}});
      case arrow:
        return tr("an arrow from {p} to {q}", {{"p", place(0)}, {"q", place(1)}});
      case line:
        return tr("a dashed line from {p} to {q}", {{"p", place(0)}, {"q", place(1)}});
      case dimension:
        return tr("the length from {p} to {q}", {{"p", place(0)}, {"q", place(1)}});
      case brace:
        return tr("a brace from {p} to {q}", {{"p", place(0)}, {"q", place(1)}});
      case angle:
        return tr("the angle at {p} between {q} and {r}", {{"p", place(1)}, {"q", place(0)}, {"r", place(2)}});
      case right_angle:
        return tr("the right angle at {p} between {q} and {r}", {{"p", place(1)}, {"q", place(0)}, {"r", place(2)}});
    }
    return {};
  }

  std::string not_drawn(const std::string& why) const {
    return tr("Not drawn is {mark}: {why}.", {{"mark", called()}, {"why", why}});
  }

  void name_at(const Vec3& p, const std::string& text) {
    if (!text.empty()) out_.items.push_back(viz::Label{p, text, mark_.role});
  }
  void name_between(const Vec3& p, const Vec3& q, const std::string& text) {
    if (!text.empty()) out_.items.push_back(viz::Label{p, text, mark_.role, q});
  }

  void draw_point() {
    out_.items.push_back(viz::Dot{at(0), viz::Mark::disc, mark_.role});
    name_at(at(0), mark_.label.value_or(shown_name(mark_.name)));
    for (int i = 0; i < (c_.file.flat ? 2 : 3); ++i) told_ += (i == 0 ? "(" : ", ") + viz::shown(at(0)[i]);
    told_ += ")";
    if (!is_exact()) told_ = tr("about {p}", {{"p", told_}});
  }

  /// Returns the direction, of length 1, in which a length stands beside its points: across the view, away from the
  /// middle of the scene; and how far.
  std::pair<Vec3, double> beside_points() const {
    const Vec3 way = at(1) - at(0);
    const Vec3 ahead = c_.file.flat ? Vec3(-Vec3::UnitZ()) : viz::View(camera_, 1, 1).forward();
    Vec3 side = ahead.cross(way);
    if (!(side.norm() > 1e-9 * way.norm())) side = Vec3::UnitY();  // it is seen end on
    side.normalize();
    if (((at(0) + at(1)) / 2 - c_.room.middle).dot(side) < 0) side = -side;
    return {side, mark_.offset.value_or(share_beside * c_.room.reach)};
  }

  void draw_dimension() {
    const auto [side, far] = beside_points();
    const Vec3 p = at(0) + far * side, q = at(1) + far * side, middle = (p + q) / 2;
    told_ = length_text(exact(0), exact(1));
    if (!is_exact() && !told_.starts_with("≈")) told_ = "≈ " + told_;
    if (far != 0)
      for (const auto& [from, to] : {std::pair(at(0), p), std::pair(at(1), q)})
        out_.items.push_back(viz::Line{from, to + 0.25 * (to - from), mark_.role, Pen::hairline});
    for (const Vec3& end : {p, q})
      if (end != middle) out_.items.push_back(viz::Arrow{middle, end, mark_.role, Pen::hairline});
    name_between(p, q, mark_.label.value_or(viz::as_markup(told_)));
  }

  void draw_brace() {
    const auto [side, far] = beside_points();
    const Vec3 way = at(1) - at(0);
    const double length = way.norm();
    if (!(length > 0)) {
      out_.missing = not_drawn(tr("both are one point"));
      return;
    }
    const Vec3 along = way / length;
    const double depth = std::min(share_of_brace * c_.room.reach, length / 4);
    const double start = mark_.offset.value_or(far / 3);
    std::vector<Vec3> half;  // how far along, and how far aside
    constexpr int parts = 8;
    for (int i = 0; i <= parts; ++i) {
      const double turn = std::numbers::pi / 2 * i / parts;
      half.emplace_back(depth * (1 - std::cos(turn)), depth * std::sin(turn), 0);
    }
    for (int i = 0; i <= parts; ++i) {
      const double turn = std::numbers::pi / 2 * i / parts;
      half.emplace_back(length / 2 - depth * (1 - std::sin(turn)), depth * (2 - std::cos(turn)), 0);
    }
    viz::Chain chain;
    chain.role = mark_.role;
    const auto add = [&, side = side](double x, double y) {
      chain.points.push_back(at(0) + x * along + (start + y) * side);
    };
    for (const Vec3& p : half) add(p.x(), p.y());
    for (auto p = half.rbegin() + 1; p != half.rend(); ++p) add(length - p->x(), p->y());
    name_at(chain.points[half.size() - 1], mark_.label.value_or(""));
    out_.items.push_back(std::move(chain));
  }

  void draw_angle() {
    const ExactVector u = from_to(exact(1), exact(0)), v = from_to(exact(1), exact(2));
    if (dot(u, u).sign() == 0 || dot(v, v).sign() == 0) {
      out_.missing = not_drawn(tr("an arm of it has no length"));
      return;
    }
    const std::string text = angle_text(u, v);
    const bool about = text.starts_with("≈") || !is_exact();
    if (mark_.kind == AuthorMark::Kind::right_angle) {
      if (!is_right(u, v) || !is_exact()) {
        const std::string angle = viz::as_markup(text);
        out_.missing = not_drawn(is_right(u, v) ? tr("it is {angle}, but from rounded places", {{"angle", angle}})
                                                : tr("it is {angle}", {{"angle", angle}}));
        return;
      }
      out_.items.push_back(viz::RightAngle{at(1), at(0), at(2)});
      if (mark_.label) name_at(at(1), *mark_.label);
      return;
    }
    told_ = (about && !text.starts_with("≈") ? "≈ " : "") + text;
    draw_arc(mark_.label.value_or(viz::as_markup(told_)));
  }

  void draw_arc(const std::string& label) {
    const Vec3 u = at(0) - at(1), v = at(2) - at(1), first = u.normalized();
    Vec3 across = v - v.dot(first) * first;
    if (!(across.norm() > 1e-12 * v.norm()))
      across = c_.file.flat ? Vec3(-first.y(), first.x(), 0) : first.unitOrthogonal();
    across.normalize();
    const double whole = std::atan2(u.cross(v).norm(), u.dot(v));
    const double radius = std::min(share_of_arc * c_.room.reach, 0.45 * std::min(u.norm(), v.norm()));
    viz::Chain arc;
    arc.role = mark_.role;
    constexpr int parts = 24;
    const auto on_arc = [&](double turn) -> Vec3 {
      return at(1) + radius * (std::cos(turn) * first + std::sin(turn) * across);
    };
    for (int i = 0; i <= parts; ++i) arc.points.push_back(on_arc(whole * i / parts));
    name_at(on_arc(whole / 2), label);
    out_.items.push_back(std::move(arc));
  }

  const Context& c_;
  const AuthorMark& mark_;
  const viz::Camera& camera_;
  std::vector<FoundSpot> places_ = {};
  MarkPicture out_ = {};
  std::string told_ = {};
};

}  // namespace

bool AuthorMark::tells(const File& file) const {
  return std::ranges::any_of(spots, [&](const Spot& spot) { return spot.tells(file); });
}

MarkPicture picture_of(const Context& c, const AuthorMark& mark, const viz::Camera& camera) {
  return MarkDrawer(c, mark, camera).draw();
}

}  // namespace isect::program::scene
