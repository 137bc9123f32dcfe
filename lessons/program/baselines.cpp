#include "lessons/program/baselines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "viz/case_map.h"
#include "viz/compose.h"
#include "viz/place.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;
using Kind = Failure::Kind;

constexpr Size picture_size = {960, 600};
constexpr viz::ThemeName theme = viz::ThemeName::screen;

/// "llvmpipe (LLVM 15.0.6, 256 bits)" -> "llvmpipe": the rest names the processor, which may differ.
std::string family(const std::string& driver) { return driver.substr(0, driver.find(' ')); }

bool is_picture(const fs::path& p) {
  const std::string name = p.filename();
  return name.ends_with(".png") && !name.ends_with(".new.png") && !name.ends_with(".diff.png");
}

std::string beside(const std::string& baseline, const std::string& ending) {
  return baseline.substr(0, baseline.size() - std::string(".png").size()) + ending;
}

/// Leftovers of an earlier failure that is mended now.
void remove_leftovers(const std::string& baseline) {
  std::error_code ignored;  // nothing is lost where they stay
  fs::remove(beside(baseline, ".new.png"), ignored);
  fs::remove(beside(baseline, ".diff.png"), ignored);
}

std::vector<fs::path> sorted_children(const fs::path& folder) {
  std::error_code absent;  // an absent folder has no children
  std::vector<fs::path> children;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent))
    children.push_back(entry.path());
  std::ranges::sort(children);
  return children;
}

/// A failure of this walk, or of one of its steps.
Failure about(const Excerpt& e, int step, Failure f) {
  f.lesson = e.lesson->id;
  f.preset = e.folder;
  f.step = step;
  if (step >= 0 && step < static_cast<int>(e.walk.steps.size()))
    f.slug = e.walk.steps[static_cast<std::size_t>(step)].slug;
  return f;
}

Failure failure(Kind kind, const std::string& what, const std::string& baseline) {
  Failure f;
  f.kind = kind;
  f.what = what;
  f.baseline = baseline;
  return f;
}

/// What is not of one step first: a parameter that changed explains the steps.
std::vector<std::string> in_words(std::vector<viz::Change> changes) {
  std::ranges::stable_partition(changes, [](const viz::Change& c) { return c.step < 0; });
  std::vector<std::string> lines;
  for (const viz::Change& c : changes)
    lines.push_back((c.step < 0 ? "" : fmt::format("step {}: ", c.step + 1)) + c.what);
  return lines;
}

}  // namespace

bool has_picture(const Excerpt& e, int step) {
  const bool own_file = e.folder != e.preset;
  if (own_file || step == viz::outcome(e.walk)) return true;
  const std::vector<viz::Preset>& presets = e.lesson->presets;
  const std::string& group = viz::preset(*e.lesson, e.preset).group;
  const auto first = std::ranges::find(presets, group, &viz::Preset::group);
  return first->id == e.preset;
}

std::string name_of(Kind kind) {
  constexpr std::array names = {"missing", "trace", "picture", "size", "blank", "unreadable", "orphan"};
  return names.at(static_cast<std::size_t>(kind));
}

std::vector<std::string> update_names() { return {"failed", "missing", "all"}; }

Update update_named(const std::string& name) {
  if (name.empty()) return Update::none;
  if (name == "failed") return Update::failed;
  if (name == "missing") return Update::missing;
  if (name == "all") return Update::all;
  throw viz::unknown("update", name, update_names());
}

Baselines::Baselines(std::string folder, Update update, viz::Offscreen& offscreen)
    : folder_(std::move(folder)), update_(update), offscreen_(offscreen) {
  const viz::Fonts fonts = viz::fonts();
  stamp_ = {family(offscreen.driver()), fonts.figure + ", " + fonts.window, viz::name_of(theme),
            fmt::format("{}x{}", picture_size.width, picture_size.height)};
}

std::string Baselines::path(const Excerpt& e, const std::string& file) const {
  return fmt::format("{}/{}/{}/{}", folder_, e.lesson->id, e.folder, file);
}

bool Baselines::accepts(Kind kind) const {
  if (kind == Kind::blank) return false;  // never a picture of nothing
  return update_ == Update::failed || update_ == Update::all ||
         (update_ == Update::missing && kind == Kind::missing);
}

std::vector<Failure> Baselines::check(const Excerpt& e) {
  std::vector<Failure> found;
  check_trace(e, found);
  const viz::Camera camera = camera_for(*e.lesson, e.walk, theme, picture_size);
  for (int step = 0; step < static_cast<int>(e.walk.steps.size()); ++step)
    if (has_picture(e, step)) check_picture(e, step, camera, found);
  return found;
}

void Baselines::check_trace(const Excerpt& e, std::vector<Failure>& found) {
  const std::string baseline = path(e, "trace.json");
  const std::string now = viz::trace_json(*e.lesson, e.folder, e.parameters, e.walk, stamp_);
  std::optional<Failure> f;
  if (!fs::exists(baseline)) {
    f = about(e, -1, failure(Kind::missing, "no trace was accepted yet", baseline));
  } else if (const std::vector<viz::Change> changes = viz::compare_traces(viz::read_file(baseline), now);
             !changes.empty()) {
    f = about(e, changes[0].step, failure(Kind::trace, changes[0].what, baseline));
    f->more = in_words({changes.begin() + 1, changes.end()});
  }
  if (update_ == Update::all || (f && accepts(f->kind))) viz::write_file(baseline, now);
  if (!f) return;
  f->accepted = accepts(f->kind);
  found.push_back(*f);
}

std::optional<Failure> Baselines::compare_with_baseline(const viz::Picture& now,
                                                        const std::string& baseline) const {
  if (viz::blank(now)) return failure(Kind::blank, "the picture is blank", baseline);
  if (!fs::exists(baseline)) return failure(Kind::missing, "no picture was accepted yet", baseline);
  viz::Picture accepted;
  try {
    accepted = viz::read_png(viz::read_file(baseline));
  } catch (const viz::FileError& error) {
    return failure(Kind::unreadable, error.what(), baseline);
  }
  Failure f = failure(Kind::picture, {}, baseline);
  f.pixels = viz::compare(accepted, now);
  if (f.pixels.passes()) return {};
  if (!f.pixels.same_size) {
    f.kind = Kind::size;
    f.what = fmt::format("the accepted picture is {}x{}, the new one {}x{}", accepted.width, accepted.height,
                         now.width, now.height);
    return f;
  }
  f.what = fmt::format("{} pixels differ by more than 8 (24 may), {} by more than 1 (256 may)",
                       f.pixels.over_8, f.pixels.over_1);
  f.difference = beside(baseline, ".diff.png");
  viz::write_file(f.difference, viz::png(viz::difference_picture(accepted, now)));
  return f;
}

void Baselines::check_picture(const Excerpt& e, int index, const viz::Camera& camera,
                              std::vector<Failure>& found) {
  const viz::Step& step = e.walk.steps[static_cast<std::size_t>(index)];
  const std::string baseline = path(e, viz::file_stem(index, step) + ".png");
  if (!fs::exists(baseline) && !accepts(Kind::missing)) {  // nothing to compare with, so nothing is drawn
    found.push_back(about(e, index, failure(Kind::missing, "no picture was accepted yet", baseline)));
    return;
  }
  const viz::Picture now = offscreen_.render(viz::figure(step, camera, theme, picture_size.width, picture_size.height).drawing);
  const auto bytes = [&] {
    return viz::png(now, viz::metadata({e.lesson->id, e.preset, index, e.parameters, {}}));
  };

  std::optional<Failure> f = compare_with_baseline(now, baseline);
  const bool accept = f ? accepts(f->kind) : update_ == Update::all;
  if (accept) viz::write_file(baseline, bytes());
  if (!f || accept) remove_leftovers(baseline);
  if (!f) return;
  f->accepted = accept;
  if (accept) {
    f->difference.clear();
  } else {
    f->fresh = beside(baseline, ".new.png");
    viz::write_file(f->fresh, bytes());
  }
  found.push_back(about(e, index, *f));
}

std::vector<Failure> Baselines::orphans(const std::vector<Excerpt>& checked, bool all_lessons,
                                        bool all_presets) {
  std::set<fs::path> wanted, lessons, presets;
  for (const Excerpt& e : checked) {
    lessons.insert(fs::path(folder_) / e.lesson->id);
    presets.insert(fs::path(folder_) / e.lesson->id / e.folder);
    wanted.insert(path(e, "trace.json"));
    for (int i = 0; i < static_cast<int>(e.walk.steps.size()); ++i)
      if (has_picture(e, i))
        wanted.insert(path(e, viz::file_stem(i, e.walk.steps[static_cast<std::size_t>(i)]) + ".png"));
  }
  std::vector<Failure> found;
  for (const fs::path& lesson : sorted_children(folder_)) {
    if (!all_lessons && !lessons.contains(lesson)) continue;
    for (const fs::path& preset : sorted_children(lesson))
      if (all_presets || presets.contains(preset)) orphans_in(preset, wanted, found);
  }
  return found;
}

void Baselines::orphans_in(const fs::path& preset, const std::set<fs::path>& wanted,
                           std::vector<Failure>& found) const {
  for (const fs::path& file : sorted_children(preset)) {
    if (!(is_picture(file) || file.filename() == "trace.json") || wanted.contains(file)) continue;
    Failure f = failure(Kind::orphan, "belongs to no step of any preset", file);
    f.lesson = preset.parent_path().filename();
    f.preset = preset.filename();
    f.accepted = accepts(f.kind);
    if (f.accepted) {
      fs::remove(file);
      remove_leftovers(file);
    }
    found.push_back(f);
  }
  std::error_code kept;  // a folder with other files in it stays
  if (update_ != Update::none && fs::is_empty(preset, kept)) fs::remove(preset, kept);
}

}  // namespace isect::program
