#include "app/checks/baselines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/checks/failure_pictures.h"
#include "app/figures/figure_maker.h"
#include "viz/compose/compose.h"
#include "viz/player/reader_state.h"
#include "viz/snapshot/baseline_picture.h"
#include "viz/walk/closing.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;
using Kind = Failure::Kind;

constexpr Size picture_size = {960, 600};
constexpr viz::ThemeName baseline_theme = viz::ThemeName::screen;

/// Returns "llvmpipe" of "llvmpipe (LLVM 15.0.6, 256 bits)": the rest names the processor, which may differ.
std::string family(const std::string& driver) { return driver.substr(0, driver.find(' ')); }

/// Returns a failure of this walk, or of one of its steps.
Failure about(const Excerpt& e, int step, Failure f) {
  f.lesson = e.lesson->id;
  f.preset = e.folder;
  f.step = step;
  if (step >= 0 && step < static_cast<int>(e.walk.steps.size())) f.slug = e.walk.steps[step].slug;
  return f;
}

Failure failure(Kind kind, const std::string& what, const std::string& baseline) {
  Failure f;
  f.kind = kind;
  f.what = what;
  f.baseline = baseline;
  return f;
}

/// Returns the failure that a pointer stands in place of the file itself.
Failure lfs_pointer(const std::string& baseline) {
  Failure f = failure(Kind::unreadable, "a Git LFS pointer, not the file itself; git lfs pull fetches that", baseline);
  f.pointer = true;
  return f;
}

/// Returns what an accepted picture carries: neither a scene's texts nor the version, which change where no pixel does.
viz::Metadata kept_metadata(const Excerpt& e, int step) {
  viz::Metadata data = metadata_of(e, step);
  data.erase("scene"), data.erase("version");
  return data;
}

std::vector<std::string> in_words(const std::vector<viz::Change>& changes) {
  std::vector<std::string> lines;
  for (const viz::Change& c : changes)
    lines.push_back((c.step < 0 ? "" : fmt::format("step {}: ", c.step + 1)) + c.what);
  return lines;
}

/// Returns the trace's words on this step's drawing, before the pixels: "the ball b moved 3 px; the label r is gone: ".
std::string drawn(const std::vector<viz::Change>& changes, int step) {
  constexpr int enough = 3;
  std::string text;
  int count = 0;
  for (const viz::Change& c : changes)
    if (c.of == viz::Change::Of::drawing && c.step == step && ++count <= enough)
      text += (text.empty() ? "" : "; ") + c.what;
  if (count > enough) text += fmt::format("; {} more", count - enough);
  return text.empty() ? text : text + ": ";
}

}  // namespace

bool is_own(const Excerpt& e) { return !e.path.empty() || e.folder != e.preset; }

bool has_picture(const Excerpt& e, int step) {
  if (e.lesson->closing && e.walk.steps[step].slug == viz::closing_slug) return false;
  if (is_own(e) || step == viz::outcome(e.walk)) return true;
  const std::vector<viz::Preset>& presets = e.lesson->presets;
  const std::string& group = viz::preset(*e.lesson, e.preset).group;
  const auto first = std::ranges::find(presets, group, &viz::Preset::group);
  return first->id == e.preset;
}

std::string name_of(Kind kind) {
  constexpr std::array names = {"missing",    "trace",  "picture", "size", "blank",
                                "unreadable", "orphan", "preset",  "moved"};
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

Baselines::Baselines(std::string folder, Update update, bool keep_pictures, viz::Offscreen& offscreen)
    : folder_(std::move(folder)), update_(update), keep_pictures_(keep_pictures), offscreen_(offscreen) {
  const viz::Fonts fonts = viz::fonts();
  stamp_ = {family(offscreen.driver()), fonts.figure + ", " + fonts.window, viz::name_of(baseline_theme),
            fmt::format("{}x{}", picture_size.width, picture_size.height)};
}

std::string Baselines::path(const Excerpt& e, const std::string& file) const {
  return fmt::format("{}/{}/{}/{}", folder_, e.lesson->id, e.folder, file);
}

bool Baselines::accepts(Kind kind) const {
  if (kind == Kind::blank) return false;  // an empty picture is never accepted
  return update_ == Update::failed || update_ == Update::all || (update_ == Update::missing && kind == Kind::missing);
}

std::vector<viz::Drawing> Baselines::drawings_of(const Excerpt& e) const {
  std::vector<viz::Drawing> drawings(e.walk.steps.size());
  const double aspect = viz::picture_aspect(e.walk, baseline_theme, picture_size.width, picture_size.height);
  for (int i = 0; i < static_cast<int>(drawings.size()); ++i)
    drawings[i] = viz::figure(e.walk.steps[i], camera_for(e, e.walk.steps[i], aspect), baseline_theme,
                              picture_size.width, picture_size.height)
                      .drawing;
  return drawings;
}

std::string Baselines::trace_now(const Excerpt& e, const std::vector<viz::Drawing>& drawings) const {
  return viz::trace_json(*e.lesson, e.folder, e.parameters, e.walk, drawings, stamp_,
                         is_own(e) ? viz::Tells::walk : viz::Tells::lesson);
}

std::vector<Failure> Baselines::check(const Excerpt& e) {
  std::vector<Failure> found;
  const bool seen = viz::is_there(path(e, "")) || accepts(Kind::missing) || keep_pictures_;
  const std::vector<viz::Drawing> drawings = seen ? drawings_of(e) : std::vector<viz::Drawing>(e.walk.steps.size());
  const std::vector<viz::Change> changes = check_trace(e, drawings, found);
  for (int step = 0; step < static_cast<int>(e.walk.steps.size()); ++step)
    if (has_picture(e, step)) check_picture(e, step, drawings[step], changes, found);
  return found;
}

const std::optional<OwnTrace>& Baselines::trace_of(const std::string& folder) {
  const auto known = traces_.find(folder);
  if (known != traces_.end()) return known->second;
  std::optional<OwnTrace> trace = own_trace(fs::path(folder_) / folder / "trace.json");
  if (trace && trace->folder != folder) trace.reset();
  return traces_[folder] = std::move(trace);
}

bool Baselines::settle(const std::string& baseline, bool ours, std::optional<Failure>& f) {
  if (f) f->foreign = !ours;
  if (!(f ? accepts(f->kind) : update_ == Update::all)) return false;
  if (f)
    f->accepted = ours;
  else if (!ours)
    left_alone_.insert(baseline);
  return ours;
}

std::vector<viz::Change> Baselines::check_trace(const Excerpt& e, const std::vector<viz::Drawing>& drawings,
                                                std::vector<Failure>& found) {
  const std::string baseline = path(e, "trace.json");
  const std::string now = viz::is_there(baseline) || accepts(Kind::missing) ? trace_now(e, drawings) : "";
  const bool ours = trace_of(folder_of(e)).has_value() || !viz::is_there(baseline);
  std::optional<Failure> f;
  std::vector<viz::Change> changes;
  if (!viz::is_there(baseline)) {
    f = about(e, -1, failure(Kind::missing, "no trace was accepted yet", baseline));
  } else {
    try {
      const std::string was = viz::read_regular_file(baseline);
      if (is_lfs_pointer(was)) {
        f = about(e, -1, lfs_pointer(baseline));
      } else {
        changes = viz::compare_traces(was, now);
        std::ranges::stable_sort(changes, {}, &viz::Change::of);
      }
      if (!changes.empty()) {
        f = about(e, changes[0].step, failure(Kind::trace, changes[0].what, baseline));
        f->more = in_words({changes.begin() + 1, changes.end()});
      }
    } catch (const viz::FileError& error) {
      f = about(e, -1, failure(Kind::unreadable, error.what(), baseline));
    }
  }
  if (settle(baseline, ours, f)) viz::write_file(baseline, now);
  if (f) found.push_back(*f);
  return changes;
}

std::optional<Failure> Baselines::compare_with_baseline(const viz::Picture& now, const std::string& baseline) const {
  if (viz::blank(now)) return failure(Kind::blank, "the picture is blank", baseline);
  if (!viz::is_there(baseline)) return failure(Kind::missing, "no picture was accepted yet", baseline);
  std::string bytes;
  viz::BaselinePicture accepted;
  try {
    bytes = viz::read_regular_file(baseline);
    if (is_lfs_pointer(bytes)) return lfs_pointer(baseline);
    accepted = viz::read_baseline_png(bytes);
  } catch (const viz::FileError& error) {
    return failure(Kind::unreadable, error.what(), baseline);
  }
  Failure f = failure(Kind::picture, {}, baseline);
  f.accepted_png = std::move(bytes);
  f.pixels = viz::compare(accepted.picture, now, accepted.slack);
  if (f.pixels.passes()) return {};
  if (!f.pixels.same_size) {
    f.kind = Kind::size;
    f.what = fmt::format("the accepted picture is {}x{}, the new one {}x{}", accepted.picture.width,
                         accepted.picture.height, now.width, now.height);
    return f;
  }
  f.what = fmt::format("{} pixels differ by more than {} (24 may), {} by more than {} (256 may)", f.pixels.over_8,
                       accepted.slack + 8, f.pixels.over_1, accepted.slack + 1);
  return f;
}

void Baselines::check_picture(const Excerpt& e, int index, const viz::Drawing& drawing,
                              const std::vector<viz::Change>& changes, std::vector<Failure>& found) {
  const viz::Step& step = e.walk.steps[index];
  const std::string baseline = path(e, viz::file_stem(index, step) + ".png");
  const bool absent = !viz::is_there(baseline);
  if (absent && !accepts(Kind::missing) && !keep_pictures_) {  // nobody would see a drawing
    found.push_back(about(e, index, failure(Kind::missing, "no picture was accepted yet", baseline)));
    return;
  }
  const viz::Picture now = offscreen_.render(drawing);
  std::optional<Failure> f = compare_with_baseline(now, baseline);
  if (f && f->kind == Kind::picture) f->what = drawn(changes, index) + f->what;
  const std::string folder = folder_of(e);
  const bool ours =
      absent || ((f || update_ == Update::all) && made_for(metadata_in(baseline), folder, trace_of(folder)));
  const bool replaced = settle(baseline, ours, f);
  const bool beside = f && !replaced && !absent;  // are the pictures written beside the baseline?
  const bool shown = f && (beside || keep_pictures_);
  std::string png;
  if (replaced || shown) png = viz::baseline_png(now, kept_metadata(e, index));
  if (replaced) viz::write_file(baseline, png);
  if (!f || replaced) remove_failure_pictures(baseline, folder);
  if (!f) return;

  f->fresh_png = std::move(png);
  if (shown && f->kind == Kind::picture) {
    const viz::BaselinePicture accepted = viz::read_baseline_png(f->accepted_png);
    f->difference_png =
        viz::png(viz::difference_picture(accepted.picture, now, accepted.slack), kept_metadata(e, index));
  }
  if (beside) write_failure_pictures(*f, folder);
  if (!keep_pictures_) f->accepted_png.clear(), f->fresh_png.clear(), f->difference_png.clear();
  found.push_back(about(e, index, *f));
}

}  // namespace isect::program
