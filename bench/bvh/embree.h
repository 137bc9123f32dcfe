#pragma once
// A mesh in Embree's form. Embree works in float, with a test of ray and triangle that is not exact, and with as many
// lanes as the machine has; ours is compiled for any x86-64 and exact in double. Single-threaded, as ours.

#include <embree3/rtcore.h>

#include <cmath>
#include <cstring>
#include <limits>

#include <isect/triangle_mesh.h>

namespace isect::bench::embree {

/// A scene of one mesh, built on construction.
class Scene {
 public:
  template <class S>
  explicit Scene(const TriangleMesh<S>& mesh) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh.vertices.size()));
    for (const Point<S, 3>& p : mesh.vertices)
      for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(p[i]);
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
                                            mesh.triangles.size());
    std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    rtcCommitScene(scene_);
  }
  ~Scene() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// The closest hit; t is infinite without one.
  template <class S>
  RTCRayHit closest(const Ray<S, 3>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit = {};
    hit.ray = converted(ray);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) hit.ray.tfar = std::numeric_limits<float>::infinity();
    return hit;
  }
  template <class S>
  bool any(const Ray<S, 3>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay embree = converted(ray);
    rtcOccluded1(scene_, &context, &embree);
    return embree.tfar < 0;
  }

 private:
  template <class S>
  static RTCRay converted(const Ray<S, 3>& ray) {
    RTCRay result = {};
    const auto f = [](S x) { return static_cast<float>(x); };
    result.org_x = f(ray.origin[0]), result.org_y = f(ray.origin[1]), result.org_z = f(ray.origin[2]);
    result.dir_x = f(ray.direction[0]), result.dir_y = f(ray.direction[1]), result.dir_z = f(ray.direction[2]);
    result.tnear = f(ray.range.lo), result.tfar = f(ray.range.hi), result.mask = ~0u;
    return result;
  }

  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace isect::bench::embree
