#include "tests/cases/scenes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/scene/file.h"
#include "app/scene/shapes.h"
#include "bench/random_shapes.h"
#include "tests/cases/case_file.h"
#include "tests/proof/draw.h"
#include "viz/lesson.h"

namespace isect::cases {

namespace {

namespace scene = program::scene;
using proof::Family, proof::Posed, proof::Rational;

scene::File read(const SceneJson& objects) {
  const SceneJson whole = {{"objects", objects}, {"ask", SceneJson::array()}};
  return scene::read_scene(whole.dump(), "");
}

std::vector<Plane<double, 3>> frustum(const scene::File& file, std::size_t i) {
  if (file.objects[i].type != scene::Type::frustum) return {};
  const auto planes = scene::frustum_of({file.parameters, file.flat}, file.objects[i]).planes;
  return {planes.begin(), planes.end()};
}

proof::Faces faces_of(const std::vector<Plane<double, 3>>& planes) {
  proof::Faces faces;
  for (const auto& [n, d] : planes) faces.push_back({{Rational(-n[0]), Rational(-n[1]), Rational(-n[2])}, Rational(d)});
  return faces;
}

/// The frusta by name: each plane as its normal and d.
SceneJson planes_of_frusta(const SceneJson& objects) {
  const scene::File file = read(objects);
  SceneJson all = SceneJson::object();
  for (std::size_t i = 0; i < file.objects.size(); ++i)
    for (const auto& [n, d] : frustum(file, i)) all[file.objects[i].name].push_back({n[0], n[1], n[2], d});
  return all;
}

const char* what_is_hard(Family f) {
  switch (f) {
    case Family::grid:
      return "small whole numbers, which touch often";
    case Family::tenths:
      return "decimals with one digit, which are no doubles";
    case Family::beside:
      return "whole numbers, some moved by an ulp";
    case Family::flat:
      return "without extent in some direction";
    case Family::large:
      return "numbers up to 1e300, whose squares overflow";
    case Family::small:
      return "numbers down to 1e-300, whose squares vanish";
    case Family::subnormal:
      return "multiples of the least double";
    case Family::mixed:
      return "the smallest numbers beside the largest";
    case Family::nested:
      return "one within the other, or nearly";
    case Family::restated:
      return "the same set, or a part of it, as another type";
    case Family::thresholds:
      return "many corners, faces or points";
  }
  return "";
}

// How many cases each pair of types gets.
constexpr int of_an_answer = 3, of_a_family = 1, beside_an_ulp = 4;
constexpr int patience = 400;  // draws that are looked at, every third of them for an ulp
constexpr std::size_t most_letters = 700, most_letters_of_many = 3000;

/// An object of size s around the place x on the x axis, or from it on: it touches, holds or equals others of like
/// sizes.
SceneJson posed_object(const std::string& type, bool flat, double x, double s) {
  const auto at = [&](double dx, double y, double z) {
    SceneJson p = {x + dx * s, y * s};
    if (!flat) p.push_back(z * s);
    return p;
  };
  const auto vector = [&](double a, double b, double c) { return flat ? SceneJson{a, b} : SceneJson{a, b, c}; };
  SceneJson corners = SceneJson::array(), axes = SceneJson::array({vector(1, 0, 0), vector(0, 1, 0)});
  for (int k = 0; k < (flat ? 4 : 8); ++k) corners.push_back(at(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  if (!flat) axes.push_back(vector(0, 0, 1));
  const std::map<std::string, SceneJson> all = {
      {"point", {{"at", at(0, 0, 0)}}},
      {"segment", {{"from", at(-1, 0, 0)}, {"to", at(1, 0, 0)}}},
      {"ray", {{"origin", at(-1, 0, 0)}, {"dir", vector(s, 0, 0)}}},
      {"line", {{"origin", at(-1, 0, 0)}, {"dir", vector(s, 0, 0)}}},
      {"plane", {{"normal", vector(1, 0, 0)}, {"d", -x}}},
      {"sphere", {{"center", at(0, 0, 0)}, {"radius", s}}},
      {"box", {{"lo", at(-1, -1, -1)}, {"hi", at(1, 1, 1)}}},
      {"capsule", {{"p", at(0, -1, 0)}, {"q", at(0, 1, 0)}, {"r", s}}},
      {"cylinder", {{"p", at(0, -1, 0)}, {"q", at(0, 1, 0)}, {"r", s}}},
      {"cone", {{"apex", at(0, -1, 0)}, {"base", at(0, 1, 0)}, {"r", s}}},
      {"triangle", {{"points", {at(-1, -1, 0), at(1, -1, 0), at(0, 1, 0)}}}},
      {"polygon", {{"points", {at(-1, -1, 0), at(1, -1, 0), at(1, 1, 0), at(-1, 1, 0)}}}},
      {"kdop", {{"normals", axes}, {"lo", at(-1, -1, -1)}, {"hi", at(1, 1, 1)}}},
      {"hull", {{"points", corners}}},
      {"frustum",
       {{"eye", at(-2, 0, 0)},
        {"forward", vector(1, 0, 0)},
        {"up", vector(0, 1, 0)},
        {"angle", 90},
        {"near", s},
        {"far", 3 * s}}},
      {"mesh",
       {{"points", corners},
        {"triangles",
         {{0, 2, 1},
          {1, 2, 3},
          {4, 5, 6},
          {5, 7, 6},
          {0, 1, 4},
          {1, 5, 4},
          {2, 6, 3},
          {3, 6, 7},
          {0, 4, 2},
          {2, 4, 6},
          {1, 3, 5},
          {3, 7, 5}}}}},
      {"cloud", {{"points", {at(0, 0, 0), at(1, 1, 0)}}}}};
  SceneJson o = {{type, ""}};
  if (type == "obb") {
    o["center"] = at(0, 0, 0), o["u"] = axes[0], o["v"] = axes[1];
    if (!flat) o["w"] = axes[2];
    o["half"] = vector(s, s, s);
  } else {
    o.update(all.at(type));
  }
  return o;
}

class Chooser {
 public:
  explicit Chooser(bool flat)
      : flat_(flat), random_(bench::stream(1, flat ? "scenes in the plane" : "scenes in space")) {}

  std::vector<SceneJson> run(int draws) {
    for (int i = 0; i < draws; ++i) {
      const proof::Drawn drawn = proof::draw(random_);
      if (drawn.flat == flat_) pairs_of(drawn);
    }
    for (auto& [types, chosen] : chosen_) posed_pairs(types, chosen);
    std::vector<SceneJson> all;
    for (auto& [types, chosen] : chosen_)
      for (SceneJson& line : chosen.lines) {
        all.push_back({{"id", all.size()}});
        all.back().update(line);
      }
    return all;
  }

 private:
  /// The cases chosen for a pair of types.
  struct Chosen {
    std::vector<SceneJson> lines;
    std::map<std::string, int> of_answer;
    std::map<Family, int> of_family;
    int beside = 0, seen = 0;
  };

  void pairs_of(const proof::Drawn& drawn) {
    for (const SceneJson& a : drawn.objects)
      for (const SceneJson& b : drawn.objects)
        if (&a < &b && random_() % 2 == 0)
          pair(drawn.family, a, b);
        else if (&a < &b)
          pair(drawn.family, b, a);
  }

  /// Adds answers that the draws have not found.
  void posed_pairs(const std::array<std::string, 2>& types, Chosen& chosen) {
    struct Pose {
      double x, s;
    };
    static constexpr Pose poses[] = {{0, 1}, {0, 0.25}, {0, 4}, {2, 1}, {0.5, 1}, {6, 1}, {-2, 1}, {1, 1}};
    for (const Pose& p : poses)
      for (const Pose& q : poses) {
        SceneJson a = posed_object(types[0], flat_, p.x, p.s), b = posed_object(types[1], flat_, q.x, q.s);
        if (!proof::in_order(type(a), type(b))) std::swap(a, b);
        a.begin().value() = "A", b.begin().value() = "B";
        const SceneJson objects = {a, b};
        const std::optional<SceneJson> truth = judged(objects);
        if (truth && ++chosen.of_answer[kind_of_answer(*truth)] == 1)
          chosen.lines.push_back(line("of like sizes, beside each other or one in the other", objects));
      }
  }

  static std::string type(const SceneJson& o) { return o.begin().key(); }

  void pair(Family family, SceneJson a, SceneJson b) {
    if (!proof::in_order(type(a), type(b))) std::swap(a, b);
    Chosen& chosen = chosen_[{std::min(type(a), type(b)), std::max(type(a), type(b))}];
    const bool many = family == Family::thresholds;
    a.begin().value() = "A", b.begin().value() = "B";
    const SceneJson objects = {a, b};
    if (chosen.seen > patience || (many && chosen.of_family[family] > 0) ||
        written(objects).size() > (many ? most_letters_of_many : most_letters))
      return;
    const std::optional<SceneJson> truth = judged(objects);
    if (!truth) return;
    ++chosen.seen;
    const std::string kind = kind_of_answer(*truth);
    int &of_answer = chosen.of_answer[kind], &of_family = chosen.of_family[family];
    if (of_answer < (many ? 1 : of_an_answer) || of_family < of_a_family) {
      ++of_answer, ++of_family;
      chosen.lines.push_back(line(what_is_hard(family), objects));
    }
    if (chosen.beside < beside_an_ulp && chosen.seen % 3 == 0 && !many) beside(chosen, objects, kind);
  }

  /// Adds the objects with one number moved by an ulp, if that changes the answer.
  void beside(Chosen& chosen, SceneJson objects, const std::string& kind) {
    std::vector<SceneJson*> numbers;
    for (SceneJson& o : objects)
      for (auto& [key, value] : o.items())
        if ((flat_ || type(o) != "polygon") &&  // whose corners lie in one plane
            key != "triangles" && key != "u" && key != "v" && key != "w")
          collect(value, numbers);
    if (numbers.empty()) return;
    SceneJson& number = *numbers[random_() % numbers.size()];
    const double was = number.get<double>();
    number = std::nextafter(was, random_() % 2 == 0 ? HUGE_VAL : -HUGE_VAL);
    const std::optional<SceneJson> truth = judged(objects);
    if (!truth || kind_of_answer(*truth) == kind) return;
    ++chosen.beside, ++chosen.of_answer[kind_of_answer(*truth)];
    chosen.lines.push_back(
        line("an ulp beside another answer, which " + written(was) + " for " + written(number) + " has", objects));
  }
  static void collect(SceneJson& value, std::vector<SceneJson*>& numbers) {
    if (value.is_number()) numbers.push_back(&value);
    if (value.is_array())
      for (SceneJson& entry : value) collect(entry, numbers);
  }

  /// Returns nothing where the program refuses one of them, or the question has no answer.
  std::optional<SceneJson> judged(const SceneJson& objects, proof::Times times = proof::Times::left_out) const {
    try {
      const std::optional<Posed2> both = posed(objects, flat_);
      return both ? expected(*both, times) : std::nullopt;
    } catch (const viz::BadInput&) {
      return {};
    }
  }

  SceneJson line(const std::string& note, const SceneJson& objects) const {
    const SceneJson ask = SceneJson::array({SceneJson::array({"A", "B"})});
    SceneJson all = {{"note", note}, {"objects", objects}, {"ask", ask}};
    if (const SceneJson planes = planes_of_frusta(objects); !planes.empty()) all["conventions"] = {{"planes", planes}};
    all["expected"] = *judged(objects, proof::Times::nearest);
    return all;
  }

  bool flat_;
  std::mt19937_64 random_;
  std::map<std::array<std::string, 2>, Chosen> chosen_;
};

bool is_thin(const Posed& hull) { return std::ranges::any_of(hull.thing.faces, &proof::Face::equation); }

}  // namespace

std::optional<Posed2> posed(const SceneJson& objects, bool flat) {
  const scene::File file = read(objects);
  Posed2 both;
  for (std::size_t i = 0; i < 2; ++i) {
    both[i] = {objects[i], proof::Thing::read(objects[i], flat, faces_of(frustum(file, i)))};
    const proof::Thing& thing = both[i].thing;
    if (thing.kind == proof::Thing::Kind::body && thing.points.empty()) return {};
    if (thing.type == "hull" && is_thin(both[i])) return {};
  }
  return both;
}

std::optional<SceneJson> expected(const Posed2& both, proof::Times times) {
  const std::optional<SceneJson> answer = proof::answer(both[0], both[1], times);
  return answer ? std::optional(SceneJson::array({{{"result", *answer}}})) : std::nullopt;
}

std::string kind_of_answer(const SceneJson& expected) {
  SceneJson words = expected[0]["result"];
  for (auto& [key, value] : words.items()) {
    if (value.is_array()) value = !value.empty();
    if (value.is_number_float()) value = "some";
    if (value.is_number_integer() && key != "line_roots" && key != "side") value = value > 0;
  }
  return words.dump();
}

std::vector<SceneJson> scenes(bool flat) { return Chooser(flat).run(900); }

}  // namespace isect::cases
