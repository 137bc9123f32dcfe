// Measures how long frames take at 1280 x 720 in software: frames [--cpu] [LESSON...] -> a row a lesson, in ms, then
// the slowest frames. Steps: every frame of the motion to every step of the first preset of each method. Drags: each
// handle of the last step that has any, 16 moves there and back. Snaps: one move of it with Shift. Nothing is asserted:
// the machine decides. On one that does other things, --cpu with LP_NUM_THREADS=0 counts the processor's time.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <set>

#include "lessons/lessons.h"
#include "tests/viz/window_driver.h"

using namespace isect::viz;

namespace {

struct Frame {
  double ms;
  std::string what;
};

double percentile(std::vector<Frame> frames, double share) {
  if (frames.empty()) return 0;
  std::ranges::sort(frames, {}, &Frame::ms);
  return frames[static_cast<std::size_t>(share * static_cast<double>(frames.size() - 1))].ms;
}

class Measurement {
 public:
  Measurement(const std::vector<const Lesson*>& lessons, bool by_processor)
      : by_processor_(by_processor),
        window_(lessons, 1280, 720, {}, {}, {.reduced_motion = false}),
        target_(1280, 720) {}

  void measure(const Lesson& lesson) {
    std::vector<Frame> steps, drags, snaps;
    window_.player().open(lesson);
    std::set<std::string> methods;
    for (const Preset& preset : lesson.presets) {
      if (!methods.insert(preset.group).second) continue;
      window_.player().load(preset);
      settle();
      const std::string where = lesson.id + " " + preset.id;
      for (int i = 0; i < window_.player().count(); ++i) walk_to(i, where, steps);
      for (int i = window_.player().count(); i-- > 0 && window_.player().scene().handles.empty();)
        window_.player().go_to(i);
      settle();
      const std::vector<Handle> handles = window_.player().scene().handles;
      for (const Handle& h : handles) {
        drag(h.parameter, where, drags);
        snap(h.parameter, where, snaps);
      }
    }
    const auto told = [](const std::vector<Frame>& f) {
      return fmt::format("{:7.1f} {:7.1f} {:7.1f}", percentile(f, 0.5), percentile(f, 0.99), percentile(f, 1));
    };
    fmt::print("{:<22} {} {} {}\n", lesson.id, told(steps), told(drags), told(snaps));
    std::fflush(stdout);
    keep(steps, steps_), keep(drags, drags_), keep(snaps, snaps_);
  }

  void tell() {
    for (auto [name, all] : {std::pair{"steps", &steps_}, {"drags", &drags_}, {"snaps", &snaps_}}) {
      fmt::print("\n{}: {} frames, median {:.1f}, 99th percentile {:.1f}, longest {:.1f} ms\n", name, all->size(),
                 percentile(*all, 0.5), percentile(*all, 0.99), percentile(*all, 1));
      std::ranges::sort(*all, std::ranges::greater{}, &Frame::ms);
      for (std::size_t i = 0; i < std::min<std::size_t>(12, all->size()); ++i)
        fmt::print("  {:7.1f}  {}\n", (*all)[i].ms, (*all)[i].what);
    }
  }

 private:
  static void keep(const std::vector<Frame>& from, std::vector<Frame>& to) {
    to.insert(to.end(), from.begin(), from.end());
  }

  double now() const {
    if (by_processor_) return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  double frame() {
    const double begin = now();
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    window_.ui.frame();
    window_.ui.draw(target_.framebuffer());
    glFinish();
    return now() - begin;
  }

  void settle() {
    for (int i = 0; i < 40; ++i) window_.frames();
  }

  void walk_to(int step, const std::string& where, std::vector<Frame>& out) {
    window_.player().go_to(step);
    const std::string what = where + ", " + window_.player().step().slug;
    for (int i = 0; i < 16; ++i) out.push_back({frame(), fmt::format("{}, frame {}", what, i + 1)});
  }

  void drag(const std::string& handle, const std::string& where, std::vector<Frame>& out) {
    const Rect r = window_.rect("handle " + handle);
    window_.move(r.middle_x(), r.middle_y());
    window_.button(true);
    for (int i = 1; i <= 16; ++i) {
      const int away = i <= 8 ? i : 16 - i;
      ImGui::GetIO().MousePos = {r.middle_x() + 3.0f * static_cast<float>(away),
                                 r.middle_y() - 2.0f * static_cast<float>(away)};
      out.push_back({frame(), fmt::format("{}, {} dragged", where, handle)});
    }
    window_.button(false);
    window_.player().undo();
    settle();
  }

  void snap(const std::string& handle, const std::string& where, std::vector<Frame>& out) {
    if (!window_.has("handle " + handle)) return;
    const Rect r = window_.rect("handle " + handle);
    window_.move(r.middle_x(), r.middle_y());
    window_.button(true);
    window_.modifiers(false, true);
    ImGui::GetIO().MousePos = {r.middle_x() + 60, r.middle_y() - 40};
    out.push_back({frame(), fmt::format("{}, {} snapped", where, handle)});
    window_.modifiers(false, false);
    window_.button(false);
    window_.player().undo();
    settle();
  }

  bool by_processor_;
  WindowDriver window_;
  FrameTarget target_;
  std::vector<Frame> steps_, drags_, snaps_;
};

}  // namespace

int main(int argc, char** argv) try {
  std::vector<const Lesson*> asked;
  const std::vector<const Lesson*> all = isect::lessons::all_lessons();
  bool by_processor = false;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--cpu")
      by_processor = true;
    else
      asked.push_back(&lesson_named(all, argv[i]));
  if (asked.empty()) asked = all;
  Measurement measurement(all, by_processor);
  fmt::print("{:<22} {:^23} {:^23} {:^23}\n", "ms: median, 99 %, most", "steps", "drags", "snaps");
  for (const Lesson* lesson : asked) measurement.measure(*lesson);
  measurement.tell();
} catch (const std::exception& failed) {
  fmt::print(stderr, "frames: {}\n", failed.what());
  return 1;
}
