// What a new object of each type looks like, before anybody has moved it.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/scene/types.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

/// Writes places and lengths that are given for an object of size 1 about the origin.
class Starting {
 public:
  explicit Starting(const Start& start) : flat_(start.flat) {
    constexpr double least = 1e-100, most = 1e100, parts = 8;
    const double size = std::isfinite(start.size) ? std::min(std::max(std::abs(start.size), least), most) : 1;
    unit_ = std::exp2(std::round(std::log2(size)));
    const double grain = unit_ / parts;
    for (int i = 0; i < (flat_ ? 2 : 3); ++i)
      if (std::abs(start.middle[i]) <= most) middle_[i] = grain * std::round(start.middle[i] / grain);
  }

  bool flat() const { return flat_; }
  const Vec3& middle() const { return middle_; }
  double length(double x) const { return unit_ * x; }
  Json place(const Vec3& p) const { return list(middle_ + unit_ * p); }
  Json along(const Vec3& v) const { return list(unit_ * v); }
  Json list(const Vec3& p) const {
    Json all = {p.x() + 0.0, p.y() + 0.0};  // no -0
    if (!flat_) all.push_back(p.z() + 0.0);
    return all;
  }
  Json places(const std::vector<Vec3>& points) const {
    Json all = Json::array();
    for (const Vec3& p : points) all.push_back(place(p));
    return all;
  }

 private:
  bool flat_;
  double unit_ = 1;
  Vec3 middle_ = Vec3::Zero();
};

void start_kdop(Json& object, const Starting& s) {
  std::vector<std::pair<Vec3, double>> slabs = {{{1, 0, 0}, 1}, {{0, 1, 0}, 1}};
  if (!s.flat()) slabs.push_back({{0, 0, 1}, 1});
  slabs.push_back(s.flat() ? std::pair<Vec3, double>{{1, 1, 0}, 1.5} : std::pair<Vec3, double>{{1, 1, 1}, 2});
  for (const char* field : {"normals", "lo", "hi"}) object[field] = Json::array();
  for (const auto& [normal, reach] : slabs) {
    object["normals"].push_back(s.list(normal));
    object["lo"].push_back(normal.dot(s.middle()) - s.length(reach));
    object["hi"].push_back(normal.dot(s.middle()) + s.length(reach));
  }
}

void start_frustum(Json& object, const Starting& s) {
  object["eye"] = s.place({0, 0, 1.5});
  object["forward"] = s.list({0, 0, -1}), object["up"] = s.list({0, 1, 0});
  object["angle"] = 45, object["aspect"] = 1.5;
  object["near"] = s.length(0.5), object["far"] = s.length(2);
}

/// Adds an octahedron.
void start_mesh(Json& object, const Starting& s) {
  object["points"] = s.places({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  object["triangles"] = Json::array();
  const int faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (const auto& face : faces) object["triangles"].push_back(Json{face[0], face[1], face[2]});
}

void start_obb(Json& object, const Starting& s) {
  object["center"] = s.place(Vec3::Zero());
  object["u"] = s.list({0.8, 0.6, 0}), object["v"] = s.list({-0.6, 0.8, 0});
  if (!s.flat()) object["w"] = s.list({0, 0, 1});
  object["half"] = s.along({1, 0.5, 0.5});
}

void write_fields(Json& object, Type type, const Starting& s) {
  switch (type) {
    case Type::point:
      object["at"] = s.place(Vec3::Zero());
      return;
    case Type::segment:
      object["from"] = s.place({-1, -0.5, 0}), object["to"] = s.place({1, 0.5, 0});
      return;
    case Type::ray:
    case Type::line:
      object["origin"] = s.place({-1, -0.25, 0}), object["dir"] = s.along({1, 0.25, 0});
      return;
    case Type::plane:
      object["normal"] = s.list({0, 1, 0}), object["d"] = 0.0 - s.middle().y();
      return;
    case Type::sphere:
      object["center"] = s.place(Vec3::Zero()), object["radius"] = s.length(1);
      return;
    case Type::box:
      object["lo"] = s.place({-1, -0.75, -0.5}), object["hi"] = s.place({1, 0.75, 0.5});
      return;
    case Type::obb:
      return start_obb(object, s);
    case Type::capsule:
      object["p"] = s.place({-0.75, 0, 0}), object["q"] = s.place({0.75, 0, 0}), object["r"] = s.length(0.5);
      return;
    case Type::cylinder:
      object["p"] = s.place({0, -1, 0}), object["q"] = s.place({0, 1, 0}), object["r"] = s.length(0.5);
      return;
    case Type::cone:
      object["apex"] = s.place({0, 1, 0}), object["base"] = s.place({0, -1, 0}), object["r"] = s.length(0.75);
      return;
    case Type::triangle:
      object["points"] = s.places({{-1, -0.75, 0}, {1, -0.75, 0}, {0, 1, 0}});
      return;
    case Type::polygon:
      object["points"] = s.places({{-1, -0.75, 0}, {1, -0.75, 0}, {1, 0.5, 0}, {0, 1, 0}, {-1, 0.5, 0}});
      return;
    case Type::kdop:
      return start_kdop(object, s);
    case Type::frustum:
      return start_frustum(object, s);
    case Type::hull:
      object["points"] = s.flat() ? s.places({{-1, -0.5, 0}, {0, -1, 0}, {1, -0.25, 0}, {0.5, 1, 0}, {-0.75, 0.75, 0}})
                                  : s.places({{-1, -0.75, -0.75}, {1, -0.75, -0.75}, {0, -0.75, 1}, {0, 1, 0}});
      return;
    case Type::mesh:
      return start_mesh(object, s);
    case Type::cloud:
      object["points"] =
          s.places({{-1, -0.5, 0}, {-0.25, 0.75, 0.5}, {0.25, -0.75, -0.5}, {0.5, 0.25, 0}, {1, 0.5, 0}});
      return;
  }
}

}  // namespace

Json start_of(Type type, const std::string& name, const Start& start) {
  const TypeSpec& row = spec(type);
  Json object = Json::object();
  const std::string other = other_name(row);
  object[start.flat && !other.empty() ? other : row.name] = name;
  write_fields(object, type, Starting(start));
  return object;
}

}  // namespace isect::program::scene
