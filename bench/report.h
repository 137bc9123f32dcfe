#pragma once
// What a run of the measurements found: speed against error, as plain values that JSON, CSV, table, plots and the
// lesson all read.

#include <optional>
#include <string>
#include <vector>

namespace isect::bench {

/// Errors of one method's values over one family.
struct Errors {
  double median = 0, p99 = 0, most = 0;
};

/// Wrong verdicts of a test that answers a sign or a location.
struct Sides {
  long called_on = 0;   ///< "on" (zero) where the truth is a side
  long wrong_side = 0;  ///< a side where the truth is the other one, or "on"
};

/// One method of one test, on one family of cases, in one scalar.
struct Row {
  std::string test;       ///< "ray-sphere"
  std::string method;     ///< "half-B", "exact", or a peer's name with what was asked of it
  std::string library;    ///< "isect" or the peer's
  std::string scalar;     ///< "float" or "double"
  std::string family;     ///< "ordinary", "near-tangent", ...
  bool hard = false;      ///< a family made to break naive tests
  bool exact = false;     ///< promises no wrong verdict at all
  bool standard = false;  ///< what the others' times are divided by

  double ns = 0;                  ///< least time of the passes, a query
  double median = 0;              ///< median of the passes
  double lo = 0, hi = 0;          ///< 95 % interval of that median, by the bootstrap over the passes
  double spread = 0;              ///< (third - first quartile of the passes) / median
  std::optional<double> latency;  ///< ns a call where each call's input depends on the answer before
  long cases = 0;                 ///< distinct inputs timed, each once a pass

  long judged = 0;             ///< of these, how many the oracle judged
  long false_yes = 0;          ///< verdicts other than the truth where the truth is no (or zero)
  long false_no = 0;           ///< all other wrong verdicts
  std::optional<Sides> sides;  ///< the same wrong verdicts by another count, where the test has sides
  std::string first_wrong;     ///< the first case judged wrong, in full precision; empty if none

  std::optional<Errors> ulps;         ///< of t or the distance, where method and truth both have one
  std::optional<Errors> conditioned;  ///< the relative error divided by u times the condition number
  std::optional<Errors> residual;     ///< how far the point found lies off the surface, relative to its size, over u
  std::vector<double> quantiles;   ///< of the error in ulps, 41 of them at 0, 2.5 %, ..., 100 %; empty without values
  std::optional<double> fallback;  ///< share of the calls that needed exact or extended arithmetic

  long wrong() const { return false_yes + false_no; }
  double wrong_per_million() const {
    return judged == 0 ? 0 : 1e6 * static_cast<double>(wrong()) / static_cast<double>(judged);
  }
};

/// Time against the number of elements.
struct Growth {
  std::string test, method, library;
  std::string unit;  ///< what one time is of: "query", "build", "all pairs"
  std::vector<double> n, ns;
  double exponent = 0;  ///< slope of log time against log n, fitted by least squares

  /// The exponent, if at least three sizes were measured: with two, the fit can't be checked.
  std::optional<double> power() const { return n.size() < 3 ? std::nullopt : std::optional(exponent); }
};

/// A time that is not a query's: starting the program, rendering a figure, drawing a frame.
struct Duty {
  std::string what;
  double value = 0;
  std::string unit;              ///< "ms", "MB", "frames/s"
  std::optional<double> target;  ///< an upper bound; for frames/s a lower one
};

/// What a family of cases is made of, as a sentence of the report without its capital letter.
struct Note {
  std::string test, family, text;
};

/// A number that a suite aims at, and the most that it may be.
struct Target {
  enum Kind {
    ratio,   ///< ours / theirs: medians of the ordinary family, in one run
    growth,  ///< the same at `n` elements
    time,    ///< ours in ns, at `n` elements
    wrong,   ///< wrong verdicts of isect, all families together
    ulps,    ///< greatest error of isect, all families together
    hard,    ///< ours / naive where that is greatest: over all hard families, in double and float
    touch    ///< ours where shapes touch exactly, as of integers or tenths, / ours on the ordinary family; likewise
  };
  std::string work;  ///< what is done, for the table
  Kind kind = ratio;
  std::string test;                    ///< of Row or Growth
  std::string ours = "exact";          ///< method of isect
  std::string theirs = {};             ///< method of isect, or library; "naive": the row that others are divided by
  double n = 0;                        ///< of Growth
  std::string unit = {};               ///< of Growth: "query", "build"; empty: any
  std::string scalar = "double";       ///< of Row
  std::optional<double> at_most = {};  ///< none: reported only
  std::string limit = {};              ///< where it may be missed: what takes the time, as sentences
};

struct Machine {
  std::string cpu, compiler, flags, build;  ///< build: "portable" or "native"
  int cores = 0;
  double load = 0;   ///< of the last minute, when the run began
  double noise = 0;  ///< by which the medians of a fixed loop differ: 0.03 = 3 %
  std::string date;
  std::string commit = {};     ///< what was built, "-dirty" if changed since; ", " between several; empty: unknown
  std::string caches = {};     ///< "1 MB of L2, 32 MB of L3"; empty: unknown
  std::string libraries = {};  ///< those measured beside, with their versions: "CGAL 5.5.1, ..."; empty: none
};

struct Report {
  Machine machine;
  unsigned long long seed = 1;
  bool quick = false;  ///< not all cases were judged
  std::vector<Row> rows = {};
  std::vector<Growth> growths = {};
  std::vector<Duty> duties = {};
  std::vector<Note> notes = {};      ///< of the hard families
  std::vector<Target> targets = {};  ///< in the order of their suites

  /// The text of a family's note; nothing where there is none.
  std::string note(const std::string& test, const std::string& family) const;
  /// Adds what another run of the same build found; the noisier machine counts.
  void add(Report other);
};

/// The commits that its programs were built from; empty where that is unknown.
std::vector<std::string> commits(const Machine&);

std::string json(const Report&);            ///< one row a line; doubles to four significant digits
Report report_of(const std::string& json);  ///< Throws std::runtime_error that names what is wrong.
std::string csv(const Report&);             ///< the rows, a header line first (RFC 4180)
std::string table(const Report&);           ///< the rows for a terminal, one block a test, scalar and family

/// Slope of log y against log x by least squares.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace isect::bench
