// A step as a figure for print: title, picture, the ray's own t-axis, formula and verdict, on common baselines.

#include <algorithm>
#include <cmath>

#include "viz/chart.h"
#include "viz/compose.h"
#include "viz/marks.h"
#include "viz/rich_text.h"
#include "viz/text.h"

namespace isect::viz {
namespace {

class Page {
 public:
  Page(const Step& step, const Theme& theme, double width, double height)
      : step_(step), theme_(theme), width_(width), height_(height) {}

  double top() const { return 2.1 * s().title; }
  /// Formula and verdict keep their rows when they are empty, so that the picture stands still from step to step.
  double bottom() const { return s().margin + 2 * 1.65 * s().label + (step_.scene.axis ? 3.1 * s().axis : 0); }

  double picture_height() const { return std::max(height_ - top() - bottom(), 0.2 * height_); }

  Figure make(const Camera& camera) {
    const double picture = picture_height();
    Figure figure = {{width_, height_, theme_.background, {}}, {}, View(camera, width_, picture, {0, top()})};
    Composed composed = compose(step_.scene, figure.view, theme_);
    figure.drawing.shapes = std::move(composed.shapes);
    figure.drawing.objects = std::move(composed.objects);
    figure.labels = std::move(composed.labels);
    out_ = &figure;

    part("title", [&] {
      text(step_.title, {width_ / 2, 1.45 * s().title}, s().title, theme_.ink(Role::text), 0.5, true);
    });
    double y = top() + picture;
    if (step_.scene.axis) {
      part("t-axis", [&] { axis(*step_.scene.axis, y + 1.75 * s().axis); });
      y += 3.1 * s().axis;
    }
    const double formula = y + 1.15 * s().label;
    if (!step_.formula.empty())
      part("formula", [&] { text(step_.formula, {width_ / 2, formula}, s().label, theme_.ink(Role::text), 0.5); });
    if (!step_.verdict.text.empty() && !is_card(step_.scene))
      part("verdict", [&] { verdict(formula + 1.65 * s().label); });
    return figure;
  }

 private:
  const Sizes& s() const { return theme_.sizes; }
  /// Calls `draw`, and all that it draws is this part of the page.
  template <class Draw>
  void part(const std::string& kind, const Draw& draw) {
    const std::size_t first = out_->drawing.shapes.size();
    draw();
    assign(out_->drawing.shapes, first, add_object(out_->drawing.objects, {"page", kind, Role::text}));
  }
  void add(Shape shape) { out_->drawing.shapes.push_back(std::move(shape)); }

  TextBox text(const std::string& markup, Vec2 at, double size, Colour colour, double align, bool bold = false) {
    Text t = {markup, at, size, colour, align, bold, 0, {}};
    TextBox box = measure(t);
    const double room = width_ - 2 * s().margin;
    if (box.right - box.left > room) {  // a long line shrinks rather than leave the picture
      t.size *= room / (box.right - box.left);
      box = measure(t);
    }
    add(t);
    out_->labels.push_back({plain(markup), box});
    return box;
  }

  /// The verdict with its sign before it: check, empty ring or diamond, so that colour never speaks alone. A cross
  /// would say that something is wrong.
  void verdict(double baseline) {
    using Kind = Verdict::Kind;
    const Kind kind = step_.verdict.kind;
    const Role role = kind == Kind::yes ? Role::hit : kind == Kind::no ? Role::miss : Role::text;
    const double sign = kind == Kind::open ? 0 : 1.3 * s().label;
    const TextBox box = text(step_.verdict.text, {width_ / 2 + sign / 2, baseline}, s().label, theme_.ink(role), 0.5);
    const Vec2 p = {box.left - 0.75 * s().label, baseline - 0.32 * s().label};
    const double a = 0.26 * s().label;
    if (kind == Kind::yes)
      add(Stroke{polyline({p + Vec2(-a, 0), p + Vec2(-0.25 * a, 0.8 * a), p + Vec2(1.1 * a, -0.9 * a)}),
                 theme_.ink(role),
                 s().marker_line,
                 {0, 0},
                 true});
    if (kind == Kind::no) add(Stroke{circle(p, 0.9 * a), theme_.ink(role), s().marker_line, {0, 0}, false});
    if (kind == Kind::on) mark(out_->drawing.shapes, Mark::diamond, p, Role::highlight, theme_);
  }

  /// The same marks in one dimension. Root labels stand above the line, the range's ends below it.
  void axis(const Axis& axis, double y) {
    const double left = 0.2 * width_, right = 0.8 * width_;
    const auto x = [&](double t) {
      return left + std::clamp((t - axis.lo) / (axis.hi - axis.lo), 0.0, 1.0) * (right - left);
    };
    const auto line = [&](double from, double to, Colour colour, double width, std::array<double, 2> dash = {0, 0}) {
      if (to > from) add(Stroke{polyline({{from, y}, {to, y}}), colour, width, dash, false});
    };
    const Colour first = theme_.ink(Role::first), muted = theme_.ink(Role::muted);
    const double from = x(axis.range_lo), to = x(axis.range_hi);
    const bool open = axis.range_hi > axis.hi;
    line(left, from, theme_.ink(Role::construction), s().construction, s().construction_dash);
    line(from, open ? to - 0.8 * s().arrow : to, first, s().ray);
    line(to, right, theme_.ink(Role::construction), s().construction, s().construction_dash);
    if (open) add(arrow_head({to, y}, {1, 0}, first, s()));
    if (axis.shared) line(x(axis.shared->x()), x(axis.shared->y()), theme_.ink(Role::hit), s().shared);

    const auto end = [&](double t, const std::string& name) {
      const double h = 0.38 * s().axis;
      add(Stroke{polyline({{x(t), y - h}, {x(t), y + h}}), first, s().ray, {0, 0}, false});
      text(name, {x(t), y + 1.3 * s().axis}, s().axis, muted, 0.5);
    };
    if (std::isfinite(axis.range_lo)) end(axis.range_lo, shown(axis.range_lo));
    if (std::isfinite(axis.range_hi)) end(axis.range_hi, shown(axis.range_hi));

    for (const Axis::Tick& tick : axis.ticks) mark(out_->drawing.shapes, tick.mark, {x(tick.t), y}, tick.role, theme_);
    tick_labels(axis, y, x);
  }

  template <class Position>
  void tick_labels(const Axis& axis, double y, const Position& x) {
    std::vector<Text> texts;
    for (const Axis::Tick& tick : axis.ticks)
      if (!tick.label.empty())
        texts.push_back({tick.label,
                         {x(tick.t), y - 0.45 * s().axis - mark_radius(tick.mark, s())},
                         s().axis,
                         theme_.ink(Role::text),
                         0.5,
                         false,
                         0,
                         {}});
    std::sort(texts.begin(), texts.end(), [](const Text& a, const Text& b) { return a.at.x() < b.at.x(); });
    for (std::size_t i = 1; i < texts.size(); ++i) {  // neighbours make room for each other
      const double gap = measure(texts[i]).left - measure(texts[i - 1]).right - s().label_clear;
      if (gap >= 0) continue;
      texts[i - 1].at.x() += gap / 2;
      texts[i].at.x() -= gap / 2;
    }
    for (const Text& t : texts) text(t.markup, t.at, t.size, t.colour, t.align);
  }

  const Step& step_;
  const Theme& theme_;
  double width_, height_;
  Figure* out_ = nullptr;
};

}  // namespace

Figure figure(const Step& step, const Camera& camera, ThemeName name, double width, double height) {
  const Theme styled = theme(name, width, height);
  return Page(step, styled, width, height).make(camera);
}

double picture_aspect(const Walk& walk, ThemeName name, double width, double height) {
  const Theme styled = theme(name, width, height);
  return width / Page(walk.steps.front(), styled, width, height).picture_height();
}

}  // namespace isect::viz
