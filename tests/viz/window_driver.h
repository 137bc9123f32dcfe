#pragma once
// The whole window without a display: an off-screen context, and hands on Dear ImGui's input. As in life,
// hover, down and up are frames of their own.

#include <imgui.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <stdexcept>

#include "viz/formats/files.h"
#include "viz/gl/offscreen.h"
#include "viz/window/frame_target.h"
#include "viz/window/key_codes.h"
#include "viz/window/window_ui.h"

namespace isect::viz {

/// A lesson's preset.
inline ReaderState place_at(const std::string& lesson, const std::string& preset) {
  ReaderState state;
  state.lesson = lesson, state.preset = preset;
  return state;
}

/// Options for tests of the layout: drawing the scene takes most of a frame, and placing its names much of the rest.
inline const WindowOptions layout_only = {.reduced_motion = true, .draw_scene = false, .place_names = false};
inline const WindowOptions names_only = {.reduced_motion = true, .draw_scene = false};

class WindowDriver {
 public:
  WindowDriver(const std::vector<const Lesson*>& lessons, float width = 1280, float height = 800,
               const ReaderState& at = {}, const Settings& settings = {},
               const WindowOptions& options = {.reduced_motion = true})
      : ui(lessons, at, offscreen.renderer(), settings, options), scale_(static_cast<float>(options.scale)) {
    resize(width, height);
    ImGui::GetIO().MousePos = {-1, -1};
    frames(3);
  }

  void resize(float width, float height) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {width, height};
    io.DisplayFramebufferScale = {scale_, scale_};
#if IMGUI_VERSION_NUM >= 18700
    io.ConfigInputTrickleEventQueue = false;  // what is pressed in a frame is pressed in that frame
#endif
  }
  void frames(int n = 1) {
    for (int i = 0; i < n; ++i) {
      ImGui::GetIO().DeltaTime = 1.0f / 60;
      ui.frame();
    }
  }
  /// Lets time pass in one frame.
  void wait(float seconds) {
    ImGui::GetIO().DeltaTime = seconds;
    ui.frame();
  }

  Rect rect(const std::string& name) const {
    const auto found = ui.rects().find(name);
    if (found == ui.rects().end()) throw std::runtime_error("no widget is called " + name);
    return found->second;
  }
  bool has(const std::string& name) const { return ui.rects().contains(name); }

  void move(float x, float y) {
    ImGui::GetIO().MousePos = {x, y};
    frames();
  }
  void button(bool down, int which = 0) {
    ImGui::GetIO().MouseDown[which] = down;
    frames();
  }
  void click(float x, float y) {
    move(x, y);
    button(true);
    button(false);
    frames();
  }
  void click(const std::string& name) {
    const Rect r = rect(name);
    click(r.middle_x(), r.middle_y());
  }
  /// Takes hold at one point and lets go at another, by way of the middle.
  void drag(float x0, float y0, float x1, float y1, int which = 0) {
    move(x0, y0);
    button(true, which);
    move((x0 + x1) / 2, (y0 + y1) / 2);
    move(x1, y1);
    button(false, which);
  }
  void drag(const std::string& name, float dx, float dy) {
    const Rect r = rect(name);
    drag(r.middle_x(), r.middle_y(), r.middle_x() + dx, r.middle_y() + dy);
  }
  void wheel(float turns) {
    ImGui::GetIO().MouseWheel = turns;
    frames();
  }

  /// Presses a key that types nothing, or one with Ctrl or Shift.
  void key(key::Code code, bool with_control = false, bool with_shift = false) {
    modifiers(with_control, with_shift);
    press(code, true);
    frames();
    press(code, false);
    modifiers(false, false);
    frames();
  }
  void press(key::Code code, bool down) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeysDown[code] = down;
#else
    ImGui::GetIO().AddKeyEvent(code, down);
#endif
  }
  void control(bool held) { modifiers(held, false); }
  void modifiers(bool with_control, bool with_shift) {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM < 18700
    io.KeyCtrl = with_control, io.KeyShift = with_shift;
    io.KeyMods = (with_control ? ImGuiKeyModFlags_Ctrl : 0) | (with_shift ? ImGuiKeyModFlags_Shift : 0);
#else
    io.AddKeyEvent(ImGuiMod_Ctrl, with_control);
    io.AddKeyEvent(ImGuiMod_Shift, with_shift);
#endif
  }
  void type(const std::string& characters) {
    ImGui::GetIO().AddInputCharactersUTF8(characters.c_str());
    frames(2);
  }

  /// Answers the open question by its choice's letter. Where more than a choice is asked for, it shows the choices
  /// first.
  void answer(int choice) {
    player().show_choices();
    type(std::string(1, static_cast<char>('a' + choice)));
  }

  /// What the window looks like now.
  Picture picture() {
    const ImGuiIO& io = ImGui::GetIO();
    const double scale = ui.scale();
    const int width = static_cast<int>(std::lround(io.DisplaySize.x * scale));
    const int height = static_cast<int>(std::lround(io.DisplaySize.y * scale));
    const FrameTarget target(width, height);
    ui.draw(target.framebuffer());

    const std::size_t row = static_cast<std::size_t>(width) * 4;
    std::vector<std::uint8_t> upwards(row * height);
    Picture picture{width, height, std::vector<std::uint8_t>(upwards.size())};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upwards.data());
    for (int y = 0; y < height; ++y)
      std::memcpy(picture.rgba.data() + y * row, upwards.data() + (height - 1 - y) * row, row);
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    return picture;
  }

  Player& player() { return ui.player(); }

  Offscreen offscreen;
  WindowUi ui;

 private:
  float scale_;
};

/// Opens each question of each lesson's first preset, and calls `then` with it.
template <class Then>
void ask_all(WindowDriver& window, const std::vector<const Lesson*>& lessons, const Then& then) {
  for (const Lesson* lesson : lessons) {
    window.player().open(*lesson);
    for (int i = 1; i < window.player().count(); ++i) {
      window.player().go_to(i - 1);
      window.player().next();
      if (const Question* question = window.player().quiz().asked()) then(*question);
    }
  }
}

}  // namespace isect::viz
