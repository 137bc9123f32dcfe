#pragma once
// The pictures of a report: inside its page, or beside it where they are many.

#include <string>

#include "app/checks/check_report.h"

namespace isect::program {

class ReportPictures {
 public:
  /// `file`: the page's; `most_inside`: bytes that may stand in the page.
  ReportPictures(const Report&, const std::string& file, std::size_t most_inside);
  /// Returns an image's `src`; empty for no bytes. `baseline` tells the format.
  std::string source_of(const std::string& baseline, const std::string& bytes);
  /// Returns what lies beside the page.
  HtmlReport take();

 private:
  HtmlReport beside_;
};

/// Returns " width=\"960\" height=\"600\"" of a PNG, so that nothing moves once it is there; empty of other bytes.
std::string size_attributes(const std::string& bytes);

}  // namespace isect::program
