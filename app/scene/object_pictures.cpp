#include "app/scene/object_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isect::program::scene {

using viz::Vec3;

namespace {

/// An object with more points than this is not kept: a copy takes as long as a new one, and memory.
constexpr std::size_t most_points_kept = 2'000;

/// Returns the room of all that lies between these corners.
Room room_between(const Vec3& lo, const Vec3& hi) {
  if (!(lo.array() <= hi.array()).all()) return {};
  const double reach = (hi - lo).norm() / 2;
  return {(lo + hi) / 2, reach > 0 ? reach : 1};
}

bool same_room(const Room& a, const Room& b) { return a.middle == b.middle && a.reach == b.reach; }

}  // namespace

ObjectPictures::Kept& ObjectPictures::kept(std::size_t i) {
  if (i >= kept_.size()) kept_.resize(i + 1);
  return kept_[i];
}

void ObjectPictures::forget(std::size_t i) { kept(i) = {}; }

Room ObjectPictures::room(const NamedValues& numbers, const std::vector<Object>& objects) {
  Vec3 lo = Vec3::Constant(INFINITY), hi = -lo;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Kept& one = kept(i);
    if (!one.has_box) {
      one.lo = Vec3::Constant(INFINITY), one.hi = -one.lo;
      for (const Vec3& p : numbers.extent(objects[i])) one.lo = one.lo.cwiseMin(p), one.hi = one.hi.cwiseMax(p);
      one.has_box = true;
    }
    lo = lo.cwiseMin(one.lo), hi = hi.cwiseMax(one.hi);
  }
  return room_between(lo, hi);
}

const ObjectPictures::Picture& ObjectPictures::of(const NamedValues& numbers, const Object& o, std::size_t i,
                                                  const Room& room, viz::Role role, HandlesOf which) {
  Kept& one = kept(i);
  if (!same_room(one.room, room)) one.pictures.clear(), one.room = room;
  const auto wanted = [&](const Picture& p) { return p.role == role && p.which == which; };
  if (const auto found = std::ranges::find_if(one.pictures, wanted); found != one.pictures.end()) return *found;
  ++made_;
  Picture picture = {role, which, drawn(numbers, o, room, role), handles(numbers, o, room, role, which)};
  if (o.fixed.points.size() > most_points_kept) return large_ = std::move(picture);
  return one.pictures.emplace_back(std::move(picture));
}

}  // namespace isect::program::scene
