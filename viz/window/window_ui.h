#pragma once
// The whole window on top of any OpenGL context: one Dear ImGui frame at a time. The GLFW loop drives it, and
// so do the tests, through ImGui's own input, with no display at all.

#include <functional>
#include <limits>
#include <memory>

#include "viz/compose/compose.h"
#include "viz/course.h"
#include "viz/gl/renderer.h"
#include "viz/scene_editor.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Square px of new texts that a frame has time for: a step has less, a closing card more.
inline constexpr double smooth_texts = 60'000;

struct WindowOptions {
  double scale = 1;             ///< the screen's density: framebuffer pixels per px of the layout, at size 1
  bool reduced_motion = false;  ///< the camera arrives at once
  bool draw_scene = true;       ///< off in tests of the layout, most of which place no names either
  bool place_names = true;
  /// The most square px of new texts that a frame draws; the rest follows in the next ones.
  double texts_a_frame = std::numeric_limits<double>::infinity();
  std::string figures = "figures";
  Course course = {};
  /// Writes the lesson's scene with a setting into its file; null: there is none.
  std::function<void(const Lesson&, const Parameters&)> save_scene = {};
  NewSceneFile new_scene_file = {};  ///< of a scene that has none yet
  Playlist playlist = {};  ///< to be gone through, from where the settings left it, and not from `at`; empty: none
  SceneEditor scene_editor = {};  ///< lists and changes the objects of scenes
};

class WindowUi {
 public:
  /// Needs a current context whose functions the renderer has loaded, and makes its own Dear ImGui context.
  /// Throws BadInput for a place that does not exist.
  WindowUi(const std::vector<const Lesson*>&, const ReaderState& at, Renderer&, const Settings& = {},
           const WindowOptions& = {});
  ~WindowUi();
  WindowUi(const WindowUi&) = delete;
  WindowUi& operator=(const WindowUi&) = delete;

  /// Builds one frame. Before it, the caller sets io.DisplaySize (px of the layout), io.DeltaTime and the
  /// input.
  void frame();
  /// Draws the frame built last into a framebuffer of OpenGL (0: the window's own).
  void draw(unsigned framebuffer = 0);

  /// Returns the window's title: lesson, preset, "step 3 of 12".
  std::string title() const;
  /// Returns framebuffer pixels per px of the layout now. A frame that changes it changes io.DisplaySize and the
  /// pointer's place accordingly.
  double scale() const;
  bool full_screen() const;
  /// Returns the seconds until something changes by itself: 0 while it moves, infinity if all is at rest.
  double rest() const;
  /// Whether Ctrl+Q was pressed.
  bool wants_to_close() const;
  /// Called when the window is to be closed from outside: returns false if that needs confirmation.
  bool may_close();
  /// Returns the widgets of the frame built last, by name, in px.
  const std::map<std::string, Rect>& rects() const;
  /// Returns the labels of the scene drawn last.
  const std::vector<PlacedLabel>& labels() const;
  /// Returns the message on show, or why typed text is refused; empty if there is none.
  std::string message() const;
  /// Returns the widget that the keyboard holds; empty if it holds none.
  const std::string& focus() const;
  /// Returns what is told of the lit name; empty: nothing.
  const std::string& sum() const;
  /// Shows a message as an error.
  void complain(const std::string& words);
  Player& player();
  /// Returns what is to be kept for the next run.
  Settings settings() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace isect::viz
