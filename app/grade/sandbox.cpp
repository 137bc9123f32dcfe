#include "app/grade/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/grade/container.h"
#include "app/shell/subprocess.h"
#include "viz/formats/files.h"

namespace isect::grade {

namespace {

using Clock = std::chrono::steady_clock;

/// Both ends of a pipe that no program inherits; each is closed once.
class Channel {
 public:
  Channel() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw viz::FileError(fmt::format("no pipe: {}", std::strerror(errno)));
  }
  ~Channel() { close(0), close(1); }
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  int end(int i) const { return ends_[i]; }
  bool is_open(int i) const { return ends_[i] >= 0; }
  void close(int i) {
    if (ends_[i] >= 0) ::close(ends_[i]);
    ends_[i] = -1;
  }
  void never_wait(int i) { ::fcntl(ends_[i], F_SETFL, O_NONBLOCK); }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

/// An empty folder, removed with whatever it holds.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "isect-grade-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw viz::FileError(fmt::format("{}: {}", name, std::strerror(errno)));
    path = name;
  }
  ~ScratchFolder() {
    std::error_code error;  // a program may have taken its own folders' permissions away
    using Iterator = std::filesystem::recursive_directory_iterator;
    for (int rounds = 0; rounds < 64; ++rounds) {
      if (std::filesystem::remove_all(path, error); !error) return;
      for (Iterator at(path, std::filesystem::directory_options::skip_permission_denied, error), end; at != end;
           at.increment(error)) {
        std::error_code ignored;
        if (at->is_directory(ignored) && !at->is_symlink(ignored))
          std::filesystem::permissions(at->path(), std::filesystem::perms::owner_all, ignored);
        if (error) break;
      }
    }
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string path;
};

/// Makes this process's memory unreadable to others of the same user, for a while.
class Secluded {
 public:
  Secluded() : before_(::prctl(PR_GET_DUMPABLE)) { ::prctl(PR_SET_DUMPABLE, 0); }
  ~Secluded() { ::prctl(PR_SET_DUMPABLE, before_ == 1 ? 1 : 0); }
  Secluded(const Secluded&) = delete;
  Secluded& operator=(const Secluded&) = delete;

 private:
  int before_;
};

/// Returns the folders of PATH that are given whole.
std::vector<std::string> search_path() {
  const char* const set = std::getenv("PATH");
  std::istringstream all(set ? set : "/usr/local/bin:/usr/bin:/bin");
  std::vector<std::string> folders;
  for (std::string folder; std::getline(all, folder, ':');)
    if (folder.starts_with('/')) folders.push_back(folder);
  return folders;
}

/// Returns the command with its files in full, since it runs in another folder. Throws viz::FileError if there is no
/// such program.
std::vector<std::string> in_full(std::vector<std::string> command) {
  std::error_code absent;
  for (std::string& word : command)
    if (!word.starts_with('-') && std::filesystem::exists(word, absent) &&
        (&word != &command[0] || word.find('/') != word.npos))
      word = std::filesystem::absolute(word).string();
  if (command[0].find('/') != std::string::npos) {
    if (std::filesystem::exists(command[0], absent)) return command;
    throw viz::FileError(fmt::format("{}: no such program", command[0]));
  }
  for (const std::string& folder : search_path())
    if (const std::string path = folder + '/' + command[0]; ::access(path.c_str(), X_OK) == 0) {
      command[0] = path;
      return command;
    }
  const bool here = std::filesystem::exists(command[0], absent);
  throw viz::FileError(fmt::format("{0}: no such program in PATH{1}", command[0],
                                   here ? fmt::format("; the file beside you is ./{}", command[0]) : ""));
}

/// Returns how many processes descend from this one: its children, theirs, and so on. 0 where the system hides them.
int descendants(pid_t of, int most, int depth = 0) {
  int count = 0;
  std::error_code gone;
  const std::filesystem::path tasks = fmt::format("/proc/{}/task", of);
  for (std::filesystem::directory_iterator at(tasks, gone), end; !gone && at != end; at.increment(gone)) {
    std::ifstream children(at->path() / "children");
    for (pid_t child = 0; children >> child && count <= most;)
      count += 1 + (depth < 64 ? descendants(child, most - count, depth + 1) : 0);
  }
  return count;
}

/// Returns how many processes this user has, since the system limits their sum.
int processes_of_user() {
  int count = 0;
  std::error_code gone;
  for (std::filesystem::directory_iterator at("/proc", gone), end; !gone && at != end; at.increment(gone)) {
    std::ifstream status(at->path() / "status");
    bool ours = false;
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("Uid:")) ours = std::strtoul(line.c_str() + 4, nullptr, 10) == ::getuid();
      if (ours && line.starts_with("Threads:")) count += std::atoi(line.c_str() + 8);
    }
  }
  return count;
}

/// Reads what is there, keeps no more than `most` bytes; false at the end.
bool taken(int from, std::string& text, std::size_t most, bool& over) {
  std::array<char, 65536> chunk;
  const ssize_t got = ::read(from, chunk.data(), chunk.size());
  if (got < 0) return errno == EINTR || errno == EAGAIN;
  const std::size_t kept = std::min(static_cast<std::size_t>(got), most - std::min(most, text.size()));
  text.append(chunk.data(), kept);
  over = over || kept < static_cast<std::size_t>(got);
  return got > 0;
}

/// Feeds the program and listens to it, until it ends or breaks a limit.
class Conversation {
 public:
  Conversation(pid_t child, Channel& in, Channel& out, Channel& messages, Channel& told, const Limits& limits)
      : child_(child), in_(in), out_(out), messages_(messages), told_(told), limits_(limits) {}

  Run held(const std::string& input) {
    in_.never_wait(1);
    while (told_.is_open(0)) {
      const double now = seconds_since(begun_);
      if (!fed_ && now >= limits_.held_back) fed_ = true, first_byte_ = Clock::now();
      const double allowed = limits_.held_back + limits_.seconds;
      if (now >= allowed) stop(Run::End::out_of_time);
      if (stopped_) stop(run_.end);  // the first signal may have come too early to be seen
      if (now >= watched_ + 0.02) {
        watched_ = now;
        if (descendants(child_, limits_.processes + 3) > limits_.processes + 2) stop(Run::End::too_many_processes);
      }
      wait(input, std::min({fed_ ? allowed : limits_.held_back, watched_ + 0.02, allowed}) - now);
    }
    finish();
    return run_;
  }

 private:
  static double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  void stop(Run::End why) {
    if (!stopped_) run_.end = why, stopped_ = true;
    ::kill(child_, SIGTERM);
    in_.close(1), out_.close(0), messages_.close(0);
  }

  void wait(const std::string& input, double most) {
    std::array<pollfd, 4> ends = {pollfd{out_.is_open(0) ? out_.end(0) : -1, POLLIN, 0},
                                  pollfd{messages_.is_open(0) ? messages_.end(0) : -1, POLLIN, 0},
                                  pollfd{told_.end(0), POLLIN, 0},
                                  pollfd{fed_ && in_.is_open(1) ? in_.end(1) : -1, POLLOUT, 0}};
    if (::poll(ends.data(), ends.size(), std::clamp(static_cast<int>(most * 1000) + 1, 1, 50)) < 0) return;
    if (ends[0].revents != 0) {
      bool over = false;
      const bool more = taken(ends[0].fd, run_.output, limits_.output, over);
      if (!fed_ && !run_.output.empty()) run_.early = true;
      if (fed_ && more) last_output_ = Clock::now();
      if (!more) out_.close(0);
      if (over) stop(Run::End::too_much_output);
    }
    if (ends[1].revents != 0 && messages_.is_open(0)) {
      bool over = false;
      if (!taken(ends[1].fd, run_.messages, 4096, over)) messages_.close(0);
    }
    if (ends[3].revents != 0 && in_.is_open(1)) feed(input);
    if (ends[2].revents != 0) {
      std::array<char, sizeof(Told)> bytes;
      const ssize_t got = ::read(told_.end(0), bytes.data(), bytes.size());
      if (got == static_cast<ssize_t>(bytes.size())) std::memcpy(&result_, bytes.data(), bytes.size());
      if (got <= 0 || result_.ended) told_.close(0);
    }
  }

  void feed(const std::string& input) {
    const std::size_t most = std::min<std::size_t>(input.size() - sent_, 65536);
    const ssize_t went = most == 0 ? 0 : ::write(in_.end(1), input.data() + sent_, most);
    if (went < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (went > 0) sent_ += static_cast<std::size_t>(went);
    if (went < 0 || sent_ == input.size()) {
      run_.read_all = went >= 0;
      in_.close(1);
    }
  }

  /// Takes what is still in the pipes, and notes how it ended.
  void finish() {
    bool over = false;
    if (out_.is_open(0)) {
      out_.never_wait(0);
      for (std::size_t before = run_.output.size() + 1; before != run_.output.size();)
        before = run_.output.size(), taken(out_.end(0), run_.output, limits_.output, over);
      if (fed_) last_output_ = Clock::now();
    }
    if (messages_.is_open(0)) {
      bool cut = false;
      messages_.never_wait(0);
      taken(messages_.end(0), run_.messages, 4096, cut);
    }
    run_.seconds = std::max(0.0, std::chrono::duration<double>(last_output_ - first_byte_).count());
    run_.alone = result_.alone, run_.no_network = result_.no_network, run_.read_only = result_.read_only;
    if (over && !stopped_) run_.end = Run::End::too_much_output, stopped_ = true;
    if (stopped_ || !result_.ended) return;
    if (!result_.started) {
      run_.end = Run::End::not_started, run_.code = result_.error;
    } else if (WIFSIGNALED(result_.status)) {
      run_.code = WTERMSIG(result_.status);
      run_.end = run_.code == SIGXCPU ? Run::End::out_of_time : Run::End::signalled;
    } else {
      run_.end = Run::End::exited, run_.code = WEXITSTATUS(result_.status);
    }
  }

  pid_t child_;
  Channel &in_, &out_, &messages_, &told_;
  const Limits& limits_;
  const Clock::time_point begun_ = Clock::now();
  Clock::time_point first_byte_ = begun_, last_output_ = begun_;
  double watched_ = 0;
  bool fed_ = false, stopped_ = false;
  std::size_t sent_ = 0;
  Told result_;
  Run run_;
};

}  // namespace

Run run_contained(const std::vector<std::string>& command, const std::string& input, const Limits& limits) {
  const ScratchFolder folder;
  std::vector<std::string> words = in_full(command);
  std::string path = "PATH=";
  for (const std::string& one : search_path()) path += (path.size() > 5 ? ":" : "") + one;
  std::vector<std::string> environment = {path, "HOME=" + folder.path, "TMPDIR=" + folder.path, "LC_ALL=C.UTF-8"};
  Container container;
  for (std::string& word : words) container.words.push_back(word.data());
  for (std::string& one : environment) container.environment.push_back(one.data());
  container.words.push_back(nullptr), container.environment.push_back(nullptr);
  container.folder = folder.path;
  container.hidden = program::this_program();
  container.user_map = fmt::format("{0} {0} 1", ::getuid());
  container.group_map = fmt::format("{0} {0} 1", ::getgid());
  container.limits = limits;
  container.limits.processes += processes_of_user();

  Channel in, out, messages, told;
  container.input = in.end(0), container.output = out.end(1), container.messages = messages.end(1);
  container.told = told.end(1);
  const Secluded secluded;
  const pid_t child = ::fork();
  if (child < 0) throw viz::FileError(fmt::format("no process: {}", std::strerror(errno)));
  if (child == 0) {
    in.close(1), out.close(0), messages.close(0), told.close(0);
    contain(container);
  }
  in.close(0), out.close(1), messages.close(1), told.close(1);
  Run run = Conversation(child, in, out, messages, told, limits).held(input);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
  return run;
}

std::string signal_name(int signal) {
  const char* const name = ::sigabbrev_np(signal);
  const char* const meaning = ::sigdescr_np(signal);
  if (!name) return fmt::format("signal {}", signal);
  return fmt::format("SIG{} ({})", name, meaning ? meaning : "");
}

}  // namespace isect::grade
