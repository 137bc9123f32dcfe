#include "viz/compose/strip.h"

#include <algorithm>

#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

constexpr double caption_pitch = 1.3;  ///< of captions, in their text's size
constexpr double above_caption = 1;    ///< from a figure's foot to the first baseline, likewise
constexpr double ink_slack = 1;        ///< for a line, whose ink is not quite centred

class Rows {
 public:
  Rows(const Theme& theme, double gap) : theme_(theme), gap_(gap) { out_.drawing.background = theme.background; }

  void add(const std::vector<Frame>& frames, std::size_t first, std::size_t last) {
    if (first > 0) y_ += gap_;
    double foot = y_, below = y_;
    for (std::size_t i = first; i < last; ++i) foot = std::max(foot, y_ + frames[i].figure.drawing.height);
    double x = 0;
    for (std::size_t i = first; i < last; ++i) {
      const Drawing& drawing = frames[i].figure.drawing;
      place(frames[i].figure, {x, foot - drawing.height});
      const std::string letter = frames.size() > 1 ? std::string("(") + letter_of(i) + ") " : "";
      below = std::max(below, caption(letter + frames[i].caption, x, foot, drawing.width));
      x += drawing.width + gap_;
    }
    out_.drawing.width = std::max(out_.drawing.width, x - gap_);
    out_.drawing.height = y_ = std::max(foot, below);
  }

  Strip made() { return std::move(out_); }

 private:
  static char letter_of(std::size_t i) { return static_cast<char>('a' + i % 26); }

  void place(const Figure& figure, const Vec2& at) {
    Drawing& to = out_.drawing;
    std::vector<int> objects;
    for (const Object& object : figure.drawing.objects) objects.push_back(add_object(to.objects, object));
    for (Shape shape : figure.drawing.shapes) {
      move(shape, at);
      std::visit([&](auto& s) { s.object = s.object == no_object ? no_object : objects[s.object]; }, shape);
      to.shapes.push_back(std::move(shape));
    }
    for (const PlacedLabel& label : figure.labels) {
      const auto& [left, top, right, bottom] = label.box;
      out_.labels.push_back({label.text, {left + at.x(), top + at.y(), right + at.x(), bottom + at.y()}});
      if (label.leads_to) out_.labels.back().leads_to = *label.leads_to + at;
    }
  }

  /// Returns where its last line ends.
  double caption(const std::string& markup, double left, double top, double width) {
    if (markup.empty()) return top;
    const double size = theme_.sizes.label;
    const int object = add_object(out_.drawing.objects, {"page", "caption", Role::text});
    double baseline = top + above_caption * size;
    for (const std::string& line : wrapped(markup, size, false, width - ink_slack)) {
      Text text = {line, {left + width / 2, baseline}, size, theme_.ink(Role::text), 0.5};
      text.object = object;
      out_.labels.push_back({plain(line), measure(text)});
      out_.drawing.shapes.push_back(std::move(text));
      baseline += caption_pitch * size;
    }
    return baseline - 0.65 * caption_pitch * size;  // including descenders
  }

  const Theme& theme_;
  double gap_, y_ = 0;
  Strip out_;
};

}  // namespace

Strip strip(const std::vector<Frame>& frames, int columns, const Theme& theme, double gap) {
  Rows rows(theme, gap);
  const auto a_row = static_cast<std::size_t>(columns);
  for (std::size_t first = 0; first < frames.size(); first += a_row)
    rows.add(frames, first, std::min(first + a_row, frames.size()));
  return rows.made();
}

}  // namespace isect::viz
