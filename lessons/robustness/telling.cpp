#include <fmt/format.h>

#include <algorithm>

#include "lessons/robustness/settings.h"
#include "lessons/shared/script.h"

namespace isect::lessons::robustness_lesson {

using namespace viz;

namespace {

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
  /// `look`: the neighbour that is asked about, so many to the right and up.
  Teller(const std::string& scalar, const Setting& setting, const std::array<int, 2>& look)
      : scalar_(scalar),
        look_(look),
        s_(setting),
        cells_(asked(s_)),
        wrong_(
            static_cast<int>(std::ranges::count_if(cells_, [](const auto& c) { return is_wrong(c.first, c.second); }))),
        script_({"Note, N10 (8); Kettner et al. (2008); Schirra (2008)",
                 fmt::format("{} Each of {} cells is a neighbour of a point in {}; the naive test is wrong in {}.",
                             s_.title, cells_.size(), scalar_, wrong_),
                 {"for each neighbour of the point",  // 0
                  "    truth ← the exact test",       // 1
                  "    answer ← the naive test",      // 2
                  "    if answer ≠ truth: mark it"},  // 3
                 s_.title}) {}

  Walk tell() {
    add("place", s_.title, 0, "A point so near that only the last bits tell. We look at its neighbours one by one.",
        s_.naive)
        .scene = s_.scene;
    raster("truth", "What is true", 1,
           fmt::format("One cell is one {} number to the side or up: {}.\nThe exact test tells the sides "
                       "apart in every cell.\nThe grips at the rim choose the neighbour that is ringed.",
                       scalar_, s_.cell),
           [](int truth, int) { return role(truth); });
    raster("naive", "What the naive test says", 2, s_.why, [](int, int answer) { return role(answer); });
    script_.value("cells", static_cast<double>(cells_.size()));
    script_.value("wrong", static_cast<double>(wrong_), {}, Role::miss);
    script_.settle(wrong_ > 0 ? Verdict::Kind::no : Verdict::Kind::yes,
                   fmt::format("naive: {} of {} wrong; exact: none", wrong_, cells_.size()));
    Step& step =
        raster("wrong", "Where it is wrong", 3,
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
  static Role role(int verdict) { return verdict > 0 ? Role::first : verdict < 0 ? Role::second : Role::highlight; }

  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    return step;
  }

  template <class Choose>
  Step& raster(const std::string& slug, const std::string& title, int line, const std::string& caption,
               const Choose& choose) {
    Step& step = add(slug, title, line, caption);
    Raster picture = {{left, bottom + side, 0}, {side, 0, 0}, {0, -side, 0}, 2 * half + 1, {}, true};
    for (const auto& [truth, answer] : cells_) picture.cells.push_back({choose(truth, answer), {}});
    step.scene.items.emplace_back(picture);
    crosshair(step);
    double y = bottom + side - 0.4;
    const auto key = [&](Mark mark, Role ink, const std::string& text) {
      step.scene.items.emplace_back(Dot{{left + side + 0.6, y, 0}, mark, ink});
      step.scene.items.emplace_back(
          viz::Heading{{left + side + 1.8, y - 0.08, 0}, text, ink == Role::highlight ? Role::text : ink, 1.9, false});
      y -= 0.6;
    };
    key(Mark::disc, Role::first, s_.verdicts[2]);
    key(Mark::diamond, Role::highlight, s_.verdicts[1]);
    key(Mark::disc, Role::second, s_.verdicts[0]);
    if (slug == "wrong") key(Mark::cross, Role::miss, "wrong");
    return step;
  }

  /// Two lines that meet in the neighbour looked at, each with a grip at the rim.
  void crosshair(Step& step) const {
    const double cell = side / (2 * half + 1), rim = 0.25;
    const Vec3 middle = {left + side / 2, bottom + side / 2, 0};
    const Vec3 at = middle + cell * Vec3(look_[0], look_[1], 0);
    const Vec3 below = {at.x(), bottom - rim, 0}, beside = {left - rim, at.y(), 0};
    step.scene.items.emplace_back(Line{below, at, Role::construction, Pen::construction});
    step.scene.items.emplace_back(Line{beside, at, Role::construction, Pen::construction});
    step.scene.items.emplace_back(Dot{at, Mark::ring, Role::text});
    step.scene.handles = {
        {"right", Handle::Kind::along, below, {middle.x(), below.y(), 0}, Role::text, Vec3::UnitX() / cell},
        {"up", Handle::Kind::along, beside, {beside.x(), middle.y(), 0}, Role::text, Vec3::UnitY() / cell}};
    const auto& [truth, answer] = cells_[(half - look_[1]) * (2 * half + 1) + half + look_[0]];
    const auto words = [&](int verdict) { return s_.verdicts[verdict + 1]; };
    step.formula = "ringed: " + (step.line == 1   ? words(truth)
                                 : step.line == 2 ? "naive says " + words(answer)
                                                  : words(truth) + ", naive says " + words(answer));
  }

  static constexpr double side = 5.2, left = -2.3, bottom = -2;  ///< of the raster
  const std::string& scalar_;
  const std::array<int, 2> look_;
  const Setting s_;
  const Cells cells_;
  const int wrong_;
  Script script_;
};

}  // namespace

Walk tell(const std::string& scalar, const Setting& setting, const std::array<int, 2>& look) {
  return Teller(scalar, setting, look).tell();
}

}  // namespace isect::lessons::robustness_lesson
