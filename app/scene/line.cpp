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

/// Returns the line's answers as a list.
std::string result_of(const std::string& line, const std::optional<std::string>& folder) {
  Source source(line);
  require_own_files(source.json()["objects"], folder);
  std::vector<std::string> beside = query::notes();
  beside.push_back("id");
  std::string list;
  each_answer(read_scene(std::move(source), folder.value_or(""), beside),
              [&](const Json& answer) { list += (list.empty() ? "[" : ",") + query::written(answer); });
  return list.empty() ? "[]" : list + "]";
}

/// Removes "line 1: ": it is the only line of its scene.
std::string without_line(std::string what) {
  constexpr std::string_view place = "line 1: ";
  return what.starts_with(place) ? what.substr(place.size()) : what;
}

bool is_scene_line(const query::Document& document) {
  if (!document.error.empty() || document.value(0).type != query::Type::object) return false;
  const query::Field fields(document, 0);
  return fields.find("objects") && !fields.find("kind");
}

}  // namespace

std::optional<query::Answer> answer_line(const std::string& line, std::size_t number,
                                         const std::optional<std::string>& folder) {
  if (line.size() > query::most_bytes() || line.find("\"objects\"") == line.npos) return {};
  std::string id = "null";
  const auto failed = [&](const std::string& what) -> query::Answer {
    const std::string where = id == "null" && number > 0 ? fmt::format("line {}: ", number) : "";
    return {fmt::format(R"({{"id":{},"error":{}}})", id, query::written(where + without_line(what))), true};
  };
  try {
    const query::Document document(line);
    if (!is_scene_line(document)) return {};
    id = document.id;
    return query::Answer{fmt::format(R"({{"id":{},"result":{}}})", id, result_of(line, folder)), false};
  } catch (const std::bad_alloc&) {
    return query::out_of_memory(number);
  } catch (const std::exception& e) {
    return failed(e.what());
  }
}

}  // namespace isect::program::scene
