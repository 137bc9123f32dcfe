#pragma once
// A lock for one process at a time, where several change the same file.

#include <string>

namespace isect::program {

/// Waits until no other process holds the lock of this file, which is created for it and removed afterwards. The system
/// releases the lock when a process ends, however it ends: a file left by a killed process blocks nobody. Throws
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
