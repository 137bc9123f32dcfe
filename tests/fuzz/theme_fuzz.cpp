// Any bytes as a theme of one's own: a theme, or a refusal. What is written of it is read as the same theme.

#include <cstdint>
#include <string>

#include "app/figures/theme_text.h"
#include "tests/fuzz/require.h"
#include "viz/lesson.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const isect::program::ReadTheme once = isect::program::read_theme(text, "name");
    const std::string written = isect::program::theme_text(once.theme);
    try {
      const isect::program::ReadTheme twice = isect::program::read_theme(written, "other");
      require(twice.theme == once.theme, "written and read again it is the same", text);
      require(twice.faults.size() == once.faults.size(), "and it has the same faults", text);
    } catch (const isect::viz::BadInput& e) {
      require(false, e.what(), written);
    }
  } catch (const isect::viz::BadInput&) {
  }
  return 0;
}
