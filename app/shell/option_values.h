#pragma once
// Values of options as they are written: sizes, lengths, formats, steps. Each throws viz::BadInput that names the
// option, what was given and what is allowed, unless it says otherwise.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viz/formats/formats.h"
#include "viz/lesson.h"

namespace isect::program {

/// A size such as "960x600"; each side 16 to 8192.
struct Size {
  int width = 960, height = 600;
};
Size size_of(const std::string& text);

/// Returns a length on paper in points: "8cm", "80 mm", "8,5CM", "227pt", "3in". To twelve digits, which in_points
/// writes: so a figure that is drawn again from what it carries is the same to the last digit.
double points_of(const std::string& option, const std::string& text, double least = 10, double most = 14400);
std::string in_points(double points);
/// Returns pixels per inch: 30 to 2400.
double dpi_of(const std::string& text);

/// Returns figures per row: 1 to 12.
int columns_of(const std::string& text);
/// Returns how long a step is shown: 0.1 to 60.
double seconds_of(const std::string& text);

/// Returns the formats of "png,svg" without repeats.
std::vector<const viz::Format*> formats_of(const std::string& text);

/// Chosen steps of a walk.
class Steps {
 public:
  /// Reads "3", "-1" (the last), "3-6", "verdict", a step's name ("intersect", "11-intersect"), several of them joined
  /// by commas, or "all"; none if the text is nothing of that kind.
  static std::optional<Steps> read(const std::string& text);
  /// Returns the steps of a walk, from 0, in order and without repeats.
  std::vector<int> of(const viz::Walk&) const;
  /// Whether a walk has all of them.
  bool all_in(const viz::Walk&) const;

 private:
  struct Part {
    int from = 0, to = 0;  ///< from 1, ends included; below 0: counted from the end; 0: by name
    std::string name = {};
  };
  static std::vector<int> of(const Part&, const viz::Walk&);
  std::vector<Part> parts_;  ///< empty: all
};

/// The word of --step for the step with the answer: the last one that shows the scene itself.
inline constexpr const char* verdict_step = "verdict";
/// Returns which step that is, from 0.
int verdict_of(const viz::Walk&);
/// Returns the names of a walk's steps.
std::vector<std::string> step_names(const viz::Walk&);
/// Returns the error for steps that a walk lacks, which is that of `whose`: "tangent has steps 1 to 13: give ...".
viz::BadInput unknown_steps(const std::string& field, const std::string& asked, const viz::Walk&,
                            const std::string& whose);

}  // namespace isect::program
