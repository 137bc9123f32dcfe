#pragma once
// Mathematics in LaTeX's notation, `$r \le \lVert a - b \rVert$`, for texts that are not set by LaTeX: letters, signs
// and scripts in one line. LaTeX gets the source as it is.

#include <string>
#include <string_view>
#include <vector>

#include "viz/text/rich_text.h"

namespace isect::viz {

struct TexMath {
  std::vector<Run> runs = {};            ///< what is shown; the first has the source
  std::vector<std::string> beyond = {};  ///< what one line can't show, each once: "\oint"; it stands there as a word
  std::string error = {};  ///< why LaTeX would refuse it, too: "a brace is not closed"; empty: it does not
};
/// Reads what stands between two dollars, without them.
TexMath read_tex_math(std::string_view source);

/// Returns the end of the mathematics that begins with the dollar at i, behind its second dollar; npos if that dollar
/// is a lone one. No space stands inside beside a dollar, and no digit behind the second one: "$5 and $6" are prices.
std::size_t end_of_tex_math(std::string_view markup, std::size_t i);
/// Returns the packages that LaTeX needs for commands in this text: "amsmath,amssymb"; empty: none.
std::string tex_packages(std::string_view tex);

}  // namespace isect::viz
