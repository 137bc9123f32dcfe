// A step as a figure for print: title, picture, the ray's own t-axis, formula and verdict, on common baselines.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "viz/chart/chart.h"
#include "viz/compose/compose.h"
#include "viz/compose/marks.h"
#include "viz/compose/paper.h"
#include "viz/compose/t_axis.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

constexpr double verdict_sign = 1.3;  ///< room for the sign before a verdict, in its text's size

/// Returns the distance from baseline to baseline, in the text's size.
double line_pitch(const PageLayout& layout) { return layout.wraps ? 1.3 : 1.65; }
/// Returns the width that a line of text has.
double room(const PageLayout& layout) { return layout.width - 2 * layout.theme.sizes.margin; }

/// Breaks the text into as few lines as fit, of about equal length.
std::vector<std::string> balanced(const std::string& markup, double size, bool bold, double room) {
  std::vector<std::string> lines = wrapped(markup, size, bold, room);
  if (lines.size() < 2) return lines;
  const double least = room / static_cast<double>(lines.size());
  for (double narrower = 0.95 * room; narrower > least; narrower *= 0.95) {
    std::vector<std::string> now = wrapped(markup, size, bold, narrower);
    if (now.size() > lines.size()) break;
    lines = std::move(now);
  }
  return lines;
}

class Page {
 public:
  Page(const Step& step, const PageLayout& layout) : step_(step), layout_(layout), theme_(layout.theme) {}

  Figure make(const Camera& camera) {
    const double picture = layout_.picture_height(), width = layout_.width;
    Figure figure = {
        {width, layout_.height, theme_.background, {}}, {}, View(camera, width, picture, {0, layout_.top()})};
    Composed composed = compose(step_.scene, figure.view, theme_);
    figure.drawing.shapes = std::move(composed.shapes);
    figure.drawing.objects = std::move(composed.objects);
    figure.labels = std::move(composed.labels);
    out_ = &figure;

    if (layout_.title_lines > 0)
      part("title", [&] { text(step_.title, {width / 2, 1.45 * s().title}, title_style()); });
    double y = layout_.top() + picture;
    if (step_.scene.axis) {
      part("t-axis", [&] { axis(*step_.scene.axis, y + axis_line * s().axis); });
      y += axis_height * s().axis;
    }
    const double formula = y + 1.15 * s().label;
    if (!step_.formula.empty())
      part("formula", [&] { text(step_.formula, {width / 2, formula}, line_style(Role::text)); });
    if (!step_.verdict.text.empty() && !is_card(step_.scene))
      part("verdict", [&] { verdict(formula + line_pitch(layout_) * layout_.formula_lines * s().label); });
    return figure;
  }

 private:
  const Sizes& s() const { return theme_.sizes; }
  /// Calls `draw`, and makes all that it draws this part of the page.
  template <class Draw>
  void part(const std::string& kind, const Draw& draw) {
    const std::size_t first = out_->drawing.shapes.size();
    draw();
    assign(out_->drawing.shapes, first, add_object(out_->drawing.objects, {"page", kind, Role::text}));
  }
  void add(Shape shape) { out_->drawing.shapes.push_back(std::move(shape)); }

  struct Style {
    double size;
    Colour colour;
    bool bold = false;
  };
  Style title_style() const { return {s().title, theme_.ink(Role::text), true}; }
  Style line_style(Role role) const { return {s().label, theme_.ink(role)}; }

  /// Draws text in the middle, on as many lines as it takes where lines wrap. Returns the box of the first.
  TextBox text(const std::string& markup, const Vec2& at, const Style& style, double indent = 0) {
    const std::vector<std::string> lines =
        layout_.wraps ? balanced(markup, style.size, style.bold, room(layout_) - indent) : std::vector{markup};
    std::optional<TextBox> first;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Vec2 below(0, line_pitch(layout_) * static_cast<double>(i) * style.size);
      const TextBox box = one_line(lines[i], at + below, style);
      if (!first) first = box;
    }
    return first.value_or(TextBox{at.x(), at.y(), at.x(), at.y()});
  }

  TextBox one_line(const std::string& markup, const Vec2& at, const Style& style) {
    Text t = {markup, at, style.size, style.colour, 0.5, style.bold, 0, {}};
    const TextBox box = has_one_size(theme_) ? measure(t) : fit_width(t, room(layout_));
    add(t);
    out_->labels.push_back({plain(markup), box});
    return box;
  }

  /// Draws the verdict after its sign: check, empty ring or diamond, so that colour never speaks alone. A cross would
  /// say that something is wrong.
  void verdict(double baseline) {
    using Kind = Verdict::Kind;
    const Kind kind = step_.verdict.kind;
    const Role role = kind == Kind::yes ? Role::hit : kind == Kind::no ? Role::miss : Role::text;
    const double sign = kind == Kind::open ? 0 : verdict_sign * s().label;
    const TextBox box = text(step_.verdict.text, {layout_.width / 2 + sign / 2, baseline}, line_style(role), sign);
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

  void axis(const Axis& axis, double y) {
    const double width = layout_.width;
    Composed drawn = compose_axis(axis, 0.2 * width, 0.8 * width, y, room(layout_), theme_);
    std::ranges::move(drawn.shapes, std::back_inserter(out_->drawing.shapes));
    std::ranges::move(drawn.labels, std::back_inserter(out_->labels));
  }

  const Step& step_;
  const PageLayout& layout_;
  const Theme& theme_;
  Figure* out_ = nullptr;
};

bool meet(const TextBox& a, const TextBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

double PageLayout::top() const {
  const double first = 2.1 + (title_lines - 1) * line_pitch(*this);
  return title_lines > 0 ? first * theme.sizes.title : theme.sizes.margin;
}

double PageLayout::bottom() const {
  const Sizes& s = theme.sizes;
  const int lines = formula_lines + verdict_lines;
  const double texts = lines > 0 ? (1.65 + (lines - 1) * line_pitch(*this)) * s.label : 0;
  return s.margin + texts + (axis ? axis_height * s.axis : 0);
}

double PageLayout::picture_height() const { return std::max(height - top() - bottom(), 0.2 * height); }

/// Formula and verdict keep their rows when they are empty, so that the picture stands still from step to step.
PageLayout page_layout(const Walk& walk, const ThemeChoice& choice, double width, double height, bool title) {
  PageLayout layout = {theme(choice, width, height), width, height, has_axis(walk)};
  layout.title_lines = title ? 1 : 0;
  return layout;
}

PageLayout paper_layout(const Walk& walk, int shown, const ThemeChoice& choice, const PaperSize& paper, bool title) {
  PageLayout layout = {paper_theme(choice, paper.text_size), paper.width, paper.height, has_axis(walk)};
  layout.title_lines = layout.formula_lines = layout.verdict_lines = 0;
  layout.wraps = true;
  const Sizes& s = layout.theme.sizes;
  const bool chart = bool(walk.steps[shown].scene.chart);
  for (const Step& step : walk.steps) {
    if (bool(step.scene.chart) != chart) continue;
    const double sign = step.verdict.kind == Verdict::Kind::open ? 0 : verdict_sign * s.label;
    const auto most = [](int& lines, const std::vector<std::string>& now) {
      lines = std::max(lines, static_cast<int>(now.size()));
    };
    if (title) most(layout.title_lines, wrapped(step.title, s.title, true, room(layout)));
    most(layout.formula_lines, wrapped(step.formula, s.label, false, room(layout)));
    most(layout.verdict_lines, wrapped(step.verdict.text, s.label, false, room(layout) - sign));
  }
  if (chart) layout.axis = false;
  if (!(layout.height > 0)) {
    constexpr double picture_shape = 2;  // as wide as in a picture for the screen
    const double picture = chart ? natural_height(*walk.steps[shown].scene.chart, layout.width, layout.theme)
                                 : layout.width / picture_shape;
    layout.height = layout.top() + picture + layout.bottom();
  }
  return layout;
}

Figure figure(const Step& step, const Camera& camera, const PageLayout& layout) {
  PageLayout own = layout;
  own.axis = (own.axis || step.scene.axis) && !step.scene.chart;  // a chart takes the axis's room
  return Page(step, own).make(camera);
}

Figure figure(const Step& step, const Camera& camera, const ThemeChoice& choice, double width, double height) {
  return Page(step, {theme(choice, width, height), width, height, bool(step.scene.axis)}).make(camera);
}

std::vector<std::string> label_faults(const Figure& figure, double least_size) {
  return label_faults(figure.drawing, figure.labels, least_size);
}

std::vector<std::string> label_faults(const Drawing& drawing, const std::vector<PlacedLabel>& labels,
                                      double least_size) {
  std::vector<std::string> faults;
  const double w = drawing.width, h = drawing.height;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::string& text = labels[i].text;
    const TextBox& b = labels[i].box;
    if (!(b.left >= 0 && b.top >= 0 && b.right <= w && b.bottom <= h)) faults.push_back(text + " is clipped");
    for (std::size_t j = 0; j < i; ++j)
      if (meet(b, labels[j].box)) faults.push_back(text + " meets " + labels[j].text);
  }
  for (const Shape& shape : drawing.shapes)
    if (const Text* text = std::get_if<Text>(&shape); text && text->size < least_size)
      faults.push_back(plain(text->markup) + " is too small");
  return faults;
}

double picture_aspect(const Walk& walk, const ThemeChoice& choice, double width, double height) {
  return width / page_layout(walk, choice, width, height).picture_height();
}

}  // namespace isect::viz
