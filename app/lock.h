#pragma once
// One process at a time, where several change the same file.

#include <string>

namespace isect::program {

/// Waits until no other process holds the lock of this file, which is made for it and gone afterwards. The system lets
/// go where a process ends, however it ends: a file left by one that was killed keeps nobody out. Throws
/// viz::FileError.
class Lock {
 public:
  explicit Lock(std::string file);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  std::string file_;
  int descriptor_ = -1;
};

}  // namespace isect::program
