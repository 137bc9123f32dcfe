#include "app/shell/terminal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>

#include "viz/formats/files.h"
#include "viz/text/utf8.h"

namespace isect::program {

namespace {

bool set_and_not_empty(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

bool coloured() {
  static const bool yes = [] {
    const char* term = std::getenv("TERM");
    return is_terminal(STDOUT_FILENO) && !set_and_not_empty("NO_COLOR") && term && std::strcmp(term, "dumb") != 0;
  }();
  return yes;
}

/// Writes all bytes; returns false, with errno set, if not everything could be written.
bool write_all(int descriptor, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = ::write(descriptor, bytes.data() + sent, bytes.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    sent += static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace

void guard_streams() {
  // open() takes the lowest free descriptor; read-only, so that writing to a closed stdout still fails.
  for (int descriptor = 0; descriptor <= 2;) {
    if (::fcntl(descriptor, F_GETFD) == -1 && ::open("/dev/null", O_RDONLY) == -1) break;
    ++descriptor;
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void print(const std::string& data) {
  if (!write_all(STDOUT_FILENO, data)) printing_failed();
}

void printing_failed() {
  if (errno == EPIPE) throw ReaderGone();
  throw viz::FileError(fmt::format("standard output: {}", std::strerror(errno)));
}

void end_by_closed_pipe() {
  sigset_t pipe;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  std::signal(SIGPIPE, SIG_DFL);
  ::sigprocmask(SIG_UNBLOCK, &pipe, nullptr);
  std::raise(SIGPIPE);
  std::_Exit(128 + SIGPIPE);  // never reached
}

// If even stderr is closed, nothing can be done.
void say(const std::string& line) { write_all(STDERR_FILENO, line + "\n"); }

SaidLater::SaidLater(std::string line, bool wanted) {
  if (!wanted) return;
  thread_ = std::jthread([this, text = std::move(line)](const std::stop_token& ended) {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, ended, std::chrono::seconds(1), [] { return false; });
    if (!ended.stop_requested()) say(text);
  });
}

SaidLater deciding(const std::string& scene) {
  return SaidLater(scene + ": what it asks is being decided, exactly; Ctrl+C ends that", is_terminal(STDERR_FILENO));
}

bool is_terminal(int descriptor) { return ::isatty(descriptor) == 1; }

std::string inked(Ink ink, const std::string& text) {
  if (ink == Ink::plain || !coloured()) return text;
  const char* code = ink == Ink::bold   ? "1"
                     : ink == Ink::dim  ? "2"
                     : ink == Ink::good ? "34"
                     : ink == Ink::bad  ? "35"
                                        : "7";
  return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

Progress::Progress(std::size_t total) : total_(total), shown_(total != 1 && is_terminal(STDERR_FILENO)) {}

Progress::~Progress() {
  if (shown_ && count_ > 0) write_all(STDERR_FILENO, "\r\x1b[K");
}

void Progress::done(const std::string& what) {
  ++count_;
  if (!shown_) return;
  const std::string of = total_ > 0 ? fmt::format("/{}", total_) : "";
  write_all(STDERR_FILENO, fmt::format("\r\x1b[K[{}{}] {}", count_, of, what.substr(0, 60)));
}

std::size_t columns() {
  long wide = 0;
  if (const char* set = std::getenv("COLUMNS")) wide = std::strtol(set, nullptr, 10);
  winsize window{};
  if (wide <= 0 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0) wide = window.ws_col;
  if (wide <= 0) wide = 80;
  return static_cast<std::size_t>(std::clamp(wide, 40L, 1000L));
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string out;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    std::istringstream words(paragraph);
    std::string line;
    const auto flush = [&] { out += std::string(indent, ' ') + std::exchange(line, {}) + "\n"; };
    for (std::string word; words >> word;) {
      if (!line.empty() && indent + viz::count_characters(line) + 1 + viz::count_characters(word) > width) flush();
      line += (line.empty() ? "" : " ") + word;
    }
    flush();
  }
  return out;
}

}  // namespace isect::program
