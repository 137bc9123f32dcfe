#pragma once
// A file that the user names to be read, which may be a pipe.

#include <string>

namespace isect::program {

/// Returns all contents of the file; "-" is the standard input. If nothing has come within a second, as from a pipe
/// that nobody writes to, stderr says that the program is waiting for it. Throws viz::FileError.
std::string read_named_file(const std::string& path);

}  // namespace isect::program
