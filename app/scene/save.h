#pragma once
// Writes other numbers into the text of a scene file, and changes nothing else in it: comments and layout stay.

#include <string>

#include "app/scene/file.h"

namespace isect::program::scene {

/// Returns `text`, from which `file` was read, with these numbers. Throws viz::BadInput if one stands in another file.
std::string with_numbers(const std::string& text, const File& file, const viz::Parameters&);

/// A scene on the disk into which numbers are written back while it is open.
class KeptFile {
 public:
  /// Throws viz::FileError, also if it is no regular file: what came through a pipe can't be written back.
  explicit KeptFile(const std::string& path);
  /// Writes the numbers. Throws viz::BadInput, or viz::FileError if somebody has changed the file, which then stays.
  void save(const viz::Parameters&);
  /// Writes another text in the file's place, as save() does.
  void write(const std::string& text);
  std::string folder() const;

 private:
  /// Throws viz::FileError if somebody has changed the file.
  void require_same() const;
  void put(const std::string& text);

  std::string path_, text_;  ///< as it was read or written last
};

}  // namespace isect::program::scene
