#pragma once
// Names in the system's folder for temporary files that no other run of the tests has.

#include <unistd.h>

#include <filesystem>
#include <string>

namespace isect::test {

inline std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::temp_directory_path() / (name + "-" + std::to_string(::getpid()));
}

}  // namespace isect::test
