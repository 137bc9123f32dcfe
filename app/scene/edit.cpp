#include "app/scene/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "app/scene/list_text.h"
#include "app/scene/own_words.h"
#include "app/scene/source.h"
#include "app/scene/spots.h"
#include "viz/text/spelling.h"

namespace isect::program::scene {

namespace {

std::string name_of(const Json& object) {
  const std::string field = type_field(object);
  return field.empty() || !object[field].is_string() ? std::string() : object[field].get<std::string>();
}

std::vector<std::string> names_in(const Json& scene) {
  std::vector<std::string> names;
  for (const Json& object : scene["objects"]) names.push_back(name_of(object));
  return names;
}

std::size_t index_of(const Source& source, const std::string& name) {
  const std::vector<std::string> names = names_in(source.json());
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    source.refuse({"objects"}, fmt::format("no object is called \"{}\"{}", name,
                                           spelling::instead(name, names, "there are " + spelling::listed(names))));
  return static_cast<std::size_t>(found - names.begin());
}

/// Throws viz::BadInput if it is no scene at all.
Source source_of(const std::string& text) {
  Source source(text);
  if (!source.json().is_object() || !source.json().contains("objects") || !source.json()["objects"].is_array())
    source.refuse({}, "\"objects\" is missing");
  return source;
}

/// A place in a question where a name of an object stands. `list`: that of the names, if there may be any number.
struct NamePlace {
  std::string path, list = {};
  std::size_t index = 0, count = 0;
};

/// Returns the places below `path` where this name stands in a question.
std::vector<NamePlace> places_of(const Json& asked, const std::string& path, const std::string& name) {
  std::vector<NamePlace> places;
  const auto look = [&](const Json& value, const std::string& at) {
    if (value == name) places.push_back({at});
    if (!value.is_array()) return;
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i] == name) places.push_back({fmt::format("{}/{}", at, i), at, i, value.size()});
  };
  if (asked.is_array()) look(asked, path);
  if (!asked.is_object()) return places;
  for (const char* field : {"of", "first hit", "fit", "clip", "to", "hierarchy", "walk", "ray"})
    if (asked.contains(field) && asked[field] != "all") look(asked[field], path + "/" + field);
  return places;
}

/// Returns the paths of all places that a mark names.
std::vector<std::string> places_of_mark(const Json& mark, std::size_t i) {
  std::vector<std::string> paths;
  if (!mark.is_object()) return paths;
  for (const auto& [field, value] : mark.items()) {
    const std::string path = fmt::format("/marks/{}/{}", i, field);
    if (field == "at" && value.is_string()) paths.push_back(path);
    for (std::size_t k = 0; value.is_array() && field != "at" && k < value.size(); ++k)
      if (value[k].is_string()) paths.push_back(fmt::format("{}/{}", path, k));
  }
  return paths;
}

const Json& marks_in(const Json& scene) {
  static const Json none = Json::array();
  return scene.contains("marks") && scene["marks"].is_array() ? scene["marks"] : none;
}

/// Removes the marks that name an object, and those that name such a mark.
void remove_marks(std::string& text, const Json& scene, const std::string& name) {
  std::vector<std::string> gone = {name};
  std::vector<std::size_t> removed;
  const Json& marks = marks_in(scene);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const std::vector<std::string> paths = places_of_mark(marks[i], i);
    const bool names_gone = std::ranges::any_of(paths, [&](const std::string& path) {
      const std::string place = scene[Json::json_pointer(path)];
      return std::ranges::any_of(gone, [&](const std::string& one) { return place_names(place, one); });
    });
    if (!names_gone) continue;
    removed.push_back(i);
    if (marks[i].contains("point") && marks[i]["point"].is_string()) gone.push_back(marks[i]["point"]);
  }
  for (auto i = removed.rbegin(); i != removed.rend(); ++i) remove_entry(text, "/marks", *i);
}

/// Adds a field behind the objects: on a line of its own if they begin one.
void add_field(std::string& text, const std::string& field) {
  const Spans::Span objects = *Spans(text).at("/objects");
  const std::size_t begin = line_begin(text, objects.begin);
  const std::size_t key = text.find_first_not_of(" \t", begin);
  const bool own_line = begin > 0 && text[key] == '"';
  put_behind(text, objects.end, own_line ? std::optional(text.substr(begin, key - begin)) : std::nullopt, field);
}

/// Removes a name from a question about three objects or more, else the question.
void remove_name(std::string& text, std::size_t question, const std::vector<NamePlace>& places) {
  if (places.size() == 1 && places[0].count > 2)
    remove_entry(text, places[0].list, places[0].index);
  else
    remove_entry(text, "/ask", question);
}

/// Where a corner of a polygon stands in the text.
struct CornerPlace {
  const Json &object, &outline;
  Path path;         ///< of the object
  std::string list;  ///< the path of the outline
  std::size_t index = 0;
};

/// Throws viz::BadInput if there is no such corner, or if it stands in another file.
CornerPlace corner_place(const Source& source, const std::string& name, int corner) {
  const std::size_t at = index_of(source, name);
  const Json& object = source.json()["objects"][at];
  const Path path = {"objects", std::to_string(at)};
  const std::string place = fmt::format("/objects/{}", at);
  if (type_field(object) != spec(Type::polygon).name) source.refuse(path, name + " is no polygon");
  if (object.contains("file"))
    source.refuse(below(path, "file"), "the corners stand in a file of their own, which isect does not change");
  std::size_t left = static_cast<std::size_t>(corner) - 1;
  const auto in = [&](const Json& outline) { return outline.is_array() && left < outline.size(); };
  if (object.contains("points") && in(object["points"]))
    return {object, object["points"], path, place + "/points", left};
  const std::size_t rings = object.contains("rings") ? object["rings"].size() : 0;
  for (std::size_t i = 0; i < rings; left -= object["rings"][i++].size())
    if (in(object["rings"][i])) return {object, object["rings"][i], path, fmt::format("{}/rings/{}", place, i), left};
  source.refuse(path, fmt::format("{} has no corner {}", name, corner));
}

std::size_t corners_of(const Json& polygon) {
  if (polygon.contains("points")) return polygon["points"].size();
  std::size_t count = 0;
  for (const Json& ring : polygon["rings"]) count += ring.size();
  return count;
}

}  // namespace

std::string type_field(const Json& object) {
  for (const TypeSpec& type : types())
    for (const std::string& field : {type.name, other_name(type)})
      if (!field.empty() && object.is_object() && object.contains(field)) return field;
  return {};
}

std::string on_one_line(const Json& json) {
  std::string all;
  if (json.is_object()) {
    for (const auto& [key, value] : json.items())
      all += (all.empty() ? "" : ", ") + Json(key).dump() + ": " + on_one_line(value);
    return "{" + all + "}";
  }
  if (json.is_array()) {
    for (const Json& value : json) all += (all.empty() ? "" : ", ") + on_one_line(value);
    return "[" + all + "]";
  }
  return json.is_number_float() ? viz::to_text(json.get<double>()) : json.dump();
}

std::string free_name(const std::string& text) {
  const std::vector<std::string> names = names_in(source_of(text).json());
  for (int round = 0;; ++round)
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      const std::string name = letter + (round == 0 ? std::string() : std::to_string(round));
      if (std::ranges::find(names, name) == names.end()) return name;
    }
}

std::string with_object(const std::string& text, Type type, const std::string& name, const Start& start) {
  const Source source = source_of(text);
  std::string now = text;
  add_entry(now, "/objects", source.json()["objects"].size(), on_one_line(start_of(type, name, start)));
  return now;
}

std::string without_object(const std::string& text, const std::string& name) {
  const Source source = source_of(text);
  const std::size_t index = index_of(source, name);
  std::string now = text;
  const Json ask = source.json().contains("ask") ? source.json()["ask"] : Json();
  for (std::size_t i = ask.is_array() ? ask.size() : 0; i-- > 0;) {
    const std::vector<NamePlace> places = places_of(ask[i], fmt::format("/ask/{}", i), name);
    if (!places.empty()) remove_name(now, i, places);
  }
  remove_marks(now, source.json(), name);
  remove_entry(now, "/objects", index);
  return now;
}

std::string with_name(const std::string& text, const std::string& name, const std::string& now) {
  const Source source = source_of(text);
  const std::size_t index = index_of(source, name);
  const Spans spans(text);
  struct Change {
    Spans::Span span;
    std::string text;
  };
  std::vector<Change> found;
  const auto take = [&](const std::string& path, const std::string& written) {
    if (const Spans::Span* span = spans.at(path)) found.push_back({*span, Json(written).dump()});
  };
  take(fmt::format("/objects/{}/{}", index, type_field(source.json()["objects"][index])), now);
  if (source.json().contains("ask") && source.json()["ask"].is_array())
    for (std::size_t i = 0; i < source.json()["ask"].size(); ++i)
      for (const NamePlace& place : places_of(source.json()["ask"][i], fmt::format("/ask/{}", i), name))
        take(place.path, now);
  const Json& marks = marks_in(source.json());
  for (std::size_t i = 0; i < marks.size(); ++i)
    for (const std::string& path : places_of_mark(marks[i], i))
      if (const std::string place = source.json()[Json::json_pointer(path)]; place_names(place, name))
        take(path, place_with_name(place, name, now));
  std::ranges::sort(found, std::ranges::greater{}, [](const Change& c) { return c.span.begin; });  // the last one first
  std::string out = text;
  for (const Change& c : found) out.replace(c.span.begin, c.span.end - c.span.begin, c.text);
  return out;
}

std::string with_hidden(const std::string& text, const std::string& name, bool hidden) {
  const Source source = source_of(text);
  const std::size_t index = index_of(source, name);
  const Spans spans(text);
  std::string now = text;
  static const std::string field = ", \"hidden\": ";
  if (const Spans::Span* was = spans.at(fmt::format("/objects/{}/hidden", index))) {
    const bool ours = was->begin >= field.size() && now.compare(was->begin - field.size(), field.size(), field) == 0;
    if (!hidden && ours)
      now.erase(was->begin - field.size(), was->end - was->begin + field.size());
    else
      now.replace(was->begin, was->end - was->begin, hidden ? "true" : "false");
  } else if (hidden) {
    const Json& object = source.json()["objects"][index];
    now.insert(spans.at(fmt::format("/objects/{}/{}", index, type_field(object)))->end, field + "true");
  }
  return now;
}

std::string with_answers(const std::string& text, bool hidden) {
  const Source source = source_of(text);
  const std::string word = hidden ? "\"hidden\"" : "\"shown\"";
  std::string now = text;
  if (const Spans spans(text); const Spans::Span* was = spans.at("/answers"))
    now.replace(was->begin, was->end - was->begin, word);
  else if (hidden)
    add_field(now, "\"answers\": " + word);
  return now;
}

std::string with_language(const std::string& text, const std::string& code) {
  const Source source = source_of(text);
  const std::string word = '"' + code + '"';
  std::string now = text;
  if (const Spans spans(text); const Spans::Span* was = spans.at("/lang"))
    now.replace(was->begin, was->end - was->begin, word);
  else
    add_field(now, "\"lang\": " + word);
  return now;
}

std::string with_question(const std::string& text, const Json& asked) {
  const Source source = source_of(text);
  const Json& scene = source.json();
  const std::string entry = on_one_line(asked);
  std::string now = text;
  if (!scene.contains("ask")) {
    add_field(now, "\"ask\": [" + entry + "]");
    return now;
  }
  if (scene["ask"] == "all pairs")
    source.refuse({"ask"}, asked.is_array() ? "all pairs are asked already"
                                            : "all pairs are asked; other questions stand in a list");
  if (!scene["ask"].is_array()) source.refuse({"ask"}, "a list of questions is expected, or \"all pairs\"");
  for (std::size_t i = 0; i < scene["ask"].size(); ++i)
    if (without_words(scene["ask"][i]) == without_words(asked))
      source.refuse({"ask", std::to_string(i)}, "this is asked already");
  add_entry(now, "/ask", scene["ask"].size(), entry);
  return now;
}

std::string without_question(const std::string& text, const Json& asked) {
  const Source source = source_of(text);
  const Json ask = source.json().contains("ask") ? source.json()["ask"] : Json();
  std::string now = text;
  if (ask.is_string() && ask == asked) {
    const Spans::Span all = *Spans(text).at("/ask");
    now.replace(all.begin, all.end - all.begin, "[]");
    return now;
  }
  auto found = ask.is_array() ? std::ranges::find(ask, asked) : ask.end();
  if (found == ask.end() && ask.is_array())  // what stands beside it, words or a camera, goes with it
    found = std::ranges::find(ask, without_words(asked), without_words);
  if (found == ask.end()) source.refuse({"ask"}, "this is not asked");
  remove_entry(now, "/ask", static_cast<std::size_t>(found - ask.begin()));
  return now;
}

bool is_about(const Json& asked, const std::string& name) {
  if (asked == "all pairs") return true;
  for (const char* field : {"hierarchy", "walk"})
    if (asked.is_object() && asked.contains(field) && asked[field] == "all") return true;
  return !places_of(asked, "", name).empty();
}

std::string with_corner(const std::string& text, const std::string& name, int corner, const viz::Vec3& place) {
  const Source source = source_of(text);
  const CornerPlace behind = corner_place(source, name, corner);
  if (const std::size_t count = corners_of(behind.object); count >= most_knobs)
    source.refuse(behind.path, fmt::format("{} has {} corners, the most that can be dragged", name, count));
  Json entry = Json::array();
  for (std::size_t i = 0; i < behind.outline[behind.index].size(); ++i) {
    const double way = behind.object.contains("at") ? behind.object["at"][i].get<double>() : 0;
    entry.push_back(place[static_cast<int>(i)] - way);
  }
  std::string now = text;
  add_entry_behind(now, behind.list, behind.index, on_one_line(entry));
  return now;
}

std::string without_corner(const std::string& text, const std::string& name, int corner) {
  const Source source = source_of(text);
  const CornerPlace place = corner_place(source, name, corner);
  std::string now = text;
  remove_entry(now, place.list, place.index);
  return now;
}

}  // namespace isect::program::scene
