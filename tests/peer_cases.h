#pragma once
// Cases from public test suites, with the truth from rational arithmetic elsewhere. The folder lies next to the
// repository, or where ISECT_PEER_CASES says.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace isect::tests {

struct PeerCase {
  std::string name;  ///< its file and its number there
  std::string kind;
  nlohmann::json content;
};

inline std::filesystem::path peer_folder() {
  const char* given = std::getenv("ISECT_PEER_CASES");
  return given ? given : ISECT_PEER_CASES_DEFAULT;
}

/// Every case of that kind, or of all kinds when it is empty, in the order of the files' names. References to a file's
/// table of rings are resolved.
inline std::vector<PeerCase> peer_cases(const std::string& kind = "") {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(peer_folder()))
    for (const auto& entry : std::filesystem::directory_iterator(peer_folder()))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());

  std::vector<PeerCase> found;
  for (const std::filesystem::path& file : files) {
    const nlohmann::json whole = nlohmann::json::parse(std::ifstream(file));
    const std::string its_kind = whole.at("kind");
    if (!kind.empty() && its_kind != kind) continue;
    int number = 0;
    for (nlohmann::json c : whole.at("cases")) {
      if (c.contains("rings") && c["rings"].is_object())
        c["rings"] = whole.at("rings_table").at(c["rings"].at("$ref").get<std::size_t>());
      found.push_back({file.filename().string() + " #" + std::to_string(number++), its_kind, std::move(c)});
    }
  }
  return found;
}

/// A number of a case; "inf", "-inf" and "nan" are texts there.
inline double peer_number(const nlohmann::json& json) {
  if (!json.is_string()) return json.get<double>();
  const std::string text = json;
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  return text == "-inf" ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

/// What a test says that finds no cases. ctest counts it as skipped.
inline std::string no_peer_cases() {
  return "skipped: no peer cases in " + peer_folder().string() + "; set ISECT_PEER_CASES to their folder";
}

}  // namespace isect::tests
