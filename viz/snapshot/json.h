#pragma once
// What the parts of a trace share: ordered JSON, and access that never fails.

#include <nlohmann/json.hpp>
#include <string>

namespace isect::viz::snap {

using Json = nlohmann::ordered_json;

/// Text as it is, everything else as JSON.
inline std::string shown(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// The member `key`; the text "absent" where there is none.
inline const Json& at(const Json& object, const std::string& key) {
  static const Json absent = "absent";
  return object.is_object() && object.contains(key) ? object.at(key) : absent;
}

}  // namespace isect::viz::snap
