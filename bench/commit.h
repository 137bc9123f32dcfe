#pragma once
// Which commit the programs that measure were built of: bench/commit.cmake asks git each time that one is built.

namespace isect::bench {

/// Its hash, with "-dirty" if a file was changed since; empty where the sources came without git.
extern const char* const commit;

}  // namespace isect::bench
