#include "app/scene/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/scene/questions.h"

namespace isect::program::scene {

namespace {

constexpr std::size_t most_objects = 200, most_vertices = 10'000;

using Path = std::vector<std::string>;  ///< keys, and numbers of entries: {"objects", "2", "lo"}

/// "objects[2].lo"
std::string told(const Path& path) {
  std::string text;
  for (const std::string& key : path) {
    const bool entry = key.find_first_not_of("0123456789") == key.npos;
    text += entry ? "[" + key + "]" : (text.empty() ? "" : ".") + key;
  }
  return text;
}

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {
    try {
      json_ = Json::parse(text, nullptr, true, true);
    } catch (const Json::parse_error& e) {
      throw viz::BadInput(fmt::format("line {}: no JSON; {}", line_at(e.byte > 0 ? e.byte - 1 : 0), reason(e.what())));
    }
  }

  File read() {
    only(json_, {}, {"title", "objects", "ask", "notes", "camera"});
    file_.text = json_.dump();
    file_.title = json_.contains("title") ? text(json_["title"], {"title"}) : "A scene";
    read_objects();
    read_questions();
    read_notes();
    if (json_.contains("camera")) read_camera();
    return std::move(file_);
  }

 private:
  // Where something stands, and what is wrong with it.

  int line_at(std::size_t byte) const {
    return 1 + static_cast<int>(std::count(
                   text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text_.size())), '\n'));
  }

  /// The last part of the parser's sentence.
  static std::string reason(const std::string& what) {
    const std::size_t dash = what.find(" - ");
    return dash == what.npos ? what.substr(what.find("] ") + 2) : what.substr(dash + 3);
  }

  /// The line of a field: its keys are looked for one after the other, entries of "objects" by how often they begin.
  int line_of(const Path& path) const {
    std::size_t at = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (i == 1 && path[0] == "objects") {
        for (int left = std::stoi(path[1]) + 1; left > 0 && at != text_.npos; --left) at = text_.find('{', at + 1);
      } else if (path[i].find_first_not_of("0123456789") != path[i].npos) {
        const std::size_t found = text_.find('"' + path[i] + '"', at);
        if (found != text_.npos) at = found;
      }
      if (at == text_.npos) return line_at(text_.size());
    }
    return line_at(at);
  }

  [[noreturn]] void refuse(const Path& path, const std::string& why) const {
    throw viz::BadInput(fmt::format("line {}: {}: {}", line_of(path), path.empty() ? "the file" : told(path), why));
  }

  void only(const Json& object, const Path& path, const std::vector<std::string>& allowed) const {
    if (!object.is_object()) refuse(path, "an object in braces is expected");
    for (const auto& [key, value] : object.items())
      if (std::ranges::find(allowed, key) == allowed.end()) {
        Path to = path;
        to.push_back(key);
        const std::string near = viz::nearest(key, allowed);
        refuse(to, fmt::format("unknown; did you mean \"{}\"? Allowed: {}", near, fmt::join(allowed, ", ")));
      }
  }

  const Json& member(const Json& object, const Path& path, const std::string& key) const {
    if (!object.contains(key)) refuse(path, fmt::format("\"{}\" is missing", key));
    return object[key];
  }

  static Path below(Path path, const std::string& key) {
    path.push_back(key);
    return path;
  }

  std::string text(const Json& value, const Path& path) const {
    if (!value.is_string()) refuse(path, "a text is expected");
    return value;
  }

  double number(const Json& value, const Path& path) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(path, "a finite number is expected");
    return value;
  }

  /// As many coordinates as the first one of the file has.
  viz::Vec3 vector(const Json& value, const Path& path) {
    const bool two = value.is_array() && value.size() == 2, three = value.is_array() && value.size() == 3;
    if (!two && !three) refuse(path, "two or three numbers are expected, as in [1, 2]");
    if (!dimension_known_) file_.flat = two, dimension_known_ = true;
    if (file_.flat != two)
      refuse(path, fmt::format("{} coordinates in a scene whose others have {}", value.size(), file_.flat ? 2 : 3));
    viz::Vec3 v = viz::Vec3::Zero();
    for (std::size_t i = 0; i < value.size(); ++i)
      v[static_cast<int>(i)] = number(value[i], below(path, std::to_string(i)));
    return v;
  }

  // Objects.

  void read_objects() {
    const Json& all = member(json_, {}, "objects");
    if (!all.is_array() || all.empty() || all.size() > most_objects)
      refuse({"objects"}, fmt::format("a list of 1 to {} objects is expected", most_objects));
    for (std::size_t i = 0; i < all.size(); ++i) read_object(all[i], {"objects", std::to_string(i)});
  }

  void read_object(const Json& json, const Path& path) {
    std::vector<std::string> names;
    for (const TypeSpec& t : types()) names.push_back(t.name);
    if (!json.is_object() || json.empty()) refuse(path, "an object such as {\"sphere\": \"A\", ...} is expected");
    const auto known = std::ranges::find_if(types(), [&](const TypeSpec& t) { return json.contains(t.name); });
    if (known == types().end()) {
      const std::string first = json.begin().key();
      refuse(below(path, first), fmt::format("no type of object; did you mean \"{}\"? Allowed: {}",
                                             viz::nearest(first, names), fmt::join(names, ", ")));
    }
    Object o = {known->type, text(json[known->name], below(path, known->name))};
    check_name(o.name, below(path, known->name));
    if (known->fields.empty())
      read_outline(json, path, o);
    else
      read_fields(json, path, *known, o);
    file_.objects.push_back(std::move(o));
  }

  void check_name(const std::string& name, const Path& path) const {
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
    if (name.empty() || name.size() > 16 || !std::ranges::all_of(name, fits) || (name[0] >= '0' && name[0] <= '9'))
      refuse(path, "a name of 1 to 16 letters and digits is expected, a letter first");
    if (std::ranges::find(file_.objects, name, &Object::name) != file_.objects.end())
      refuse(path, fmt::format("\"{}\" is the name of another object", name));
  }

  void read_fields(const Json& json, const Path& path, const TypeSpec& type, Object& o) {
    std::vector<std::string> allowed = {type.name};
    for (const FieldSpec& f : type.fields) allowed.push_back(f.name);
    only(json, path, allowed);
    for (const FieldSpec& f : type.fields) {
      if (!json.contains(f.name) && f.optional) continue;
      const Json& value = member(json, path, f.name);
      const Path to = below(path, f.name);
      viz::Setting& setting = file_.parameters[o.name + "." + f.name];
      if (f.kind == FieldSpec::Kind::number) {
        const double x = number(value, to);
        if (x < f.lo) refuse(to, fmt::format("{} is below {}", viz::to_text(x), viz::to_text(f.lo)));
        setting = x;
      } else {
        setting = vector(value, to);
      }
      if ((f.name == "dir" || f.name == "normal") && std::get<viz::Vec3>(setting).isZero(0))
        refuse(to, "a vector of any length but 0 is expected");
      o.fields.push_back(f.name);
    }
    if (type.type == Type::obb && json.contains("w") == file_.flat)
      refuse(path, file_.flat ? "a third axis w in the plane" : "\"w\", the third axis, is missing");
  }

  /// "points": a list of points; of a polygon with holes "rings": a list of such lists.
  void read_outline(const Json& json, const Path& path, Object& o) {
    const std::string type = spec(o.type).name;
    only(json, path,
         o.type == Type::polygon ? std::vector<std::string>{type, "points", "rings"}
                                 : std::vector<std::string>{type, "points"});
    if (json.contains("points") == json.contains("rings"))
      refuse(path, json.contains("rings") ? "give either \"points\" or \"rings\"" : "\"points\" is missing");
    if (json.contains("points")) {
      read_ring(json["points"], below(path, "points"), o);
    } else {
      const Path to = below(path, "rings");
      if (!json["rings"].is_array() || json["rings"].empty()) refuse(to, "a list of lists of points is expected");
      for (std::size_t i = 0; i < json["rings"].size(); ++i)
        read_ring(json["rings"][i], below(to, std::to_string(i)), o);
    }
    if (o.rings.size() > 1 && !file_.flat) refuse(path, "holes are for polygons in the plane");
  }

  void read_ring(const Json& ring, const Path& path, Object& o) {
    const std::size_t least = 3, most = o.type == Type::triangle ? 3 : most_vertices;
    if (!ring.is_array() || ring.size() < least || ring.size() > most)
      refuse(path,
             least == most ? "three points are expected" : fmt::format("{} to {} points are expected", least, most));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      o.fields.push_back(std::to_string(o.fields.size() + 1));
      file_.parameters[o.name + "." + o.fields.back()] = vector(ring[i], below(path, std::to_string(i)));
    }
    o.rings.push_back(static_cast<int>(ring.size()));
  }

  // Questions.

  std::size_t object_named(const Json& value, const Path& path) const {
    const std::string name = text(value, path);
    const auto found = std::ranges::find(file_.objects, name, &Object::name);
    if (found != file_.objects.end()) return static_cast<std::size_t>(found - file_.objects.begin());
    std::vector<std::string> names;
    for (const Object& o : file_.objects) names.push_back(o.name);
    refuse(path, fmt::format("no object is called \"{}\"; did you mean \"{}\"? There are {}", name,
                             viz::nearest(name, names), fmt::join(names, ", ")));
  }

  /// Points of one's own are seldom the same.
  bool worth_asking(Type a, Type b) const {
    return !(a == Type::point && b == Type::point) && can_ask(a, b, file_.flat);
  }

  void read_questions() {
    if (!json_.contains("ask")) return;
    const Json& ask = json_["ask"];
    if (ask == "all pairs") {
      for (std::size_t a = 0; a < file_.objects.size(); ++a)
        for (std::size_t b = a + 1; b < file_.objects.size(); ++b)
          if (worth_asking(file_.objects[a].type, file_.objects[b].type)) file_.asked.push_back(PairAsked{a, b});
      return;
    }
    if (!ask.is_array()) refuse({"ask"}, "a list of questions is expected, or \"all pairs\"");
    for (std::size_t i = 0; i < ask.size(); ++i) read_question(ask[i], {"ask", std::to_string(i)});
  }

  void read_question(const Json& json, const Path& path) {
    if (json.is_object()) {
      only(json, path, {"first hit"});
      const Path to = below(path, "first hit");
      const std::size_t ray = object_named(member(json, path, "first hit"), to);
      const Type type = file_.objects[ray].type;
      if (type != Type::ray && type != Type::line && type != Type::segment)
        refuse(to, fmt::format("\"{}\" is a {}; a ray, a line or a segment is expected", file_.objects[ray].name,
                               spec(type).name));
      file_.asked.push_back(FirstHitAsked{ray});
      return;
    }
    if (!json.is_array() || json.size() != 2)
      refuse(path, "two names are expected, as in [\"r\", \"A\"], or {\"first hit\": \"r\"}");
    const std::size_t a = object_named(json[0], path), b = object_named(json[1], path);
    if (a == b) refuse(path, "an object can't be asked about itself");
    const Object &x = file_.objects[a], &y = file_.objects[b];
    if (!can_ask(x.type, y.type, file_.flat))
      refuse(path, fmt::format("there is no test of a {} against a {} {}; a {} can be asked about: {}",
                               spec(x.type).name, spec(y.type).name, file_.flat ? "in the plane" : "in space",
                               spec(x.type).name, partners(x.type, file_.flat)));
    file_.asked.push_back(PairAsked{a, b});
  }

  void read_notes() {
    if (!json_.contains("notes")) return;
    if (!json_["notes"].is_array()) refuse({"notes"}, "a list of notes is expected");
    for (std::size_t i = 0; i < json_["notes"].size(); ++i) {
      const Path path = {"notes", std::to_string(i)};
      const Json& note = json_["notes"][i];
      only(note, path, {"at", "text"});
      file_.notes.push_back(
          {vector(member(note, path, "at"), below(path, "at")), text(member(note, path, "text"), below(path, "text"))});
    }
  }

  void read_camera() {
    constexpr double degree = std::numbers::pi / 180;
    const Json& camera = json_["camera"];
    only(camera, {"camera"}, {"azimuth", "elevation", "perspective"});
    if (camera.contains("azimuth")) file_.camera.azimuth = degree * number(camera["azimuth"], {"camera", "azimuth"});
    if (camera.contains("elevation")) {
      const double elevation = number(camera["elevation"], {"camera", "elevation"});
      if (std::abs(elevation) > 90) refuse({"camera", "elevation"}, "-90 to 90 degrees are expected");
      file_.camera.elevation = degree * elevation;
    }
    if (camera.contains("perspective")) {
      if (!camera["perspective"].is_boolean()) refuse({"camera", "perspective"}, "true or false is expected");
      file_.camera.perspective = camera["perspective"];
    }
  }

  const std::string& text_;
  Json json_;
  File file_;
  bool dimension_known_ = false;
};

}  // namespace

bool holds_objects(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false, true);
  if (!json.is_object() || !json.contains("objects") || !json["objects"].is_array()) return false;
  return std::ranges::any_of(json["objects"], [](const Json& o) {
    return o.is_object() && std::ranges::any_of(types(), [&](const TypeSpec& t) { return o.contains(t.name); });
  });
}

bool is_scene(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false, true);
  if (json.is_object()) return json.contains("objects");
  return json.is_discarded() && text.find("\"objects\"") != text.npos;  // meant as one, though broken
}

File read_scene(const std::string& text) { return Reader(text).read(); }

}  // namespace isect::program::scene
