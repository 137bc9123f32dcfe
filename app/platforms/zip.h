#pragma once
// Several files in one: packages for learning platforms are zip archives.

#include <string>
#include <vector>

namespace isect::program::platforms {

struct ZipEntry {
  std::string name;  ///< its path in the archive: "items/question-1.xml"
  std::string bytes;
};

/// Returns an archive of these files, in their order. Same input, same bytes: each file has the date 1980-01-01, the
/// first that an archive can have. The archive ends with the comment, at most 65,535 bytes of ASCII. Throws
/// viz::FileError if it can't be made, mostly for want of memory.
std::string zip_archive(const std::vector<ZipEntry>&, const std::string& comment);

}  // namespace isect::program::platforms
