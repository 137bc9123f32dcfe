#pragma once
// Random scenes of all types of objects, drawn so that they touch, are equal or lie in one another often.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace isect::proof {

using Json = nlohmann::ordered_json;

enum class Family {
  grid,        ///< small whole numbers
  tenths,      ///< decimals with one digit, which are not doubles
  beside,      ///< whole numbers, some moved by one ulp
  flat,        ///< no extent in some direction
  large,       ///< up to 1e300
  small,       ///< down to 1e-300
  subnormal,   ///< multiples of the least double
  mixed,       ///< all of these sizes in one scene
  nested,      ///< ever smaller ones within one another
  restated,    ///< the same set as another type
  thresholds,  ///< as many corners, faces or points as where another way through the program begins
};
inline constexpr int families = 11;
const char* name(Family);

struct Drawn {
  Family family;
  bool flat;
  Json objects = Json::array();
};

/// Draws a scene. An object's type is its first key; the names are capital letters.
Drawn draw(std::mt19937_64&);

}  // namespace isect::proof
