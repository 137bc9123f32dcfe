#pragma once
// The window: a player for any list of lessons.

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "viz/course.h"
#include "viz/lesson.h"
#include "viz/player/playlist.h"
#include "viz/player/reader_state.h"
#include "viz/scene_editor.h"

namespace isect::viz {

/// Thrown if there is no display for the window; the message names what to do instead.
struct NoDisplay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Opens the window at `at` and returns when it is closed. Messages for the user, such as that a state file is damaged,
/// are shown there and passed to `say`. `save_scene` writes a lesson's scene with this setting into its file; the
/// lesson is then as if made from that; null: there is no file. `new_file`: gives a scene one that has none.
/// `playlist`: the window goes through it, from where it was left, and not to `at`; its lessons are among the others.
/// `editor`: lists and changes the objects of scenes; an empty one lists none. Throws NoDisplay.
void show(const std::vector<const Lesson*>&, const Course&, const ReaderState& at,
          const std::function<void(const std::string&)>& say = {},
          const std::function<void(const Lesson&, const Parameters&)>& save_scene = {}, const Playlist& playlist = {},
          const SceneEditor& editor = {}, const NewSceneFile& new_file = {});

}  // namespace isect::viz
