// isect query: one JSON case per line in, one JSON answer per line out.

#include "app/query/query.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>

#include "app/program.h"
#include "app/scene/line.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"

namespace isect::program {

namespace {

/// The lines of a file or pipe, as they come, with memory for one line.
class Lines {
 public:
  explicit Lines(int file) : file_(file) {}

  enum class Next { line, too_long, out_of_memory, end };
  /// Reads the next line without its end; the last may lack one. A line that can't be kept is dropped whole. Calls
  /// `idle` before it has to wait for more.
  template <class Idle>
  Next next(std::string& line, const Idle& idle) {
    line.clear();
    Next kept = Next::end;
    for (;;) {
      if (at_ == chunk_.size() && !refill(idle)) return kept;
      if (kept == Next::end) kept = Next::line;
      const std::size_t stop = chunk_.find('\n', at_), end = std::min(stop, chunk_.size());
      if (kept == Next::line) kept = keep(line, end);
      at_ = stop == std::string::npos ? end : end + 1;
      if (stop != std::string::npos) return kept;
    }
  }

 private:
  /// Appends what stands before `end`.
  Next keep(std::string& line, std::size_t end) {
    if (line.size() + (end - at_) > query::most_bytes()) {
      line.clear();
      return Next::too_long;
    }
    try {
      line.append(chunk_, at_, end - at_);
      return Next::line;
    } catch (const std::bad_alloc&) {
      std::string().swap(line);
      return Next::out_of_memory;
    }
  }

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
  explicit File(const std::string& path) : descriptor(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY)) {
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

struct QueryOptions {
  std::string path = "-";
  std::optional<std::string> files;  ///< the folder whose files scenes may name
  bool strict = false;
};

query::Answer answer(Lines::Next next, const std::string& line, std::size_t number, const QueryOptions& options) {
  switch (next) {
    case Lines::Next::too_long:
      return query::too_long(number);
    case Lines::Next::out_of_memory:
      return query::out_of_memory(number);
    default:
      if (const auto scene = scene::answer_line(line, number, options.files)) return *scene;
      return query::answer(line, number, options.strict);
  }
}

int answer_all(const QueryOptions& options) {
  if (std::error_code absent; options.files && !std::filesystem::is_directory(*options.files, absent))
    throw viz::FileError(fmt::format("--files: {} is no folder", *options.files));
  const File file(options.path);
  if (options.path == "-" && ::isatty(STDIN_FILENO))
    say("one JSON case a line; Ctrl+D ends. `isect query --help` lists the kinds");
  Lines lines(file.descriptor);
  std::string line;
  bool errors = false;
  const auto flush = [] {
    if (std::fflush(stdout) != 0) printing_failed();
  };
  for (std::size_t number = 1;; ++number) {
    const Lines::Next next = lines.next(line, flush);
    if (next == Lines::Next::end) break;
    if (next == Lines::Next::line && query::blank(line)) continue;
    const query::Answer reply = answer(next, line, number, options);
    write_line(reply.text);
    errors = errors || reply.error;
    if (line.capacity() > (1 << 20)) std::string().swap(line);  // releases the memory of a long line
  }
  flush();
  return errors ? check_failed : done;
}

std::string footer() {
  std::string text = "Kinds, with their variants and inputs:\n";
  for (const query::Kind& kind : query::kinds())
    text +=
        fmt::format("  {:<20} {}\n  {:<20} inputs: {}\n", kind.name, fmt::join(kind.variants, " "), "", kind.inputs);
  return text + fmt::format(R"(
Every case is an object on one line: "kind", the kind's inputs ([those] may be missing), and if wanted "id", "scalar" ("f64"
or "f32"), "variant" and "trace" (true). A point is a list of 2 or 3 numbers; a and b of obb_obb are {{"c", "u", "e"}}, of
kdop_kdop {{"lo", "hi"}}. Each number is rounded once, to the scalar. Only tmin, tmax and the ends of intervals and of empty
boxes may be "inf" or "-inf", in quotes: a box that has points ends at finite numbers, and so does a k-DOP.
How two shapes lie is "relation", as seen from a: disjoint, equal, a_contains_b, b_contains_a (a touch from within is
containment), touch (common points, none interior to both), overlap. A shape without thickness has its interior within the
line or plane that it spans: a plate that pierces a box overlaps it. "interiors_intersect" of box_box says whether on
every axis each box begins before the other ends. A box with lo above hi is empty: "empty" names it.
The sphere of bounding_volume_fit has a center near that of the smallest ball, and the least radius for it;
smallest_sphere is the smallest ball, but for rounding. robust of ray_sphere is another name of exact.
t_in and t_out of segment_plane are the part with normal . x + d >= 0. points of polygon_plane and polygon_box is what is
left of a convex polygon there, or in the box; a and b of convex_polygons are convex and have areas.
With --strict an empty shape is an error that names its field, and so are a plane without a normal and an obb whose axes
depend on each other.
A line with "objects" in place of "kind" is a whole scene, as `isect scene --help` tells: {{"objects": [{{"sphere": "A",
"center": [0, 0], "radius": 1}}, {{"point": "p", "at": [1, 0]}}], "ask": [["p", "A"]]}}. Its result is what `isect scene --json`
prints: an answer a question. Of files that it names, only those below --files DIR are read.
The id comes back as it was sent, to the letter; null for a line that is no JSON. An error without an id names its line.
These fields may stand beside them and are not looked at: {}.
Any other field, a field given twice, and bytes behind the end are errors. Lines of blanks get no answer.
Limits, beyond which an error answers: a line of {} MiB; {} levels of lists and objects; slabs that would take 256 MiB;
2^26 normals times points of a k-DOP around points; and the memory that there is.
Exit status: 0 every line was answered; 1 some line was an error; 2 usage; 4 FILE can't be read.
Example: echo '{{"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1]}}' | isect query)",
                            fmt::join(query::notes(), ", "), query::most_bytes() >> 20, query::most_levels());
}

}  // namespace

void add_query(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("query", "the exact oracle: a JSON case a line in, a JSON answer a line out");
  const auto options = std::make_shared<QueryOptions>();
  sub.add_option("FILE", options->path, "the cases; standard input if none is given")->check(not_empty());
  sub.add_flag("--strict", options->strict, "an empty shape is an error that names it, no answer");
  sub.add_option_function<std::string>(
         "--files", [options](const std::string& folder) { options->files = folder; },
         "the folder whose files scenes may name; none if it is not given")
      ->type_name("DIR")
      ->check(not_empty());
  sub.footer(footer());
  sub.callback([&program, options] { program.chosen = [options] { return answer_all(*options); }; });
}

}  // namespace isect::program
