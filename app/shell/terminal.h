#pragma once
// Output to the terminal: data to stdout, messages to stderr, colour and progress only if a person is watching.

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace isect::program {

/// Makes sure that descriptors 0 to 2 are taken, so that no file opened later is mistaken for one of them,
/// and that a closed pipe or a limit on a file's size is an error to be handled instead of a signal.
void guard_streams();

/// Thrown when the reader of stdout has gone away (a closed pipe): nobody is left to work for.
struct ReaderGone {};
/// Prints data. Throws ReaderGone, or viz::FileError if it can't be written for another reason.
void print(const std::string& data);
/// Throws what print throws, by errno.
[[noreturn]] void printing_failed();
/// Ends the process as a closed pipe ends other programs: by SIGPIPE, which a shell shows as 141. Call it when
/// everything has been put in order.
[[noreturn]] void end_by_closed_pipe();
/// Prints a message: one line on stderr.
void say(const std::string& line);

/// Says a line after a second, unless it is destroyed before or not `wanted`: long work is announced.
class SaidLater {
 public:
  explicit SaidLater(std::string line, bool wanted = true);

 private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // the last one, as it uses the others
};

/// Says so for the answers that a scene asks for, if a person is watching.
SaidLater deciding(const std::string& scene);

bool is_terminal(int descriptor);
/// Colours on stdout: on a terminal that has them, unless NO_COLOR is set.
enum class Ink { plain, bold, dim, good, bad, mark };
std::string inked(Ink, const std::string& text);

/// One line on stderr that says how far the work is; silent in a pipe. A total of 0 means that it is not known yet.
class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void done(const std::string& what);

 private:
  std::size_t total_, count_ = 0;
  bool shown_;
};

/// Returns `text` broken into lines of at most `width` characters, each after `indent` spaces; '\n' separates
/// paragraphs.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);
/// Returns how wide a line of stdout may be: COLUMNS if it is set, else the terminal's width, else 80. At least 40.
std::size_t columns();

}  // namespace isect::program
