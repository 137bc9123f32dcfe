#include "viz/formats/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>

#include "viz/formats/writable.h"

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
  /// Closes the file; some file systems report a failed write only here.
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

/// Writes all bytes. Returns 0, or the reason why not.
int send(int descriptor, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno != EINTR) return errno;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  return 0;
}

/// Returns the descriptor of standard output or error if `file` is one of them, however it is named; -1 otherwise.
int own_stream(const struct stat& file) {
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own;
    if (::fstat(descriptor, &own) == 0 && own.st_dev == file.st_dev && own.st_ino == file.st_ino) return descriptor;
  }
  return -1;
}

/// Writes into the existing file, device or pipe. Returns 0, or the reason why not.
int write_in_place(const std::string& path, const struct stat& there, const std::string& bytes) {
  if (const int stream = own_stream(there); stream >= 0) return send(stream, bytes);
  Descriptor file(path, O_WRONLY | O_NOCTTY);
  if (!file.open()) return errno;
  const int reason = send(file.get(), bytes);
  return !file.close() && reason == 0 ? errno : reason;
}

/// A new file that nobody else writes to or sweeps away as long as it is open.
class NewFile {
 public:
  explicit NewFile(const std::string& path) : file_(path, O_WRONLY | O_CREAT | O_EXCL), path_(path) {
    struct stat made;
    if (!file_.open()) {
      reason_ = errno;
    } else if (::flock(file_.get(), LOCK_EX | LOCK_NB) == 0 && ::fstat(file_.get(), &made) == 0 && made.st_nlink == 0) {
      reason_ = EEXIST;  // swept away before it was locked
    }
  }

  int reason() const { return reason_; }  ///< 0, or why there is no such file

  /// Takes these bytes, mode and owner of `old`, if there is one, and another name. Returns 0, or the reason why not,
  /// and then there is no file.
  int become(const std::string& name, const std::string& bytes, const struct stat* old) {
    int reason = send(file_.get(), bytes);
    // The file keeps its owner where this user may give files away. The mode is set last, as a new owner clears bits of
    // it.
    if (old && reason == 0) {
      [[maybe_unused]] const int given = ::fchown(file_.get(), old->st_uid, old->st_gid);
      if (::fchmod(file_.get(), old->st_mode & 07777) != 0) reason = errno;
    }
    if (reason == 0 && !flushed()) reason = errno;
    if (reason == 0 && ::rename(path_.c_str(), name.c_str()) != 0) reason = errno;
    if (reason != 0) ::unlink(path_.c_str());
    return reason;
  }

 private:
  /// Whether all is written: some file systems tell only at a close, and this descriptor stays open: it holds the lock.
  bool flushed() {
    const int copy = ::dup(file_.get());
    return copy >= 0 && ::close(copy) == 0;
  }

  Descriptor file_;
  std::string path_;
  int reason_ = 0;
};

constexpr const char* beside_mark = ".tmp-";

/// Removes what killed writes of this very file left behind: files whose lock nobody holds.
void sweep(const std::filesystem::path& path) {
  const std::string prefix = path.filename().string() + beside_mark;
  std::error_code unreadable;  // then nothing is swept
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    const std::string name = entry.path().filename();
    const bool ours = name.starts_with(prefix) && name.find_first_not_of("-0123456789", prefix.size()) == name.npos;
    if (!ours) continue;
    const Descriptor left(entry.path(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    if (left.open() && ::flock(left.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
  }
}

/// Returns a name beside `path`, another one at each call.
std::string name_beside(const std::string& path) {
  static std::atomic<unsigned> count = 0;
  return path + beside_mark + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

/// Returns the file at the end of all links; it need not exist. Loops are found before this is called.
std::string without_links(std::filesystem::path path) {
  std::error_code no_link;  // this is the file then
  for (std::filesystem::path to; to = std::filesystem::read_symlink(path, no_link), !no_link;)
    path = to.is_absolute() ? to : path.parent_path() / to;
  return path;
}

/// Writes a file beside, then renames it. Returns 0, or the reason why not.
int replace(const std::string& path, const std::string& bytes, const struct stat* old) {
  sweep(path);
  for (;;) {
    NewFile beside(name_beside(path));
    if (beside.reason() == 0) return beside.become(path, bytes, old);
    if (beside.reason() != EEXIST) return beside.reason();
  }
}

/// Returns the state of what is there, if anything. Throws FileError where it may not be written to.
std::optional<struct stat> stat_to_write(const std::string& path) {
  struct stat there;
  const bool exists = ::stat(path.c_str(), &there) == 0;
  if (!exists && (errno != ENOENT || path.empty())) fail("write", path, errno);
  if (!exists) return {};
  if (S_ISDIR(there.st_mode)) fail("write", path, EISDIR);
  if (own_stream(there) < 0 && ::euidaccess(path.c_str(), W_OK) != 0) fail("write", path, errno);  // rename won't ask
  return there;
}

bool is_written_in_place(const struct stat& there) { return !S_ISREG(there.st_mode) || own_stream(there) >= 0; }

void make_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) fail("write", path, error.value());
}

/// Reads all that comes. Throws FileError on failure, and on more than `most` bytes.
std::string receive(int descriptor, const std::string& path, std::size_t most, std::size_t expected = 0) {
  std::string bytes;
  bytes.reserve(expected);
  char block[1 << 16];
  while (true) {
    const ssize_t n = ::read(descriptor, block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("read", path, errno);
    if (n == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(n));
    if (bytes.size() > most) fail("read", path, EFBIG);
  }
}

}  // namespace

void write_file(const std::string& path, const std::string& bytes) {
  const std::optional<struct stat> there = stat_to_write(path);
  if (there && is_written_in_place(*there)) {
    if (const int reason = write_in_place(path, *there, bytes); reason != 0) fail("write", path, reason);
    return;
  }
  make_folder_of(path);
  const std::string target = without_links(path);
  if (const int reason = replace(target, bytes, there ? &*there : nullptr); reason != 0)
    fail("write", target == path ? path : path + "', a link to '" + target, reason);
}

void need_writable(const std::string& path) {
  const std::optional<struct stat> there = stat_to_write(path);
  if (there && is_written_in_place(*there)) return;  // a pipe's reader would take a trial for the end
  make_folder_of(path);
  const std::string target = name_beside(without_links(path));
  if (const NewFile trial(target); trial.reason() != 0) fail("write", path, trial.reason());
  ::unlink(target.c_str());
}

std::string read_file(const std::string& path, std::size_t most) {
  const Descriptor file(path, O_RDONLY);
  if (!file.open()) fail("read", path, errno);
  return receive(file.get(), path, most);
}

std::string read_regular_file(const std::string& path) {
  const Descriptor file(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);
  struct stat there;
  if (!file.open() || ::fstat(file.get(), &there) != 0) fail("read", path, errno);
  if (S_ISDIR(there.st_mode)) fail("read", path, EISDIR);
  if (!S_ISREG(there.st_mode)) throw FileError("cannot read '" + path + "': not a regular file");
  constexpr std::size_t most_reserved = std::size_t{1} << 30;  // it may have holes, and be as large as it likes
  return receive(file.get(), path, std::string::npos, std::min(static_cast<std::size_t>(there.st_size), most_reserved));
}

bool is_there(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown) || unknown;
}

}  // namespace isect::viz
