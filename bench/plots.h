#pragma once
// What the measurements found, as charts with their captions.

#include <string>
#include <vector>

#include "bench/report.h"
#include "viz/chart/chart.h"

namespace isect::bench {

/// A chart, the name of its file, and its texts.
struct Plotted {
  std::string name;     ///< "ray-sphere-double-error": lower case, digits, '-'
  std::string caption;  ///< plain sentences
  std::string alt;      ///< what the picture shows, for those who don't see it; from the numbers themselves
  viz::Chart chart;
  double width = 227;  ///< in points, at which its text has its own size
};

/// Time against the error of the value at its 99th percentile, a panel a family.
Plotted error_plot(const Report&, const std::string& test, const std::string& scalar,
                   const std::vector<std::string>& families = {});
/// Time against wrong verdicts per million, a panel a family.
Plotted verdict_plot(const Report&, const std::string& test, const std::string& scalar,
                     const std::vector<std::string>& families = {});
/// How large a share of the values is within which error, a line a method.
Plotted distribution_plot(const Report&, const std::string& test, const std::string& scalar,
                          const std::vector<std::string>& families = {});
/// Time against the number of elements, with the exponent of the fitted power beside each line.
Plotted growth_plot(const Report&, const std::string& test, const std::string& unit);
/// The exact call's time divided by that of each library's fastest way, a row a test and library.
Plotted ratio_plot(const Report&);
/// The times of starting, drawing and rendering, divided by their limits.
Plotted duty_plot(const Report&);

/// All that the report has data for, test by test.
std::vector<Plotted> plots(const Report&);

/// The picture as SVG, or as PNG at three pixels a point.
std::string svg_of(const Plotted&, viz::ThemeName);
std::string png_of(const Plotted&, viz::ThemeName);

}  // namespace isect::bench
