// Random pairs of objects, asked as a user does, through a scene's text, and judged by rationals that share no code
// with the core.
//
//    scene_pairs [PAIRS]
//
// PAIRS: 4,000 if not given, with ISECT_LONG a million. ISECT_SEED is as for the other tests. Each verdict in words,
// each t and each relation is compared. Each scene is a line of `isect query`, too, and must be answered there alike;
// so must the query of two objects that asks the same. What is wrong or not decided is printed as a scene of one line
// that `isect scene` reads, with the truth. Exit: 1 if there is any.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <map>
#include <set>

#include "app/query/query.h"
#include "app/scene/answered.h"
#include "app/scene/line.h"
#include "app/scene/shapes.h"
#include "tests/proof/draw.h"
#include "tests/proof/words.h"
#include "tests/settings.h"
#include "viz/lesson.h"

namespace isect::proof {

namespace {

namespace scene = program::scene;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr int most_printed = 200;

struct Count {
  long asked = 0, wrong = 0, undecided = 0;
};

class Judge {
 public:
  explicit Judge(std::uint64_t seed) : random_(seed) {}

  void run(long pairs) {
    while (all_.asked < pairs) one_scene(draw(random_));
  }

  int report() const {
    std::printf("%-44s %9s %6s %9s\n", "pair", "asked", "wrong", "undecided");
    for (const auto& [of, n] : of_types_)
      std::printf("%-44s %9ld %6ld %9ld\n", of.c_str(), n.asked, n.wrong, n.undecided);
    for (const auto& [of, n] : of_families_)
      std::printf("%-44s %9ld %6ld %9ld\n", of.c_str(), n.asked, n.wrong, n.undecided);
    std::printf("%-44s %9ld %6ld %9ld\n", "all", all_.asked, all_.wrong, all_.undecided);
    for (const auto& [why, n] : refused_) std::printf("refused %ld times: %s\n", n, why.c_str());
    std::printf("%ld pairs were asked by a query of two objects, too\n", queries_);
    std::printf("%.0f s, %.0f s of them the program's\n", seconds(), asking_);
    return all_.wrong + all_.undecided > 0 ? 1 : 0;
  }

 private:
  /// A scene file with its numbers, ready for questions.
  struct Opened {
    scene::File file;
    scene::NamedValues numbers;
    std::vector<Thing> things;
  };

  static Json text_of(const Json& objects, const Json& ask) { return {{"objects", objects}, {"ask", ask}}; }

  static Faces planes_of(const scene::NamedValues& s, const scene::Object& o) {
    Faces faces;
    if (o.type != scene::Type::frustum) return faces;
    for (const Plane<double, 3>& plane : scene::frustum_of(s, o).planes)
      faces.push_back(
          {{Rational(-plane.normal[0]), Rational(-plane.normal[1]), Rational(-plane.normal[2])}, Rational(plane.d)});
    return faces;
  }

  /// The objects without those that the program refuses; it must say why.
  Json accepted(const Json& objects) {
    Json kept = Json::array();
    for (const Json& o : objects) {
      try {
        scene::read_scene(text_of(Json::array({o}), Json::array()).dump(), "");
        kept.push_back(o);
      } catch (const viz::BadInput& e) {
        std::string why = e.what();
        ++refused_[o.begin().key() + why.substr(std::min(why.size(), why.find_last_of(':')))];
      }
    }
    return kept;
  }

  void one_scene(Drawn drawn) {
    try {
      scene::read_scene(text_of(drawn.objects, Json::array()).dump(), "");
    } catch (const viz::BadInput&) {
      drawn.objects = accepted(drawn.objects);
    }
    const std::size_t n = drawn.objects.size();
    if (n < 2) return;
    Json ask = Json::array();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Json pair = {drawn.objects[i].begin().value(), drawn.objects[j].begin().value()};
        if (random_() % 2 == 0) std::swap(pair[0], pair[1]);
        ask.push_back(pair);
      }
    const scene::File file = scene::read_scene(text_of(drawn.objects, ask).dump(), "");
    const scene::Context context = {file, {file.parameters, file.flat}, {}};
    std::vector<Thing> things;
    for (std::size_t i = 0; i < n; ++i) {
      things.push_back(Thing::read(drawn.objects[i], drawn.flat, planes_of(context.numbers, file.objects[i])));
      if (things.back().kind == Thing::Kind::body &&
          things.back().points.empty())  // a frustum whose planes are rounded
        return static_cast<void>(++refused_["a scene with an empty " + things.back().type]);
    }
    const Json line = Json::parse(scene::answer_line(text_of(drawn.objects, ask).dump(), 1).value().text);
    for (std::size_t i = 0; i < file.asked.size(); ++i) {
      const auto [a, b] = std::get<scene::PairAsked>(file.asked[i]);
      one_pair(drawn, context, a, b, things, line.contains("result") ? line["result"][i] : Json());
    }
  }

  /// Whether `isect query` gives each field the same value; a scene may tell more.
  bool same_by_query(const Json& query, const Json& result) {
    const Json said = Json::parse(query::answer(query.dump(), 1).text);
    ++queries_;
    if (!said.contains("result")) return false;
    for (const auto& [field, value] : said["result"].items())
      if (!result.contains(field) || result[field] != value) return false;
    return true;
  }

  static bool is_thin_hull(const Thing& t) { return t.type == "hull" && std::ranges::any_of(t.faces, &Face::equation); }
  static bool has_no_inside(const Thing& t) { return t.type == "mesh" && !t.closed; }

  void one_pair(const Drawn& drawn, const scene::Context& context, std::size_t a, std::size_t b,
                const std::vector<Thing>& things, const Json& as_line) {
    if (!has_test(things[a], things[b])) return;
    const Named x = {context.object(a).name, things[a]}, y = {context.object(b).name, things[b]};
    for (const auto& [one, other] : {std::pair{&x, &y}, {&y, &x}})
      if (has_no_inside(one->thing) && (other->thing.type == "point" || other->thing.type == "cloud")) return;
    std::string verdict, wrong;
    Json result;
    Judged judged = Judged::wrong;
    try {
      const double before = seconds();
      const scene::Answered answer = scene::answered(context, scene::PairAsked{a, b});
      asking_ += seconds() - before;
      verdict = answer.json["verdict"].get<std::string>(), result = answer.json["result"];
      judged = judge(verdict, x, y);
      if (judged == Judged::right) wrong = wrong_in_result(result, answer.json.contains("query"), x, y);
      if (!as_line.is_null() && as_line != answer.json) wrong = "line of a query";
      if (answer.json.contains("query") && !same_by_query(answer.json["query"], result)) wrong = "query";
      if (!wrong.empty()) judged = Judged::wrong;
    } catch (const viz::BadInput& e) {
      verdict = std::string("error: ") + e.what();
      if (is_thin_hull(things[a]) || is_thin_hull(things[b])) return static_cast<void>(++refused_["a thin hull"]);
    } catch (const std::exception& e) {
      verdict = std::string("error of another kind: ") + e.what();
    }
    const std::string types = std::minmax(things[a].type, things[b].type).first + ", " +
                              std::minmax(things[a].type, things[b].type).second +
                              (drawn.flat ? " in the plane" : " in space");
    for (Count* n : {&of_types_[types], &of_families_[name(drawn.family)], &all_}) {
      ++n->asked;
      n->wrong += judged == Judged::wrong || judged == Judged::unknown;
      n->undecided += judged == Judged::undecided;
    }
    if (judged == Judged::right || ++printed_[types] > 3 || ++told_ > most_printed) return;
    const Json line =
        text_of(Json::array({drawn.objects[a], drawn.objects[b]}), Json::array({Json::array({x.name, y.name})}));
    std::cout << types << ", " << name(drawn.family) << ": " << verdict
              << (wrong.empty() ? "" : " with a wrong " + wrong) << "\n  result " << result.dump()
              << "\n  truth: " << truth_of(x, y) << "\n  " << line.dump() << std::endl;
  }

  std::mt19937_64 random_;
  double asking_ = 0;
  long queries_ = 0;
  std::map<std::string, Count> of_types_, of_families_;
  std::map<std::string, long> refused_;
  std::map<std::string, int> printed_;
  int told_ = 0;
  Count all_;
};

}  // namespace

}  // namespace isect::proof

int main(int count, char** arguments) {
  const long pairs = count > 1 ? std::atol(arguments[1]) : isect::tests::cases(4000, 1'000'000);
  isect::proof::Judge judge(isect::tests::seed());
  judge.run(pairs);
  std::printf("seed %llu\n", static_cast<unsigned long long>(isect::tests::seed()));
  return judge.report();
}
