#pragma once
// Other numbers written into the text of a scene file, and nothing else of it changed: comments and layout stay.

#include <string>

#include "app/scene/file.h"

namespace isect::program::scene {

/// `text` is what `file` was read from. Throws viz::BadInput where a number stands in another file.
std::string with_numbers(const std::string& text, const File& file, const viz::Parameters&);

/// A scene on the disk into which numbers are written back while it is open.
class KeptFile {
 public:
  /// Throws viz::FileError, also for what is no regular file: what came through a pipe can't be written back.
  explicit KeptFile(const std::string& path);
  /// Throws viz::BadInput, or viz::FileError where somebody else has changed the file since; it stays as it is then.
  void save(const viz::Parameters&);
  std::string folder() const;

 private:
  std::string path_, text_;  ///< as it was read or written last
};

}  // namespace isect::program::scene
