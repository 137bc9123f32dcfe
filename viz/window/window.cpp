#include "viz/window/window.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "viz/formats/files.h"
#include "viz/window/end_signals.h"
#include "viz/window/key_codes.h"
#include "viz/window/window_ui.h"

namespace isect::viz {
namespace {

#if IMGUI_VERSION_NUM < 18700
static_assert(key::right == GLFW_KEY_RIGHT && key::left == GLFW_KEY_LEFT && key::home == GLFW_KEY_HOME &&
              key::end == GLFW_KEY_END && key::escape == GLFW_KEY_ESCAPE && key::enter == GLFW_KEY_ENTER &&
              key::tab == GLFW_KEY_TAB && key::f1 == GLFW_KEY_F1 && key::f12 == GLFW_KEY_F12 &&
              key::minus == GLFW_KEY_MINUS && key::equal == GLFW_KEY_EQUAL && key::keypad_plus == GLFW_KEY_KP_ADD &&
              key::f11 == GLFW_KEY_F11 && key::z == GLFW_KEY_Z);
#endif

std::string glfw_words() {
  const char* words = nullptr;
  return glfwGetError(&words) != GLFW_NO_ERROR && words ? words : "no reason given";
}

/// GLFW with its one window, whose context is current.
class Window {
 public:
  Window(int width, int height) {
    if (!glfwInit()) throw NoDisplay("no display to open a window on (" + glfw_words() + ")");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    const Size fits = within_monitor(width, height);
    handle_ = glfwCreateWindow(fits.width, fits.height, "isect", nullptr, nullptr);
    if (!handle_) {
      const std::string words = glfw_words();
      glfwTerminate();
      throw NoDisplay("the display opens no window with OpenGL 3.3 (" + words + ")");
    }
    glfwMakeContextCurrent(handle_);
    glfwSwapInterval(1);
    const auto pixels = [this](int px) { return static_cast<int>(px * scale()); };
    glfwSetWindowSizeLimits(handle_, pixels(least_width), pixels(least_height), GLFW_DONT_CARE, GLFW_DONT_CARE);
  }
  ~Window() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return handle_; }

  /// Returns framebuffer pixels per px of the layout.
  double scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(handle_, &x, &y);
    return x > 0 ? x : 1;
  }

  struct Size {
    int width, height;
  };
  /// Fills the whole first screen, or goes back to the old place.
  void fill_screen(bool wanted) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (wanted == filling_ || !mode) return;
    if (wanted) {
      before_ = size();
      glfwGetWindowPos(handle_, &x_, &y_);
      glfwGetWindowSize(handle_, &width_, &height_);
      glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
      glfwSetWindowMonitor(handle_, nullptr, x_, y_, width_, height_, GLFW_DONT_CARE);
    }
    filling_ = wanted;
  }

  /// Returns the size in px of the layout, whatever the screen's density; if the window fills the screen, the old size.
  Size size() const {
    if (filling_) return before_;
    int across = 0, down = 0;
    glfwGetFramebufferSize(handle_, &across, &down);
    return {static_cast<int>(std::lround(across / scale())), static_cast<int>(std::lround(down / scale()))};
  }

 private:
  /// Limits a size to the first screen, if there is one to ask.
  static Size within_monitor(int width, int height) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return {width, height};
    int x = 0, y = 0, across = 0, down = 0;
    float scale = 1, scale_down = 1;
    glfwGetMonitorWorkarea(monitor, &x, &y, &across, &down);
    glfwGetMonitorContentScale(monitor, &scale, &scale_down);
    if (!(across > 0 && down > 0 && scale > 0)) return {width, height};
    const auto least_of = [scale](int wanted, int there, int least) {
      return std::max(std::min(wanted, static_cast<int>(std::floor(static_cast<float>(there) / scale))), least);
    };
    return {least_of(width, across, least_width), least_of(height, down, least_height)};
  }

  GLFWwindow* handle_ = nullptr;
  bool filling_ = false;
  Size before_ = {};
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;  ///< before it filled the screen, in GLFW's coordinates
};

/// Finds a key by what it says. GLFW numbers keys by their place on a US keyboard; Ctrl+Z means the Z, Ctrl++ the +.
int by_layout(int code, int scancode) {
  if (code <= GLFW_KEY_SPACE || code > GLFW_KEY_GRAVE_ACCENT) return code;
  const char* name = glfwGetKeyName(code, scancode);
  if (!name || !name[0] || name[1]) return code;
  if (name[0] >= 'a' && name[0] <= 'z') return name[0] - 'a' + GLFW_KEY_A;
  return name[0] == '+' || name[0] == '-' || name[0] == '=' || name[0] == '0' ? name[0] : code;
}

#if IMGUI_VERSION_NUM >= 18700
/// Returns Dear ImGui's own number of a key that we or its fields use.
ImGuiKey number_of(int code) {
  const auto within = [code](int first, int last, ImGuiKey from) {
    return code >= first && code <= last ? static_cast<ImGuiKey>(from + code - first) : ImGuiKey_None;
  };
  static const std::map<int, ImGuiKey> others = {{GLFW_KEY_SPACE, ImGuiKey_Space},
                                                 {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
                                                 {GLFW_KEY_ENTER, ImGuiKey_Enter},
                                                 {GLFW_KEY_TAB, ImGuiKey_Tab},
                                                 {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
                                                 {GLFW_KEY_INSERT, ImGuiKey_Insert},
                                                 {GLFW_KEY_DELETE, ImGuiKey_Delete},
                                                 {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
                                                 {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
                                                 {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
                                                 {GLFW_KEY_UP, ImGuiKey_UpArrow},
                                                 {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
                                                 {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
                                                 {GLFW_KEY_HOME, ImGuiKey_Home},
                                                 {GLFW_KEY_END, ImGuiKey_End},
                                                 {GLFW_KEY_MINUS, ImGuiKey_Minus},
                                                 {GLFW_KEY_EQUAL, ImGuiKey_Equal},
                                                 {'+', ImGuiKey_KeypadAdd},
                                                 {GLFW_KEY_KP_0, ImGuiKey_Keypad0},
                                                 {GLFW_KEY_KP_ADD, ImGuiKey_KeypadAdd},
                                                 {GLFW_KEY_KP_SUBTRACT, ImGuiKey_KeypadSubtract},
                                                 {GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter}};
  const auto found = others.find(code);
  if (found != others.end()) return found->second;
  if (const ImGuiKey letter = within(GLFW_KEY_A, GLFW_KEY_Z, ImGuiKey_A); letter != ImGuiKey_None) return letter;
  if (const ImGuiKey digit = within(GLFW_KEY_0, GLFW_KEY_9, ImGuiKey_0); digit != ImGuiKey_None) return digit;
  return within(GLFW_KEY_F1, GLFW_KEY_F12, ImGuiKey_F1);
}
#endif

/// Dear ImGui's input from GLFW. Keys wait in a queue: each frame sees one key, with the modifiers held at its press,
/// even if these are released before the frame begins.
class Input {
 public:
  explicit Input(GLFWwindow* window) : window_(window) {
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int code, int scancode, int action, int modifiers) {
      if (action == GLFW_REPEAT) return;  // Dear ImGui repeats by itself
      const KeyEvent event{by_layout(code, scancode), scancode, action, modifiers};
      told(w).waiting_.push_back(event);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
      told(w);
      ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
      told(w);
      ImGui_ImplGlfw_ScrollCallback(w, x, y);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int c) {
      told(w);
      ImGui_ImplGlfw_CharCallback(w, c);
    });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { told(w); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { told(w); });
#if IMGUI_VERSION_NUM < 18700
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { told(w); });
#else  // pointer events are passed on at once, and so in px of the layout
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
      const double to_px = told(w).to_px_;
      ImGui::GetIO().AddMousePosEvent(static_cast<float>(to_px * x), static_cast<float>(to_px * y));
    });
#endif
  }
  ~Input() { ImGui_ImplGlfw_Shutdown(); }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  /// Whether some keys have not been seen yet.
  bool waiting() const { return !waiting_.empty(); }
  /// Whether any event has come since the last call.
  bool came() { return std::exchange(came_, false); }
  /// Starts a frame, in a layout with `scale` framebuffer pixels per px. It sees one key pressed, and never one key
  /// released and pressed again.
  void new_frame(double scale) {
    std::set<int> gone;
    for (bool pressed = false; waiting() && !pressed;) {
      const KeyEvent e = waiting_.front();
      if (e.action == GLFW_PRESS && gone.contains(e.code)) break;
      waiting_.pop_front();
      tell(e);
      if (e.action == GLFW_RELEASE) gone.insert(e.code);
      pressed = e.action == GLFW_PRESS && !is_modifier(e.code);
    }
    ImGui_ImplGlfw_NewFrame();
    to_layout(scale);
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    const float to_px = static_cast<float>(to_px_);
    if (io.MousePos.x > -1e6f) io.MousePos = {io.MousePos.x * to_px, io.MousePos.y * to_px};
#endif
  }

 private:
  struct KeyEvent {
    int code, scancode, action, modifiers;
  };
  static Input& told(GLFWwindow* window) {
    Input& input = *static_cast<Input*>(glfwGetWindowUserPointer(window));
    input.came_ = true;
    return input;
  }
  void tell(const KeyEvent&);
  void to_layout(double scale);

  static bool is_modifier(int code) { return code >= GLFW_KEY_LEFT_SHIFT && code <= GLFW_KEY_RIGHT_SUPER; }

  GLFWwindow* window_;
  std::deque<KeyEvent> waiting_;
  bool came_ = false;
  double to_px_ = 1;  ///< px of the layout to a window coordinate
};

#if IMGUI_VERSION_NUM < 18700
void Input::tell(const KeyEvent& e) { ImGui_ImplGlfw_KeyCallback(window_, e.code, e.scancode, e.action, e.modifiers); }
#else
/// Passes an event on; not through Dear ImGui's back end, which takes the modifiers that are down by now.
void Input::tell(const KeyEvent& e) {
  ImGuiIO& io = ImGui::GetIO();
  const bool down = e.action == GLFW_PRESS;
  const auto modifier = [&](ImGuiKey mod, int bit, int left, int right) {
    const bool itself = e.code == left || e.code == right;  // for it `modifiers` tells the state before
    io.AddKeyEvent(mod, itself ? down : (e.modifiers & bit) != 0);
  };
  modifier(ImGuiMod_Ctrl, GLFW_MOD_CONTROL, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  modifier(ImGuiMod_Shift, GLFW_MOD_SHIFT, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  modifier(ImGuiMod_Alt, GLFW_MOD_ALT, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  if (const ImGuiKey key = number_of(e.code); key != ImGuiKey_None) io.AddKeyEvent(key, down);
}
#endif

/// Converts GLFW's window coordinates to px of the layout.
void Input::to_layout(double scale) {
  int width = 1, height = 1, pixels_across = 1, pixels_down = 1;
  glfwGetWindowSize(window_, &width, &height);
  glfwGetFramebufferSize(window_, &pixels_across, &pixels_down);
  ImGuiIO& io = ImGui::GetIO();
  const float s = static_cast<float>(scale);
  io.DisplaySize = {static_cast<float>(pixels_across) / s, static_cast<float>(pixels_down) / s};
  io.DisplayFramebufferScale = {s, s};
  if (width > 0) to_px_ = pixels_across / (width * scale);
}

/// The state in its file. It is also written whenever all has been at rest for a while, so that no crash loses it.
class KeptState {
 public:
  KeptState(std::string file, const Window& window, const WindowUi& ui)
      : file_(std::move(file)), window_(window), ui_(ui) {}

  void write() {
    Settings settings = ui_.settings();
    settings.width = window_.size().width, settings.height = window_.size().height;
    std::string text = text_of(settings);
    if (text == written_) return;
    written_ = std::move(text);
    try {
      write_settings(file_, settings);
    } catch (const FileError&) {
      // A state folder that can't be written is no reason to fail: the next run starts from the defaults.
    }
  }

 private:
  std::string file_, written_;
  const Window& window_;
  const WindowUi& ui_;
};

/// Waits for events; while nothing is moved or pressed, no longer than `rest` seconds.
void wait(double rest, KeptState& state) {
  constexpr double patience = 1;
  const double begun = glfwGetTime();
  glfwWaitEventsTimeout(std::min(rest, patience));
  if (rest <= patience || glfwGetTime() - begun < patience) return;
  state.write();
  rest -= patience;
  std::isfinite(rest) ? glfwWaitEventsTimeout(rest) : glfwWaitEvents();
}

void run(Window& window, Input& input, WindowUi& ui, const EndSignals& signals, KeptState& state) {
  constexpr int settle = 3;  // frames that Dear ImGui may need to answer an event
  int frames_due = settle;
  std::string title;
  while (!ui.wants_to_close() && !signals.came()) {
    if (glfwWindowShouldClose(window.handle())) {
      if (ui.may_close()) break;
      glfwSetWindowShouldClose(window.handle(), GLFW_FALSE);
    }
    // An idle window costs nothing, but a text cursor blinks.
    const double rest = ImGui::GetIO().WantTextInput ? std::min(ui.rest(), 0.25) : ui.rest();
    if (rest <= 0 || input.waiting()) frames_due = settle;
    if (frames_due > 0) {
      glfwPollEvents();
    } else {
      wait(rest, state);
      frames_due = settle;
    }
    if (input.came()) frames_due = settle;
    --frames_due;
    input.new_frame(ui.scale());
    if (ImGui::GetIO().DisplaySize.x < 1 || ImGui::GetIO().DisplaySize.y < 1) continue;  // minimised
    ui.frame();
    ui.draw();
    glfwSwapBuffers(window.handle());
    window.fill_screen(ui.full_screen());
    if (ui.title() != title) glfwSetWindowTitle(window.handle(), (title = ui.title()).c_str());
  }
}

}  // namespace

void show(const std::vector<const Lesson*>& lessons, const Course& course, const ReaderState& at,
          const std::function<void(const std::string&)>& say,
          const std::function<void(const Lesson&, const Parameters&)>& save_scene, const Playlist& playlist,
          const SceneEditor& editor, const NewSceneFile& new_file) {
  const std::string file = settings_file();
  Settings kept = read_settings(file, lessons);
  const bool resumed = at.lesson.empty() && kept.reader_state && playlist.stops.empty();
  const ReaderState start = resumed ? *kept.reader_state : at;
  if (!resumed) kept.beside.reset();
  const EndSignals signals(glfwPostEmptyEvent);
  Window window(kept.width, kept.height);
  Renderer renderer([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
  const double scale = window.scale();
  WindowUi ui(lessons, start, renderer, kept,
              {.scale = scale,
               .texts_a_frame = smooth_texts,
               .course = course,
               .save_scene = save_scene,
               .new_scene_file = new_file,
               .playlist = playlist,
               .scene_editor = editor});
  if (const std::string damage = set_spoilt_settings_aside(file); !damage.empty()) {
    if (say) say(damage);
    ui.complain(damage);
  }
  Input input(window.handle());
  KeptState state(file, window, ui);
  run(window, input, ui, signals, state);
  state.write();
}

}  // namespace isect::viz
