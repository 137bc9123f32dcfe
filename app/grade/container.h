#pragma once
// The child's side of run_contained: namespaces, limits, and the end of all that was started. Between fork and exec no
// memory may be asked for, so all texts are made before.

#include <string>
#include <vector>

#include "app/grade/sandbox.h"

namespace isect::grade {

/// What the child tells, twice: how well the program is contained, and then how it ended as well.
struct Told {
  bool alone = false, no_network = false, read_only = false;
  bool ended = false;
  bool started = false;
  int error = 0;   ///< errno of the start
  int status = 0;  ///< as of waitpid
};

/// Everything that the child needs, made before the fork.
struct Container {
  std::vector<char*> words;                    ///< the command, with a null at the end
  std::vector<char*> environment;              ///< the same
  std::string hidden;                          ///< a program that is out of its reach: isect itself
  std::string folder;                          ///< where the program runs
  std::string user_map, group_map;             ///< lines of uid_map and gid_map
  int input = -1, output = -1, messages = -1;  ///< become 0, 1 and 2
  int told = -1;                               ///< takes a Told
  Limits limits;
};

/// Starts the program, waits for it, kills what it leaves behind, and tells how it went; never returns. SIGTERM ends it
/// early, and so does the death of the parent.
[[noreturn]] void contain(const Container&);

}  // namespace isect::grade
