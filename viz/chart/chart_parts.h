#pragma once
// The parts that all kinds of chart share: measured text, markers, scales with their ticks, and the legend.

#include "viz/chart/chart.h"
#include "viz/chart/chart_pick.h"
#include "viz/compose/labels.h"

namespace isect::viz {

/// Collects shapes and labels in a theme.
class ChartInk {
 public:
  explicit ChartInk(const Theme& theme) : theme_(theme) {}

  const Theme& theme() const { return theme_; }
  const Sizes& sizes() const { return theme_.sizes; }
  double glyph_radius() const { return 1.55 * sizes().disc; }

  /// Assigns what is drawn from now on to this part of the chart; an earlier part may be continued.
  void part(const std::string& kind, const std::string& markup = {}, Role role = Role::text);

  struct Style {
    double size;
    Role role = Role::text;
    double align = 0;
    bool bold = false;
    double halo = 0;
  };
  double width(const std::string& markup, double size, bool bold = false) const;
  TextBox text(const std::string& markup, const Vec2& at, const Style&, const std::optional<Vec2>& leads_to = {});
  /// Breaks words into as few lines as fit into `room`; a word wider than that gets a line of its own.
  std::vector<std::string> wrapped(const std::string& markup, double size, bool bold, double room) const;

  void line(const std::vector<Vec2>& points, const Colour&, double width, std::array<double, 2> dash = {0, 0},
            bool round_cap = false);
  void ring(const Vec2& middle, double radius, const Colour&, double width);
  void fill(const std::vector<Vec2>& points, const Colour&);
  void box(const Bounds&, const Colour&);
  /// Places labels within `room`, wherever they fit clear of each other, of the texts so far and of the
  /// obstacles.
  void place(const std::vector<Wanted>&, const std::vector<Obstacle>&, const Bounds& room);
  /// Draws a scene's marker.
  void mark(Mark, const Vec2& at, Role);
  /// Draws a marker with a halo; hollow ones are filled with the background, or are see-through if `open`.
  void glyph(Glyph, const Vec2& at, double radius, const Colour&, bool hollow, bool open = false);

  /// Says what a pointer is told at a place: it draws nothing.
  void tell(const Vec2& at, std::string words) { marks_.push_back({at, std::move(words)}); }
  const std::vector<ChartMark>& marks() const { return marks_; }

  const std::vector<PlacedLabel>& labels() const { return out_.labels; }
  Composed take();

 private:
  const Theme& theme_;
  Composed out_;
  std::vector<ChartMark> marks_;
  int part_ = no_object;
  std::size_t assigned_ = 0;  ///< this many shapes have their part
};

/// One scale over a stretch of the drawing (`from` may lie right of or below `to`).
class ScaleLine {
 public:
  /// Labels may reach beyond both ends by `reach`.
  ScaleLine(const Scale& scale, double from, double to, double reach = 0)
      : scale_(scale), from_(from), to_(to), reach_(reach) {}
  double at(double value) const;
  /// Returns values with labels, as many as `room` allows: the width of a label's text, or a line's height.
  std::vector<std::pair<double, std::string>> ticks(const ChartInk&, bool across) const;

 private:
  const Scale& scale_;
  double from_, to_, reach_;
};

/// Returns the colour that lies `share` of the way from the background to `ink`, opaque.
Colour tinted(const Theme&, const Colour& ink, double share);
/// Returns the colour of a cell of a map, or of a bar that stands for such cells.
Colour colour_of(Tone, const Theme&);
std::array<double, 2> dash_of(int index, const Sizes&);
/// Returns "0.05", "5", "2 000", "10^{6}": short enough for an axis.
std::string tick_text(double value);

/// An entry of a legend: a marker (with a piece of its curve where there is one), or a filled square.
struct LegendEntry {
  std::string name;
  std::optional<Glyph> glyph = {};
  Colour colour = {};
  bool hollow = false;
  std::optional<std::array<double, 2>> dash = {};  ///< of the curve
  bool tick = false;                               ///< a target's short upright line
};
double legend_height(const ChartInk&, const std::vector<LegendEntry>&, double width);
/// Draws the legend in centred rows within `width`, from `corner` down.
void legend(ChartInk&, const std::vector<LegendEntry>&, const Vec2& corner, double width);

// The kinds, each in a file of its own.
void draw(ChartInk&, const Plot&, const Bounds&);
void draw(ChartInk&, const Maps&, const Bounds&);
void draw(ChartInk&, const Bars&, const Bounds&);
void draw(ChartInk&, const Mirrored&, const Bounds&);
void draw(ChartInk&, const Cases&, const Bounds&);
void draw(ChartInk&, const Card&, const Bounds&);
double natural_height(const ChartInk&, const Plot&, double width);
double natural_height(const ChartInk&, const Maps&, double width);
double natural_height(const ChartInk&, const Bars&, double width);
double natural_height(const ChartInk&, const Mirrored&, double width);
double natural_height(const ChartInk&, const Cases&, double width);
double natural_height(const ChartInk&, const Card&, double width);
/// Returns a chart's rectangle without its margins.
Bounds room_of(Vec2 corner, double width, double height, const Theme&);
/// Returns what is told of a point: "time (ns): 12.5".
std::string told_of(const Scale&, double value);
/// Returns the plane's own rectangle within a chart's rectangle.
Bounds plane_within(const ChartInk&, const Cases&, const Bounds&);

/// A marker at the place of its data.
struct Marker {
  Vec2 at;
  Glyph glyph;
  Colour colour;
  bool hollow = false;
  std::string name = {};  ///< markup; may be empty
};
/// Draws each marker at its place. Of markers that overlap the later ones are smaller, and their names stand aside with
/// leaders, where the panel has room clear of markers and lines.
void draw_markers(ChartInk&, const std::vector<Marker>&, std::vector<Obstacle> lines, const Bounds& panel);

/// Draws one panel's data within its rectangle.
void draw_data(ChartInk&, const Plot&, const Panel&, const Bounds&);

}  // namespace isect::viz
