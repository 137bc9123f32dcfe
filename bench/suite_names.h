#pragma once
// What can be measured, known without the measurements themselves.

#include <string>
#include <vector>

namespace isect::bench {

/// The names of all suites, in the order of the report. CMake writes them from the folders of bench/.
const std::vector<std::string>& suite_names();

}  // namespace isect::bench
