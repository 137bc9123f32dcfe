#pragma once
// A folder for files that are thrown away.

#include <cstdlib>
#include <filesystem>
#include <string>

#include "viz/formats/files.h"

namespace isect::program {

class ScratchFolder {
 public:
  /// Throws viz::FileError if no folder can be made.
  ScratchFolder() : path_((std::filesystem::temp_directory_path() / "isect-XXXXXX").string()) {
    if (!mkdtemp(path_.data())) throw viz::FileError("no scratch folder " + path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace isect::program
