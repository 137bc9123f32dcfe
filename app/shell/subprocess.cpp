#include "app/shell/subprocess.h"

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>

#include "viz/formats/files.h"

namespace isect::program {
namespace {

/// Both ends of a pipe; each is closed once.
class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_.data()) != 0) throw viz::FileError(fmt::format("no pipe: {}", std::strerror(errno)));
  }
  ~Pipe() { close(0), close(1); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int end(int i) const { return ends_[i]; }
  void close(int i) {
    if (ends_[i] >= 0) ::close(ends_[i]);
    ends_[i] = -1;
  }
  /// Appends what is there; returns false at the end of the stream.
  bool drain(std::string& text) {
    std::array<char, 4096> chunk;
    const ssize_t got = ::read(ends_[0], chunk.data(), chunk.size());
    if (got < 0) return errno == EINTR;
    text.append(chunk.data(), static_cast<std::size_t>(got));
    return got > 0;
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

}  // namespace

std::string this_program() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw viz::FileError(fmt::format("/proc/self/exe: {}", error.message()));
  return self.string();
}

std::string beside(const std::string& name) {
  return (std::filesystem::path(this_program()).parent_path() / name).string();
}

CompletedProcess run_subprocess(const std::vector<std::string>& command,
                                const std::function<void(const std::string&)>& told) {
  Pipe out, talk;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out.end(1), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, talk.end(1), STDERR_FILENO);
  for (const Pipe* pipe : {&out, &talk})
    for (const int i : {0, 1}) posix_spawn_file_actions_addclose(&actions, pipe->end(i));
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t pid = 0;
  const auto start = std::chrono::steady_clock::now();
  const int failed = posix_spawnp(&pid, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw viz::FileError(fmt::format("{}: {}", command[0], std::strerror(failed)));
  out.close(1), talk.close(1);

  CompletedProcess process;
  std::string lines;
  std::array<pollfd, 2> waited = {pollfd{out.end(0), POLLIN, 0}, pollfd{talk.end(0), POLLIN, 0}};
  while (waited[0].fd >= 0 || waited[1].fd >= 0) {
    if (::poll(waited.data(), waited.size(), -1) < 0 && errno != EINTR) break;
    if (waited[0].fd >= 0 && waited[0].revents != 0 && !out.drain(process.output)) waited[0].fd = -1;
    if (waited[1].fd >= 0 && waited[1].revents != 0 && !talk.drain(lines)) waited[1].fd = -1;
    for (std::size_t stop; (stop = lines.find('\n')) != std::string::npos; lines.erase(0, stop + 1))
      told(lines.substr(0, stop));
  }
  int status = 0;
  rusage used{};
  while (::wait4(pid, &status, 0, &used) < 0 && errno == EINTR) {
  }
  process.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const timeval& part : {used.ru_utime, used.ru_stime})
    process.processor += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
  process.peak = static_cast<double>(used.ru_maxrss) * 1024e-6;
  process.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return process;
}

}  // namespace isect::program
