#pragma once
// Where the parts of the window lie: bars of fixed height, panels that are a share of the width, with a least and a
// most, and all the rest for the scene. In a narrow window the lesson's panel lies below the scene.

#include <string>
#include <vector>

namespace isect::viz {

/// A rectangle in px of the layout, y down.
struct Rect {
  float left = 0, top = 0, right = 0, bottom = 0;
  float width() const { return right - left; }
  float height() const { return bottom - top; }
  float middle_x() const { return (left + right) / 2; }
  float middle_y() const { return (top + bottom) / 2; }
  bool contains(float x, float y) const { return x >= left && x < right && y >= top && y < bottom; }
  Rect inset(float by) const { return {left + by, top + by, right - by, bottom - by}; }
};

struct WindowLayout {
  Rect top, lesson, scene, code, transport;
  Rect between_bars() const { return {top.left, top.bottom, top.right, transport.top}; }
};

WindowLayout window_layout(float width, float height);
/// Returns the layout of a lecture, without the panels: `lesson` is the strip for the words below the scene, as high as
/// the window allows, whatever it says.
WindowLayout lecture_layout(float width, float height);

/// Sizes of what is read from afar, in px: of words; of code, formulas and values, which are 20 px at least, and never
/// smaller than words.
struct LectureSizes {
  double words, large;
};
/// Returns the sizes in a strip of this height.
LectureSizes lecture_sizes(float strip);

/// A rectangle cut in two with a share of it for the second part: side by side, or one below the other if it is not
/// much wider than high.
struct Halves {
  Rect first, second;
};
Halves halves(const Rect&, float share);

/// Two panes: each with its scene above its pseudocode and values. The lesson's text stands beside them if that leaves
/// both wide enough; else `lesson` is empty. The strip for the words of a lecture has the place of pseudocode and
/// values, which then are empty; else it is.
struct PanesLayout {
  Rect lesson, heads, first_scene, second_scene, first_code, second_code, strip;
};
/// `panels`: there are some, as `whole` has them. `asks`: a question needs a place, also where the lesson has none.
PanesLayout panes_layout(const WindowLayout& whole, bool panels, bool asks);

/// Returns a line of pseudocode on as few rows as `columns` letters allow, the later ones indented further, each ending
/// where it disturbs a reader least: after a colon or before "and", not in a formula.
std::vector<std::string> code_rows(const std::string& line, int columns);

/// Returns the width of each chip in a row of `width` px, `gap` apart: that of `wide` where they fit; otherwise the
/// last ones shrink to `narrow`, except the chosen one.
std::vector<float> chip_widths(const std::vector<float>& wide, float narrow, float gap, float width, int chosen);

}  // namespace isect::viz
