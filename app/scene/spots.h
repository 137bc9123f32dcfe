#pragma once
// Places that marks name: given, of an object, or computed from the core's answers. All but the first move along when
// objects are dragged.

#include <optional>
#include <string>
#include <vector>

#include "app/scene/exact_points.h"
#include "app/scene/source.h"

namespace isect::program::scene {

struct Context;
struct File;

struct Spot {
  enum class Kind {
    given,    ///< [1, 2]
    field,    ///< "A.center", or "p" for a point
    mark,     ///< "q", an earlier mark that is a point
    meeting,  ///< "r x S", a point that both have
    foot      ///< "foot of p on T", the point of T nearest to it
  };
  Kind kind = Kind::given;
  viz::Vec3 at = viz::Vec3::Zero();
  std::size_t a = 0,
              b = 0;  ///< indices: of the object whose field it is, of the mark, of both that meet; b: of the foot
  std::string field = {};
  int nth = 1;                ///< of several points that both have, along the first
  std::vector<Spot> of = {};  ///< for a foot: the place that it belongs to
  std::string text = {};      ///< markup, as sentences call it

  /// Whether the answer to a question tells it.
  bool tells(const File&) const;
};

struct FoundSpot {
  std::optional<viz::Vec3> at = {};      ///< to the nearest doubles; none: there is no such place
  std::optional<ExactPoint> exact = {};  ///< if no rounding was needed
  std::string why = {};                  ///< markup: why there is none
};

/// Reads a place. Throws viz::BadInput, which names what is allowed.
Spot read_spot(Source&, const File&, const Json&, const Path&);
/// Finds it at the current numbers. Throws viz::BadInput if the core refuses them.
FoundSpot find_spot(const Context&, const Spot&);
/// Returns a written place in which an object has another name.
std::string place_with_name(const std::string& place, const std::string& name, const std::string& now);
/// Whether a written place names an object or a mark.
bool place_names(const std::string& place, const std::string& name);

}  // namespace isect::program::scene
