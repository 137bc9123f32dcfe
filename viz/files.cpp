#include "viz/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace isect::viz {
namespace {

[[noreturn]] void fail(const std::string& verb, const std::string& path, int reason) {
  throw FileError("cannot " + verb + " '" + path + "': " + std::strerror(reason));
}

/// An open file descriptor, closed at the end of its scope.
class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  /// Some file systems report a failed write only here.
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

/// Writes all bytes into a new file; 0, or the reason why not, and then there is no file.
int write_new(const std::string& path, const std::string& bytes) {
  Descriptor file(path, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.open()) return errno;
  int reason = 0;
  for (std::size_t done = 0; done < bytes.size() && reason == 0;) {
    const ssize_t n = ::write(file.get(), bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno != EINTR) reason = errno;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  if (!file.close() && reason == 0) reason = errno;
  if (reason != 0) ::unlink(path.c_str());
  return reason;
}

/// A name beside `path`, another one at each call.
std::string name_beside(const std::string& path) {
  static std::atomic<unsigned> count = 0;
  return path + ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

}  // namespace

void write_file(const std::string& path, const std::string& bytes) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) fail("write", path, error.value());

  std::string beside;
  int reason = 0;
  do {
    beside = name_beside(path);
    reason = write_new(beside, bytes);
  } while (reason == EEXIST);
  if (reason != 0) fail("write", path, reason);
  if (::rename(beside.c_str(), path.c_str()) == 0) return;
  reason = errno;
  ::unlink(beside.c_str());
  fail("write", path, reason);
}

std::string read_file(const std::string& path) {
  const Descriptor file(path, O_RDONLY);
  if (!file.open()) fail("read", path, errno);
  std::string bytes;
  char block[1 << 16];
  while (true) {
    const ssize_t n = ::read(file.get(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("read", path, errno);
    if (n == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(n));
  }
}

}  // namespace isect::viz
