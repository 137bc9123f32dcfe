#include "viz/metadata_text.h"

#include <nlohmann/json.hpp>

namespace isect::viz {

using Json = nlohmann::ordered_json;

std::string metadata_text(const Metadata& metadata) {
  return Json(metadata).dump(-1, ' ', true, Json::error_handler_t::replace);
}

Metadata metadata_of_text(const std::string& text, const char* format) {
  try {
    return Json::parse(text).get<Metadata>();
  } catch (const Json::exception&) {
    throw FileError(std::string("broken ") + format + ": its metadata cannot be read");
  }
}

}  // namespace isect::viz
