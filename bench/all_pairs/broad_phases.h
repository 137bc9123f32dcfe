#pragma once
// All overlapping pairs by the libraries that are installed: Embree's rtcCollide, Bullet's btDbvt, FCL's dynamic AABB
// tree. Single-threaded, each pair listed once. Embree reports each pair twice, and leaves that are only near each
// other: its list is filtered by our comparison.

#ifdef ISECT_HAS_EMBREE
#include <embree3/rtcore.h>
#endif
#ifdef ISECT_HAS_BULLET
#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#endif
#ifdef ISECT_HAS_FCL
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#endif

#include <memory>
#include <vector>

#include <isect/many/all_pairs.h>

namespace isect::bench::peers {

using Boxes = std::vector<Aabb<float, 3>>;
using List = std::vector<IndexPair>;

#ifdef ISECT_HAS_EMBREE
struct Found {
  const Boxes& boxes;
  List pairs;
};

inline List embree(RTCDevice device, const Boxes& boxes) {
  RTCScene scene = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry, const_cast<Boxes*>(&boxes));
  const auto bounds = [](const RTCBoundsFunctionArguments* a) {
    const Aabb<float, 3>& box = (*static_cast<const Boxes*>(a->geometryUserPtr))[a->primID];
    a->bounds_o->lower_x = box.lo[0], a->bounds_o->lower_y = box.lo[1], a->bounds_o->lower_z = box.lo[2];
    a->bounds_o->upper_x = box.hi[0], a->bounds_o->upper_y = box.hi[1], a->bounds_o->upper_z = box.hi[2];
  };
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);

  Found found = {boxes, {}};
  const auto collide = [](void* to, RTCCollision* collisions, unsigned count) {
    Found& f = *static_cast<Found*>(to);
    for (unsigned k = 0; k < count; ++k) {
      const int i = static_cast<int>(collisions[k].primID0), j = static_cast<int>(collisions[k].primID1);
      if (i < j && intersects(f.boxes[i], f.boxes[j])) f.pairs.push_back({i, j});
    }
  };
  rtcCollide(scene, scene, collide, &found);
  rtcReleaseScene(scene);
  return found.pairs;
}
#endif

#ifdef ISECT_HAS_BULLET
inline List bullet(const Boxes& boxes) {
  struct Collect : btDbvt::ICollide {
    List pairs;
    void Process(const btDbvtNode* a, const btDbvtNode* b) override {
      if (a != b) pairs.push_back({std::min(a->dataAsInt, b->dataAsInt), std::max(a->dataAsInt, b->dataAsInt)});
    }
  } collect;
  btDbvt tree;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto& [lo, hi] = boxes[i];
    const btDbvtVolume volume = btDbvtVolume::FromMM({lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]});
    tree.insert(volume, nullptr)->dataAsInt = static_cast<int>(i);
  }
  tree.collideTT(tree.m_root, tree.m_root, collect);
  return collect.pairs;
}
#endif

#ifdef ISECT_HAS_FCL
/// FCL's objects are shapes with poses: boxes of the same bounds up to rounding.
inline List fcl_tree(const Boxes& boxes) {
  using Object = fcl::CollisionObject<float>;
  std::vector<std::unique_ptr<Object>> objects;
  std::vector<Object*> pointers;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vector<float, 3> size = boxes[i].hi - boxes[i].lo, center = (boxes[i].hi + boxes[i].lo) / 2;
    fcl::Transform3<float> pose = fcl::Transform3<float>::Identity();
    pose.translation() = center;
    objects.push_back(std::make_unique<Object>(std::make_shared<fcl::Box<float>>(size), pose));
    objects.back()->setUserData(reinterpret_cast<void*>(i));
    pointers.push_back(objects.back().get());
  }
  fcl::DynamicAABBTreeCollisionManager<float> manager;
  manager.registerObjects(pointers);
  manager.setup();
  List pairs;
  manager.collide(&pairs, [](Object* a, Object* b, void* to) {
    const int i = static_cast<int>(reinterpret_cast<std::size_t>(a->getUserData())),
              j = static_cast<int>(reinterpret_cast<std::size_t>(b->getUserData()));
    static_cast<List*>(to)->push_back({std::min(i, j), std::max(i, j)});
    return false;
  });
  return pairs;
}
#endif

template <class Race>
void all_pairs(Race& race) {
#ifdef ISECT_HAS_EMBREE
  RTCDevice device = rtcNewDevice("threads=1");
  race.row("Embree rtcCollide", 1'000'000, [&](const Boxes& boxes) { return embree(device, boxes); });
  rtcReleaseDevice(device);
#endif
#ifdef ISECT_HAS_BULLET
  race.row("Bullet btDbvt", 100'000, bullet);
#endif
#ifdef ISECT_HAS_FCL
  race.row("FCL tree (rounded boxes)", 100'000, fcl_tree);
#endif
}

}  // namespace isect::bench::peers
