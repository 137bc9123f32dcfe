#pragma once
// A figure of ours carries the place where it was made: lesson, step, parameters and camera, and a scene whole.

#include <string>
#include <vector>

#include "app/program.h"
#include "viz/formats.h"
#include "viz/place.h"

namespace isect::program {

struct FigurePlace {
  viz::Place place;
  std::string steps = {};   ///< of a strip or an animation: all of them, "2-4"; else empty
  std::string folder = {};  ///< as Excerpt::folder; empty where it does not say
  std::string style = {};   ///< how it was asked for (see app/style.h); empty where it does not say
};
/// The place where a figure was made; the lesson of a scene goes `to` the others. Throws viz::BadInput, also where it
/// carries none, and viz::FileError.
FigurePlace place_in_figure(const Program&, const std::string& path, const viz::Format&,
                            std::vector<const viz::Lesson*>& to);

}  // namespace isect::program
