// A page has no files besides the text that is opened in it.

#include "viz/formats/files.h"

#include <fmt/format.h>

namespace isect::viz {

namespace {

[[noreturn]] std::string refuse(const std::string& path) {
  throw FileError(fmt::format("{}: this page does not have it; drop the file on the page, or open it", path));
}

}  // namespace

std::string read_file(const std::string& path, std::size_t) { return refuse(path); }
std::string read_regular_file(const std::string& path) { return refuse(path); }
void write_file(const std::string& path, const std::string&) { refuse(path); }

}  // namespace isect::viz
