#pragma once
// The result of a check as text, as JSON for programs, and as one HTML page with pictures inside.

#include <string>
#include <vector>

#include "lessons/program/baselines.h"

namespace isect::program {

struct Report {
  std::string program;  ///< how it was called
  std::string folder;   ///< of the baselines
  bool presets_too;     ///< the folder holds the presets as well: --dir
  std::vector<std::string> lessons;
  std::size_t presets = 0, pictures = 0;
  std::vector<Failure> failures;
};

/// 0, 1 or 3; what was accepted counts for nothing.
int status(const Report&);
/// The exact command that accepts this failure.
std::string accept_command(const Report&, const Failure&);
std::string to_text(const Report&);
std::string to_json(const Report&);
/// Self-contained: old, new and difference side by side. Reads the pictures that the failures name.
std::string to_html(const Report&);

}  // namespace isect::program
