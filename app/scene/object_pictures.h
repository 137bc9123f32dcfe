#pragma once
// The picture of each object, kept while its numbers stay.

#include <cstddef>
#include <vector>

#include "app/scene/objects.h"

namespace isect::program::scene {

class ObjectPictures {
 public:
  struct Picture {
    viz::Role role;
    HandlesOf which;
    std::vector<viz::Item> items = {};
    std::vector<viz::Handle> handles = {};
  };

  /// Returns the room of all objects. Throws viz::BadInput if one's numbers are no shape for the core.
  Room room(const NamedValues&, const std::vector<Object>&);
  /// Returns the picture of object number `i`. Throws viz::BadInput if its numbers are no shape for the core. It lasts
  /// until the next call.
  const Picture& of(const NamedValues&, const Object&, std::size_t i, const Room&, viz::Role, HandlesOf);
  /// Says that this object has other numbers.
  void forget(std::size_t i);
  /// Returns how many pictures were made so far.
  int made() const { return made_; }

 private:
  struct Kept {
    bool has_box = false;
    viz::Vec3 lo = viz::Vec3::Zero(), hi = viz::Vec3::Zero();
    Room room = {};  ///< for which the pictures were made
    std::vector<Picture> pictures = {};
  };
  Kept& kept(std::size_t i);

  std::vector<Kept> kept_;
  Picture large_ = {viz::Role::text, HandlesOf::all};  ///< the last one that is too large to be kept
  int made_ = 0;
};

}  // namespace isect::program::scene
