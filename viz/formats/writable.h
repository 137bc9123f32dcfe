#pragma once
// Whether a file can be written, checked before there is anything to write.

#include <string>

namespace isect::viz {

/// Throws the FileError of write_file (viz/formats/files.h) as far as it can be foreseen. Makes the folder, as
/// write_file does.
void need_writable(const std::string& path);

}  // namespace isect::viz
