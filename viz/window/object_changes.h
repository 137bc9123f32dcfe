#pragma once
// What a reader does to the list of a scene's objects: each change shows another version of the scene.

#include <string>

#include "viz/camera.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Lists the objects of the scene on show, if that is not done yet: none if it can't be changed.
void list_anew(WindowSession&);
/// Shows the scene after a change, which the reader may leave the step for. Returns whether it was not refused; why it
/// was is told.
bool change_scene(WindowSession&, const SceneEdit&, bool leaves_step = false);
/// Chooses an object, or lets it go; of three the one chosen first is let go.
void choose_object(ObjectsPanel&, const std::string& name);
/// Adds an object in the middle of what is seen.
void add_object_of(WindowSession&, const std::string& type);
void remove_object(WindowSession&, const std::string& name);
/// Shows the field in which a name is typed.
void begin_renaming(ObjectsPanel&, const std::string& name);
void rename_object(WindowSession&, const std::string& name, const std::string& now);
/// Adds a question, and goes to its answer.
void ask_about_chosen(WindowSession&, const std::string& question);
void remove_question(WindowSession&, const SceneQuestion&);

// The corners of outlines. Each returns whether there is such a side or corner; why a change is refused is told.
/// Adds a corner where a side is seen at this pixel.
bool add_corner_at(WindowSession&, const View&, const Vec2& pixel);
/// Adds one in the middle of the side that begins at the corner of a handle, "P.3".
bool add_corner_behind(WindowSession&, const std::string& handle);
bool remove_corner(WindowSession&, const std::string& handle);

}  // namespace isect::viz
