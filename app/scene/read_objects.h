#pragma once
// The objects of a scene file.

#include <string>
#include <vector>

#include "app/scene/source.h"

namespace isect::program::scene {

struct ReadObjects {
  std::vector<Object> all;
  viz::Parameters parameters;
  Json json;  ///< as in the file, with the points of short files instead of their names
};

/// Reads the objects. `folder`: what names of other files are relative to. Throws viz::BadInput, viz::FileError.
ReadObjects read_objects(Source&, const std::string& folder);

/// Throws viz::BadInput unless the name is one: letters and digits.
void require_name(const Source&, const std::string& name, const Path&);
/// Reads "from step" and "to step". Throws viz::BadInput.
StepRange read_steps(const Source&, const Json&, const Path&);

/// Returns the index of the object with this name; the error for a missing one names the nearest.
std::size_t object_named(const Source&, const std::vector<Object>&, const Json& name, const Path&);

}  // namespace isect::program::scene
