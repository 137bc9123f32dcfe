// isect query: a JSON case a line in, a JSON answer a line out.

#include "lessons/query/query.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "lessons/program/options.h"
#include "lessons/program/program.h"
#include "lessons/program/terminal.h"
#include "viz/files.h"

namespace isect::program {

namespace {

/// Lines of a file or pipe, as they come, in memory for one line.
class Lines {
 public:
  static constexpr std::size_t limit = std::size_t(64) << 20;

  explicit Lines(int file) : file_(file) {}

  enum class Next { line, too_long, end };
  /// The next line without its end; the last may lack one. Calls `idle` before it has to wait for more.
  template <class Idle>
  Next next(std::string& line, const Idle& idle) {
    line.clear();
    bool some = false, long_line = false;
    for (;;) {
      if (at_ == chunk_.size() && !refill(idle))
        return !some ? Next::end : long_line ? Next::too_long : Next::line;
      some = true;
      const std::size_t stop = chunk_.find('\n', at_), end = std::min(stop, chunk_.size());
      long_line = long_line || line.size() + (end - at_) > limit;
      if (long_line)
        line.clear();
      else
        line.append(chunk_, at_, end - at_);
      at_ = stop == std::string::npos ? end : end + 1;
      if (stop != std::string::npos) return long_line ? Next::too_long : Next::line;
    }
  }

 private:
  template <class Idle>
  bool refill(const Idle& idle) {
    idle();
    chunk_.resize(1 << 16);
    ssize_t got = 0;
    do got = ::read(file_, chunk_.data(), chunk_.size());
    while (got < 0 && errno == EINTR);
    if (got < 0) throw viz::FileError(fmt::format("the cases can't be read: {}", std::strerror(errno)));
    chunk_.resize(static_cast<std::size_t>(got));
    at_ = 0;
    return got > 0;
  }

  int file_;
  std::string chunk_;
  std::size_t at_ = 0;
};

/// An open file, closed at the end; standard input stays open.
class File {
 public:
  explicit File(const std::string& path)
      : descriptor(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY)) {
    if (descriptor < 0) throw viz::FileError(fmt::format("{}: {}", path, std::strerror(errno)));
  }
  ~File() {
    if (descriptor != STDIN_FILENO) ::close(descriptor);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const int descriptor;
};

void write_line(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fputc('\n', stdout) == EOF)
    printing_failed();
}

int answer_all(const std::string& path) {
  const File file(path);
  if (path == "-" && ::isatty(STDIN_FILENO))
    say("one JSON case a line; Ctrl+D ends. `isect query --help` lists the kinds");
  Lines lines(file.descriptor);
  std::string line;
  bool errors = false;
  const auto flush = [] {
    if (std::fflush(stdout) != 0) printing_failed();
  };
  for (;;) {
    const Lines::Next next = lines.next(line, flush);
    if (next == Lines::Next::end) break;
    const query::Answer answer =
        next == Lines::Next::too_long ? query::too_long(Lines::limit) : query::answer(line);
    write_line(answer.text);
    errors = errors || answer.error;
  }
  flush();
  return errors ? check_failed : done;
}

std::string footer() {
  std::string text = "Kinds, with their variants:\n";
  for (const query::Kind& kind : query::kinds()) {
    text += fmt::format("  {:<20}", kind.name);
    for (const std::string& variant : kind.variants) text += " " + variant;
    text += '\n';
  }
  return text + R"(
Every case is an object on one line: "kind", the kind's inputs, and if wanted "id", "scalar" ("f64" or "f32"),
"variant" and "trace" (true). Numbers may be "inf" or "-inf" where a range or a box ends.
Exit status: 0 every line was answered; 1 some line was an error; 2 usage; 4 FILE can't be read.
Example: echo '{"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1]}' | isect query)";
}

}  // namespace

void add_query(CLI::App& app, Program& program) {
  CLI::App& sub =
      *app.add_subcommand("query", "the exact oracle: a JSON case a line in, a JSON answer a line out");
  const auto path = std::make_shared<std::string>("-");
  sub.add_option("FILE", *path, "the cases; standard input if none is given")->check(not_empty());
  sub.footer(footer());
  sub.callback([&program, path] { program.chosen = [path] { return answer_all(*path); }; });
}

}  // namespace isect::program
