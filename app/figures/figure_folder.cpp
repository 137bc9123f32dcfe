#include "app/figures/figure_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/figures/digest.h"
#include "app/figures/ownership.h"
#include "app/figures/question_figure.h"
#include "app/shell/lock.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"
#include "viz/snapshot/json.h"
#include "viz/snapshot/snapshot.h"
#include "viz/text/rich_text.h"
#include "viz/text/tex.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool is_figure(const fs::path& file) {
  return !fs::is_symlink(file) && fs::is_regular_file(file) && viz::format_of(file) != nullptr;
}

std::vector<fs::path> figures_in(const fs::path& folder) {
  std::error_code absent;  // an absent folder has none
  std::vector<fs::path> figures;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent))
    if (is_figure(entry.path())) figures.push_back(entry.path());
  std::ranges::sort(figures);
  return figures;
}

/// Returns the lesson and the preset of an excerpt.
Json place_of(const Excerpt& e) {
  return {{"lesson", e.lesson->id}, {"preset", e.preset.empty() ? Json(nullptr) : Json(e.preset)}};
}

/// Returns what the manifest says of a figure's steps.
Json steps_in(const Excerpt& e, const FigureInfo& info) {
  Json entry = place_of(e);
  if (!shows_several(info.metadata)) {
    entry.update({{"step", info.steps.front() + 1}, {"slug", e.walk.steps[info.steps.front()].slug}});
    return entry;
  }
  entry["steps"] = Json::array();
  for (const int step : info.steps) entry["steps"].push_back(step + 1);
  return entry;
}

/// Returns what the manifest says of the parts of a figure of several settings.
Json parts_of(Excerpts cases) {
  Json parts = Json::array();
  for (const Excerpt& e : cases)
    for (const int step : e.steps) {
      Json part = place_of(e);
      part.update({{"step", step + 1}, {"slug", e.walk.steps[step].slug}});
      part["parameters"] = Json::parse(viz::to_json(e.parameters));
      parts.push_back(std::move(part));
    }
  Json entry;
  entry["parts"] = std::move(parts);
  return entry;
}

std::string faces_file(const FigureInfo& info) { return faces_of(info.stem) + ".pdf"; }

/// Writes a figure and the picture that it names, each at its path. If the figure can't be written, the picture is as
/// it was. Throws viz::FileError.
void write_both(const std::string& figure, const std::string& picture, const FigureFile& made) {
  std::error_code absent;
  const bool was_there = fs::is_regular_file(picture, absent);
  const std::string before = was_there ? viz::read_regular_file(picture) : std::string();
  viz::write_file(picture, made.faces);
  try {
    viz::write_file(figure, made.bytes);
  } catch (const viz::FileError&) {
    if (was_there)
      viz::write_file(picture, before);
    else
      fs::remove(picture, absent);
    throw;
  }
}

[[noreturn]] void not_ours(const std::string& path) {
  throw viz::FileError(
      fmt::format("cannot write '{}': the file there was not made by isect; move it away, or give another folder "
                  "with --out",
                  path));
}

}  // namespace

FigureFolder::FigureFolder(std::string folder, const Program& program) : folder_(std::move(folder)) {
  if (const auto trace = baseline_below(folder_, program))
    throw viz::BadInput(
        fmt::format("out: {} holds baselines ({}), and figures never lie among them; give another folder, such as "
                    "--out figures",
                    folder_, trace->string()));
  listed_ = read_manifest();
}

FigureFolder::~FigureFolder() {
  try {
    list();
  } catch (const std::exception&) {
    // The first error is the one that is reported.
  }
}

void FigureFolder::need_ours(const FigureInfo& info, const viz::Format& format) const {
  std::vector<std::string> files = {info.stem + "." + format.name};
  if (format.name == "tikz") files.push_back(faces_file(info));
  for (const std::string& file : files)
    if (!is_ours(file)) not_ours(path(file));
}

std::string FigureFolder::path(const std::string& file) const { return (fs::path(folder_) / file).string(); }

/// Whether a file is isect's, or may be replaced because it is absent, not a regular file, or empty.
bool FigureFolder::is_ours(const std::string& file) const {
  const fs::path there = path(file);
  std::error_code absent;
  if (!fs::is_regular_file(there, absent) || listed_.figures.contains(file) || fs::file_size(there, absent) == 0)
    return true;
  return metadata_in(there).contains("lesson");
}

bool FigureFolder::is_our_text(const std::string& stem, const std::string& now) const {
  const std::string file = path(stem + ".txt");
  std::error_code absent;
  if (!fs::is_regular_file(file, absent)) return true;
  const std::string there = viz::read_regular_file(file);
  const auto wrote_it = [&](const auto& entry) {
    return fs::path(entry.first).replace_extension() == stem && entry.second.value("alt", "") == there;
  };
  return there == now || std::ranges::any_of(added_.figures, wrote_it) ||
         std::ranges::any_of(listed_.figures, wrote_it);
}

bool FigureFolder::is_edited(const std::string& file, const Entries Manifest::*kind, const std::string& now) const {
  const Entries& last = (added_.*kind).contains(file) ? added_.*kind : listed_.*kind;
  const auto entry = last.find(file);
  std::error_code absent;
  if (entry == last.end() || !entry->second.contains("digest") || !fs::is_regular_file(path(file), absent))
    return false;
  const std::string there = viz::read_regular_file(path(file));
  return !there.empty() && there != now && digest(there) != entry->second["digest"];
}

FigureFolder::Manifest FigureFolder::read_manifest() const {
  const std::string file = path("manifest.json");
  if (!viz::is_there(file)) return {};
  const Json manifest = viz::snap::parsed(viz::read_regular_file(file));
  Manifest listed;
  try {
    if (manifest.at("program") != "isect") not_ours(file);
    for (const Json& entry : manifest.at("figures")) {
      static_cast<void>(entry.value("alt", ""));  // the text that the entry names
      listed.figures.emplace(entry.at("file").get<std::string>(), entry);
    }
    for (const Json& entry : manifest.value("pages", Json::array()))
      listed.pages.emplace(entry.at("file").get<std::string>(), entry);
  } catch (const Json::exception&) {
    not_ours(file);
  }
  return listed;
}

std::string FigureFolder::add(const Excerpt& e, const FigureInfo& info, const std::string& format,
                              const FigureFile& made, Json about) {
  return add(Excerpts(&e, 1), info, format, made, std::move(about));
}

std::string FigureFolder::add(Excerpts cases, const FigureInfo& info, const std::string& format, const FigureFile& made,
                              Json about) {
  const std::string file = info.stem + "." + format, faces = faces_file(info);
  const bool apart = !made.faces.empty(), edited = is_edited(file, &Manifest::figures, made.bytes);
  const bool faces_edited = apart && is_edited(faces, &Manifest::figures, made.faces);
  if (edited) left_alone_.insert(path(file));
  if (faces_edited) left_alone_.insert(path(faces));
  if (edited || faces_edited) return {};
  if (apart)
    write_both(path(file), path(faces), made);
  else
    viz::write_file(path(file), made.bytes);
  if (is_our_text(info.stem, info.alt))
    viz::write_file(path(info.stem + ".txt"), info.alt);
  else
    left_alone_.insert(path(info.stem + ".txt"));

  Json entry;
  entry["file"] = file;
  entry.update(cases.size() == 1 ? steps_in(cases[0], info) : parts_of(cases));
  entry.update({{"title", viz::plain(info.title)},
                {"caption", viz::plain(info.caption)},
                {"caption_tex", viz::tex(info.caption)},
                {"alt", info.alt}});
  if (cases.size() == 1) entry["parameters"] = Json::parse(viz::to_json(cases[0].parameters));
  entry.update(about);
  entry["version"] = viz::version();
  entry["digest"] = digest(made.bytes);
  added_.figures[file] = entry;
  if (apart) {
    entry.update({{"file", faces}, {"part_of", file}, {"digest", digest(made.faces)}});
    added_.figures[faces] = entry;
  }
  return path(file) + "\n";
}

std::string FigureFolder::add_page(const std::string& file, const std::string& text) {
  if (is_edited(file, &Manifest::pages, text)) {
    left_alone_.insert(path(file));
    return {};
  }
  viz::write_file(path(file), text);
  added_.pages[file] = {{"file", file}, {"digest", digest(text)}};
  return path(file) + "\n";
}

std::size_t FigureFolder::remove_stale(const Excerpt& e) {
  std::set<std::string> wanted, gone;
  for (int i = 0; i < static_cast<int>(e.walk.steps.size()); ++i) {
    std::vector<std::string> stems = {file_of(e, i)};
    if (e.walk.steps[i].question) stems.push_back(file_of_question(e, i));  // for a deck, a handout or a quiz
    for (const std::string& stem : stems) wanted.insert({stem, faces_of(stem)});
  }
  const std::vector<fs::path> figures = figures_in(path(folder_of(e)));
  std::size_t removed = 0;
  for (const fs::path& figure : figures) {
    const std::string stem = folder_of(e) + "/" + figure.stem().string();
    if (wanted.contains(stem)) continue;
    const viz::Metadata data = metadata_in(figure);
    if (shows_several(data)) continue;  // it stays, whatever steps there are now
    const std::string file = stem + figure.extension().string();
    if (!made_as(data, stem, {}) && !(listed_.figures.contains(file) && made_for(data, folder_of(e), {}))) continue;
    if (is_edited(file, &Manifest::figures, {})) {
      left_alone_.insert(path(file));
      continue;
    }
    removed += fs::remove(figure);
    gone.insert(stem);
  }
  for (const fs::path& figure : figures_in(path(folder_of(e))))  // a foreign figure of that name keeps the text
    gone.erase(folder_of(e) + "/" + figure.stem().string());
  for (const std::string& stem : gone)
    if (is_our_text(stem, {}))
      fs::remove(path(stem + ".txt"));
    else
      left_alone_.insert(path(stem + ".txt"));
  return removed;
}

void FigureFolder::list() {
  if (added_.figures.empty() && added_.pages.empty()) return;
  const Lock alone(path(".isect-manifest.lock"));
  Manifest all = added_, before = read_manifest();
  const auto listed = [&](Entries& entries, Entries& earlier) {
    entries.merge(earlier);
    Json list = Json::array();
    for (const auto& [file, entry] : entries)
      if (viz::is_there(path(file))) list.push_back(entry);
    return list;
  };
  Json manifest = {{"program", "isect"}, {"version", viz::version()}, {"figures", listed(all.figures, before.figures)}};
  if (const Json pages = listed(all.pages, before.pages); !pages.empty()) manifest["pages"] = pages;
  viz::write_file(path("manifest.json"), manifest.dump(2) + "\n");
  listed_ = std::move(all), added_ = {};
}

void FigureFolder::say_left_alone() const {
  for (const std::string& file : left_alone_) program::say_left_alone(file);
}

}  // namespace isect::program
