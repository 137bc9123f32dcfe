#pragma once
// A file that the user names to be read, which may be a pipe.

#include <string>

namespace isect::program {

/// All that it holds. Where nothing has come within a second, as from a pipe that nobody writes to, stderr says that it
/// is waited for. Throws viz::FileError.
std::string read_named_file(const std::string& path);

}  // namespace isect::program
