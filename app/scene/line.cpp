#include "app/scene/line.h"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "app/query/reply.h"
#include "app/scene/file.h"
#include "app/scene/lesson.h"

namespace isect::program::scene {

namespace {

namespace fs = std::filesystem;

/// Throws viz::BadInput if an object names a file that may not be read.
void require_own_files(const Json& objects, const std::optional<std::string>& folder) {
  if (!objects.is_array()) return;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].is_object() || !objects[i].contains("file") || !objects[i]["file"].is_string()) continue;
    const std::string name = objects[i]["file"], field = fmt::format("objects[{}].file", i);
    if (!folder)
      throw viz::BadInput(fmt::format("{}: no file is read without --files DIR, where \"{}\" would be", field, name));
    const fs::path below = fs::weakly_canonical(*folder), file = fs::weakly_canonical(below / name);
    if (std::mismatch(below.begin(), below.end(), file.begin(), file.end()).first != below.end())
      throw viz::BadInput(fmt::format("{}: \"{}\" lies outside the folder of --files", field, name));
  }
}

/// Returns the line's answers as a list. Fields that are not a scene's own are removed first.
std::string result_of(const std::string& line, const std::optional<std::string>& folder) {
  Json scene = Json::parse(line);
  scene.erase("id");
  for (const std::string& name : query::notes()) scene.erase(name);
  require_own_files(scene["objects"], folder);
  std::string list;
  each_answer(read_scene(scene.dump(), folder.value_or("")),
              [&](const Json& answer) { list += (list.empty() ? "[" : ",") + query::written(answer); });
  return list.empty() ? "[]" : list + "]";
}

/// Removes "line 1: ": it is the only line of its scene.
std::string without_line(std::string what) {
  constexpr std::string_view place = "line 1: ";
  return what.starts_with(place) ? what.substr(place.size()) : what;
}

}  // namespace

bool is_scene_line(const std::string& line) try {
  if (line.size() > query::most_bytes() || line.find("\"objects\"") == line.npos) return false;
  const query::Document document(line);
  if (!document.error.empty() || document.value(0).type != query::Type::object) return false;
  const query::Field fields(document, 0);
  return fields.find("objects") && !fields.find("kind");
} catch (const std::bad_alloc&) {
  return false;  // the next reader reports it
}

query::Answer answer_line(const std::string& line, std::size_t number, const std::optional<std::string>& folder) {
  std::string id = "null";
  const auto failed = [&](const std::string& what) -> query::Answer {
    const std::string where = id == "null" && number > 0 ? fmt::format("line {}: ", number) : "";
    return {fmt::format(R"({{"id":{},"error":{}}})", id, query::written(where + without_line(what))), true};
  };
  try {
    id = query::Document(line).id;
    return {fmt::format(R"({{"id":{},"result":{}}})", id, result_of(line, folder)), false};
  } catch (const std::bad_alloc&) {
    return query::out_of_memory(number);
  } catch (const std::exception& e) {
    return failed(e.what());
  }
}

}  // namespace isect::program::scene
