// Baselines that nothing is compared with any more.

#include <algorithm>

#include "app/baselines.h"
#include "app/leftovers.h"
#include "viz/snapshot.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

bool is_baseline(const fs::path& file) {
  return file.filename() == "trace.json" || (file.extension() == ".png" && !is_leftover(file));
}

std::vector<fs::path> sorted_children(const fs::path& folder) {
  std::error_code absent;  // an absent folder has no children
  std::vector<fs::path> children;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent)) children.push_back(entry.path());
  std::ranges::sort(children);
  return children;
}

/// A preset's name may have folders in it: all that are below, those further up first.
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

std::vector<Failure> Baselines::orphans(const std::vector<Excerpt>& checked, const Reach& reach) {
  std::set<fs::path> wanted;
  std::set<std::string> lessons, folders;
  for (const Excerpt& e : checked) {
    lessons.insert(e.lesson->id);
    folders.insert(folder_of(e));
    wanted.insert(path(e, "trace.json"));
    for (int i = 0; i < static_cast<int>(e.walk.steps.size()); ++i)
      if (has_picture(e, i)) wanted.insert(path(e, viz::file_stem(i, e.walk.steps[i]) + ".png"));
  }
  std::vector<Failure> found;
  for (const fs::path& lesson : sorted_children(folder_)) {
    const std::string id = lesson.filename();
    if (!reach.all_lessons && !lessons.contains(id)) continue;
    for (const fs::path& folder : folders_below(lesson)) {
      const std::string preset = folder.lexically_relative(lesson);
      if ((reach.all_presets && !reach.spared.contains(preset)) || folders.contains(id + "/" + preset))
        orphans_in(id, preset, wanted, found);
    }
  }
  return found;
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
    f.baseline = file;
    f.accepted = accepts(f.kind);
    if (f.accepted) {
      if (file.extension() == ".png") remove_leftovers(file, folder);
      removed |= fs::remove(file);
    }
    found.push_back(f);
  }
  std::error_code kept;  // a folder with other files in it stays
  for (fs::path empty = place; removed && fs::is_empty(empty, kept) && empty != folder_; empty = empty.parent_path())
    fs::remove(empty, kept);
}

}  // namespace isect::program
