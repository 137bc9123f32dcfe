// Drives the window at random, in this process and off-screen: drive [--minutes M] [--round N] [--out DIR]. Keys with
// and without Ctrl and Shift, clicks, drags of handles and of anything else, the wheel, typed and pasted junk, other
// sizes, long waits: over all lessons and the scenes of examples/, a few more scenes, and each as a walk of the lessons
// that take it, and a playlist. A round is a window of its own, on a lesson and a preset drawn at random; one of four
// draws all it shows.
//
// Nothing may be thrown, and no frame may keep a reader waiting. A failure is reported with its round and its last
// actions; the next round goes on, and the program ends with 1. Where it crashes, DIR/actions.txt has them (DIR:
// drive). ISECT_SEED=n draws other rounds, --round does that one alone. Without --minutes: a round for each four
// lessons or scenes.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <deque>
#include <filesystem>
#include <fstream>
#include <random>
#include <ranges>
#include <string>
#include <vector>

#include "app/playlist_file.h"
#include "app/scene/editor.h"
#include "app/scene/lesson.h"
#include "lessons/course.h"
#include "lessons/lessons.h"
#include "tests/settings.h"
#include "tests/viz/window_driver.h"
#include "viz/player/reader_state.h"

using namespace isect;
using namespace isect::viz;

namespace {

/// The processor time in seconds that a frame may take; the sanitizers make it several times slower.
#if defined(__SANITIZE_ADDRESS__)
constexpr double most_a_frame = 120;
#else
constexpr double most_a_frame = 15;
#endif
constexpr int actions_a_round = 150;

/// Scenes that lessons walk through, or refuse if a corner is dragged too far.
constexpr const char* walked[] = {
    R"({"objects": [{"point": "p", "at": [0, 0]}, {"polygon": "P", "points": [[-2, -2], [2, -2], [2, 2], [-2, 2]]}],
        "ask": [{"walk": ["p", "P"], "lesson": "convex-polygon"}]})",
    R"({"objects": [{"point": "p", "at": [0, 0]}, {"polygon": "P", "points": [[-2, -2], [2, -2], [2, 2], [0, 0.5], [-2, 2]]}],
        "ask": [{"walk": ["p", "P"], "lesson": "concave-polygon"}, {"walk": ["p", "P"], "lesson": "crossings"}]})",
    R"({"objects": [{"ray": "r", "origin": [-4, 0.5, 1], "dir": [2, 0.25, -0.25]},
                    {"sphere": "S", "center": [0, 0, 0], "radius": 1.5}, {"obb": "A", "center": [1, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1], "half": [1, 1, 1]},
                    {"obb": "B", "center": [3, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1], "half": [1, 0.5, 1]}],
        "ask": [{"walk": ["r", "S"]}, {"walk": ["A", "B"]}, ["A", "B"], ["r", "A"]]})"};

/// Texts that are typed and pasted.
const std::vector<std::string> junk = {"1,5",
                                       "1e-3",
                                       "2*pi",
                                       "1/3",
                                       "1/0",
                                       "nan",
                                       "-inf",
                                       "1e400",
                                       "1e-320",
                                       "-0",
                                       "",
                                       " ",
                                       "sqrt(2)",
                                       "0x10",
                                       "9e999999",
                                       "abc",
                                       "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80",
                                       "{}",
                                       "[",
                                       R"({"lesson": "ray-sphere"})",
                                       R"({"lesson": "nothing"})",
                                       R"({"lesson": "crossings", "step": 99})",
                                       R"({"lesson": "ray-sphere", "parameters": {"radius": -1}})",
                                       R"({"lesson": "relations", "step": 3, "beside": {"preset": "x"}})",
                                       "?",
                                       "12345678901234567890",
                                       "collision",
                                       "8cm",
                                       "(((((((((((((((((((((1))))))))))",
                                       "1+",
                                       "*",
                                       ",",
                                       ";",
                                       "t_max",
                                       "\t\n"};

const key::Code codes[] = {
    key::left, key::right, key::up,     key::down,  key::home,      key::end,      key::page_up,     key::page_down,
    key::tab,  key::enter, key::escape, key::space, key::backspace, key::del,      key::insert,      key::f1,
    key::f6,   key::f11,   key::f12,    key::zero,  key::minus,     key::equal,    key::plus,        key::keypad_plus,
    key::a,    key::c,     key::o,      key::q,     key::s,         key::v,        key::x,           key::y,
    key::z,    key::right, key::right,  key::right, key::left,      key::keypad_0, key::keypad_enter};

constexpr ThemeName themes[] = {ThemeName::dark, ThemeName::screen, ThemeName::print, ThemeName::grey};
const std::string spoilers = "0123456789e-.,{}[]\"x";  ///< of a state that is pasted

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Drive {
 public:
  Drive(std::string out, std::uint64_t seed) : out_(std::move(out)), seed_(seed), stops_(lessons::all_lessons()) {
    std::filesystem::create_directories(out_);
    for (const auto& entry : std::filesystem::directory_iterator(ISECT_EXAMPLE_SCENES))
      if (entry.path().extension() == ".json") add(read_file(entry.path().string()), ISECT_EXAMPLE_SCENES);
    for (const char* text : walked) add(text, ISECT_EXAMPLE_SCENES);
    hour_ =
        program::read_playlist({"isect", lessons::all_lessons()}, ISECT_EXAMPLE_SCENES "/playlists/ray-and-ball.json");
    Stop gone;
    gone.name = "gone.json", gone.fault = "stop 3, line 9: scene: gone.json: No such file or directory";
    hour_.stops.insert(hour_.stops.begin() + 2, gone);
  }

  std::size_t stops() const { return stops_.size(); }
  int actions() const { return actions_; }
  double slowest() const { return slowest_; }
  const std::string& slowest_was() const { return slowest_was_; }

  void round(int number) {
    std::filesystem::remove_all(out_ + "/figures");
    told_.clear();
    log_.close();
    log_.open(out_ + "/actions.txt", std::ios::trunc);
    random_.seed(seed_ * 1'000'003 + static_cast<std::uint64_t>(number));
    const Lesson& lesson = *stops_[(static_cast<std::size_t>(number) * 7 + seed_) % stops_.size()];
    ReaderState state;
    state.lesson = lesson.id;
    state.preset = any(lesson.presets).id;
    Settings settings;
    settings.parameters_open = chance(0.5), settings.map = chance(0.3), settings.nonstop = chance(0.2);
    settings.theme = any(themes);
    WindowOptions options{.reduced_motion = chance(0.5), .draw_scene = chance(0.25), .place_names = true};
    options.figures = out_ + "/figures", options.course = lessons::course();
    std::vector<const Lesson*> all = lessons::all_lessons();
    if (!lesson.made_from.empty()) {
      all.push_back(&lesson);
      options.save_scene = [](const Lesson& scene, const Parameters& p) {
        program::scene::keep(scene, ISECT_EXAMPLE_SCENES, p);
      };
      options.scene_editor = program::scene::editor();
    } else if (chance(0.3)) {
      options.playlist = hour_;
      settings.hours = {{hour_.file, below(hour_.stops.size()), -1}};
      for (const Stop& stop : hour_.stops)
        if (stop.lesson && !stop.lesson->made_from.empty()) all.push_back(stop.lesson);
    }
    tell(fmt::format("round {}, ISECT_SEED={}: {} {}{}", number, seed_, lesson.id, state.preset,
                     options.playlist.stops.empty() ? "" : ", a playlist instead"));
    try {
      timed([&] { window_.emplace(all, 1280.0f, 800.0f, state, settings, options); });
      for (int i = 0; i < actions_a_round; ++i) timed([&] { act(); });
      window_.reset();
    } catch (const std::exception& e) {
      std::string last;
      for (const std::string& action : told_) last += "  " + action + "\n";
      window_.reset();
      throw Failure(fmt::format("round {}, ISECT_SEED={}, {}: {}\nThe last actions:\n{}", number, seed_, lesson.id,
                                e.what(), last));
    }
  }

 private:
  void add(const std::string& text, const std::string& folder) {
    const Lesson& scene = program::scene::kept_lesson_of(text, folder);
    stops_.push_back(&scene);
    for (const Lesson* lesson : lessons::all_lessons()) {
      try {
        stops_.push_back(&program::scene::kept_walks_of(*lesson, "", text, folder));
      } catch (const BadInput&) {
        continue;  // it takes none of these objects
      }
    }
  }

  bool chance(double share) { return std::uniform_real_distribution(0.0, 1.0)(random_) < share; }
  float between(float lo, float hi) { return std::uniform_real_distribution(lo, hi)(random_); }
  int below(std::size_t n) { return static_cast<int>(std::uniform_int_distribution<std::size_t>(0, n - 1)(random_)); }
  template <class List>
  const std::ranges::range_value_t<List>& any(const List& list) {
    return list[static_cast<std::size_t>(below(std::size(list)))];
  }

  void tell(const std::string& action) {
    log_ << action << std::endl;
    told_.push_back(action);
    if (told_.size() > 40) told_.pop_front();
  }

  /// Times an action, which is a few frames: no frame may keep a reader waiting.
  template <class Action>
  void timed(const Action& action) {
    const double begun = processor_seconds();
    action();
    const double took = processor_seconds() - begun;
    if (took > slowest_) slowest_ = took, slowest_was_ = told_.front() + ": " + told_.back();
    if (took > most_a_frame) throw std::runtime_error(fmt::format("this took {:.1f} s of the processor", took));
  }

  /// A widget by its name, if there is any.
  std::optional<std::string> widget(const std::string& prefix = "") {
    std::vector<std::string> names;
    for (const auto& [name, rect] : window_->ui.rects())
      if (name.starts_with(prefix)) names.push_back(name);
    if (names.empty()) return {};
    return any(names);
  }

  Vec2 anywhere() {
    const ImVec2& size = ImGui::GetIO().DisplaySize;
    return {between(-20, size.x + 20), between(-20, size.y + 20)};
  }

  void modify(bool held) {
    const bool control = held && chance(0.25), shift = held && chance(0.4);
    window_->modifiers(control, shift);
    if (held) tell(fmt::format("  with{}{}", control ? " Ctrl" : "", shift ? " Shift" : ""));
  }

  void act() {
    ++actions_;
    const double which = std::uniform_real_distribution(0.0, 1.0)(random_);
    if (which < 0.30)
      press();
    else if (which < 0.42)
      type();
    else if (which < 0.55)
      click();
    else if (which < 0.85)
      drag();
    else if (which < 0.90)
      type_a_number();
    else if (which < 0.93)
      paste();
    else if (which < 0.95)
      resize();
    else
      rest();
  }

  void press() {
    const key::Code code = any(codes);
    const bool control = chance(0.2), shift = chance(0.25);
    const int times = chance(0.1) ? 20 : 1;
    tell(fmt::format("key {}{}{}, {} times", control ? "Ctrl " : "", shift ? "Shift " : "", static_cast<int>(code),
                     times));
    for (int i = 0; i < times; ++i) window_->key(code, control, shift);
  }

  void type() {
    std::string text = chance(0.2) ? any(junk) : std::string();
    const std::string letters = "abcdefghijklmnopqrstuvwxyz0123456789[]+-?= ABC";
    while (text.empty() || chance(0.4)) text += letters[static_cast<std::size_t>(below(letters.size()))];
    tell("type " + text);
    window_->type(text);
  }

  void click() {
    const std::optional<std::string> name = chance(0.8) ? widget() : std::nullopt;
    Vec2 at = anywhere();
    if (name) {
      const Rect r = window_->rect(*name);
      at = {r.middle_x(), r.middle_y()};
    }
    const int times = chance(0.15) ? 2 : 1, button = chance(0.1) ? 1 : 0;
    tell(fmt::format("click {} at ({}, {}), button {}, {} times", name.value_or("nothing"), at.x(), at.y(), button,
                     times));
    window_->move(static_cast<float>(at.x()), static_cast<float>(at.y()));
    modify(chance(0.2));
    for (int i = 0; i < times; ++i) window_->button(true, button), window_->button(false, button);
    modify(false);
    if (chance(0.2)) window_->wheel(between(-5, 5));
  }

  /// Drags mostly a handle, and mostly not far; other keys go on meanwhile.
  void drag() {
    const bool other = chance(0.1);
    std::optional<std::string> name = chance(0.85) ? widget(other ? "other handle " : "handle ") : widget();
    Vec2 at = anywhere();
    if (name) {
      const Rect r = window_->rect(*name);
      at = {r.middle_x(), r.middle_y()};
    }
    const int button = chance(0.08) ? 1 : 0;
    tell(fmt::format("drag {} from ({}, {}), button {}", name.value_or("nothing"), at.x(), at.y(), button));
    window_->move(static_cast<float>(at.x()), static_cast<float>(at.y()));
    modify(chance(0.5));
    window_->button(true, button);
    const float far = chance(0.2) ? 900 : 150;
    for (int moves = 1 + below(4); moves > 0; --moves) {
      at += Vec2(between(-far, far), between(-far, far));
      tell(fmt::format("  to ({}, {})", at.x(), at.y()));
      window_->move(static_cast<float>(at.x()), static_cast<float>(at.y()));
      if (chance(0.2)) modify(true);
      if (chance(0.1)) press();
      if (chance(0.05)) type();
      settle();
    }
    if (chance(0.5)) modify(false);
    window_->button(false, button);
    modify(false);
    settle();
  }

  /// Waits for some frames, as a search for a border takes.
  void settle() { window_->frames(1 + below(12)); }

  void type_a_number() {
    const std::optional<std::string> field = widget("parameter ");
    if (!field) return type();
    const Rect r = window_->rect(*field);
    const std::string text = chance(0.5) ? any(junk) : fmt::format("{}", between(-4, 4));
    tell(fmt::format("type {} into {}", text, *field));
    window_->move(r.middle_x(), r.middle_y());
    window_->control(true);
    window_->button(true);
    window_->control(false);
    window_->button(false);
    window_->frames(6);
    window_->type(text);
    window_->key(chance(0.8) ? key::enter : key::escape);
  }

  void paste() {
    std::string text = any(junk);
    if (chance(0.5)) {  // a state, perhaps spoilt
      text = to_json(window_->player().reader_state());
      for (int i = below(3); i > 0; --i) text[static_cast<std::size_t>(below(text.size()))] = any(spoilers);
    }
    tell("paste " + text);
    ImGui::SetClipboardText(text.c_str());
    window_->key(key::v, true);
  }

  void resize() {
    const float width = chance(0.2) ? between(1, 400) : between(640, 1800),
                height = between(width > 400 ? 400 : 1, 1200);
    tell(fmt::format("resize to {} x {}", width, height));
    window_->resize(width, height);
    window_->frames(3);
  }

  void rest() {
    const float seconds = between(0, 4);
    tell(fmt::format("wait {} s", seconds));
    window_->wait(seconds);
    window_->frames(1 + below(8));
    if (chance(0.3)) static_cast<void>(window_->picture());
  }

  std::string out_;
  std::uint64_t seed_;
  std::vector<const Lesson*> stops_;
  Playlist hour_;
  std::mt19937_64 random_;
  std::optional<WindowDriver> window_;
  std::ofstream log_;
  std::deque<std::string> told_;
  int actions_ = 0;
  double slowest_ = 0;
  std::string slowest_was_;
};

}  // namespace

int main(int count, char** words) {
  double minutes = 0;
  int only = -1;
  std::string out = "drive";
  for (int i = 1; i < count; i += 2) {
    const std::string word = words[i];
    const bool known = (word == "--minutes" || word == "--round" || word == "--out") && i + 1 < count;
    if (!known) return std::fputs("window_drive [--minutes M] [--round N] [--out DIR]\n", stderr), 2;
    if (word == "--minutes") minutes = std::stod(words[i + 1]);
    if (word == "--round") only = std::stoi(words[i + 1]);
    if (word == "--out") out = words[i + 1];
  }
  try {
    using Clock = std::chrono::steady_clock;
    const auto begun = Clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count() / 60; };
    Drive drive(out, tests::seed());
    const int rounds = only >= 0 ? 1 : static_cast<int>(drive.stops() / 4);
    int done = 0, failed = 0;
    while (minutes > 0 ? passed() < minutes : done < rounds) {
      try {
        drive.round(only >= 0 ? only : done);
      } catch (const Failure& failure) {
        std::fprintf(stderr, "%s\n", failure.what());
        ++failed;
      }
      ++done;
      if (minutes > 0 && done % 20 == 0) {
        std::printf("%.1f minutes: %d rounds, %d actions, slowest %.2f s (%s)\n", passed(), done, drive.actions(),
                    drive.slowest(), drive.slowest_was().c_str());
        std::fflush(stdout);
      }
    }
    std::printf("%d rounds over %zu lessons and scenes, %d actions, ISECT_SEED=%llu; the slowest took %.2f s: %s\n",
                done, drive.stops(), drive.actions(), static_cast<unsigned long long>(tests::seed()), drive.slowest(),
                drive.slowest_was().c_str());
    return failed > 0 ? 1 : 0;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
}
