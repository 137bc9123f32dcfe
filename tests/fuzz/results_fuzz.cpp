// Any bytes as the results of measurements, or as what the long proof found: values, or a refusal. Values that are
// written and read again are written the same.

#include <cstdint>
#include <stdexcept>
#include <string>

#include "bench/compare_reports.h"
#include "bench/proof.h"
#include "bench/report.h"
#include "tests/fuzz/require.h"

namespace {

using namespace isect::bench;

void check_report(const std::string& text) {
  Report report;
  try {
    report = report_of(text);
  } catch (const std::runtime_error&) {
    return;
  }
  const std::string once = json(report);
  try {
    require(json(report_of(once)) == once, "written and read again it is the same", text);
  } catch (const std::runtime_error& e) {
    require(false, e.what(), once);
  }
  require(!csv(report).empty(), "a line of headings", text);
  table(report);
  try {
    require(!told(compare(report, report)).empty(), "a comparison in words", text);
  } catch (const std::runtime_error&) {
  }
}

void check_proof(const std::string& text) {
  try {
    require(!proof_text(proof_of(text)).empty(), "a section of the report", text);
  } catch (const std::runtime_error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  check_report(text);
  check_proof(text);
  return 0;
}
