// make_cases [DIR]: writes the hard cases, one file a kind, to DIR; without one, where the repository keeps them.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/cases/case_file.h"

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ISECT_CASES;
  for (const isect::cases::CaseFile& file : isect::cases::all()) {
    const std::filesystem::path path = folder / (file.kind() + ".json");
    std::ofstream out(path, std::ios::binary);
    if (!(out << file.text() << std::flush)) {
      std::fprintf(stderr, "make_cases: %s can't be written\n", path.c_str());
      return 4;
    }
    std::printf("%4zu %s\n", file.size(), path.c_str());
  }
}
