// Baselines with which nothing is compared any more.

#include <fmt/format.h>

#include <algorithm>

#include "app/checks/baselines.h"
#include "app/checks/causes.h"
#include "app/checks/failure_pictures.h"
#include "app/checks/pictured.h"
#include "app/figures/digest.h"
#include "viz/player/reader_state.h"
#include "viz/snapshot/snapshot.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

bool is_baseline(const fs::path& file) {
  const bool picture = file.extension() == ".png" || file.extension() == ".svg" || file.extension() == ".tikz";
  return file.filename() == "trace.json" || (picture && !is_failure_picture(file));
}

std::vector<fs::path> sorted_children(const fs::path& folder) {
  std::error_code absent;  // an absent folder has no children
  std::vector<fs::path> children;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent)) children.push_back(entry.path());
  std::ranges::sort(children);
  return children;
}

/// Returns all folders below, upper ones first: a preset's name may contain folders.
std::vector<fs::path> folders_below(const fs::path& folder) {
  std::error_code absent;
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, absent))
    if (entry.is_directory(absent)) folders.push_back(entry.path());
  std::ranges::sort(folders);
  return folders;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> Baselines::in_reach(const std::vector<Excerpt>& checked,
                                                                     const Reach& reach) const {
  std::set<std::string> lessons, folders;
  for (const Excerpt& e : checked) lessons.insert(e.lesson->id), folders.insert(folder_of(e));
  std::vector<std::pair<std::string, std::string>> found;
  for (const fs::path& lesson : sorted_children(folder_)) {
    const std::string id = lesson.filename();
    if (!reach.all_lessons && !lessons.contains(id)) continue;
    for (const fs::path& folder : folders_below(lesson)) {
      const std::string preset = folder.lexically_relative(lesson);
      if ((reach.all_presets && !reach.spared.contains(preset)) || folders.contains(id + "/" + preset))
        found.emplace_back(id, preset);
    }
  }
  return found;
}

std::vector<Failure> Baselines::orphans(const std::vector<Excerpt>& checked, const Reach& reach) {
  std::set<fs::path> wanted;
  for (const Excerpt& e : checked) {
    wanted.insert(path(e, "trace.json"));
    for (int i = 0; i < static_cast<int>(e.walk.steps.size()); ++i) {
      if (!has_picture(e, i)) continue;
      wanted.insert(pictured(e, i, nullptr).baseline);
      for (const Guard& guard : e.guards) wanted.insert(pictured(e, i, &guard).baseline);
    }
  }
  std::vector<Failure> found;
  for (const auto& [lesson, preset] : in_reach(checked, reach)) orphans_in(lesson, preset, wanted, found);
  return found;
}

std::vector<Baselines::Move> Baselines::moves(const std::vector<Excerpt>& checked, const Reach& reach) {
  std::set<std::string> folders;
  for (const Excerpt& e : checked) folders.insert(folder_of(e));
  std::vector<std::pair<std::string, std::string>> left = in_reach(checked, reach);
  std::erase_if(left, [&](const auto& place) { return folders.contains(place.first + "/" + place.second); });

  std::vector<Move> found;
  for (const Excerpt& e : checked) {
    if (left.empty()) break;
    if (viz::is_there(path(e, ""))) continue;
    std::string now;  // drawn only if another preset has the same parameters
    const auto from = std::ranges::find_if(left, [&](const auto& place) {
      if (place.first != e.lesson->id) return false;
      const std::optional<OwnTrace>& trace = trace_of(place.first + "/" + place.second);
      if (!trace || trace->parameters != viz::to_json(e.parameters)) return false;
      if (now.empty()) now = trace_now(e, drawings_of(e));
      const std::string was = viz::read_regular_file(fs::path(folder_) / place.first / place.second / "trace.json");
      const std::vector<viz::Change> changes = viz::compare_traces(was, now);
      return changes.size() == 1 && changes[0].what == fmt::format("preset was {}, is {}", place.second, e.folder);
    });
    if (from == left.end()) continue;
    found.push_back({from->first, from->second, e.folder});
    left.erase(from);
  }
  return found;
}

void Baselines::join(const std::vector<Move>& moves, std::vector<Failure>& failures) const {
  if (update_ == Update::missing) return;  // it accepts only the missing half
  for (const Move& move : moves) {
    const auto of = [&](const Failure& f) {
      return f.lesson == move.lesson && ((f.kind == Failure::Kind::missing && f.preset == move.to) ||
                                         (f.kind == Failure::Kind::orphan && f.preset == move.from));
    };
    const auto first = std::ranges::find_if(failures, of);
    if (first == failures.end()) continue;
    Failure whole{Failure::Kind::moved, move.lesson, move.to};
    whole.what = fmt::format("says and shows what {} did, which is no more", move.from);
    whole.cause = cause_of(whole.kind);
    for (const Failure& f : failures)
      if (of(f)) whole.reviewed.insert(whole.reviewed.end(), f.reviewed.begin(), f.reviewed.end());
    whole.baseline = (fs::path(folder_) / move.lesson / move.from).string();
    whole.accepted = std::ranges::all_of(failures, [&](const Failure& f) { return !of(f) || f.accepted; });
    *first = whole;
    std::erase_if(failures, of);
  }
}

void Baselines::orphans_in(const std::string& lesson, const std::string& preset, const std::set<fs::path>& wanted,
                           std::vector<Failure>& found) {
  const std::string folder = lesson + "/" + preset;
  const fs::path place = fs::path(folder_) / folder;
  const std::optional<OwnTrace> trace = trace_of(folder);
  bool removed = false;
  for (const fs::path& file : sorted_children(place)) {
    if (!is_baseline(file) || wanted.contains(file)) continue;
    const bool ours =
        !fs::is_symlink(file) &&
        (file.filename() == "trace.json" ? trace.has_value()
                                         : made_as(metadata_in(file), folder + "/" + file.stem().string(), trace));
    if (!ours) {
      left_alone_.insert(file);
      continue;
    }
    Failure f{Failure::Kind::orphan, lesson, preset};
    f.what = "belongs to no step of any preset";
    f.cause = cause_of(f.kind);
    f.baseline = file;
    const std::string there = keep_pictures_ || acceptance_ ? digest(viz::read_regular_file(file)) : "";
    if (keep_pictures_) f.reviewed = {{below(f.baseline), there, true}};
    f.accepted = acceptance_ ? acceptance_->takes_away(below(f.baseline), there) : accepts(f.kind);
    if (f.accepted) {
      if (file.filename() != "trace.json") remove_failure_pictures(file, folder);
      removed |= fs::remove(file);
    }
    found.push_back(f);
  }
  std::error_code kept;  // a folder with other files in it stays
  for (fs::path empty = place; removed && fs::is_empty(empty, kept) && empty != folder_; empty = empty.parent_path())
    fs::remove(empty, kept);
}

}  // namespace isect::program
