#include "app/scene/files/shape_file.h"

#include "viz/formats/files.h"

namespace isect::program::scene {

/// A page reads no other files, so it goes without their readers.
ShapeFile read_shape_file(const std::string& path) { return viz::read_regular_file(path), ShapeFile(); }

}  // namespace isect::program::scene
