#include "app/scene/markup.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "viz/text/tex_math.h"

namespace isect::program::scene {

namespace {

bool by_tex_alone = false;

void check_math(const Source& source, const std::string& math, const Path& path) {
  const viz::TexMath read = viz::read_tex_math(math);
  if (!read.error.empty())
    source.refuse(path, fmt::format("LaTeX refuses ${}$: {}; a dollar sign is written \\$", math, read.error));
  if (!read.beyond.empty() && !by_tex_alone)
    source.refuse(path, fmt::format("{} in ${}$ is set by LaTeX only; draw it with --format tikz, or write the formula "
                                    "without (isect scene --help lists what is set elsewhere)",
                                    fmt::join(read.beyond, ", "), math));
}

}  // namespace

std::string read_markup(const Source& source, const Json& json, const Path& path) {
  const std::string text = source.text(json, path);
  std::string markup;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\\' && i + 1 < text.size()) {
      markup += text.substr(i, 2), i += 2;
      continue;
    }
    const std::size_t end = text[i] == '$' ? viz::end_of_tex_math(text, i) : text.npos;
    if (end != text.npos) {
      check_math(source, text.substr(i + 1, end - i - 2), path);
      markup += text.substr(i, end - i), i = end;
      continue;
    }
    if (text[i] == '$') markup += '\\';
    markup += text[i++];
  }
  return markup;
}

void set_by_tex_alone(bool alone) { by_tex_alone = alone; }

}  // namespace isect::program::scene
