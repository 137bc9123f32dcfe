#include "viz/compose/t_axis.h"

#include <algorithm>
#include <cmath>

#include "viz/compose/marks.h"
#include "viz/compose/paper.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

class AxisPart {
 public:
  AxisPart(const Axis& axis, double left, double right, double y, double most, const Theme& theme)
      : axis_(axis), left_(left), right_(right), y_(y), most_(most), theme_(theme) {}

  Composed make() {
    const Colour first = theme_.ink(Role::first), beyond = theme_.ink(Role::construction);
    const double from = x(axis_.range_lo), to = x(axis_.range_hi);
    const bool open = axis_.range_hi > axis_.hi;
    line(left_, from, beyond, s().construction, s().construction_dash);
    line(from, open ? to - 0.8 * s().arrow : to, first, s().ray);
    line(to, right_, beyond, s().construction, s().construction_dash);
    if (open) out_.shapes.push_back(Fill{arrow_head({to, y_}, {1, 0}, s().arrow), first, 0, 0, {}});
    if (axis_.shared) line(x(axis_.shared->x()), x(axis_.shared->y()), theme_.ink(Role::hit), s().shared);

    if (std::isfinite(axis_.range_lo)) end(axis_.range_lo);
    if (std::isfinite(axis_.range_hi)) end(axis_.range_hi);

    for (const Axis::Tick& tick : axis_.ticks) mark(out_.shapes, tick.mark, {x(tick.t), y_}, tick.role, theme_);
    tick_labels();
    return std::move(out_);
  }

 private:
  const Sizes& s() const { return theme_.sizes; }
  double x(double t) const {
    return left_ + std::clamp((t - axis_.lo) / (axis_.hi - axis_.lo), 0.0, 1.0) * (right_ - left_);
  }

  void line(double from, double to, Colour colour, double width, std::array<double, 2> dash = {0, 0}) {
    if (to > from) out_.shapes.push_back(Stroke{polyline({{from, y_}, {to, y_}}), colour, width, dash, false});
  }

  void end(double t) {
    const double h = 0.38 * s().axis;
    out_.shapes.push_back(
        Stroke{polyline({{x(t), y_ - h}, {x(t), y_ + h}}), theme_.ink(Role::first), s().ray, {0, 0}, false});
    add(text(shown(t), {x(t), y_ + 1.3 * s().axis}, theme_.ink(Role::muted)));
  }

  Text text(const std::string& markup, const Vec2& at, Colour colour) const {
    return {markup, at, s().axis, colour, 0.5, false, 0, {}};
  }
  void add(Text t) {
    const TextBox box = has_one_size(theme_) ? measure(t) : fit_width(t, most_);
    out_.shapes.push_back(t);
    out_.labels.push_back({plain(t.markup), box});
  }

  void tick_labels() {
    std::vector<Text> texts;
    for (const Axis::Tick& tick : axis_.ticks)
      if (!tick.label.empty())
        texts.push_back(
            text(tick.label, {x(tick.t), y_ - 0.45 * s().axis - mark_radius(tick.mark, s())}, theme_.ink(Role::text)));
    std::sort(texts.begin(), texts.end(), [](const Text& a, const Text& b) { return a.at.x() < b.at.x(); });
    for (std::size_t i = 1; i < texts.size(); ++i) {  // neighbours move apart: two adjacent names would read as one
      const double gap = measure(texts[i]).left - measure(texts[i - 1]).right - 2 * s().label_clear;
      if (gap >= 0) continue;
      texts[i - 1].at.x() += gap / 2;
      texts[i].at.x() -= gap / 2;
    }
    for (const Text& t : texts) add(t);
  }

  const Axis& axis_;
  double left_, right_, y_, most_;
  const Theme& theme_;
  Composed out_;
};

}  // namespace

Composed compose_axis(const Axis& axis, double left, double right, double y, double most, const Theme& theme) {
  return AxisPart(axis, left, right, y, most, theme).make();
}

}  // namespace isect::viz
