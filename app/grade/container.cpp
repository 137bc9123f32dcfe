#include "app/grade/container.h"

#include <dirent.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace isect::grade {

namespace {

volatile std::sig_atomic_t to_end = 0;
void end_soon(int) { to_end = 1; }

bool wrote(const char* path, const std::string& text) {
  const int file = ::open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool all = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(file);
  return all;
}

/// Namespaces of one's own, where the system allows them.
void part(const Container& c, Told& told) {
  ::prctl(PR_SET_DUMPABLE, 1);  // else the maps can't be written
  const auto mapped = [&c] {
    wrote("/proc/self/setgroups", "deny");
    wrote("/proc/self/uid_map", c.user_map);
    wrote("/proc/self/gid_map", c.group_map);
  };
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNET | CLONE_NEWPID | CLONE_NEWIPC | CLONE_NEWNS) == 0) {
    mapped();
    told.alone = told.no_network = true;
  } else if (::unshare(CLONE_NEWUSER | CLONE_NEWNET) == 0) {
    mapped();
    told.no_network = true;
  }
}

/// All that is mounted becomes read-only, but for the folder.
bool only_folder_writable(const std::string& folder) {
  struct Attributes {
    unsigned long long set, clear, propagation, user_namespace;
  };
  constexpr long set_attributes = 442;  // mount_setattr, on every architecture
  constexpr unsigned recursive = 0x8000, read_only = 1;
  const Attributes closed = {read_only, 0, 0, 0}, open = {0, read_only, 0, 0};
  return ::mount(folder.c_str(), folder.c_str(), nullptr, MS_BIND, nullptr) == 0 &&
         ::syscall(set_attributes, AT_FDCWD, "/", recursive, &closed, sizeof closed) == 0 &&
         ::syscall(set_attributes, AT_FDCWD, folder.c_str(), 0, &open, sizeof open) == 0;
}

void limit(int resource, rlim_t most) {
  const rlimit both = {most, most};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void limit_all(const Limits& limits) {
  constexpr rlim_t mib = 1u << 20;
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds + limits.held_back)) + 1);
  limit(RLIMIT_AS, limits.memory_mib * mib);
  limit(RLIMIT_FSIZE, limits.file_mib * mib);
  limit(RLIMIT_NOFILE, static_cast<rlim_t>(limits.files));
  limit(RLIMIT_NPROC, static_cast<rlim_t>(limits.processes));
}

/// Becomes the program. `failed` takes errno if it can't.
[[noreturn]] void become(const Container& c, int failed) {
  ::setsid();  // no terminal
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(c.input, 0), ::dup2(c.output, 1), ::dup2(c.messages, 2);
  if (::chdir(c.folder.c_str()) == 0) {
    ::umask(077);
    for (int right = 0; right < 64; ++right) ::prctl(PR_CAPBSET_DROP, right, 0, 0, 0);  // root is nobody special here
    limit_all(c.limits);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    ::execve(c.words[0], c.words.data(), c.environment.data());
  }
  const int error = errno;
  [[maybe_unused]] const ssize_t sent = ::write(failed, &error, sizeof error);
  ::_exit(127);
}

/// Kills every child that this process has, also those that it inherited, until there are none.
void kill_children() {
  for (int rounds = 0; rounds < 100000; ++rounds) {
    const int file = ::open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
    char text[4096];
    const ssize_t got = file < 0 ? 0 : ::read(file, text, sizeof text - 1);
    if (file >= 0) ::close(file);
    if (got > 0) {
      text[got] = 0;
      for (char* at = text; *at != 0;) {
        char* end = at;
        const long pid = std::strtol(at, &end, 10);
        if (end == at || *end == 0) break;  // the last may be cut off
        ::kill(static_cast<pid_t>(pid), SIGKILL);
        at = end;
        while (*at == ' ') ++at;
      }
    }
    // All that are dead leave the list, so that those behind them come into sight.
    pid_t gone = ::waitpid(-1, nullptr, got > 0 ? 0 : WNOHANG);
    while (gone > 0) gone = ::waitpid(-1, nullptr, WNOHANG);
    if (gone < 0 && errno == ECHILD) return;
    if (gone == 0 && file < 0) return;  // this system does not tell them
  }
}

/// Waits for a process; kills it if it is to end.
int waited(pid_t pid) {
  int status = 0;
  for (;;) {
    if (to_end) ::kill(pid, SIGKILL);
    const pid_t gone = ::waitpid(pid, &status, 0);
    if (gone == pid) return status;
    if (gone < 0 && errno != EINTR) return status;
  }
}

void tell(const Container& c, const Told& told) {
  [[maybe_unused]] const ssize_t sent = ::write(c.told, &told, sizeof told);
}

/// Starts the program, waits for it and notes how it ended.
void start_and_wait(const Container& c, Told& told) {
  ::prctl(PR_SET_DUMPABLE, 0);  // nobody reads this process's memory
  tell(c, told);
  int failed[2];
  if (::pipe2(failed, O_CLOEXEC) != 0) {
    told.error = errno;
    return;
  }
  const pid_t program = ::fork();
  if (program == 0) become(c, failed[1]);
  ::close(failed[1]);
  if (program < 0) {
    told.error = errno;
    return;
  }
  for (const int end : {c.input, c.output, c.messages}) ::close(end);
  told.started = ::read(failed[0], &told.error, sizeof told.error) == 0;
  told.status = waited(program);
}

/// The first process of a namespace: with it ends every other.
[[noreturn]] void first_process(const Container& c, Told told) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
  ::mount("proc", "/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr);
  ::mount("/dev/null", c.hidden.c_str(), nullptr, MS_BIND, nullptr);
  told.read_only = only_folder_writable(c.folder);
  start_and_wait(c, told);
  told.ended = true;
  tell(c, told);
  ::_exit(0);
}

}  // namespace

void contain(const Container& c) {
  ::setsid();
  struct sigaction action = {};
  action.sa_handler = end_soon;
  ::sigaction(SIGTERM, &action, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  Told told;
  part(c, told);
  if (told.alone) {
    const pid_t first = ::fork();
    if (first == 0) first_process(c, told);
    for (const int end : {c.input, c.output, c.messages}) ::close(end);
    if (first > 0) {
      waited(first);
      ::_exit(0);
    }
    told.error = errno;
  } else {
    start_and_wait(c, told);
    kill_children();
  }
  told.ended = true;
  tell(c, told);
  ::_exit(0);
}

}  // namespace isect::grade
