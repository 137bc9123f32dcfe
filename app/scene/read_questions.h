#pragma once
// The questions of a scene file: "ask".

#include "app/scene/file.h"
#include "app/scene/source.h"

namespace isect::program::scene {

/// Reads the questions about the objects of `file`, and what its author says of their answers. Throws viz::BadInput.
void read_questions(const Source&, File& file);

}  // namespace isect::program::scene
