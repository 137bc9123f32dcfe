#pragma once
// Hard cases with true answers: the project's own, tests/cases, and those of public test suites where they are at hand.
// The public ones lie beside the repository, in shared/peer-cases, or where ISECT_PEER_CASES says.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace isect::tests {

struct PeerCase {
  std::string name;  ///< its file, its number there and its note
  std::string kind;
  nlohmann::json content;
  bool own;  ///< one of the project's cases
};

inline std::filesystem::path own_cases() { return ISECT_CASES; }

/// The folder of public cases; empty if there is none. Throws if a folder was named and isn't there.
inline std::filesystem::path public_cases() {
  if (const char* given = std::getenv("ISECT_PEER_CASES")) {
    if (!std::filesystem::is_directory(given))
      throw std::runtime_error(std::string("ISECT_PEER_CASES names no folder: ") + given);
    return given;
  }
  const std::filesystem::path repository = own_cases().parent_path().parent_path(),
                              beside = repository.parent_path() / "shared" / "peer-cases";
  return std::filesystem::is_directory(beside) ? beside : std::filesystem::path();
}

/// The cases of that folder and kind, or of all kinds when it is empty, in the order of the files' names. References to
/// a file's table of rings are resolved.
inline std::vector<PeerCase> cases_in(const std::filesystem::path& folder, const std::string& kind) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
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
      const std::string name = file.filename().string() + " #" + std::to_string(number++) + " " + c.value("note", "");
      found.push_back({name, its_kind, std::move(c), folder == own_cases()});
    }
  }
  return found;
}

/// The project's own cases, then the public ones.
inline std::vector<PeerCase> all_cases(const std::string& kind = "") {
  std::vector<PeerCase> all = cases_in(own_cases(), kind);
  if (const std::filesystem::path folder = public_cases(); !folder.empty())
    for (PeerCase& c : cases_in(folder, kind)) all.push_back(std::move(c));
  return all;
}

inline bool asks_for_floats(const nlohmann::json& c) { return c.value("scalar", "f64") == "f32"; }

/// A number of a case; "inf", "-inf" and "nan" are texts there.
inline double peer_number(const nlohmann::json& json) {
  if (!json.is_string()) return json.get<double>();
  const std::string text = json;
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  return text == "-inf" ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}
/// The number as the case means it, where it may ask for floats: then the nearest float.
inline double peer_number(const nlohmann::json& json, bool f32) {
  const double x = peer_number(json);
  return f32 ? static_cast<float>(x) : x;
}

}  // namespace isect::tests
