// Two triangles with a common edge, and the neighbours of a ray: which of them slip through.

#include "lessons/ray_triangle/seam.h"

#include <algorithm>
#include <array>

#include "lessons/ray_triangle/telling.h"
#include "lessons/shared/microscope.h"
#include "lessons/shared/plural.h"

namespace isect::lessons::ray_triangle_lesson {
namespace {

using namespace viz;

bool meets(Test test, const Ray3& ray, const Triangle3& triangle) {
  switch (test) {
    case Test::moller_trumbore:
      return ray_triangle::moller_trumbore(ray, triangle).has_value();
    case Test::volumes:
      return ray_triangle::signed_volumes(ray, triangle).has_value();
    case Test::shear:
      return ray_triangle::woop(ray, triangle).has_value();
    case Test::exact:
      break;
  }
  return intersects(ray, triangle);
}

const char* name_of(int test) {
  static const char* const names[] = {"Möller and Trumbore", "signed volumes", "shear"};
  return names[test];
}

class SeamTeller {
 public:
  explicit SeamTeller(const Setup& s)
      : s_(s),
        all_(neighbours(s)),
        ringed_(all_[microscope::place_of(s.selected)]),
        script_({"Möller and Trumbore, Fast, minimum storage ray/triangle intersection (1997); Woop, Benthin and Wald, "
                 "Watertight ray/triangle intersection (2013)",
                 fmt::format("Two triangles abc and cbq share the edge bc. Of {} neighbours of a ray, {} slip between "
                             "them by the test of Möller and Trumbore.",
                             counted(total()), counted(holes(0))),
                 {
                     "for each neighbour of d",                                         // 0
                     "    truth ← the triangles that the ray meets, by exact signs",    // 1
                     "    answer ← those that it meets by Möller and Trumbore",         // 2
                     "    answer ← those that it meets by signed volumes",              // 3
                     "    answer ← those that it meets after the shear",                // 4
                     "    an answer of neither is a hole, unless the truth is neither"  // 5
                 },
                 "a seam"}) {}

  Walk tell() {
    Step& place = script_.add(
        "seam", "Two triangles, one edge", 0,
        std::string("The triangles **a**, **b**, **c** and **c**, **b**, **q** share the edge bc. ") +
            (no_edge() ? "But **b** and **c** are equal here: they have no edge between them, and no area.\n"
             : aimed() ? "The ray **o** + *t* **d** is aimed at it: it must meet one of them, or both.\n"
             : alike() ? "The ray **o** + *t* **d** is not aimed at it: all its neighbours have one true answer.\n"
                       : "Not all neighbours of the ray **o** + *t* **d** have one true answer.\n") +
            "Its neighbours have the next doubles in *x* and in *y* of **d**. We test them one by one.");
    place.scene = picture(s_, {});
    truth();
    moller_trumbore_cells();
    signed_cells(
        1, "volumes", "By signed volumes",
        "For both triangles the signed volume of this edge is one number, with opposite signs. Rounding leaves "
        "that so.");
    signed_cells(2, "shear", "After the shear",
                 "For both triangles the area at this edge is one number, too, with opposite signs.");
    end();
    return std::move(script_.walk());
  }

 private:
  int count(const auto& holds) const { return static_cast<int>(std::ranges::count_if(all_, holds)); }
  int total() const { return static_cast<int>(all_.size()); }
  int holes(int test) const {
    return count([&](const Answers& a) { return a.hole(test); });
  }
  /// How many answers name one triangle where the truth is the other one.
  int exchanged(int test) const {
    return count([&](const Answers& a) {
      const Met& m = a.rounded[test];
      return m.own != m.other && a.exact.own != a.exact.other && m.own != a.exact.own;
    });
  }
  bool alike() const {
    return std::ranges::all_of(all_, [&](const Answers& a) { return a.exact == all_.front().exact; });
  }
  bool no_edge() const { return s_.vertex(1) == s_.vertex(2); }
  /// Whether each neighbour meets one of the two, and some leave out the one, some the other.
  bool aimed() const {
    return std::ranges::all_of(all_, [](const Answers& a) { return a.exact.any(); }) &&
           std::ranges::any_of(all_, [](const Answers& a) { return !a.exact.own; }) &&
           std::ranges::any_of(all_, [](const Answers& a) { return !a.exact.other; });
  }

  static Role role_of(const Met& m, bool hole) {
    return hole               ? Role::miss
           : m.own && m.other ? Role::highlight
           : m.own            ? Role::second
           : m.other          ? Role::grid
                              : Role::construction;
  }

  /// A picture of one answer in each cell; `test`: of which rounded test, -1 for the truth.
  Step& raster(const std::string& slug, const std::string& title, int line, const std::string& caption, int test) {
    const auto answer = [&](const Answers& a) -> const Met& { return test < 0 ? a.exact : a.rounded[test]; };
    const auto role = [&](const Answers& a) { return role_of(answer(a), test >= 0 && a.hole(test)); };
    std::vector<Cell> shades;
    for (const Answers& a : all_) shades.push_back({role(a), {}});
    std::vector<std::pair<Role, std::string>> keys;
    const std::pair<Role, const char*> names[] = {{Role::second, "abc alone"},
                                                  {Role::grid, "cbq alone"},
                                                  {Role::highlight, "both"},
                                                  {Role::miss, "hole"},
                                                  {Role::construction, "neither"}};
    for (const auto& name : names)
      if (const int n = count([&](const Answers& a) { return role(a) == name.first; }); n > 0)
        keys.emplace_back(name.first, fmt::format("{}: {}", name.second, counted(n)));
    Step& step = script_.add(slug, title, line, caption, "ringed: " + words(answer(ringed_)));
    step.scene = cells(s_, std::move(shades), keys);
    return step;
  }

  void truth() {
    const int both = count([](const Answers& a) { return a.exact.own && a.exact.other; });
    raster(
        "truth", "What is true", 1,
        std::string(
            "Each cell is one ray. The exact test, an exact predicate, finds the true signs, and so is right in each "
            "cell.\n") +
            (both > 0 ? fmt::format("{} both triangles. A ray through the common edge does.\n",
                                    both == 1 ? std::string("One ray meets") : counted(both) + " rays meet")
                      : std::string()) +
            "A test is watertight if no ray slips between neighbours where it passes their common edge.",
        -1);
  }

  void moller_trumbore_cells() {
    const int n = holes(0);
    script_.value("cells", total());
    script_.value("holes by Möller and Trumbore", n, {}, n > 0 ? Role::miss : Role::muted);
    Step& step = raster(
        "moller-trumbore", "By Möller and Trumbore", 2,
        (n > 0 ? fmt::format("In {} the ray misses both triangles, as if the mesh had a hole.\n", plural(n, "cell"))
               : std::string("No ray slips through here.\n")) +
            "At this edge abc asks whether *u* + *v* ≤ 1, and cbq whether *v* ≥ 0. These are different numbers, "
            "rounded apart.",
        0);
    step.question =
        Question{"In how many of these cells does the ray miss both triangles, though in truth it meets one?",
                 {"in none of them", "in less than a tenth", "in a tenth or more"},
                 n == 0             ? 0
                 : 10 * n < total() ? 1
                                    : 2,
                 fmt::format("In {} of {}, counted.", counted(n), counted(total()))};
  }

  void signed_cells(int test, const std::string& slug, const std::string& title, const std::string& why) {
    const int n = holes(test), wrong = exchanged(test);
    script_.value(fmt::format("holes by {}", name_of(test)), n, {}, n > 0 ? Role::miss : Role::muted);
    raster(slug, title, 2 + test,
           why + "\n" +
               (n > 0 ? fmt::format("In {} the ray slips through all the same.", plural(n, "cell"))
                      : std::string("No ray slips through here.")) +
               (wrong > 0 ? fmt::format(" In {} rounding names the wrong one of the two.", plural(wrong, "cell"))
                          : std::string()),
           test);
  }

  void end() {
    const bool open = holes(0) + holes(1) + holes(2) > 0;
    script_.settle(
        open ? Verdict::Kind::no : Verdict::Kind::yes,
        fmt::format("{} of Möller and Trumbore in {}; exact: none", plural(holes(0), "hole"), plural(total(), "cell")));
    std::string told =
        "The exact test leaves no hole: both triangles get the true sign of their common edge.\n"
        "That cures shared edges only. Where a vertex lies within another edge, a T-junction, a gap may show.\n";
    std::string found = "The ringed ray meets, exactly: " + words(ringed_.exact) + ".";
    for (int test = 0; test < 3; ++test)
      found += fmt::format(" {} {}: {}.", test == 2 ? "After the" : "By", name_of(test), words(ringed_.rounded[test]));
    Step& step = script_.add("holes", "Which tests are watertight here", 5, told + found);
    step.decides = true;
    step.scene = picture(s_, {.crossing = true, .settled = true});
  }

  const Setup& s_;
  const std::vector<Answers> all_;
  const Answers& ringed_;
  Script script_;
};

}  // namespace

Met met(Test test, const Ray3& ray, const Setup& s) {
  return {meets(test, ray, s.triangle), meets(test, ray, s.neighbour)};
}

std::string words(const Met& m) {
  return m.own && m.other ? "both" : m.own ? "abc alone" : m.other ? "cbq alone" : "neither";
}

std::vector<Answers> neighbours(const Setup& s) {
  std::array<double, microscope::columns> x, y;
  for (int k = 0; k < microscope::columns; ++k) {
    x[k] = microscope::neighbour<double>(s.given.x(), k - microscope::half);
    y[k] = microscope::neighbour<double>(s.given.y(), k - microscope::half);
  }
  std::vector<Answers> all;
  microscope::for_each_neighbour([&](int i, int j) {
    Ray3 ray = s.ray;
    ray.direction = {x[i + microscope::half], y[j + microscope::half], s.given.z()};
    Answers answers = {met(Test::exact, ray, s), {}};
    for (int k = 0; k < 3; ++k) answers.rounded[k] = met(rounded_tests[k], ray, s);
    all.push_back(answers);
  });
  return all;
}

Walk seam(const Setup& s) { return SeamTeller(s).tell(); }

}  // namespace isect::lessons::ray_triangle_lesson
