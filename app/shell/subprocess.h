#pragma once
// One of our programs, started by another: the measurements for this machine's instructions or beside other libraries.

#include <functional>
#include <string>
#include <vector>

namespace isect::program {

std::string this_program();  ///< its path
/// Returns the path of a program in the same folder as this one.
std::string beside(const std::string& name);

struct CompletedProcess {
  int status = 0;      ///< its exit status; 128 + n where signal n ended it
  std::string output;  ///< what it wrote to stdout
  double seconds = 0;  ///< from its start to its end
  double processor =
      0;  ///< of all its threads, and the system for them, in seconds: what a busy machine does not change
  /// The most memory it had at once, in MB; as Linux counts, never less than what this program had when it started it.
  double peak = 0;
};
/// Runs a program, by its path or found in PATH, to its end; `told` gets each line of its stderr as it comes. Throws
/// viz::FileError if it can't be started.
CompletedProcess run_subprocess(const std::vector<std::string>& command,
                                const std::function<void(const std::string&)>& told);

}  // namespace isect::program
