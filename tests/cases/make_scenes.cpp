// make_scenes [DIR]: writes the hard cases of a scene's pairs to DIR/plane.jsonl and DIR/space.jsonl; without a folder,
// where the repository keeps them.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/cases/case_file.h"
#include "tests/cases/scenes.h"

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ISECT_CASES "/scenes";
  std::filesystem::create_directories(folder);
  for (const bool flat : {true, false}) {
    const std::filesystem::path path = folder / (flat ? "plane.jsonl" : "space.jsonl");
    const std::vector<isect::cases::SceneJson> lines = isect::cases::scenes(flat);
    std::ofstream out(path, std::ios::binary);
    for (const isect::cases::SceneJson& line : lines) out << isect::cases::written(line) << '\n';
    if (!out.flush()) {
      std::fprintf(stderr, "make_scenes: %s can't be written\n", path.c_str());
      return 4;
    }
    std::printf("%5zu %s\n", lines.size(), path.c_str());
  }
}
