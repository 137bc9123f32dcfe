#include "app/scene/save.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <vector>

#include "app/scene/spans.h"
#include "app/scene/types.h"
#include "viz/formats/files.h"

namespace isect::program::scene {

namespace {

/// Returns the paths at which a field may stand: that of a vertex depends on how the object is written.
std::vector<std::string> places(const Object& o, const std::string& field) {
  std::vector<std::string> all = {"/" + field};
  if (o.type == Type::kdop) all.push_back(fmt::format("/{}/{}", field.substr(0, 2), std::stoi(field.substr(2)) - 1));
  if (field.find_first_not_of("0123456789") != field.npos) return all;
  int left = std::stoi(field) - 1;
  all.push_back(fmt::format("/points/{}", left));
  for (std::size_t ring = 0; ring < o.rings.size(); left -= o.rings[ring++])
    if (left >= 0 && left < o.rings[ring]) all.push_back(fmt::format("/rings/{}/{}", ring, left));
  return all;
}

/// Returns where "at" is added to an object that has none yet: behind its name. Null: there is no such object.
const Spans::Span* end_of_name(const Spans& spans, const Object& o, std::size_t i) {
  const Spans::Span* name = spans.at(fmt::format("/objects/{}/{}", i, spec(o.type).name));
  return name ? name : spans.at(fmt::format("/objects/{}/{}", i, other_name(spec(o.type))));
}

/// Returns a number of the setting. Points that nothing moves are moved by 0.
viz::Setting value(const viz::Parameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  return found == parameters.end() ? viz::Setting(viz::Vec3(0, 0, 0)) : found->second;
}

std::string written(const viz::Setting& setting, bool flat) {
  if (const double* x = std::get_if<double>(&setting)) return viz::to_text(*x);
  const auto& p = std::get<viz::Vec3>(setting);
  return fmt::format("[{}, {}{}]", viz::to_text(p.x()), viz::to_text(p.y()), flat ? "" : ", " + viz::to_text(p.z()));
}

}  // namespace

std::string with_numbers(const std::string& text, const File& file, const viz::Parameters& parameters) {
  const Spans spans(text);
  std::map<std::size_t, std::pair<std::size_t, std::string>, std::greater<>> changes;  // the last one first
  for (std::size_t i = 0; i < file.objects.size(); ++i) {
    const Object& o = file.objects[i];
    std::vector<std::string> fields = o.fields;
    if (o.lacks_at()) fields.push_back("at");
    for (const std::string& field : fields) {
      const std::string name = o.name + "." + field;
      const viz::Setting now = value(parameters, name);
      if (now == value(file.parameters, name)) continue;
      const Spans::Span* span = nullptr;
      for (const std::string& place : places(o, field))
        if (!span) span = spans.at(fmt::format("/objects/{}{}", i, place));
      const Spans::Span* const own = field == "at" && !span ? end_of_name(spans, o, i) : nullptr;
      if (own)
        changes[own->end] = {own->end, ", \"at\": " + written(now, file.flat)};
      else if (span)
        changes[span->begin] = {span->end, written(now, file.flat)};
      else
        throw viz::BadInput(fmt::format("{}: it stands in a file of its own, which isect does not change", name));
    }
  }
  std::string out = text;
  for (const auto& [begin, change] : changes) out.replace(begin, change.first - begin, change.second);
  return out;
}

KeptFile::KeptFile(const std::string& path) : path_(path), text_(viz::read_regular_file(path)) {}

std::string KeptFile::folder() const { return std::filesystem::path(path_).parent_path().string(); }

void KeptFile::require_same() const {
  if (viz::read_regular_file(path_) != text_)
    throw viz::FileError(fmt::format(
        "cannot write '{}': somebody has changed it since it was opened. Ctrl+C copies these numbers", path_));
}

void KeptFile::put(const std::string& text) {
  viz::write_file(path_, text);
  text_ = text;
}

void KeptFile::save(const viz::Parameters& parameters) {
  require_same();
  put(with_numbers(text_, read_scene(text_, folder()), parameters));
}

void KeptFile::write(const std::string& text) {
  require_same();
  put(text);
}

}  // namespace isect::program::scene
