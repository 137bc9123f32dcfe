#pragma once
// Shared by the parts of a trace: ordered JSON, and access that never fails.

#include <nlohmann/json.hpp>
#include <string>

namespace isect::viz::snap {

using Json = nlohmann::ordered_json;

/// Reads a file of ours; discarded if it is no JSON, or nests deeper than any of ours does. The library copies,
/// compares and writes by recursion, which would overflow the stack.
inline Json parsed(const std::string& text) {
  constexpr int deepest = 64;
  bool shallow = true;
  const auto watch = [&](int depth, Json::parse_event_t, const Json&) { return shallow = shallow && depth <= deepest; };
  Json json = Json::parse(text, watch, false);
  return shallow ? json : Json(Json::value_t::discarded);
}

/// Returns a text as it is, everything else as JSON.
inline std::string shown(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// Returns the member `key`; the text "absent" if there is none.
inline const Json& at(const Json& object, const std::string& key) {
  static const Json absent = "absent";
  return object.is_object() && object.contains(key) ? object.at(key) : absent;
}

}  // namespace isect::viz::snap
