#include "app/checks/baselines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/checks/causes.h"
#include "app/checks/failure_pictures.h"
#include "app/checks/pictured.h"
#include "app/checks/text_difference.h"
#include "app/figures/digest.h"
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
  constexpr std::array names = {"missing",    "trace",  "picture", "size",  "blank",
                                "unreadable", "orphan", "preset",  "moved", "text"};
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

Baselines::Baselines(std::string folder, Update update, bool keep_pictures, viz::Offscreen& offscreen,
                     Acceptance* acceptance)
    : folder_(std::move(folder)),
      update_(update),
      keep_pictures_(keep_pictures),
      offscreen_(offscreen),
      acceptance_(acceptance) {
  const viz::Fonts fonts = viz::fonts();
  stamp_ = {family(offscreen.driver()), fonts.figure + ", " + fonts.window, viz::name_of(baseline_theme),
            fmt::format("{}x{}", picture_size.width, picture_size.height)};
}

std::string Baselines::path(const Excerpt& e, const std::string& file) const {
  return fmt::format("{}/{}/{}/{}", folder_, e.lesson->id, e.folder, file);
}

std::string Baselines::below(const std::string& baseline) const {
  return fs::path(baseline).lexically_relative(folder_).string();
}

bool Baselines::passes_over(const std::string& baseline) const {
  return acceptance_ && !acceptance_->names(below(baseline));
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
  const bool seen = viz::is_there(path(e, "")) || accepts(Kind::missing) || keep_pictures_ || acceptance_;
  const std::vector<viz::Drawing> drawings = seen ? drawings_of(e) : std::vector<viz::Drawing>(e.walk.steps.size());
  const std::vector<viz::Change> changes = check_trace(e, drawings, found);
  for (int step = 0; step < static_cast<int>(e.walk.steps.size()); ++step)
    if (has_picture(e, step))
      if (const Pictured p = pictured(e, step, nullptr); !need_no_drawing(p, found))
        check_picture(p, drawings[step], changes, found);
  for (const Guard& guard : e.guards) check_guard(e, guard, changes, found);
  return found;
}

const std::optional<OwnTrace>& Baselines::trace_of(const std::string& folder) {
  const auto known = traces_.find(folder);
  if (known != traces_.end()) return known->second;
  std::optional<OwnTrace> trace = own_trace(fs::path(folder_) / folder / "trace.json");
  if (trace && trace->folder != folder) trace.reset();
  return traces_[folder] = std::move(trace);
}

bool Baselines::settle(const std::string& baseline, bool ours, std::optional<Failure>& f, const std::string& now) {
  if (f) f->foreign = !ours;
  if (acceptance_) return settle_reviewed(baseline, f, now);
  if (!(f ? accepts(f->kind) : update_ == Update::all)) return false;
  if (f)
    f->accepted = ours;
  else if (!ours)
    left_alone_.insert(baseline);
  return ours;
}

bool Baselines::settle_reviewed(const std::string& baseline, std::optional<Failure>& f, const std::string& now) {
  Acceptance::Found found{digest(now), {}, f.has_value()};
  try {
    if (viz::is_there(baseline)) found.there = digest(viz::read_regular_file(baseline));
  } catch (const viz::FileError&) {  // it is no file of ours, then
  }
  if (f && f->kind == Kind::blank)
    found.hindrance = f->what;
  else if (f && f->pointer)
    found.hindrance = "the file in its place is " + f->what;
  else if (f && f->foreign)
    found.hindrance = "the file in its place was not made by isect; move it away first";
  const bool taken = acceptance_->takes(below(baseline), found);
  if (f) f->accepted = taken;
  return taken;
}

std::vector<viz::Change> Baselines::check_trace(const Excerpt& e, const std::vector<viz::Drawing>& drawings,
                                                std::vector<Failure>& found) {
  const std::string baseline = path(e, "trace.json");
  if (passes_over(baseline)) return {};
  const bool wanted = viz::is_there(baseline) || accepts(Kind::missing) || keep_pictures_ || acceptance_;
  const std::string now = wanted ? trace_now(e, drawings) : "";
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
        f->cause = cause_of_trace(changes);
        f->line = first_difference(was, now).line;
      }
    } catch (const viz::FileError& error) {
      f = about(e, -1, failure(Kind::unreadable, error.what(), baseline));
    }
  }
  if (settle(baseline, ours, f, now)) viz::write_file(baseline, now);
  if (f && keep_pictures_) f->reviewed = {{below(baseline), digest(now)}};
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
  f.accepted_file = std::move(bytes);
  f.pixels = viz::compare(accepted.picture, now, accepted.slack);
  if (f.pixels.passes()) return {};
  f.eye = viz::perceived(accepted.picture, now, accepted.slack);
  if (!f.pixels.same_size) {
    f.kind = Kind::size;
    f.cause = cause_of(f.kind);
    f.what = fmt::format("the accepted picture is {}x{}, the new one {}x{}", accepted.picture.width,
                         accepted.picture.height, now.width, now.height);
    return f;
  }
  f.what = fmt::format("{} pixels differ by more than {} (24 may), {} by more than {} (256 may)", f.pixels.over_8,
                       accepted.slack + 8, f.pixels.over_1, accepted.slack + 1);
  return f;
}

Pictured Baselines::pictured(const Excerpt& e, int step, const Guard* guard) const {
  const std::string stem = viz::file_stem(step, e.walk.steps[step]);
  return {&e, step, guard, path(e, guard ? guard->file(stem) : stem + ".png"), {}};
}

bool Baselines::need_no_drawing(const Pictured& p, std::vector<Failure>& found) const {
  if (acceptance_) return passes_over(p.baseline);
  if (viz::is_there(p.baseline) || accepts(Kind::missing) || keep_pictures_) return false;
  found.push_back(about(p, failure(Kind::missing, "no picture was accepted yet", p.baseline)));
  return true;
}

void Baselines::check_picture(const Pictured& p, const viz::Drawing& drawing, const std::vector<viz::Change>& changes,
                              std::vector<Failure>& found) {
  const viz::Picture now = offscreen_.render(drawing);
  std::optional<Failure> f = compare_with_baseline(now, p.baseline);
  if (f && f->kind == Kind::picture) {
    f->cause = cause_of_picture(changes, p.step);
    if (!p.guard) f->what = drawn(changes, p.step) + f->what;
  }
  const auto kept = [&] { return viz::baseline_png(now, kept_metadata(p)); };
  conclude(
      p, std::move(f), kept,
      [&](const Failure& differing) -> std::string {
        if (differing.kind != Kind::picture) return {};
        const viz::BaselinePicture accepted = viz::read_baseline_png(differing.accepted_file);
        return viz::png(viz::difference_picture(accepted.picture, now, accepted.slack), kept_metadata(p));
      },
      found);
}

void Baselines::conclude(const Pictured& p, std::optional<Failure> f, const std::function<std::string()>& now,
                         const std::function<std::string(const Failure&)>& difference, std::vector<Failure>& found) {
  const std::string& baseline = p.baseline;
  const std::string folder = folder_of(*p.excerpt);
  const bool absent = !viz::is_there(baseline), looked_at = f || update_ == Update::all;
  const bool ours = absent || (looked_at && made_for(metadata_in(baseline), folder, trace_of(folder)));
  std::string bytes;
  if (acceptance_) bytes = now();
  const bool replaced = settle(baseline, ours, f, bytes);
  const bool beside = f && !replaced && !absent && !acceptance_;  // are the pictures written beside the baseline?
  const bool shown = f && (beside || keep_pictures_);
  if (bytes.empty() && (replaced || shown)) bytes = now();
  if (replaced) viz::write_file(baseline, bytes);
  if (replaced || (!f && !acceptance_)) remove_failure_pictures(baseline, folder);
  if (!f) return;

  if (keep_pictures_ && f->kind != Kind::blank) f->reviewed = {{below(baseline), digest(bytes)}};
  if (shown) f->difference_file = difference(*f);
  f->fresh_file = std::move(bytes);
  if (beside) write_failure_pictures(*f, folder);
  if (!keep_pictures_) f->accepted_file.clear(), f->fresh_file.clear(), f->difference_file.clear();
  found.push_back(about(p, std::move(*f)));
}

}  // namespace isect::program
