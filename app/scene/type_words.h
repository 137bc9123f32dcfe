#pragma once
// What types of objects and volumes around them are called, in the language that is spoken, in the form that a sentence
// needs.

#include <cstddef>
#include <string>

#include "app/scene/objects.h"
#include "viz/lang/message.h"

namespace isect::program::scene {

/// Returns "oriented box", as in a list: "oriented box B, ray r".
std::string type_in_list(Type, bool flat);
/// Returns "3 spheres"; in the plane "3 circles".
std::string counted_types(std::size_t n, Type, bool flat);
/// Returns "an obb", as in "no test is made for an obb and a cloud".
std::string article_and_type(Type);
/// Returns "Which oriented box fits M tightly?" for the name of a volume in files, "obb". `name`: of the object, as
/// markup.
std::string asked_volume(const std::string& volume, bool flat, const std::string& name);

/// What is said of a volume around an object, which is {a}.
struct VolumeWords {
  const char* volume;  ///< as files call it
  bool flat;
  viz::Message in_list,  ///< "smallest ball"
      title,             ///< "The smallest ball of {a}"
      verdict,           ///< "the smallest ball of {a} has volume {size}"
      size;              ///< "volume of the smallest ball"
};
const VolumeWords& words_of(const std::string& volume, bool flat);

}  // namespace isect::program::scene
