#pragma once
// Values of options as they are written: sizes, lengths, formats, steps. Each throws viz::BadInput that names the
// option, what was given and what is allowed, unless it says otherwise.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viz/formats.h"

namespace isect::program {

/// "960x600"; each side 16 to 8192.
struct Size {
  int width = 960, height = 600;
};
Size size_of(const std::string& text);

/// A length on paper in points: "8cm", "80 mm", "8,5CM", "227pt", "3in".
double points_of(const std::string& option, const std::string& text, double least = 10, double most = 14400);
/// Pixels an inch: 30 to 2400.
double dpi_of(const std::string& text);

/// Figures a row: 1 to 12.
int columns_of(const std::string& text);
/// How long a step is shown: 0.1 to 60.
double seconds_of(const std::string& text);

/// "png,svg" as names without repeats.
std::vector<const viz::Format*> formats_of(const std::string& text);

/// Chosen steps, counted from 1.
class Steps {
 public:
  /// "3", "3-6", "3,5,7-9" or "all"; none where the text is nothing of that kind.
  static std::optional<Steps> read(const std::string& text);
  /// Those of a walk of so many steps, from 0, in order and without repeats.
  std::vector<int> of(int count) const;
  /// Whether a walk of so many steps has all of them.
  bool all_in(int count) const;

 private:
  std::vector<std::pair<int, int>> ranges_;  ///< from 1, ends included; empty: all
};

}  // namespace isect::program
