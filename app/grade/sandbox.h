#pragma once
// A program that nobody vouches for, run once: in a folder of its own, with limits, and gone afterwards with all that
// it started.

#include <cstddef>
#include <string>
#include <vector>

namespace isect::grade {

struct Limits {
  double seconds = 10;            ///< by the clock and of the processor, from the first byte of input on
  std::size_t memory_mib = 4096;  ///< address space of a process
  int processes = 64;             ///< at once, threads among them where the system counts those
  std::size_t file_mib = 16;      ///< of a file that it writes
  int files = 64;                 ///< open at once
  std::size_t output = 1u << 20;  ///< bytes of answers
  double held_back = 0.3;         ///< seconds for which the input is held back: what comes then is no answer
};

/// How a run ended.
struct Run {
  enum class End { exited, signalled, out_of_time, too_much_output, too_many_processes, not_started };
  End end = End::exited;
  int code = 0;             ///< the exit status, the signal, or the errno of a program that could not be started
  std::string output;       ///< all bytes of it up to the limit
  std::string messages;     ///< the first bytes of what it wrote to stderr
  bool early = false;       ///< it answered before there was any input
  bool read_all = false;    ///< it took all of the input before it ended
  double seconds = 0;       ///< from the first byte of input until its output ended
  bool alone = false;       ///< it saw no processes but its own
  bool read_only = false;   ///< it could write to its folder only
  bool no_network = false;  ///< it had no network
};

/// Runs a command with this input. A word that names a file is that file, also from the folder where it runs; that
/// folder is empty and is removed. Of the environment only PATH is left. Throws viz::FileError if no process can be
/// made.
Run run_contained(const std::vector<std::string>& command, const std::string& input, const Limits& limits);

/// Returns "SIGSEGV (it used memory that is not its own)".
std::string signal_name(int signal);

}  // namespace isect::grade
