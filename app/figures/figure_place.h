#pragma once
// The place where a figure of ours was made: lesson, step, parameters and camera, and a whole scene if there is one.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/program.h"
#include "viz/formats/formats.h"
#include "viz/player/reader_state.h"

namespace isect::program {

struct FigurePlace {
  viz::ReaderState state;
  const viz::Lesson* lesson = nullptr;
  std::string steps = {};   ///< for a strip or an animation all steps, "2-4"; else empty
  std::string folder = {};  ///< as Excerpt::folder; empty if the figure does not say
  std::string style = {};   ///< how it was asked for (see app/figures/style.h); empty if the figure does not say
  std::vector<FigurePlace> cases = {};  ///< of a strip of several settings, or a scale for several, all; else empty
  std::optional<std::size_t> scaled_as = {};  ///< the figure shows this one of them, at one scale with the others
};
/// Returns the place where a figure was made; the lesson of a scene is added `to` the others. Throws viz::BadInput,
/// also if the figure has no place, and viz::FileError.
FigurePlace place_in_figure(const Program&, const std::string& path, const viz::Format&,
                            std::vector<const viz::Lesson*>& to);

}  // namespace isect::program
