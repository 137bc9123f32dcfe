#include "viz/player/reader_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "viz/compose/compose.h"
#include "viz/player/direction.h"

namespace isect::viz {

namespace {

using Json = nlohmann::ordered_json;

Json json(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json json(const Parameters& parameters) {
  Json object = Json::object();
  for (const auto& [name, value] : parameters) {
    if (const auto* v = std::get_if<Vec3>(&value)) {
      object[name] = json(*v);
    } else if (const auto* x = std::get_if<double>(&value)) {
      object[name] = *x;
    } else {
      object[name] = std::get<std::string>(value);
    }
  }
  return object;
}

double in_radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Returns the number of fewest digits that is read as this angle, so that 30 stays 30; else the nearest one.
double in_degrees(double radians) {
  const double near = radians / std::numbers::pi * 180;
  for (int digits = 1; digits <= 17; ++digits) {
    const double degrees = std::stod(fmt::format("{:.{}g}", near, digits));
    if (in_radians(degrees) == radians) return degrees;
  }
  double below = near, above = near;  // both conversions round, by a few ulps at most
  for (int ulps = 1; ulps <= 4; ++ulps) {
    below = std::nextafter(below, -HUGE_VAL), above = std::nextafter(above, HUGE_VAL);
    if (in_radians(below) == radians) return below;
    if (in_radians(above) == radians) return above;
  }
  return near;
}

double within_a_turn(double radians) {
  constexpr double turn = 2 * std::numbers::pi;
  return std::abs(radians) > turn ? std::remainder(radians, turn) : radians;
}

Json json(const Camera& camera) {
  return {{"angles", "degrees"},
          {"target", json(camera.target)},
          {"azimuth", in_degrees(within_a_turn(camera.azimuth))},
          {"elevation", in_degrees(camera.elevation)},
          {"half_height", camera.half_height},
          {"perspective", camera.perspective},
          {"field_of_view", in_degrees(camera.field_of_view)}};
}

/// Our files never nest deeper; deeper JSON would overflow the stack: the library writes JSON by recursion.
constexpr int deepest = 16;

/// Parses the whole text strictly: the library would take the last of two fields, and end at a NUL byte.
Json parse(const std::string& field, const std::string& text) try {
  if (text.find('\0') != text.npos) throw BadInput(fmt::format("{}: not JSON; there is a NUL byte in it", field));
  std::vector<std::set<std::string>> open;  // the keys of each object that has not ended yet
  return Json::parse(text, [&](int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > deepest) throw BadInput(fmt::format("{}: nested more than {} levels deep", field, deepest));
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
      throw BadInput(fmt::format("{}: {} is given twice", field, parsed.dump()));
    return true;
  });
} catch (const Json::exception& e) {
  const std::string why = e.what();  // "[json.exception...] parse error at line 1, column 3: ..."
  throw BadInput(fmt::format("{}: not JSON; {}", field, why.substr(why.find(']') + 2)));
}

/// Throws BadInput unless the object has only these fields; `path` says where it stands.
void only_fields(const Json& object, const std::string& path, const std::vector<std::string>& allowed) {
  if (!object.is_object()) throw BadInput(fmt::format("{}: {} is no JSON object", path, object.dump()));
  for (const auto& item : object.items())
    if (std::ranges::find(allowed, item.key()) == allowed.end()) throw unknown("field of " + path, item.key(), allowed);
}

std::string text_of(const Json& value, const std::string& field) {
  if (!value.is_string()) throw BadInput(fmt::format("{}: {} is no text", field, value.dump()));
  return value.get<std::string>();
}

double number_of(const Json& value, const std::string& field, double lo, double hi,
                 const std::string& unit = "a number") {
  const double x = value.is_number() ? value.get<double>() : NAN;
  if (!(x >= lo && x <= hi))
    throw BadInput(fmt::format("{}: {} is not allowed; give {} from {} to {}", field, value.dump(), unit, lo, hi));
  return x;
}

Vec3 point_of(const Json& value, const std::string& field) {
  const bool good =
      value.is_array() && value.size() == 3 && std::ranges::all_of(value, [](const Json& x) { return x.is_number(); });
  if (!good)
    throw BadInput(fmt::format("{}: {} is not allowed; give three numbers, such as [0, 1, 0]", field, value.dump()));
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

Parameters parameters_of(const Json& object, const Lesson& lesson, Parameters parameters) {
  std::vector<std::string> names;
  for (const Parameter& p : lesson.parameters) names.push_back(p.name);
  only_fields(object, "parameters", names);
  for (const auto& item : object.items()) {
    const Json& value = item.value();
    if (value.is_number()) {
      parameters.insert_or_assign(item.key(), value.get<double>());
    } else if (value.is_string()) {
      parameters.insert_or_assign(item.key(), value.get<std::string>());
    } else {
      parameters.insert_or_assign(item.key(), point_of(value, item.key()));
    }
  }
  validate(lesson, parameters);
  return parameters;
}

enum class Angles { degrees, radians };
constexpr double widest_in_radians = 3.1;

/// Angles are in degrees; files of older versions had radians. Those name the field of view, at most 3.1 in radians,
/// which in degrees would be a mere slit. What people wrote themselves may be either, if all angles are as small as
/// radians are.
Angles angles_of(const Json& camera, const Lesson& lesson) {
  if (camera.contains("angles")) {
    const std::string unit = text_of(camera["angles"], "camera angles");
    if (unit != "degrees" && unit != "radians") throw unknown("camera angles", unit, {"degrees", "radians"});
    return unit == "degrees" ? Angles::degrees : Angles::radians;
  }
  const auto of = [&](const std::string& field) {
    return camera.contains(field) && camera[field].is_number() ? camera[field].get<double>() : 0;
  };
  if (camera.contains("field_of_view"))
    return of("field_of_view") > widest_in_radians ? Angles::degrees : Angles::radians;
  const double most = std::max(std::abs(of("azimuth")), std::abs(of("elevation")));
  if (most == 0 || most > 3.15 || lesson.flat) return Angles::degrees;
  const std::string field = std::abs(of("azimuth")) == most ? "azimuth" : "elevation";
  throw BadInput(
      fmt::format("camera {}: {} can be degrees, or radians as in older files; add \"angles\": \"degrees\" or "
                  "\"angles\": \"radians\" to the camera",
                  field, camera[field].dump()));
}

/// Returns a camera in this direction with the whole walk in the frame.
Camera framed(const Camera& direction, const Walk& walk) {
  return frame_alike(direction, walk, {walk}, picture_aspect(walk, ThemeName::screen, 960, 600));
}

/// Reads a camera. Where only a direction is given, in degrees, the walk is framed from there.
Camera camera_of(const Json& object, const Lesson& lesson, const Parameters& parameters) {
  only_fields(object, "camera",
              {"angles", "target", "azimuth", "elevation", "half_height", "perspective", "field_of_view"});
  Camera camera = opening(lesson);
  const bool degrees = angles_of(object, lesson) == Angles::degrees;
  struct Range {
    double lo, hi;
  };
  const auto angle = [&](const std::string& field, double& to, Range of_degrees, Range of_radians) {
    if (!object.contains(field)) return;
    const auto& [lo, hi] = degrees ? of_degrees : of_radians;
    const double given = number_of(object[field], "camera " + field, lo, hi, degrees ? "degrees" : "radians");
    to = degrees ? in_radians(given) : given;
  };
  if (object.contains("target")) camera.target = point_of(object["target"], "camera target");
  angle("azimuth", camera.azimuth, {-360, 360}, {-1e6, 1e6});
  angle("elevation", camera.elevation, {-90, 90}, {-std::numbers::pi / 2, std::numbers::pi / 2});
  angle("field_of_view", camera.field_of_view, {0.5, 178}, {0.01, widest_in_radians});
  if (object.contains("half_height"))
    camera.half_height = number_of(object["half_height"], "camera half_height", 1e-300, 1e300);
  if (object.contains("perspective")) {
    const Json& value = object["perspective"];
    if (!value.is_boolean())
      throw BadInput(fmt::format("camera perspective: {} is not allowed; give true or false", value.dump()));
    camera.perspective = value.get<bool>();
  }
  if (lesson.flat && (camera.azimuth != 0 || camera.elevation != 0 || camera.perspective))
    throw BadInput(fmt::format(
        "camera: {} lies in one plane and is seen straight on; leave azimuth, elevation and perspective out",
        lesson.id));
  const bool turned = object.contains("azimuth") || object.contains("elevation");
  const bool placed = object.contains("target") || object.contains("half_height");
  return degrees && turned && !placed ? framed(camera, lesson.walk(parameters)) : camera;
}

int step_of(const Json& value, std::size_t steps) {
  const bool good =
      value.is_number_integer() && value.get<double>() >= 1 && value.get<double>() <= static_cast<double>(steps);
  if (!good) throw BadInput(fmt::format("step: {} is unknown; give a number from 1 to {}", value.dump(), steps));
  return value.get<int>() - 1;
}

/// Returns the motion of a step, from 0. Throws BadInput if nothing moves in it.
const Scene::Time& motion_of(const Walk& walk, int step) {
  const auto& time = walk.steps.at(static_cast<std::size_t>(step)).scene.time;
  if (!time) throw BadInput(fmt::format("time: nothing moves at step {} of this setting", step + 1));
  return *time;
}

OtherSide beside_of(const Json& object, const Lesson& lesson) {
  only_fields(object, "beside", {"method", "preset"});
  if (object.size() != 1) throw BadInput("beside: give either a method or a preset");
  OtherSide side;
  if (object.contains("preset")) {
    side.preset = preset(lesson, text_of(object["preset"], "beside preset")).id;
    return side;
  }
  side.method = text_of(object["method"], "beside method");
  for (const Parameter& p : lesson.parameters)
    if (p.name == lesson.group_by && std::ranges::find(p.choices, side.method) == p.choices.end())
      throw unknown("beside method", side.method, p.choices);
  if (lesson.group_by.empty()) throw BadInput(fmt::format("beside method: {} has one method alone", lesson.id));
  return side;
}

ReaderState state_of(const Json& object, const std::vector<const Lesson*>& lessons) {
  // "guard" is for `isect check` alone.
  only_fields(object, "the state", {"lesson", "preset", "step", "parameters", "camera", "beside", "time", "guard"});
  if (!object.contains("lesson")) throw BadInput("lesson: missing; the state of which lesson is it?");
  const Lesson& lesson = lesson_named(lessons, text_of(object["lesson"], "lesson"));
  ReaderState state;
  state.lesson = lesson.id;

  Parameters parameters;
  for (const Parameter& p : lesson.parameters)
    if (!p.optional) parameters.emplace(p.name, p.initial);
  if (object.contains("preset")) state.preset = text_of(object["preset"], "preset");
  if (!state.preset.empty()) parameters = preset(lesson, state.preset).parameters;
  if (object.contains("parameters")) parameters = parameters_of(object["parameters"], lesson, parameters);
  state.parameters = parameters;

  if (object.contains("camera")) state.camera = camera_of(object["camera"], lesson, parameters);
  if (object.contains("beside")) state.beside = beside_of(object["beside"], lesson);
  if (!object.contains("step")) {
    if (object.contains("time")) throw BadInput("time: of which step is it? Give \"step\", too");
    return state;
  }
  const Walk walk = lesson.walk(parameters);
  state.step = step_of(object["step"], walk.steps.size());
  if (object.contains("time")) {
    const Scene::Time& motion = motion_of(walk, *state.step);
    state.time = number_of(object["time"], "time", motion.lo, motion.hi);
  }
  return state;
}

}  // namespace

Camera seen_from(const Lesson& lesson, const Walk& walk, double azimuth, double elevation) {
  Camera camera = opening(lesson);
  camera.azimuth = in_radians(azimuth), camera.elevation = in_radians(elevation);
  return framed(camera, walk);
}

double checked_time(const Walk& walk, int step, double t) {
  const Scene::Time& motion = motion_of(walk, step);
  return number_of(Json(t), "time", motion.lo, motion.hi);
}

std::string to_json(const Parameters& parameters) { return json(parameters).dump(); }

std::string to_json(const ReaderState& state) {
  std::string text = fmt::format("{{\n  \"lesson\": {}", Json(state.lesson).dump());
  if (!state.preset.empty()) text += fmt::format(",\n  \"preset\": {}", Json(state.preset).dump());
  if (state.step) text += fmt::format(",\n  \"step\": {}", *state.step + 1);
  if (state.time) text += fmt::format(",\n  \"time\": {}", Json(*state.time).dump());
  if (state.parameters) text += fmt::format(",\n  \"parameters\": {}", to_json(*state.parameters));
  if (state.camera) text += fmt::format(",\n  \"camera\": {}", json(*state.camera).dump());
  if (const auto& side = state.beside; side && side->method.empty())
    text += fmt::format(",\n  \"beside\": {}", Json{{"preset", side->preset}}.dump());
  else if (side)
    text += fmt::format(",\n  \"beside\": {}", Json{{"method", side->method}}.dump());
  return text + "\n}\n";
}

ReaderState reader_state_from_json(const std::string& text, const std::vector<const Lesson*>& lessons) {
  return state_of(parse("the state", text), lessons);
}

Metadata metadata(const ReaderState& state) {
  Metadata data{{"lesson", state.lesson}, {"version", version()}};
  if (state.step) data["step"] = std::to_string(*state.step + 1);
  if (!state.preset.empty()) data["preset"] = state.preset;
  if (state.time) data["time"] = Json(*state.time).dump();
  if (state.parameters) data["parameters"] = to_json(*state.parameters);
  if (state.camera) data["camera"] = json(*state.camera).dump();
  return data;
}

ReaderState reader_state_from_metadata(const Metadata& data, const std::vector<const Lesson*>& lessons) {
  if (!data.contains("lesson")) throw BadInput("lesson: the picture names none, so it was not made by isect");
  Json object;
  for (const std::string field : {"lesson", "preset"})
    if (data.contains(field)) object[field] = data.at(field);
  for (const std::string field : {"step", "time", "parameters", "camera"})
    if (data.contains(field)) object[field] = parse(field, data.at(field));
  return state_of(object, lessons);
}

const Lesson& lesson_named(const std::vector<const Lesson*>& lessons, const std::string& id) {
  std::vector<std::string> ids;
  for (const Lesson* lesson : lessons) {
    if (lesson->id == id) return *lesson;
    ids.push_back(lesson->id);
  }
  throw unknown("lesson", id, ids);
}

std::string version() { return ISECT_VERSION; }

}  // namespace isect::viz
