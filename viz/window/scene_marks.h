#pragma once
// What lies over the scene: verdict, axes, projection, messages, and what the pointer is at.

#include "viz/compose.h"
#include "viz/window/session.h"

namespace isect::viz {

/// Much of it would be covered by what lies over it.
inline bool is_low(const Rect& scene) { return scene.height() < 340; }
/// What the scene leaves free at its top for the chips: in a chart as much as they take, in a low scene as much at each
/// step, as they would cover much of it.
float head_of(Session&, const Rect& scene);
/// The part of that which does not change from step to step.
float steady_head(Session&, const Rect& scene);
/// The verdict in a chip at the top left.
void verdict_chip(Session&, const Rect& scene);
/// Below it, or beside it in a low scene, where methods that should agree do not: how many differ, and with the pointer
/// on it what each says.
void alarm_chip(Session&, const Rect& scene);
/// The directions of the axes at the bottom left, unless a label or a handle stands there.
void tripod(Session&, const View&, const Rect& scene, const std::vector<PlacedLabel>&);
/// The projection's name at the bottom right: a button (before the scene's own), and its text (over the picture, unless
/// a label stands there).
void projection_name(Session&, const Rect& scene);
void projection_text(Session&, const Rect& scene, const std::vector<PlacedLabel>&);
/// Above it, where parameters were changed by hand: leads back to the preset. A button and its text, likewise.
/// Charts and pages, whose words reach everywhere, leave a strip below them for it; not where a drag makes the change,
/// under which nothing else may move.
float changed_room(const Session&);
void changed_mark(Session&, const Rect& scene);
void changed_text(Session&, const Rect& scene);
/// The message of the moment at the bottom.
void toast(Session&, const Rect& scene);

/// Rings a handle, names its parameter and value, and tells why it does not follow the pointer, if anything forbids
/// that.
void handle_under_pointer(Session&, const View&, const Handle&, const std::string& forbidden);
/// The name of a handle with the keyboard's ring, where none stands at it.
void handle_by_keyboard(Session&, const View&, const Handle&);
/// Names the ball, solid, mesh or polygon that the viewing ray through `pixel` meets first, asking the core's own ray
/// tests.
void item_under_pointer(Session&, const View&, const Vec2& pixel);

}  // namespace isect::viz
