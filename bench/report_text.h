#pragma once
// The measurements as a text to be read, with its figures: bench/REPORT.md. Every sentence is computed from the rows,
// so that none contradicts them.

#include <optional>
#include <string>
#include <vector>

#include "bench/plots.h"
#include "bench/proof.h"
#include "bench/report.h"

namespace isect::bench {

/// One run for any machine, and if they were made: one compiled for this machine, one beside other libraries.
struct Measured {
  Report portable;
  std::optional<Report> native = {}, peers = {};
};
/// Sorts reports by their build; several of one are put together, in the order of the suites. Throws std::runtime_error
/// if none is portable, or two of one build have the same test.
Measured measured_of(std::vector<Report>);

/// The text and the figures that it names: as SVG, maps as PNG.
struct Publication {
  std::string text;
  std::vector<std::pair<std::string, std::string>> files;  ///< name in the folder report/, bytes
};
Publication publication(const Measured&, const std::optional<Proof>& = {});

// Its parts.
std::string machine_text(const Measured&);
/// The first page: a line a test with its times, who is right, and what to choose.
std::string summary_text(const Measured&);
/// Who is right about the hard cases: a line a test, a column a library.
std::string verdicts_text(const Report& peers);
/// What one test found: a paragraph, what to choose, tables.
std::string test_text(const Measured&, const std::string& test);
/// Which targets were met and which missed, as a table.
std::string target_text(const Measured&);
/// Everything in which a naive method or another library is ahead.
std::string loss_text(const Measured&);

/// The rows that the lesson `speed-against-error` reads, without what it does not: bench/results.json.
Report lesson_excerpt(const Report&);

/// The most noise that a published report may have been measured at.
constexpr double most_noise = 0.1;
/// Throws std::runtime_error where a machine is noisier.
void require_quiet(const Machine&);
/// Throws std::runtime_error where builds come from different commits, or one from changed sources. Unknown commits are
/// equal.
void require_one_commit(const std::vector<Machine>&);
/// Throws std::runtime_error that says which run can't be published and why: besides those, a quick one.
void require_publishable(const Measured&);

/// Writes REPORT.md, report/* and results.json into `folder`; figures of an earlier report go. The long proof is told
/// if the folder has one, proof.json. Throws viz::FileError,
/// and std::runtime_error where a run is not publishable.
void publish(const Measured&, const std::string& folder);

}  // namespace isect::bench
