#pragma once
// The objects of a scene file.

#include <string>
#include <vector>

#include "app/scene/source.h"

namespace isect::program::scene {

struct ReadObjects {
  std::vector<Object> all;
  viz::Parameters parameters;
  Json json;  ///< as in the file, the points of short files in place of their names
};

/// `folder`: what names of other files are relative to. Throws viz::BadInput, viz::FileError.
ReadObjects read_objects(Source&, const std::string& folder);

/// The index of the object with this name; the nearest one is told where there is none.
std::size_t object_named(const Source&, const std::vector<Object>&, const Json& name, const Path&);

}  // namespace isect::program::scene
