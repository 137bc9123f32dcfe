#include "viz/window/window_ui.h"

#include <glad/gl.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "viz/formats/files.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/pseudocode.h"
#include "viz/window/kept_picture.h"
#include "viz/window/key_codes.h"
#include "viz/window/lesson_picture.h"
#include "viz/window/map_view.h"
#include "viz/window/object_changes.h"
#include "viz/window/objects_panel.h"
#include "viz/window/panels.h"
#include "viz/window/resting_pointer.h"
#include "viz/window/save_figure.h"
#include "viz/window/saving.h"
#include "viz/window/scene_view.h"
#include "viz/window/second_pane.h"

namespace isect::viz {

/// A Dear ImGui context with its OpenGL side, for as long as the window is open.
struct ImGuiScope {
  ImGuiScope() : context(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context);
    ImGui::GetIO().IniFilename = nullptr;
    if (!ImGui_ImplOpenGL3_Init("#version 330 core"))
      throw std::runtime_error("Dear ImGui cannot draw with this OpenGL");
  }
  ~ImGuiScope() {
    ImGui::SetCurrentContext(context);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context);
  }
  ImGuiScope(const ImGuiScope&) = delete;
  ImGuiScope& operator=(const ImGuiScope&) = delete;
  ImGuiContext* context;
};

namespace {

UiFonts fonts_at(double scale) {
  key::map();
  return load_fonts(scale);
}

/// Returns the size of code in a lecture in this window, px.
double large_size_in(const ImVec2& window) {
  return lecture_sizes(lecture_layout(window.x, window.y).lesson.height()).large;
}

/// Returns where the player starts: in the playlist, if there is one.
ReaderState start_of(const WindowOptions& options, const Settings& kept, const ReaderState& at) {
  const std::optional<Hour> hour = hour_of(options.playlist, kept);
  return hour ? hour->start() : at;
}

/// Keeps freed memory for the next frame, which needs about as much: otherwise it would be given back and fetched again
/// page by page.
void keep_memory() {
#ifdef __GLIBC__
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
  mallopt(M_TOP_PAD, 16 << 20);
#endif
}

}  // namespace

struct WindowUi::Impl {
  Impl(const std::vector<const Lesson*>& lessons, const ReaderState& at, Renderer& gl, const Settings& kept,
       const WindowOptions& options)
      : renderer(gl),
        player(lessons, start_of(options, kept, at), options.reduced_motion || kept.reduced_motion),
        settings(kept),
        reduced_motion(options.reduced_motion),
        drawing(options.draw_scene),
        density(options.scale),
        ui{palette(kept.theme), fonts_at(options.scale), TextTextures(options.scale, options.texts_a_frame)},
        course(options.course),
        session{.player = player,
                .ui = ui,
                .settings = settings,
                .course = course,
                .figures = options.figures,
                .scene_file = {.save = options.save_scene, .fresh = options.new_scene_file},
                .scene_editor = options.scene_editor},
        scene(gl, options.scale, options.draw_scene, options.place_names),
        map(gl, options.scale, options.draw_scene),
        panes(gl, options.scale, options.draw_scene) {
    keep_memory();
    player.clock().set_speed(kept.speed);
    player.clock().stop_at_questions(!kept.nonstop);
    if (at.beside) settings.beside = beside_of(at);
    session.hour = hour_of(options.playlist, kept);
    begin_hour(session);
  }

  /// Draws the preview; again only if something has changed.
  void draw_preview() {
    if (!session.save_sheet.open) return previewed.clear();
    const std::string now =
        to_json(player.reader_state()) + name_of(settings.save_theme) + " " + shown(settings.save_width_cm) + " cm";
    if (now == std::exchange(previewed, now) || !drawing) return;
    constexpr double width = 320, height = 280;  // px of the layout, at most
    const double scale = density * size;
    const PixelBox made = viz::draw_preview(player, settings, renderer, static_cast<int>(width * scale),
                                            static_cast<int>(height * scale), session.save_sheet.why);
    session.save_sheet.width = static_cast<float>(made.width),
    session.save_sheet.height = static_cast<float>(made.height);
    if (made.width == 0) return;
    preview.take(renderer.texture(), made.width, made.height);
    session.save_sheet.picture = preview.id();
  }

  /// Draws the first preset's outcome, once per lesson and theme.
  void draw_pictured() {
    const Lesson* const lesson = session.picker.lesson;
    session.picker.picture = {};
    if (!lesson || !drawing) return;
    KeptPicture& kept = pictured[{lesson, settings.theme}];
    if (!kept.id()) {
      const PixelBox made = draw_lesson(*lesson, window_theme(settings.theme), renderer, density * size);
      kept.take(renderer.texture(), made.width, made.height);
    }
    session.picker.picture = kept.id();
  }

  /// Prepares the next step. A map of cases takes as long as a frame: it is made before its step comes, a little in
  /// each frame, but never while a hand moves something. Returns whether there is more to do.
  bool prepare_next_step() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDown[0] || io.MouseDown[1]) return false;
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    while (player.prepare_next())
      if (Clock::now() - begin > std::chrono::milliseconds(3)) return true;
    return false;
  }

  /// Returns the wanted size, as far as the least layout fits into the window; smaller than usual where a display has
  /// made the window smaller than it may be.
  double fitting_size() const {
    const ImGuiIO& io = ImGui::GetIO();
    const double across = io.DisplaySize.x * size / least_width, down = io.DisplaySize.y * size / least_height;
    return std::min(settings.size, std::max(0.2, std::floor(10 * std::min(across, down) + 1e-3) / 10));
  }

  void resize() {
    const double now = fitting_size();
    ImGuiIO& io = ImGui::GetIO();
    const float by = static_cast<float>(size / now), scale = static_cast<float>(density * now);
    const double large = large_size_in({io.DisplaySize.x * by, io.DisplaySize.y * by});
    if (now == size && large == ui.fonts.large) return;
    io.Fonts->Clear();
    ui.fonts = load_fonts(scale, large);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    if (std::exchange(size, now) == now) return;
    ui.texts.rescale(scale);
    scene.rescale(scale);
    map.rescale(scale);
    panes.rescale(scale);
    pictured.clear();
    io.DisplaySize = {io.DisplaySize.x * by, io.DisplaySize.y * by};
    io.DisplayFramebufferScale = {scale, scale};
    if (io.MousePos.x > -1e6f) io.MousePos = {io.MousePos.x * by, io.MousePos.y * by};
  }

  /// Learns the names in the walk on show.
  void learn_names() {
    if (names_of_revision == player.revision() && !ui.names.empty()) return;
    names_of_revision = player.revision();
    if (std::exchange(names_of_lesson, &player.lesson()) != &player.lesson())
      names_of_knobs = names_of(player.lesson());
    ui.names = names_of(player.walk());
    ui.names.insert(names_of_knobs.begin(), names_of_knobs.end());
  }

  bool lectures() const { return !session.panels && !session.review; }

  WindowLayout layout() {
    const ImVec2& whole = ImGui::GetIO().DisplaySize;
    return !lectures() ? window_layout(whole.x, whole.y) : lecture_layout(whole.x, whole.y);
  }

  /// Shows a question of a review as its lesson does; at the end what came of all.
  void show_review(const WindowLayout& at, const ScenePane& pane, const LessonPanel& lesson) {
    panes.leave(player, settings);
    if (session.review->over()) return review_score(session, at.between_bars());
    scene.show(pane, at.scene);
    lesson_panel(lesson, at.lesson);
    code_panel(player, ui, at.code);
  }

  /// Shows all between the two bars.
  void show_step(const WindowLayout& at) {
    ScenePane pane{player, ui, session.toast, session.requests.zoom};
    pane.add_corner = [this](const View& view, const Vec2& pixel) { return add_corner_at(session, view, pixel); };
    pane.remove_corner = [this](const Handle& handle) { return remove_corner(session, handle.id()); };
    pane.in_file = scene_in_file(session);
    LessonPanel lesson{player, ui, settings, session.fields, session.step_words, session.requests, session.toast};
    lesson.in_hour = session.hour.has_value();
    if (session.review) return show_review(at, pane, lesson);
    if (shows_fault(session)) {
      panes.leave(player, settings);
      return stop_fault(session, at.between_bars());
    }
    if (two_panes(player, settings)) {
      const PanesLayout two = panes_layout(at, session.panels, player.quiz().asked() || player.quiz().answered());
      panes.show(pane, settings, scene, two);
      if (two.lesson.width() > 0) return lesson_panel(lesson, two.lesson);
      if (two.strip.height() > 0)
        lecture(player, ui, session.step_words, two.strip,
                [&](const auto& draw) { panes.on_its_side(pane, settings, draw); });
      return;
    }
    panes.leave(player, settings);
    if (shows_map(player, settings)) {
      const Halves parts = halves(at.scene, 0.42f);
      scene.show(pane, parts.first);
      map.show(player, ui, session.toast, parts.second);
    } else {
      scene.show(pane, at.scene);
    }
    if (!session.panels) return lecture(player, ui, session.step_words, at.lesson);
    lesson.answers = lists_objects(session);
    lesson_panel(lesson, at.lesson);
    if (lesson.answers && lists_objects(session)) return objects_panel(session, at.code);
    code_panel(player, ui, at.code);
  }

  ImGuiScope imgui;
  Renderer& renderer;
  Player player;
  Settings settings;
  bool reduced_motion;  ///< overrides the settings
  bool drawing;
  bool preparing = false;  ///< part of what the next step shows is still to be made
  unsigned names_of_revision = 0;
  const Lesson* names_of_lesson = nullptr;
  std::set<std::string> names_of_knobs = {};  ///< that lesson's: a scene may have thousands
  double density, size = 1;
  RestingPointer resting;
  Ui ui;
  Course course;
  WindowSession session;
  SceneView scene;
  MapView map;
  SecondPane panes;
  KeptPicture preview;
  std::string previewed;  ///< what it shows; empty: nothing
  std::map<std::pair<const Lesson*, ThemeName>, KeptPicture> pictured;
};

WindowUi::WindowUi(const std::vector<const Lesson*>& lessons, const ReaderState& at, Renderer& renderer,
                   const Settings& settings, const WindowOptions& options)
    : impl_(std::make_unique<Impl>(lessons, at, renderer, settings, options)) {}

WindowUi::~WindowUi() = default;

void WindowUi::frame() {
  Impl& w = *impl_;
  ImGui::SetCurrentContext(w.imgui.context);
  w.resize();
  const ImGuiIO& io = ImGui::GetIO();
  w.ui.palette = palette(w.settings.theme);
  dress(w.ui.palette);
  w.ui.rects.clear();
  w.session.toast.seconds_left -= io.DeltaTime;
  w.player.advance(io.DeltaTime);
  if (w.session.toast.at && *w.session.toast.at != Toast::here(w.player)) w.session.toast = {};
  // Only now: the frame built last shows the scene's texture, which saving overwrites.
  save_what_is_wanted(w.session, w.renderer);
  w.draw_preview();
  w.draw_pictured();
  follow_review(w.session);

  const bool came_back = w.resting.begin_frame(w.lectures(), w.ui.pointer_rest);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  if (w.resting.hidden() || w.session.dark) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  const bool moved = came_back || io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  w.ui.pointer_rest = moved ? 0 : w.ui.pointer_rest + io.DeltaTime;
  ImGui::PushFont(w.ui.fonts.body);
  ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true);  // Tab is the window's own
  keys(w.session);
  follow_review(w.session);
  follow_hour(w.session);
  w.learn_names();
  const WindowLayout at = w.layout();
  w.show_step(at);
  if (w.session.review) {
    review_bars(w.session, at.top, at.transport);
  } else {
    top_bar({w.player, w.ui, w.settings, w.session.requests, w.session.toast, pages_go_on(w.session),
             names_presets(w.session), scene_in_file(w.session)},
            at.top);
    transport(w.session, at.transport);
  }
  sheets(w.session, {0, 0, io.DisplaySize.x, io.DisplaySize.y});
  dark_screen(w.session, {0, 0, io.DisplaySize.x, io.DisplaySize.y});
  if (!w.session.dark) focus_ring(w.ui);
  w.ui.light.end_frame(io.DeltaTime, w.settings.reduced_motion || w.reduced_motion, moved, w.ui.focus.moved());
  const std::string name = w.ui.light.name();
  w.ui.sum =
      name.empty() ? name : sum_of(w.player.lesson(), w.player.parameters(), w.player.walk(), w.player.index(), name);
  if (!w.session.dark) tell_sum(w.ui, {0, 0, io.DisplaySize.x, io.DisplaySize.y});
  w.ui.focus.end_frame();
  keep_score(w.player, w.settings, w.session.answers_kept);
  if (!w.session.review) keep_place(w.player, w.settings);
  ImGui::PopItemFlag();
  ImGui::PopFont();
  ImGui::Render();

  w.ui.texts.next_frame();
  w.preparing = w.prepare_next_step();
}

void WindowUi::draw(unsigned framebuffer) {
  ImGui::SetCurrentContext(impl_->imgui.context);
  const ImGuiIO& io = ImGui::GetIO();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, static_cast<int>(io.DisplaySize.x * io.DisplayFramebufferScale.x),
             static_cast<int>(io.DisplaySize.y * io.DisplayFramebufferScale.y));
  glDisable(GL_SCISSOR_TEST);
  const Colour& c = impl_->ui.palette.window;
  glClearColor(static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

std::string WindowUi::title() const {
  const Player& p = impl_->player;
  const std::optional<Hour>& hour = impl_->session.hour;
  if (shows_fault(impl_->session)) return hour->told() + ": a stop that can't be opened – isect";
  std::string preset_title = "changed";
  const bool named = names_presets(impl_->session), edited = scene_in_file(impl_->session);
  for (const Preset& preset : p.lesson().presets)
    if (preset.id == p.played().preset_id() && !edited) preset_title = plain(p.told_title(preset, !named));
  return (hour ? hour->told() + ": " : "") + plain(p.lesson().title) + ", " + preset_title + ", step " +
         std::to_string(p.index() + 1) + " of " + std::to_string(p.count()) + " – isect";
}

double WindowUi::rest() const {
  const Player& p = impl_->player;
  const WindowSession& s = impl_->session;
  const bool scene_is_shown = s.review ? !s.review->over() : !shows_fault(s);
  if (p.camera().moving() || p.time_runs() || p.motion().share() < 1 || p.motion().light() < 1 ||
      impl_->ui.light.changing() || (scene_is_shown && impl_->scene.behind()) || impl_->panes.behind() ||
      impl_->ui.texts.waiting() || impl_->preparing)
    return 0;
  double rest = std::numeric_limits<double>::infinity();
  if (p.running()) rest = std::min(rest, std::max(p.clock().seconds_to_step(), 0.0));
  const bool pointed =
      !s.panels && !s.review && !impl_->resting.hidden() && ImGui::IsMousePosValid(&ImGui::GetIO().MousePos);
  if (pointed) rest = std::min(rest, std::max(pointer_patience - impl_->ui.pointer_rest, 0.0));
  if (impl_->session.toast.seconds_left > 0) rest = std::min(rest, impl_->session.toast.seconds_left);
  return rest;
}

double WindowUi::scale() const { return impl_->density * impl_->size; }
bool WindowUi::full_screen() const { return impl_->session.full_screen; }

bool WindowUi::wants_to_close() const { return impl_->session.requests.close; }
bool WindowUi::may_close() { return may_leave(impl_->session); }

const std::map<std::string, Rect>& WindowUi::rects() const { return impl_->ui.rects; }

void WindowUi::complain(const std::string& words) { impl_->session.toast.complain(words); }
std::string WindowUi::message() const {
  const WindowSession& s = impl_->session;
  if (s.save_sheet.open && !s.save_sheet.failed.empty()) return s.save_sheet.failed;
  if (s.toast.seconds_left > 0) return s.toast.text;
  if (!s.save_sheet.width_wrong.empty()) return s.save_sheet.width_wrong;
  return s.fields.refused.revision == s.player.revision() ? s.fields.refused.why : std::string();
}
const std::vector<PlacedLabel>& WindowUi::labels() const { return impl_->scene.labels(); }
const std::string& WindowUi::sum() const { return impl_->ui.sum; }
const std::string& WindowUi::focus() const { return impl_->ui.focus.name(); }

Player& WindowUi::player() { return impl_->player; }

Settings WindowUi::settings() const {
  Settings settings = impl_->settings;
  const std::optional<Reviewing>& review = impl_->session.review;
  const Player& player = review ? review->before : impl_->player;
  if (review) settings.beside = review->beside;
  settings.speed = player.clock().speed();
  if (impl_->session.hour) keep_hour(settings.hours, impl_->session.hour->place());
  if (!player.lesson().made_from.empty()) return settings;  // from a file that the next run does not know
  settings.reader_state = player.reader_state();
  if (!player.camera().moved()) settings.reader_state->camera.reset();  // presets keep framing themselves
  return settings;
}

}  // namespace isect::viz
