#pragma once
// Which rows of a report belong together, in the order in which they were measured.

#include <string>
#include <vector>

#include "bench/report.h"

namespace isect::bench {

/// The rows of one test in one scalar; of one family if it is given.
std::vector<const Row*> rows_of(const Report&, const std::string& test, const std::string& scalar,
                                const std::string& family = {});
std::vector<std::string> tests_of(const Report&);
std::vector<std::string> scalars_of(const Report&, const std::string& test);
/// Whether another library was measured beside an exact call, on ordinary cases in double.
bool has_peers(const Report&);
std::vector<std::string> families_of(const std::vector<const Row*>&);
/// "half-B"; a peer's with its library before it: "CGAL: do_intersect".
std::string name_of(const Row&);
std::string name_of(const Growth&);
/// The names of the methods, isect's first.
std::vector<std::string> methods_of(const std::vector<const Row*>&);

/// The rows that no other row of the same family dominates, that is, is at most as slow and at most as wrong (or,
/// `by_value`, as far off at its 99th percentile) and better in one of both.
std::vector<const Row*> front_of(const std::vector<const Row*>& family, bool by_value);
/// The median time of a divided by that of b, and bounds for it: a's lower end by b's upper end, and a's upper end by
/// b's lower end.
struct Ratio {
  double value, lo, hi;
};
Ratio ratio_of(const Row& a, const Row& b);
/// Whether a takes less time than b for certain: their intervals are apart, and so are their medians by more than the
/// noise of the machine.
bool faster(const Row& a, const Row& b, double noise);

/// The row that the others are compared with, and the first of isect's that promises no wrong verdict; null if none.
const Row* standard_of(const std::vector<const Row*>&);
const Row* exact_of(const std::vector<const Row*>&);

/// The measure of an error in ulps that plots show: log2(1 + ulps), at most 64.
double bits(double ulps);
/// "near-tangent" as words: "near tangent"; "point-in-polygon" stays.
std::string words(std::string family);

}  // namespace isect::bench
