#pragma once
// Seeds that a target writes itself, in the format of the day: where ISECT_FUZZ_SEEDS names a folder, before it runs.

#include <cstdlib>
#include <fstream>
#include <string>

/// Returns the folder; empty if no seeds are asked for.
inline std::string seeds_folder() {
  const char* folder = std::getenv("ISECT_FUZZ_SEEDS");
  return folder ? folder : "";
}

/// Writes a seed: what selects the reader, then the text.
inline void write_seed(const std::string& name, int reader, const std::string& bytes) {
  std::ofstream out(seeds_folder() + "/" + name, std::ios::binary);
  out << static_cast<char>(reader) << bytes;
}
