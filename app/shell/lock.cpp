#include "app/shell/lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "viz/formats/files.h"

namespace isect::program {

namespace {

/// Whether the locked file still exists: the previous holder may have removed it, and another process made a new one.
bool still_there(int descriptor, const std::string& file) {
  struct stat held, named;
  return ::fstat(descriptor, &held) == 0 && ::stat(file.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
         held.st_dev == named.st_dev;
}

}  // namespace

Lock::Lock(std::string file) : file_(std::move(file)) {
  for (;;) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0) break;
    while (::flock(descriptor_, LOCK_EX) != 0)
      if (errno != EINTR) break;  // a file system without locks: going on is better than refusing
    if (still_there(descriptor_, file_)) return;
    ::close(descriptor_);
  }
  throw viz::FileError(fmt::format("cannot lock '{}': {}", file_, std::strerror(errno)));
}

Lock::~Lock() {
  ::unlink(file_.c_str());  // before the lock is released, so that nobody locks a file that is gone
  ::close(descriptor_);
}

}  // namespace isect::program
