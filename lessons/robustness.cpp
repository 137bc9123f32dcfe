// Robustness (N10, rule 8): a microscope. Each cell is one floating-point neighbour of a point, coloured by what a naive
// test says of it, and by what is true.
//
// The tests under the microscope stand in robustness/settings.

#include <fmt/format.h>

#include <algorithm>

#include "lessons/robustness/settings.h"
#include "lessons/script.h"

namespace isect::lessons {
namespace {

using namespace viz;
using namespace robustness_lesson;

/// Truth and answer of each neighbour, row by row from the top.
using Cells = std::vector<std::pair<int, int>>;
Cells asked(const Setting& s) {
  Cells cells;
  for (int j = half; j >= -half; --j)
    for (int i = -half; i <= half; ++i) cells.emplace_back(s.truth(i, j), s.answer(i, j));
  return cells;
}

class Teller {
 public:
  Teller(const std::string& scalar, Setting setting)
      : scalar_(scalar),
        s_(std::move(setting)),
        cells_(asked(s_)),
        wrong_(static_cast<int>(
            std::ranges::count_if(cells_, [](const auto& c) { return is_wrong(c.first, c.second); }))),
        script_({"Note, N10 (8); Kettner et al. (2008); Schirra (2008)",
                 fmt::format(
                     "{} Each of {} cells is a neighbour of a point in {}; the naive test is wrong in {}.",
                     s_.title, cells_.size(), scalar_, wrong_),
                 {"for each neighbour of the point",  // 0
                  "    truth ← the exact test",       // 1
                  "    answer ← the naive test",      // 2
                  "    if answer ≠ truth: mark it"},  // 3
                 s_.title}) {}

  Walk tell() {
    add("place", s_.title, 0,
        "A point so near that only the last bits tell. We look at its neighbours one by one.", s_.naive)
        .scene = s_.scene;
    raster("truth", "What is true", 1,
           fmt::format("One cell is one {} number to the side or up: {}.\nThe exact test tells the sides "
                       "apart in every cell.",
                       scalar_, s_.cell),
           [](int truth, int) { return role(truth); });
    raster("naive", "What the naive test says", 2, s_.why, [](int, int answer) { return role(answer); });
    script_.value("cells", static_cast<double>(cells_.size()));
    script_.value("wrong", static_cast<double>(wrong_), {}, Role::miss);
    script_.settle(wrong_ > 0 ? Verdict::Kind::no : Verdict::Kind::yes,
                   fmt::format("naive: {} of {} wrong; exact: none", wrong_, cells_.size()));
    Step& step = raster(
        "wrong", "Where it is wrong", 3,
        "Marked cells have a wrong verdict. No tolerance mends them: it moves the band, or makes it wider.\n"
        "The exact test costs a few nanoseconds more away from the line, and is right on it.",
        [](int truth, int answer) { return is_wrong(truth, answer) ? Role::miss : role(truth); });
    step.decides = true;
    step.question = Question{"In how many of these cells is the naive test wrong?",
                             {"none", "fewer than a tenth", "a tenth or more"},
                             wrong_ == 0                                     ? 0
                             : wrong_ * 10 < static_cast<int>(cells_.size()) ? 1
                                                                             : 2,
                             fmt::format("{} of {}, counted.", wrong_, cells_.size())};
    return std::move(script_.walk());
  }

 private:
  /// A yes/no test cannot say "touching": either answer will do there.
  static bool is_wrong(int truth, int answer) { return answer != truth && (truth != 0 || answer == 0); }
  static Role role(int verdict) {
    return verdict > 0 ? Role::first : verdict < 0 ? Role::second : Role::highlight;
  }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    return step;
  }

  template <class Choose>
  Step& raster(const std::string& slug, const std::string& title, int line, const std::string& caption,
               const Choose& choose) {
    Step& step = add(slug, title, line, caption);
    Raster picture = {{-2, 2, 0}, {4, 0, 0}, {0, -4, 0}, 2 * half + 1, {}, true};
    for (const auto& [truth, answer] : cells_) picture.cells.push_back({choose(truth, answer), {}});
    step.scene.items.emplace_back(picture);
    double y = 1.6;
    const auto key = [&](Mark mark, Role ink, const std::string& text) {
      step.scene.items.emplace_back(Dot{{2.6, y, 0}, mark, ink});
      step.scene.items.emplace_back(
          viz::Heading{{3.8, y - 0.08, 0}, text, ink == Role::highlight ? Role::text : ink, 1.9, false});
      y -= 0.6;
    };
    key(Mark::disc, Role::first, s_.verdicts[2]);
    key(Mark::diamond, Role::highlight, s_.verdicts[1]);
    key(Mark::disc, Role::second, s_.verdicts[0]);
    if (slug == "wrong") key(Mark::cross, Role::miss, "wrong");
    return step;
  }

  const std::string& scalar_;
  const Setting s_;
  const Cells cells_;
  const int wrong_;
  Script script_;
};

Walk walk(const Parameters& values) {
  const std::string& scalar = std::get<std::string>(values.at("scalar"));
  return Teller(scalar,
                setting(std::get<std::string>(values.at("test")), scalar, std::get<Vec3>(values.at("p"))))
      .tell();
}

}  // namespace

const Lesson& robustness() {
  static const Lesson lesson = [] {
    std::vector<Preset> presets;
    for (const std::string& test : tests())
      for (const char* scalar : {"double", "float"})
        presets.push_back({test + (scalar == std::string("float") ? "-float" : ""),
                           test + ", " + scalar,
                           {},
                           {{"test", test}, {"scalar", std::string(scalar)}, {"p", standard_point(test)}}});
    return Lesson{
        .id = "robustness",
        .title = "Robustness: a microscope",
        .rows = "N10",
        .summary =
            "Neighbouring floating-point numbers, coloured by the verdict of a naive test and by the true "
            "one.",
        .parameters = {{"test", "test", "The naive test under the microscope.", tests().front(), 0, 0, 0, 0,
                        tests()},
                       {"scalar",
                        "scalar",
                        "The numbers: 53 bits or 24.",
                        std::string("double"),
                        0,
                        0,
                        0,
                        0,
                        {"double", "float"}},
                       {"p", "**p**",
                        "The point in the middle, in world units; its third coordinate is not used.",
                        standard_point(tests().front()), -1e6, 1e6, -4, 4}},
        .group_by = {},
        .presets = presets,
        .camera = {.azimuth = 0, .elevation = 0},
        .walk = walk,
        .flat = true,
    };
  }();
  return lesson;
}

}  // namespace isect::lessons
