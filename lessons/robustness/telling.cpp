#include <fmt/format.h>

#include <algorithm>

#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/robustness/settings.h"
#include "lessons/shared/script.h"
#include "lessons/speed_against_error/results.h"

namespace isect::lessons::robustness_lesson {

using namespace viz;

namespace {

/// Truth and answer of each neighbour, row by row from the top.
using Cells = std::vector<std::pair<int, int>>;
Cells asked(const Setting& s) {
  Cells cells;
  microscope::for_each_neighbour([&](int i, int j) { cells.emplace_back(s.truth(i, j), s.answer(i, j)); });
  return cells;
}

class Teller {
 public:
  /// `look` is the neighbour that the question is about, in steps to the right and up.
  Teller(const std::string& scalar, const Setting& setting, const std::array<int, 2>& look)
      : scalar_(scalar),
        look_(look),
        s_(setting),
        cells_(asked(s_)),
        on_(count(Fault::called_on)),
        side_(count(Fault::wrong_side)),
        script_({"Lecture note, rules of thumb (8); Kettner et al., Classroom examples of robustness problems (2008)",
                 fmt::format("{} Each of {} cells is a neighbour of a point in {}; the naive test is wrong in {}.",
                             s_.title, cells_.size(), scalar_, wrong()),
                 {"for each neighbour of the point",  // 0
                  "    truth ← the exact test",       // 1
                  "    answer ← the naive test",      // 2
                  "    if answer ≠ truth: mark it"},  // 3
                 s_.title}) {}

  Walk tell() {
    add("place", s_.title, 0,
        std::string(near()
                        ? "The point is so close that only the last bits decide. We look at its neighbours one by one."
                        : "Here all neighbours of the point have one true verdict: it lies away from the border.") +
            "\n" + s_.given + (scalar_ == "float" ? " All numbers are rounded to float." : ""),
        s_.naive)
        .scene = s_.scene;
    raster("truth", "What is true", 1,
           fmt::format("Each cell is {}: one step right is the next {} in *x*, one step up the next in *y*.\nThe exact "
                       "test is correct in every cell.\n"
                       "Numbers at the border count these steps; the handles there select the ringed neighbour.",
                       s_.cell, scalar_),
           [](int truth, int) { return role(truth); });
    Step& naive = raster("naive", "What the naive test says", 2,
                         wrong() > 0 ? s_.why : "Rounding happens here, too, but it changes no verdict.",
                         [](int, int answer) { return role(answer); });
    const std::size_t all = cells_.size();
    naive.question = Question{"In how many of these cells is the naive test wrong?",
                              {"in none of them", "in fewer than a tenth", "in a tenth or more"},
                              wrong() == 0                           ? 0
                              : wrong() * 10 < static_cast<int>(all) ? 1
                                                                     : 2,
                              fmt::format("In {} of {}, counted.", wrong(), all)};
    script_.value("cells", static_cast<double>(all));
    script_.value("wrong", wrong(), {}, Role::miss);
    if (s_.has_on) script_.value("of these called on the line", on_);
    if (s_.has_on) script_.value("of these on the wrong side", side_, {}, Role::miss);
    script_.settle(wrong() > 0 ? Verdict::Kind::no : Verdict::Kind::yes,
                   fmt::format("naive: {} of {} wrong{}; exact: none", wrong(), all,
                               s_.has_on && wrong() > 0 ? fmt::format(", {} on the wrong side", side_) : ""));
    Step& step = raster("wrong", "Where it is wrong", 3, wrong_caption(), [&](int truth, int answer) {
      const Fault f = fault(s_, truth, answer);
      return f == Fault::wrong_side ? Role::miss : f == Fault::called_on ? Role::text : role(truth);
    });
    step.decides = true;
    if (wrong() > 0) step.question = how_it_errs();
    return std::move(script_.walk());
  }

 private:
  int count(Fault kind) const {
    return static_cast<int>(
        std::ranges::count_if(cells_, [&](const auto& c) { return fault(s_, c.first, c.second) == kind; }));
  }
  int wrong() const { return on_ + side_; }
  /// Whether the true verdicts differ.
  bool near() const {
    return std::ranges::any_of(cells_, [&](const auto& c) { return c.first != cells_.front().first; });
  }

  std::string wrong_caption() const {
    if (wrong() == 0) return "No verdict is wrong here. " + price();
    std::string kinds;
    if (s_.has_on && side_ == 0) kinds = " Each says “on the line” of a point beside it; none names the wrong side.";
    return "Marked cells have a wrong verdict." + kinds + "\n" + s_.consequence +
           " One tolerance only moves the band, or widens it.\n" + price();
  }

  /// A sentence on the cost of the exact test, as measured far from degeneracy and near it.
  std::string price() const {
    const auto rows = bench::rows_of(speed_against_error_lesson::results(), s_.measured, "double");
    const bench::Row *usual = nullptr, *most = nullptr;
    for (const bench::Row* r : rows) {
      if (!r->exact || r->library != "isect" || r->method != "exact") continue;
      if (!r->hard && usual == nullptr) usual = r;
      if (most == nullptr || r->ns > most->ns) most = r;
    }
    if (usual == nullptr || most == nullptr) return "The exact test is never wrong.";
    return fmt::format("The exact test is never wrong. It took {} ns on ordinary cases, up to {} ns on hard ones.",
                       shown(usual->ns), shown(most->ns));
  }

  /// Misconceptions: rounding only blurs the border; it always errs to the same side.
  Question how_it_errs() const {
    const auto says = [&](int verdict) {
      return std::ranges::any_of(
          cells_, [&](const auto& c) { return c.second == verdict && fault(s_, c.first, c.second) != Fault::none; });
    };
    const auto wrongly = [&](int verdict) { return "only by saying “" + s_.verdicts[verdict + 1] + "”"; };
    Question q = {"How does the naive test err in these cells?",
                  {wrongly(1), wrongly(-1), "in more than one way"},
                  0,
                  "All wrong cells were checked."};
    if (s_.has_on) q.choices.insert(q.choices.begin() + 1, wrongly(0));
    const int ways = says(1) + says(0) + says(-1);
    const int last = static_cast<int>(q.choices.size()) - 1;
    q.answer = ways > 1 ? last : says(1) ? 0 : says(0) ? 1 : last - 1;
    return q;
  }

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
    std::vector<Cell> cells;
    for (const auto& [truth, answer] : cells_) cells.push_back({choose(truth, answer), {}});
    microscope::add_cells(step.scene, cells, look_);
    step.formula = ringed(step.line);

    // Keys have the number of cells in the step that says what is wrong.
    microscope::Keys keys(step.scene);
    const auto key = [&](Role ink, const std::string& text) {
      keys.add(ink, slug == "wrong" ? fmt::format("{}: {}", text, std::ranges::count(cells, ink, &Cell::role)) : text);
    };
    key(Role::first, s_.verdicts[2]);
    key(Role::highlight, s_.verdicts[1]);
    key(Role::second, s_.verdicts[0]);
    if (slug == "wrong" && side_ > 0) key(Role::miss, s_.has_on ? "wrong side" : "wrong");
    if (slug == "wrong" && on_ > 0) key(Role::text, "wrongly on");
    return step;
  }

  /// What is known of the ringed neighbour where a line of the pseudocode has run.
  std::string ringed(int line) const {
    const auto& [truth, answer] = cells_[microscope::place_of(look_)];
    const std::string is = s_.in_words(truth), said = "naive says " + s_.in_words(answer);
    return "ringed: " + (line == 1 ? is : line == 2 ? said : is + ", " + said);
  }

  const std::string& scalar_;
  const std::array<int, 2> look_;
  const Setting s_;
  const Cells cells_;
  const int on_, side_;  ///< how many cells are wrong, by the kind of fault
  Script script_;
};

}  // namespace

Walk tell(const std::string& scalar, const Setting& setting, const std::array<int, 2>& look) {
  return Teller(scalar, setting, look).tell();
}

}  // namespace isect::lessons::robustness_lesson
