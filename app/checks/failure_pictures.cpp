#include "app/checks/failure_pictures.h"

#include <fmt/format.h>

#include "app/figures/ownership.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

/// Returns "03-foot.new.png" for "03-foot.png".
std::string sibling(const fs::path& baseline, const std::string& what) {
  return (baseline.parent_path() / (baseline.stem().string() + "." + what + baseline.extension().string())).string();
}

/// Writes a picture. Returns the name of the file, if it could be written.
std::string write_beside(const std::string& file, const std::string& bytes, const std::string& folder, Failure& f) {
  if (bytes.empty()) return {};
  if (viz::is_there(file) && !made_for(metadata_in(file), folder, {})) {
    f.notes.push_back(fmt::format("not written: {} is there and was not made by isect", file));
    return {};
  }
  try {
    viz::write_file(file, bytes);
    return file;
  } catch (const viz::FileError& error) {
    f.notes.push_back(error.what());
    return {};
  }
}

}  // namespace

bool is_failure_picture(const fs::path& file) {
  const std::string what = fs::path(file.stem()).extension();
  return what == ".new" || what == ".diff";
}

void write_failure_pictures(Failure& f, const std::string& folder) {
  f.fresh = write_beside(sibling(f.baseline, "new"), f.fresh_file, folder, f);
  f.difference = write_beside(sibling(f.baseline, "diff"), f.difference_file, folder, f);
}

void remove_failure_pictures(const std::string& baseline, const std::string& folder) {
  for (const std::string what : {"new", "diff"}) {
    const std::string file = sibling(baseline, what);
    std::error_code ignored;  // it does no harm if they stay
    if (fs::exists(file, ignored) && made_for(metadata_in(file), folder, {})) fs::remove(file, ignored);
  }
}

}  // namespace isect::program
