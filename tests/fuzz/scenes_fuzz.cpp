// Two objects of a scene, their numbers drawn from the input: each pair is answered or is said not to be decided, the
// two may be asked in either order, and scaling all lengths by a power of two changes no verdict.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/scene/questions.h"
#include "app/scene/read_objects.h"
#include "app/scene/source.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/source.h"
#include "viz/lesson.h"

namespace {

namespace scene = isect::program::scene;
using scene::Json;

/// How a field changes when all lengths are scaled: lengths and points do, directions do not.
enum class Form { point, direction, length, offset, axes, points, rings, slabs, triangles };
struct FieldSpec {
  const char* name;
  Form form;
};
struct TypeSpec {
  const char* type;
  bool in_plane;
  std::vector<FieldSpec> fields;
};

const std::vector<TypeSpec>& specs() {
  using enum Form;
  static const std::vector<TypeSpec> all = {
      {"point", true, {{"at", point}}},
      {"segment", true, {{"from", point}, {"to", point}}},
      {"ray", true, {{"origin", point}, {"dir", direction}}},
      {"line", true, {{"origin", point}, {"dir", direction}}},
      {"plane", true, {{"normal", direction}, {"d", offset}}},
      {"sphere", true, {{"center", point}, {"radius", length}}},
      {"box", true, {{"lo", point}, {"hi", point}}},
      {"obb", true, {{"center", point}, {"", axes}, {"half", point}}},
      {"capsule", true, {{"p", point}, {"q", point}, {"r", length}}},
      {"cylinder", false, {{"p", point}, {"q", point}, {"r", length}}},
      {"cone", false, {{"apex", point}, {"base", point}, {"r", length}}},
      {"triangle", true, {{"points", points}}},
      {"polygon", true, {{"points", points}}},
      {"kdop", true, {{"", slabs}}},
      {"hull", true, {{"points", points}}},
      {"frustum",
       false,
       {{"eye", point}, {"forward", direction}, {"up", direction}, {"near", length}, {"far", length}}},
      {"mesh", false, {{"points", points}, {"triangles", triangles}}},
      {"cloud", true, {{"points", points}}},
  };
  return all;
}

class Drawing {
 public:
  Drawing(Source& source, bool flat) : source_(source), n_(flat ? 2 : 3) {}

  Json object(const TypeSpec& spec, const char* name) {
    Json o = {{spec.type, name}};
    for (const FieldSpec& f : spec.fields) field(o, spec, f);
    if (o.contains("eye")) o["angle"] = 60;
    if (o.contains("lo") && o.contains("hi"))  // no box is empty
      for (std::size_t i = 0; i < o["lo"].size(); ++i)
        if (o["lo"][i] > o["hi"][i]) std::swap(o["lo"][i], o["hi"][i]);
    return o;
  }

 private:
  Json list(int count) {
    Json numbers = Json::array();
    for (int i = 0; i < count; ++i) numbers.push_back(std::clamp(source_.number(), -1e300, 1e300));
    return numbers;
  }
  Json points(int count) {
    Json all = Json::array();
    for (int i = 0; i < count; ++i) all.push_back(list(n_));
    return all;
  }

  void field(Json& o, const TypeSpec& spec, const FieldSpec& f) {
    const std::string type = spec.type;
    switch (f.form) {
      case Form::length:
        o[f.name] = std::abs(list(1)[0].get<double>());
        break;
      case Form::offset:
        o[f.name] = list(1)[0];
        break;
      case Form::axes:
        o["u"] = n_ == 2 ? Json{0.6, 0.8} : Json{0.6, 0.8, 0}, o["v"] = n_ == 2 ? Json{-0.8, 0.6} : Json{-0.8, 0.6, 0};
        if (n_ == 3) o["w"] = {0, 0, 1};
        break;
      case Form::points:
        o[f.name] = points(type == "triangle" ? 3 : type == "mesh" ? 4 : 3 + source_.below(5));
        break;
      case Form::triangles:
        o[f.name] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        break;
      case Form::slabs: {
        o["normals"] = n_ == 2 ? Json{{1, 0}, {0, 1}, {1, 1}} : Json{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
        o["lo"] = list(n_ + 1), o["hi"] = list(n_ + 1);
        break;
      }
      default:
        o[f.name] = list(n_);
        if (std::string(f.name) == "half")
          for (Json& x : o[f.name]) x = std::abs(x.get<double>());
    }
  }

  Source& source_;
  int n_;
};

/// All numbers 2^10 times as large; `exact` turns false when one does not fit.
Json scaled(const Json& value, bool& exact) {
  if (value.is_number()) {
    const double x = value.get<double>(), y = std::ldexp(x, 10);
    exact = exact && std::ldexp(y, -10) == x && std::abs(y) <= 1e300 && (x == 0 || std::abs(x) >= 0x1p-1022);
    return y;
  }
  Json all = value;
  for (Json& entry : all) entry = scaled(entry, exact);
  return all;
}
Json grown(const Json& object, bool& exact) {
  Json larger = object;
  for (auto& [key, value] : larger.items())
    if (!value.is_string() && key != "dir" && key != "normal" && key != "normals" && key != "u" && key != "v" &&
        key != "w" && key != "triangles" && key != "forward" && key != "up" && key != "angle")
      value = scaled(value, exact);
  return larger;
}

/// The verdict on [A, B]; empty where an object is not valid.
std::string verdict(const Json& a, const Json& b, bool turned) {
  try {
    const Json both = {{"objects", {a, b}}};
    const std::string whole = both.dump();
    scene::Source source(whole);
    const scene::ReadObjects objects = scene::read_objects(source, "");
    const scene::NamedValues numbers = {objects.parameters, source.flat()};
    const scene::Shaped one(numbers, objects.all[0]), other(numbers, objects.all[1]);
    const scene::Told told = turned ? scene::ask(other, one) : scene::ask(one, other);
    require(!told.verdict.text.empty(), "a verdict in words", whole);
    return told.open ? "open" : told.verdict.text;
  } catch (const isect::viz::BadInput& e) {
    require(std::string(e.what()) != "", "a refusal that says why", a.dump() + b.dump());
    return "";
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Source source(data, size);
  const bool flat = source.below(2) == 0;
  std::vector<Json> objects;
  for (const char* name : {"A", "B"}) {
    const TypeSpec& spec = specs()[static_cast<std::size_t>(source.below(static_cast<int>(specs().size())))];
    if (flat && !spec.in_plane) return 0;
    objects.push_back(Drawing(source, flat).object(spec, name));
  }
  const std::string asked = verdict(objects[0], objects[1], false), turned = verdict(objects[0], objects[1], true),
                    what = objects[0].dump() + ", " + objects[1].dump();
  require(asked.empty() == turned.empty() && (asked == "open") == (turned == "open"), "either order", what);
  require((asked.find("disjoint") == asked.npos) == (turned.find("disjoint") == turned.npos), "one verdict", what);

  bool exact = true;
  const Json a = grown(objects[0], exact), b = grown(objects[1], exact);
  if (exact) require(verdict(a, b, false) == asked, "scaling changes no verdict", what);
  return 0;
}
