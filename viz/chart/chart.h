#pragma once
// Charts as values: small multiples with markers and curves, maps of verdicts, rows against targets, bars back
// to back, cards of text.
//
// A chart says what was measured; the theme makes ink of it, as with scenes. Texts are markup
// (see viz/text/rich_text.h).

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "viz/compose/compose.h"

namespace isect::viz {

/// The marker of a series. By convention the stars are for what promises to be exact.
enum class Glyph {
  triangle,
  diamond,
  square,
  disc,
  down,
  pentagon,
  plus,
  saltire,
  right,
  hexagon,
  left,
  star,
  star4,
  star6
};

/// One method in every panel of a chart. In curves, role and dash tell it from the others, too. Without a name it is
/// not in the legend.
struct Series {
  std::string name;
  Glyph glyph = Glyph::disc;
  Role role = Role::construction;
  int dash = 0;  ///< 0: solid; 1 to 5: ever shorter dashes
};

/// One direction of a plot. Values beyond the ends are drawn at the ends.
struct Scale {
  enum class Kind {
    linear,
    log,
    log_zero  ///< logarithmic from `lo`, with zero on a line of its own below
  };
  Kind kind = Kind::linear;
  double lo = 0, hi = 1;
  std::string title;
  std::vector<std::pair<double, std::string>> ticks = {};  ///< chosen by themselves if empty
};

/// A marker, with a whisker down to `low` if there is one. Markers on the front are joined by steps.
struct Spot {
  int series = 0;
  double x = 0, y = 0;
  std::optional<double> low = {};
  bool front = false;
};

struct Curve {
  int series = 0;
  std::vector<Vec2> points;
  std::string label = {};  ///< written at its right end
};

struct Panel {
  std::string title;
  std::string note = {};  ///< small, under the title: "hard"
  std::vector<Spot> spots = {};
  std::vector<Curve> curves = {};
  bool muted = false;  ///< drawn faintly: not what this picture is about
};

/// Panels that share both scales. Only horizontal grid lines; a legend only for markers.
struct Plot {
  Scale x, y;
  std::vector<Series> series;
  std::vector<Panel> panels;
};

/// What a cell of a map says. `mild` and `wrong` are the two kinds of wrong verdict.
enum class Tone { first, second, on, mild, wrong };

/// One cell for each neighbour of a point: what a method said there, against the truth.
struct Map {
  std::string title;
  std::string note = {};
  int columns = 0, rows = 0;
  std::vector<unsigned char> cells;  ///< index into the chart's kinds, row by row from the bottom
  std::vector<Vec2> line = {};       ///< the true boundary, in cells from the lower left corner; may be empty
};
struct Maps {
  std::vector<std::pair<std::string, Tone>> kinds;  ///< what is said of a cell, as in the legend
  std::vector<Map> maps;
  std::string below;  ///< what the cells are
};

/// One row: its name, markers on the shared scale, a target, and a text at the end.
struct Bar {
  std::string name;
  std::vector<std::pair<int, double>> dots;  ///< series, value
  std::optional<double> target = {};
  std::string text = {};
  Verdict::Kind kind = Verdict::Kind::open;                ///< sign and colour of the text
  std::optional<std::pair<double, double>> interval = {};  ///< a line through the first marker
};
struct Bars {
  Scale x;
  std::vector<Series> series;
  std::vector<Bar> bars;
  std::string target_name = "target";  ///< in the legend, if any row has one
};

/// Two opposite faults back to back, one panel per method: one fault to the left of a zero line, the other to the
/// right. Panels share their rows and their scale; each bar has its number.
struct Mirrored {
  struct Pair {
    double left = 0, right = 0;  ///< in percent
  };
  struct Panel {
    std::string title;
    std::vector<Pair> pairs;  ///< a row each
  };
  std::vector<std::string> rows;  ///< names, from the top
  int apart = 0;                  ///< this many rows at the top stand apart from the others
  std::string rows_title;
  std::array<std::pair<std::string, Tone>, 2> kinds;  ///< left and right, as in the legend
  std::vector<Panel> panels;
  std::string below;  ///< what the numbers are
};
/// Returns a share in percent with two digits: "28", "5.4", "0.06", "<0.01", and "0" for none.
std::string percent_text(double);

/// A plane of two parameters in regions, one for each branch. viz/chart/case_map.h makes one.
struct Cases {
  /// The part of a region between two levels: lower left, lower right, upper right, upper left.
  struct Patch {
    std::array<Vec2, 4> corners;
    int branch = 0;
  };
  struct Spot {
    Vec2 at;
    int branch = 0;
  };
  Scale x, y;
  std::vector<std::string> branches;  ///< names, written into the regions; the first one has no colour
  std::vector<Patch> patches;
  std::vector<std::vector<Vec2>> borders;
  bool one_scale = false;  ///< a unit is as long along y as along x
  /// Which names are written: all, those for which their regions have room, or none.
  enum class Named { all, within, none } named = Named::all;
  std::vector<Spot> presets;      ///< small rings; a branch without an area gets its name beside one
  std::optional<Spot> here = {};  ///< the setting that is shown
};

/// A text in rows, each beside or below its head.
struct Card {
  struct Row {
    std::string head, text;
  };
  std::vector<Row> rows;
};

struct Chart {
  std::variant<Plot, Maps, Bars, Mirrored, Cases, Card> kind;
};

/// Whether the scene shows nothing but a card: it is about the whole lesson, not about one setting.
bool is_card(const Scene&);

/// Returns the shapes of a chart within a rectangle, and all of its labels.
Composed compose(const Chart&, Vec2 corner, double width, double height, const Theme&);
/// Returns the height at which a chart of this width reads well.
double natural_height(const Chart&, double width, const Theme&);
/// Returns where the plane lies in a chart composed within this rectangle, for the pointer.
Box2 plane_of(const Cases&, Vec2 corner, double width, double height, const Theme&);
/// Returns a chart as a figure of its own, with the sizes of a figure of this width.
Figure chart_figure(const Chart&, ThemeName, double width);

/// Tells which points (x: cost, y: error) are beaten by no other one, at most as large in both and smaller in one.
std::vector<bool> pareto_front(const std::vector<Vec2>&);

}  // namespace isect::viz
