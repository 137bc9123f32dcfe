// GeoJSON (RFC 7946): polygons, and objects that contain some. nlohmann's parser reads the JSON.

#include <nlohmann/json.hpp>
#include <set>

#include "app/scene/files/polygon_builder.h"
#include "app/scene/files/reading.h"
#include "app/scene/spans.h"

namespace isect::program::scene {

namespace {

using GeoPath = std::string;  ///< "/features/3/geometry"

class GeoJsonReader {
 public:
  GeoJsonReader(const std::string& bytes, const std::string& file)
      : file_(file),
        without_mark_(bytes.starts_with("\xef\xbb\xbf") ? bytes.substr(3) : ""),
        text_(without_mark_.empty() ? bytes : without_mark_),
        polygons_([this](const std::string& why) { refuse(at_, why); }) {}

  ShapeFile read() {
    read(parsed(), "", 0);
    return polygons_.made();
  }

 private:
  nlohmann::json parsed() const {
    using Event = nlohmann::json::parse_event_t;
    std::vector<std::set<std::string>> keys;  ///< of the objects that are open
    std::optional<std::string> twice;
    const auto watch = [&](int, Event event, const nlohmann::json& json) {
      if (event == Event::object_start) keys.emplace_back();
      if (event == Event::object_end) keys.pop_back();
      if (event == Event::key && !keys.back().insert(json.get<std::string>()).second && !twice)
        twice = json.get<std::string>();
      return true;
    };
    try {
      nlohmann::json all = nlohmann::json::parse(text_, watch);
      if (twice) refuse_key_given_twice(*twice);
      return all;
    } catch (const nlohmann::json::parse_error& e) {
      refuse_at(std::min(e.byte, text_.size()), "no JSON from here on: " + reason(e.what()));
    } catch (const nlohmann::json::out_of_range& e) {
      const std::string told = e.what(), number = told.substr(std::min(told.find('\''), told.size() - 1) + 1);
      refuse_at(std::min(text_.find(number.substr(0, number.find('\''))), text_.size()), "a number beyond all doubles");
    }
  }
  /// Returns the last part of the parser's sentence.
  static std::string reason(const std::string& what) {
    const std::size_t dash = what.find(" - ");
    return dash == what.npos ? what.substr(what.find("] ") + 2) : what.substr(dash + 3);
  }

  [[noreturn]] void refuse_at(std::size_t byte, const std::string& why) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(byte);
    scene::refuse(file_, fmt::format("line {}: {}", 1 + std::count(text_.begin(), end, '\n'), why));
  }
  /// Throws with the value's place, which is looked up only here.
  [[noreturn]] void refuse(const GeoPath& path, const std::string& why) const {
    const Spans spans(text_);
    const Spans::Span* const span = spans.at(path);
    refuse_at(span ? span->begin : 0, why);
  }

  [[noreturn]] void refuse_key_given_twice(const std::string& key) const {
    const Spans spans(text_);
    const std::string why = in_quotes(key) + " is given twice";
    if (spans.twice().empty()) refuse_at(std::min(spans.too_deep(), text_.size()), why);
    refuse(spans.twice().front(), why);
  }

  void read(const nlohmann::json& json, const GeoPath& path, int level) {
    if (!json.is_object() || !json.contains("type") || !json["type"].is_string())
      refuse(path, "an object with a \"type\" is expected");
    const std::string type = json["type"];
    if (level > 8) refuse(path, "collections within collections");
    if (type == "FeatureCollection") return each(json, path, "features", level);
    if (type == "GeometryCollection") return each(json, path, "geometries", level);
    if (type == "Feature") {
      if (!json.contains("geometry")) refuse(path, "a feature without a \"geometry\"");
      return json["geometry"].is_null() ? void() : read(json["geometry"], path + "/geometry", level + 1);
    }
    if (type != "Polygon" && type != "MultiPolygon")
      refuse(path, fmt::format("{}; Polygon and MultiPolygon are read, and collections of them", in_quotes(type)));
    const GeoPath to = path + "/coordinates";
    const nlohmann::json& coordinates = list(json, path, "coordinates");
    if (type == "Polygon") return polygon(coordinates, to);
    for (std::size_t i = 0; i < coordinates.size(); ++i) polygon(coordinates[i], fmt::format("{}/{}", to, i));
  }

  const nlohmann::json& list(const nlohmann::json& json, const GeoPath& path, const char* name) const {
    if (!json.contains(name) || !json[name].is_array()) refuse(path, fmt::format("a list \"{}\" is expected", name));
    return json[name];
  }
  void each(const nlohmann::json& json, const GeoPath& path, const char* name, int level) {
    const nlohmann::json& all = list(json, path, name);
    for (std::size_t i = 0; i < all.size(); ++i) read(all[i], fmt::format("{}/{}/{}", path, name, i), level + 1);
  }

  void polygon(const nlohmann::json& rings, const GeoPath& path) {
    if (!rings.is_array()) refuse(path, "a list of outlines is expected");
    if (!rings.empty()) polygons_.begin_polygon();
    for (std::size_t i = 0; i < rings.size(); ++i) {
      at_ = fmt::format("{}/{}", path, i);
      if (!rings[i].is_array()) refuse(at_, "a list of positions is expected");
      polygons_.begin_ring();
      for (const nlohmann::json& one : rings[i]) position(one);
      polygons_.end_ring();
    }
  }

  void position(const nlohmann::json& json) {
    const auto is_number = [](const nlohmann::json& x) { return x.is_number(); };
    if (!json.is_array() || json.size() < 2 || json.size() > 3 || !std::ranges::all_of(json, is_number))
      refuse(at_, fmt::format("{} is no position; two or three numbers are expected", shown(json)));
    viz::Vec3 p = viz::Vec3::Zero();
    for (std::size_t i = 0; i < json.size(); ++i) p[static_cast<int>(i)] = json[i].get<double>();
    polygons_.position(p, json.size());
  }

  /// Shows a value without its nested contents: these may be deep.
  static std::string shown(const nlohmann::json& json) {
    if (json.is_object()) return "an object";
    const bool nested = std::ranges::any_of(json, [](const nlohmann::json& x) { return x.is_structured(); });
    return nested ? "a list of lists" : shortened(json.dump(-1, ' ', true));
  }

  const std::string& file_;
  const std::string without_mark_;  ///< the text behind a byte order mark
  const std::string& text_;
  GeoPath at_;  ///< the path of the outline being read
  PolygonBuilder polygons_;
};

}  // namespace

ShapeFile read_geojson(const std::string& bytes, const std::string& file) { return GeoJsonReader(bytes, file).read(); }

}  // namespace isect::program::scene
