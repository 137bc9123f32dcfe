#include "viz/formats/metadata_text.h"

#include <nlohmann/json.hpp>

namespace isect::viz {

using Keyed = nlohmann::json;  // sorted: a file made to have very many keys is read no slower for it

std::string metadata_text(const Metadata& metadata) {
  return Keyed(metadata).dump(-1, ' ', true, Keyed::error_handler_t::replace);
}

Metadata metadata_of_text(const std::string& text, const char* format) {
  try {
    return Keyed::parse(text).get<Metadata>();
  } catch (const Keyed::exception&) {
    throw FileError(std::string("broken ") + format + ": its metadata cannot be read");
  }
}

}  // namespace isect::viz
