#pragma once
// The commit from which the measuring programs were built: bench/commit.cmake asks git whenever one is built.

namespace isect::bench {

/// Its hash, with "-dirty" if a file was changed since; empty where the sources came without git.
extern const char* const commit;

}  // namespace isect::bench
