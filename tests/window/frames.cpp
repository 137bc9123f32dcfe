// Measures how long frames take at 1280 x 720 in software: frames [--cpu] [LESSON...|SCENE.json...] -> a row a lesson
// or scene, in ms, then the slowest frames. Steps: every frame of the motion to every step of the first preset of each
// walk. Drags: each handle of the last step that has any, 16 moves there and back. Snaps: one move of it with Shift,
// until all is found. Last, where no lesson is named, or "100,000 triangles", "a ray and a mesh" and "10,000 corners"
// are: what a scene's file may hold, a mesh of 100,000 triangles, alone and with a ray, and an outline of 10,000
// corners; drags turn or shift it, and in place of snaps the pointer rests on it, so that it is picked; the same with a
// scene's file. "1,000 balls" is a scene: one of them is dragged, which shall take 50 ms of the processor's time at the
// most; its steps are those of its opening. Nothing is asserted: the machine decides. On one that does other things,
// --cpu with LP_NUM_THREADS=0 counts the processor's time.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <deque>
#include <filesystem>
#include <numbers>
#include <set>

#include "app/scene/lesson.h"
#include "lessons/lessons.h"
#include "tests/app/many_balls.h"
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

/// A torus with dents.
Mesh large_mesh() {
  constexpr int around = 250, across = 200;
  Mesh mesh;
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < across; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * k / across;
      const double r = 1 + 0.08 * std::sin(7 * u) * std::sin(5 * v), x = 3 + r * std::cos(v);
      mesh.vertices.emplace_back(x * std::cos(u), r * std::sin(v), x * std::sin(u));
      const int next = (i + 1) % around, a = i * across + k, b = next * across + k,
                c = next * across + (k + 1) % across, d = i * across + (k + 1) % across;
      mesh.triangles.push_back({a, d, c}), mesh.triangles.push_back({a, c, b});
    }
  return mesh;
}

/// A ring with teeth.
Region large_outline() {
  constexpr int corners = 10'000;
  Region region;
  region.rings.emplace_back();
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * std::numbers::pi * i / corners, r = 3 + 0.5 * std::sin(37 * a) + 0.2 * std::sin(211 * a);
    region.rings[0].emplace_back(r * std::cos(a), r * std::sin(a), 0);
  }
  return region;
}

/// A lesson of one picture.
Lesson lesson_of(const std::string& id, const std::vector<Item>& items, bool flat) {
  Lesson lesson;
  lesson.id = id, lesson.title = id, lesson.flat = flat;
  lesson.presets = {{"all", "all", "", {}}};
  lesson.steps = [items](const Parameters&) {
    Walk walk;
    walk.steps.emplace_back();
    walk.steps[0].slug = "all", walk.steps[0].title = "All", walk.steps[0].scene.items = items;
    return walk;
  };
  return lesson;
}

class Measurement {
 public:
  Measurement(const std::vector<const Lesson*>& lessons, bool by_processor)
      : by_processor_(by_processor),
        window_(lessons, 1280, 720, {}, {}, {.reduced_motion = false, .texts_a_frame = smooth_texts}),
        target_(1280, 720) {}

  void measure(const Lesson& lesson) {
    std::vector<Frame> steps, drags, snaps;
    window_.player().open(lesson);
    std::set<std::string> walks;
    for (const Preset& preset : lesson.presets) {
      std::string slugs = preset.group;
      for (const Step& step : lesson.walk(preset.parameters).steps) slugs += " " + step.slug;
      if (!walks.insert(slugs).second) continue;
      window_.player().load(preset);
      settle();
      const std::string where = lesson.id + " " + preset.id;
      for (int i = 0; i < window_.player().count(); ++i) walk_to(i, where, steps);
      for (int i = window_.player().count(); i-- > 0 && window_.player().scene().handles.empty();)
        window_.player().go_to(i);
      settle();
      const std::vector<Handle> handles = window_.player().scene().handles;
      for (const Handle& h : handles) {
        drag(h.id(), where, drags);
        snap(h.id(), where, snaps);
      }
    }
    row(lesson.id, steps, drags, snaps);
  }

  /// Measures turning or shifting, and picking, on the last step that is a picture.
  void measure_large(const Lesson& lesson) {
    std::vector<Frame> opened, turns, picks;
    window_.player().open(lesson);
    for (int i = 0; i < window_.player().count() && !window_.player().walk().steps[i].scene.chart; ++i)
      walk_to(i, lesson.id, opened);
    settle();
    const Rect r = window_.rect("scene");
    window_.move(r.middle_x(), r.middle_y());
    window_.button(true);
    for (int i = 1; i <= 64; ++i) {
      ImGui::GetIO().MousePos = {r.middle_x() + 5 * static_cast<float>(i % 32), r.middle_y() - static_cast<float>(i)};
      turns.push_back({frame(), fmt::format("{} turned", lesson.id)});
    }
    window_.button(false);
    settle();
    for (int i = 0; i < 64; ++i) {
      ImGui::GetIO().MousePos = {r.left + r.width() * static_cast<float>(i) / 64, r.middle_y()};
      picks.push_back({frame(), fmt::format("{} picked", lesson.id)});
    }
    row(lesson.id, opened, turns, picks);
  }

  /// Measures a drag of one of many objects.
  void measure_one_of_many(const Lesson& lesson, const std::string& handle) {
    std::vector<Frame> opened, drags;
    window_.player().open(lesson);
    walk_to(0, lesson.id, opened);
    settle();
    for (int i = 0; i < 4; ++i) drag(handle, lesson.id, drags);
    row(lesson.id, opened, drags, {});
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
  void row(const std::string& id, const std::vector<Frame>& steps, const std::vector<Frame>& drags,
           const std::vector<Frame>& snaps) {
    const auto told = [](const std::vector<Frame>& f) {
      return fmt::format("{:7.1f} {:7.1f} {:7.1f}", percentile(f, 0.5), percentile(f, 0.99), percentile(f, 1));
    };
    fmt::print("{:<22} {} {} {}\n", id, told(steps), told(drags), told(snaps));
    std::fflush(stdout);
    keep(steps, steps_), keep(drags, drags_), keep(snaps, snaps_);
  }
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
    for (int i = 0; i < 300 && window_.ui.rest() == 0; ++i)
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
  std::vector<const Lesson*> all = isect::lessons::all_lessons();
  const Lesson mesh = lesson_of("100,000 triangles", {large_mesh()}, false);
  const Line ray = {{-4.5, 0.75, 1}, {4.5, -0.4, -1.25}, Role::second, Pen::solid, "**r**"};
  const Lesson hiding = lesson_of("a ray and a mesh", {large_mesh(), ray}, false);
  const Lesson outline = lesson_of("10,000 corners", {large_outline()}, true);
  std::vector<std::string> names;
  bool by_processor = false;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--cpu")
      by_processor = true;
    else
      names.emplace_back(argv[i]);
  Lesson balls = isect::program::scene::lesson_of(isect::test::many_balls(1000, R"([["b555", "b556"]])"), "");
  balls.id = "1,000 balls";
  all.push_back(&mesh), all.push_back(&hiding), all.push_back(&outline), all.push_back(&balls);
  std::deque<Lesson> scenes;
  for (std::string& name : names)
    if (const std::filesystem::path file = name; file.extension() == ".json") {
      scenes.push_back(isect::program::scene::lesson_of(read_file(file), file.parent_path()));
      scenes.back().id = name = file.stem();
      all.push_back(&scenes.back());
    }
  for (const std::string& name : names) asked.push_back(&lesson_named(all, name));
  if (asked.empty()) asked = all;
  Measurement measurement(all, by_processor);
  fmt::print("{:<22} {:^23} {:^23} {:^23}\n", "ms: median, 99 %, most", "steps", "drags", "snaps");
  const std::vector<const Lesson*> own = isect::lessons::all_lessons();
  for (const Lesson* lesson : asked)
    if (lesson == &balls)
      measurement.measure_one_of_many(*lesson, "b555.center");
    else if (std::ranges::find(own, lesson) == own.end())
      measurement.measure_large(*lesson);
    else
      measurement.measure(*lesson);
  measurement.tell();
} catch (const std::exception& failed) {
  fmt::print(stderr, "frames: {}\n", failed.what());
  return 1;
}
