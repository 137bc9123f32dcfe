#pragma once
// Marks over the scene: verdict, axes, projection, messages, and what the pointer is at.

#include "viz/compose/compose.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Whether the scene is so low that the marks would cover much of it.
inline bool is_low(const Rect& scene) { return scene.height() < 340; }
/// The tallest of a walk's verdicts, which may be thousands, and what it depends on.
struct TallestVerdict {
  unsigned walk = 0;
  float width = 0, height = 0, alarm = 0, tallest = 0;
  bool operator==(const TallestVerdict&) const = default;
};
/// Returns the height that the scene leaves free at its top for the chips: in a chart as much as they take, in a low
/// scene the same at each step, as they would cover much of it. `steady`: the part that does not change.
float head_of(const Player&, Ui&, float steady, const Rect& scene);
/// Returns the part of that height that does not change from step to step. `known`: from the frame before.
float steady_head(const Player&, Ui&, TallestVerdict& known, const Rect& scene);
/// Returns how far the chips reach below the scene's top; 0 if there are none.
float chips_height(const Player&, Ui&, const Rect& scene);
/// The ink of a verdict, and its sign: a tick, a ring, a diamond, or dots while it is open.
const Colour& verdict_ink(const Palette&, Verdict::Kind);
void verdict_sign(Verdict::Kind, float x, float y, float size, ImU32 ink);
/// Draws the verdict in a chip at the top left.
void verdict_chip(const Player&, Ui&, const Rect& scene);
/// Draws, below the verdict, or beside it in a low scene, a chip if methods that should agree do not: how many differ,
/// and with the pointer on it what each says.
void alarm_chip(const Player&, Ui&, const Rect& scene);
/// Draws the directions of the axes at the bottom left, unless a label or a handle stands there.
void tripod(Ui&, const View&, const Rect& scene, const std::vector<PlacedLabel>&, const std::vector<Handle>&);
/// Draw the projection's name at the bottom right: a button (before the scene's own), unless a handle stands there, and
/// its text (over the picture, unless a label does).
void projection_name(Player&, Ui&, const View&, const Rect& scene, const std::vector<Handle>&);
void projection_text(const Player&, Ui&, const Rect& scene, const std::vector<PlacedLabel>&);
/// A mark above it, where parameters were changed by hand: a button, with its text, that leads back to the preset.
/// Charts and pages, whose words reach everywhere, leave a strip of this height below them for it; not if a drag makes
/// the change: nothing else may move during a drag.
float changed_room(const Player&, const Lesson* in_file);
void changed_mark(Player&, Ui&, Toast&, const Rect& scene, const Lesson* in_file);
void changed_text(const Player&, const Ui&, const Rect& scene, const Lesson* in_file);
/// Keeps the reader's view for all presets of the lesson, or no longer.
void toggle_pin(Player&, Toast&);
/// A pin above these, once the reader has moved the view: a button (before the scene's own), and its sign.
void pin_mark(Player&, Ui&, Toast&, const View&, const Rect& scene, const std::vector<Handle>&);
void pin_text(const Player&, const Ui&, const Rect& scene);
/// Where a message stands, and of which one, on what: it stays there while that is on show.
struct MessagePlace {
  std::string of = {};
  Rect at = {};
};
/// Draws the current message at the bottom or, if it would cover labels or handles there, where it covers least.
/// `shown`: the step on show. (message.cpp)
void toast(Ui&, const Toast&, const Rect& scene, const std::vector<PlacedLabel>&, const std::string& shown,
           MessagePlace&);

/// Rings a handle. (handle_words.cpp)
void ring_handle(const Ui&, const View&, const Handle&);
/// Returns the name and value of a handle's parameter, and why it does not follow the pointer, if it is `forbidden` to;
/// plain lines. (handle_words.cpp)
std::string words_on_handle(const Player&, const Handle&, const std::string& forbidden);
/// Draws the words at the top right of the scene or, if a pixel that they keep `off` is near, at its bottom left.
/// (handle_words.cpp)
void words_at_edge(Ui&, const std::string& words, const Rect& scene, const std::vector<Vec2>& off);
/// Draws the name of the handle with the keyboard's ring, if no name stands at it.
void handle_by_keyboard(const Player&, Ui&, const View&, const Handle&);
/// Names the ball, solid, mesh or polygon that the viewing ray through `pixel` hits first, by the core's own ray
/// tests.
void item_under_pointer(const Player&, Ui&, const View&, const Vec2& pixel);

}  // namespace isect::viz
