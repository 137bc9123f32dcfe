#pragma once
// The questions of a scene file: "ask".

#include "app/scene/file.h"
#include "app/scene/source.h"

namespace isect::program::scene {

/// Reads the questions about the objects of `file`, what its author says of their answers, and where from they are
/// seen. The scene's camera was read before. Throws viz::BadInput.
void read_questions(Source&, File& file);

}  // namespace isect::program::scene
