// A segment against a box by slabs: what the products are, what min and max make of them, and what that is worth.

#include <fmt/format.h>

#include <cmath>

#include "lessons/clipping/reciprocals.h"
#include "lessons/shared/axis_names.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

std::string SlabTeller::planes_caption() const {
  const double d = known_.segment.q[axis_] - known_.segment.p[axis_];
  const std::string start = fmt::format("On {} the component of **d** is {}, and its reciprocal is {}.\n",
                                        axis_names[axis_], shown(d), shown(inverse_));
  if (!std::isinf(inverse_)) return start + "The line crosses the lines of two sides at *t*_1 and *t*_2.";
  if (no_number(slab_))
    return start + fmt::format("**p** lies level with {}: there 0 · ∞ is not a number.",
                               name_of(Side{axis_, std::isnan(slab_.hi)}));
  return start + (slab_.lo < slab_.hi ? "The line is parallel to two sides and lies between them. So the crossings "
                                        "are infinitely far, one before and one after."
                                      : "The line is parallel to two sides and lies beyond one of them. So both "
                                        "crossings are infinitely far, on one side.");
}

std::string SlabTeller::crossing_caption() const {
  if (!no_number(slab_)) return "The smaller is the entry into the slab, the larger the exit from it.";
  return std::string(
             "No comparison with what is not a number holds. So both min and max return their first argument, "
             "*t*_1.\n") +
         (no_number(crossing_) ? "So neither entry nor exit is a number."
                               : "It is −∞, for entry and exit. That *t*_2 is not a number is hidden now.");
}

std::string SlabTeller::remains_caption(const Interval<double>& before) const {
  if (no_number(crossing_) && !no_number(range_))
    return "The range comes first, so max and min return it: this slab is passed over, as if it were not there.";
  if (no_number(before) && no_number(range_))
    return "The range is not a number, and the first argument is returned: still no number.";
  if (no_number(range_))
    return "Entry and exit come first, so max and min return them: the range is no longer a number.";
  if (no_number(before))
    return "Entry and exit come first and replace what is not a number. What was found before is forgotten, and with "
           "it 0 ≤ *t* ≤ 1.";
  if (hidden_ && known_.left) return "The exit −∞ ends the range before it begins. Nothing tells why.";
  if (known_.left) return "The range ends before it begins: nothing of it is left.";
  return before == range_ ? "The range lies in this slab already, and stays as it is."
                          : "The last entry and the first exit count: the range shrinks.";
}

std::string SlabTeller::verdict_text() const {
  if (!truth_) return std::string("nothing is kept") + (found_ ? "; this method keeps a part" : "");
  const auto [lo, hi] = shown_apart(truth_->lo, truth_->hi);
  const std::string kept = is_a_point()               ? "the point is kept"
                           : truth_->lo == truth_->hi ? "one point is kept: *t* = " + lo
                                                      : fmt::format("kept: *t* from {} to {}", lo, hi);
  return kept + (!found_ ? "; this method loses it" : beyond() ? "; this method keeps more" : "");
}

std::string SlabTeller::end_caption() const {
  if (no_number_seen_)
    return what_it_is_worth() +
           fmt::format("\nWith the arguments exchanged it would keep {}.", exchanged_ ? "a part" : "none");
  if (found_.has_value() != truth_.has_value())
    return "Rounding makes this method wrong here: at a corner the last entry is the first exit, and rounding "
           "moved them.";
  return found_ ? "No product was 0 · ∞, so min and max compared numbers only. The exact test keeps a part, too."
                : "No product was 0 · ∞, so min and max compared numbers only. The exact test keeps nothing, too.";
}

std::string SlabTeller::what_it_is_worth() const {
  if (beyond()) return "The part kept goes beyond the segment, whose range was forgotten: this answer is wrong.";
  if (found_ && truth_)
    return range_first_ ? "This answer is right: the range came first, so what is not a number was passed over."
                        : "This answer is right: the next axis replaced what is not a number. The range that it "
                          "forgot was not needed.";
  if (found_) return "The exact test keeps nothing: this answer is wrong.";
  if (!truth_) return "The exact test keeps nothing, too.";
  return hidden_ ? "The segment lies in a side, and the exact test keeps it. This method loses it: −∞ has hidden "
                   "that a product was not a number."
                 : "The segment lies in a side, and the exact test keeps it. This method loses it: the range is not "
                   "a number, and no comparison with it holds.";
}

}  // namespace isect::lessons::clipping_lesson
