#pragma once
// The functions by which the window lists and changes the objects of kept scenes.

#include "viz/scene_editor.h"

namespace isect::program::scene {

viz::SceneEditor editor();

}  // namespace isect::program::scene
