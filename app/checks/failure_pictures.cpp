#include "app/checks/failure_pictures.h"

#include <fmt/format.h>

#include "app/figures/ownership.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

std::string sibling(const std::string& baseline, const std::string& ending) {
  return baseline.substr(0, baseline.size() - std::string(".png").size()) + ending;
}

/// Writes a picture. Returns the name of the file, if it could be written.
std::string write(const std::string& file, const std::string& png, const std::string& folder, Failure& f) {
  if (png.empty()) return {};
  if (viz::is_there(file) && !made_for(metadata_in(file), folder, {})) {
    f.notes.push_back(fmt::format("not written: {} is there and was not made by isect", file));
    return {};
  }
  try {
    viz::write_file(file, png);
    return file;
  } catch (const viz::FileError& error) {
    f.notes.push_back(error.what());
    return {};
  }
}

}  // namespace

bool is_failure_picture(const fs::path& file) {
  const std::string name = file.filename();
  return name.ends_with(".new.png") || name.ends_with(".diff.png");
}

void write_failure_pictures(Failure& f, const std::string& folder) {
  f.fresh = write(sibling(f.baseline, ".new.png"), f.fresh_png, folder, f);
  f.difference = write(sibling(f.baseline, ".diff.png"), f.difference_png, folder, f);
}

void remove_failure_pictures(const std::string& baseline, const std::string& folder) {
  for (const std::string ending : {".new.png", ".diff.png"}) {
    const std::string file = sibling(baseline, ending);
    std::error_code ignored;  // it does no harm if they stay
    if (fs::exists(file, ignored) && made_for(metadata_in(file), folder, {})) fs::remove(file, ignored);
  }
}

}  // namespace isect::program
