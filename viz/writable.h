#pragma once
// Whether a file can be written, asked before there is anything to write.

#include <string>

namespace isect::viz {

/// Throws the FileError of write_file (viz/files.h) as far as it is known beforehand. Makes the folder, as that does.
void need_writable(const std::string& path);

}  // namespace isect::viz
