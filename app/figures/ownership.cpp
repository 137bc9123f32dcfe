#include "app/figures/ownership.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/shell/terminal.h"
#include "viz/formats/formats.h"
#include "viz/player/reader_state.h"
#include "viz/snapshot/json.h"
#include "viz/snapshot/snapshot.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const viz::Step& step_of(const Excerpt& e, int step) { return e.walk.steps[step]; }

std::string at(const viz::Metadata& data, const std::string& key) {
  const auto found = data.find(key);
  return found == data.end() ? std::string() : found->second;
}

}  // namespace

std::string folder_of(const Excerpt& e) { return e.place.empty() ? e.lesson->id + "/" + e.folder : e.place; }

std::string file_of(const Excerpt& e, int step) { return folder_of(e) + "/" + viz::file_stem(step, step_of(e, step)); }

viz::Metadata metadata_of(const Excerpt& e, int step) {
  const std::optional<double> time = step == e.step ? e.time : std::nullopt;
  viz::Metadata data = viz::metadata({e.lesson->id, e.preset, step, e.parameters, e.camera, {}, time});
  data["file"] = file_of(e, step);
  if (!e.lesson->made_from.empty()) data["scene"] = e.lesson->made_from;
  return data;
}

viz::Metadata metadata_in(const fs::path& picture) {
  std::error_code hidden;  // an unreadable file is not known as ours
  const viz::Format* const format = viz::format_of(picture);
  if (!format || !fs::is_regular_file(picture, hidden)) return {};
  try {
    return format->metadata(viz::read_regular_file(picture));
  } catch (const viz::FileError&) {
    return {};
  }
}

std::optional<OwnTrace> own_trace(const fs::path& file) try {
  if (!fs::is_regular_file(file)) return {};
  const Json trace = viz::snap::parsed(viz::read_regular_file(file));
  OwnTrace own;
  own.folder = trace.at("lesson").get<std::string>() + "/" + trace.at("preset").get<std::string>();
  own.parameters = trace.at("parameters").dump();
  for (const Json& step : trace.at("steps"))
    own.stems.insert(fmt::format("{:02}-{}", own.stems.size() + 1, step.at("slug").get<std::string>()));
  return own;
} catch (const std::exception&) {
  return {};  // it can't be read as a trace
}

bool is_lfs_pointer(const std::string& bytes) { return bytes.starts_with("version https://git-lfs.github.com/spec/"); }

bool made_for(const viz::Metadata& data, const std::string& folder, const std::optional<OwnTrace>& beside) {
  if (const std::string file = at(data, "file"); !file.empty()) return fs::path(file).parent_path() == folder;
  if (at(data, "lesson").empty()) return false;
  if (at(data, "lesson") + "/" + at(data, "preset") == folder) return true;
  return beside && beside->folder == folder && beside->parameters == at(data, "parameters");
}

bool made_as(const viz::Metadata& data, const std::string& file, const std::optional<OwnTrace>& beside) {
  if (data.contains("file")) return data.at("file") == file;
  const fs::path path = file;
  const std::string stem = path.filename();
  return made_for(data, path.parent_path(), beside) && beside && beside->stems.contains(stem) &&
         stem.starts_with(fmt::format("{:0>2}-", at(data, "step")));
}

bool may_be_replaced(const fs::path& file, const std::function<bool(const std::string& begin)>& ours) {
  std::error_code absent;
  if (!fs::is_regular_file(file, absent) || fs::file_size(file, absent) == 0) return true;
  std::string bytes(512, '\0');
  std::ifstream there(file, std::ios::binary);
  there.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return ours(bytes);
}

void say_left_alone(const std::string& file) {
  say(fmt::format("left alone: {} was edited; remove it to have isect's own again", file));
}

std::optional<fs::path> trace_below(const fs::path& lesson) {
  std::error_code absent;  // nothing below
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(lesson, fs::directory_options::skip_permission_denied, absent))
    if (entry.path().filename() == "trace.json" && own_trace(entry.path())) return entry.path();
  return {};
}

std::optional<fs::path> baseline_below(const fs::path& folder, const Program& program) {
  const auto trace_in = [](const fs::path& place) -> std::optional<fs::path> {
    if (own_trace(place / "trace.json")) return place / "trace.json";
    return {};
  };
  if (const auto found = trace_in(folder)) return found;
  std::error_code absent;  // nothing below
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent))
    if (entry.is_directory(absent))
      if (const auto found = trace_in(entry.path())) return found;
  for (const viz::Lesson* lesson : program.lessons)
    if (const auto found = trace_below(folder / lesson->id)) return found;
  return {};
}

}  // namespace isect::program
