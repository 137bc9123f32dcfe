#pragma once
// The window's own small widgets, drawn with ImDrawList at given places. Each records its place, so that tests click on
// names and not on guessed coordinates.

#include <imgui.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "viz/window/focus.h"
#include "viz/window/layout.h"
#include "viz/window/light.h"
#include "viz/window/palette.h"
#include "viz/window/text_textures.h"
#include "viz/window/ui_fonts.h"

namespace isect::viz {

/// Seconds after which a resting pointer has no tooltip any more and, in a lecture, is hidden.
constexpr double pointer_patience = 3;

/// The state that every widget needs.
struct Ui {
  Palette palette;
  UiFonts fonts;
  TextTextures texts;
  std::map<std::string, Rect> rects = {};  ///< this frame's widgets by name
  double pointer_rest = 1e9;               ///< seconds since the pointer last moved
  Focus focus = {};
  std::string side = {};  ///< prefix of the names in the second of two panes
  Light light = {};
  std::set<std::string> names = {};  ///< the walk's names; all else in a line of pseudocode is words
  std::string sum = {};              ///< what is told of the lit name; empty: nothing
  Rect ring = {};                    ///< around the visible part of what the keyboard holds; empty: nothing
};

enum class Icon { first, back, play, pause, next, last, map, panes, pass };

inline ImVec2 top_left(const Rect& r) { return {r.left, r.top}; }
inline ImVec2 bottom_right(const Rect& r) { return {r.right, r.bottom}; }

/// Words that were cut at a side, or set smaller than the body, for tests: Dear ImGui's user data points at them, if at
/// anything.
using CutWords = std::vector<std::string>;

/// Draws one line of plain text; `y` is its middle; align 0 left, 0.5 middle, 1 right. Returns its width.
float text(ImFont*, float x, float y, ImU32, const std::string&, float align = 0);
float text_width(ImFont*, const std::string&);
/// Returns the text, or as much of it as fits into `room`, with "…" for the rest.
std::string fitted(ImFont*, const std::string&, float room);

/// Draws rich text from its top left corner. Returns its size.
ImVec2 rich(Ui&, const Paragraph&, ImVec2 at);
/// Draws one line of rich text around the middle `y`; align as above.
ImVec2 rich_line(Ui&, const Paragraph&, float x, float y, float align = 0);

/// A place where names stand: the pointer on it lights them, and they are lit there. `bright`: on a bright ground.
void lights(Ui&, const std::vector<std::string>& names, const Rect&, bool bright = false);
/// Does so for the names in a line of plain text that was drawn from x on, around the middle y: a lit name is drawn
/// once more, near-black on the highlight.
void lights_in(Ui&, ImFont*, float x, float y, const std::string&, bool bright = false);
/// Draws the light itself, over what stands there, which is drawn once more on it, near-black.
void light_up(Ui&, const Rect&, double strength, bool bright = false);
/// Shows what is known of the lit name, beside it, over everything.
void tell_sum(Ui&, const Rect& window);

/// Whether the keyboard holds the widget of this name; then it gets a ring and scrolls into view.
bool focused(Ui&, const std::string& name, const Rect&);
/// Whether Tab left the field drawn last, in which the reader was typing; the focus moves to the next widget, or back.
bool left_by_tab(Ui&, const std::string& name);
/// Draws the ring, over everything.
void focus_ring(Ui&);

/// The state of a place to press, with the pointer or with the keyboard. `clicked`: the button was released inside.
struct Press {
  bool clicked, hovered, held;
};
Press press(Ui&, const std::string& name, const Rect&);
/// Begins a window that fills `r`, not movable, not decorated; `above`: over the others. End it with ImGui::End().
/// Without a background the whole window's shows, which costs a software renderer nothing more.
void begin_region(Ui&, const char* name, const Rect& r, const std::optional<Colour>& background = {},
                  bool above = false);
/// In a scrolling part: dims its upper or lower end if there is more beyond it.
void more_beyond(Ui&, const std::string& name, const Rect& r);
/// Draws a part of a region that scrolls by itself; `inside` draws its contents.
template <class Inside>
void scrolling(Ui& ui, const char* name, const Rect& r, Inside&& inside) {
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::BeginChild(name, {r.width(), r.height()}, false, 0);
  ImGui::PopStyleVar();
  inside();
  more_beyond(ui, name, r);
  ImGui::EndChild();
}
void tooltip(const Ui&, const std::string&);
/// Draws what belongs to the second of two panes: the names of its widgets get a prefix.
template <class Draw>
void on_other_side(Ui& ui, Draw&& draw) {
  std::map<std::string, Rect> all = std::exchange(ui.rects, {});
  ui.side = "other ";
  ImGui::PushID("other side");
  draw();
  ImGui::PopID();
  for (const auto& [name, rect] : ui.rects) all[ui.side + name] = rect;
  ui.rects = std::move(all);
  ui.side.clear();
}

void filled(const Rect&, const Colour&, float rounding = 6);
void outlined(const Rect&, const Colour&, float width = 1.5f, float rounding = 6);
void rule(const Ui&, float x0, float x1, float y);

/// Words that open a menu, followed by its sign, in at most `room` px. Returns where it ends.
struct Opener {
  std::string name, words, help;
  float x, y, room;
};
float opener(Ui&, const Opener&, bool quiet, bool& pressed);
/// Draws a button with a word on it.
bool chip(Ui&, const std::string& name, const Rect&, const std::string& label, bool chosen, ImFont* = nullptr);
/// Draws a transport button.
bool icon_button(Ui&, const std::string& name, const Rect&, Icon, bool primary, bool enabled);

void tick(float x, float y, float size, ImU32);
void cross(float x, float y, float size, ImU32);  ///< wrong
/// Draws "No": a finding, not a fault.
void ring(float x, float y, float size, ImU32);
void diamond(float x, float y, float size, ImU32);
/// Draws a small triangle: pointing down when `open`, else to the right.
void caret(float x, float y, bool open, ImU32);
/// Draws a handle's sign: a disc in a ring.
void handle_sign(float x, float y, const Colour&, const Colour& rim);
/// Draws a circular arrow.
void turn_sign(float x, float y, const Colour&);
/// Draws isect's mark: a ray through a ball, green where they meet.
void logo(const Ui&, float x, float y);

}  // namespace isect::viz
