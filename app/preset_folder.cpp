#include "app/preset_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/figures/ownership.h"
#include "app/guard.h"
#include "app/playlist_file.h"
#include "app/scene/lesson.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Returns all JSON files that isect did not leave itself, in order of their names.
std::vector<PresetFile> json_files(const fs::path& folder) {
  std::vector<PresetFile> files;
  std::error_code error;
  auto entry = fs::recursive_directory_iterator(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    const std::string name = path.filename();
    const bool baselines = entry.depth() == 0 && name == "snapshots";
    std::error_code hidden;  // what it is shows once it is read
    const bool is_folder = entry->is_directory(hidden);
    if (is_folder && (name.starts_with(".") || baselines)) entry.disable_recursion_pending();
    if (is_folder || name.starts_with(".") || path.extension() != ".json") continue;
    if (name == "manifest.json" || own_trace(path)) continue;
    files.push_back({path.string(), path.lexically_relative(folder).replace_extension().string()});
  }
  if (error) throw viz::FileError(fmt::format("{}: {}", folder.string(), error.message()));
  std::ranges::sort(files, {}, &PresetFile::name);
  return files;
}

/// Whether a text, which may be no JSON, has a field of this name. It may be as long as it likes, as may its blanks.
bool has_field(const std::string& text, const std::string& name) {
  const std::string key = '"' + name + '"';
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at)) {
    at += key.size();
    if (const std::size_t next = text.find_first_not_of(" \t\r\n", at); next != text.npos && text[next] == ':')
      return true;
  }
  return false;
}

/// Whether a scene's text is no longer valid JSON.
bool is_broken_scene(const std::string& text) { return !Json::accept(text, true) && has_field(text, "objects"); }

/// Whether it is meant as a preset, which names its lesson; in invalid JSON, a field of that name shows it.
bool is_meant_as_preset(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_discarded()) return json.is_object() && json.contains("lesson");
  return has_field(text, "lesson");
}

}  // namespace

PresetFolder preset_folder(const std::string& folder, const Program& program) {
  PresetFolder found;
  for (const PresetFile& file : json_files(folder)) try {
      const std::string text = viz::read_regular_file(file.path);
      if (scene::holds_objects(text) || is_broken_scene(text)) {
        require_utf8(file);
        scene::lesson_of(text, std::filesystem::path(file.path).parent_path().string());
        guards_in(text);
        found.presets.push_back(file);
        continue;
      }
      scene::require_shallow(text);
      if (is_playlist(text) || !is_meant_as_preset(text)) {
        found.foreign.push_back(file.path);
        continue;
      }
      require_utf8(file);
      viz::reader_state_from_json(text, program.lessons);
      guards_in(text);
      found.presets.push_back(file);
    } catch (const viz::FileError& e) {
      found.broken.push_back({file, e.what()});
    } catch (const viz::BadInput& e) {
      found.broken.push_back({file, fmt::format("{}: {}", file.path, e.what())});
    }
  if (found.presets.empty() && found.broken.empty())
    throw viz::BadInput(
        fmt::format("dir: {} holds no preset files; put some there, NAME.json each, such as {{\"lesson\": "
                    "\"ray-sphere\", "
                    "\"parameters\": {{...}}}} (Ctrl+C in the window copies one)",
                    folder));
  return found;
}

void require_utf8(const PresetFile& file) try {
  static_cast<void>(Json(file.name).dump());
} catch (const Json::exception&) {
  throw viz::BadInput("the file's name is not UTF-8; rename it");
}

void say_passed_over(const PresetFolder& folder) {
  constexpr std::size_t enough = 5;
  for (std::size_t i = 0; i < std::min(enough, folder.foreign.size()); ++i)
    say(fmt::format("passed over: {} is no preset", folder.foreign[i]));
  if (folder.foreign.size() > enough) say(fmt::format("passed over: {} other files", folder.foreign.size() - enough));
}

}  // namespace isect::program
