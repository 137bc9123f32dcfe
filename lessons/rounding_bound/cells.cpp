// The microscope: what is true of each neighbour, which stage decides it, and what a filter lets through.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lessons/rounding_bound/telling.h"
#include "lessons/shared/plural.h"

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

Role role_of(int truth) { return truth > 0 ? Role::first : truth < 0 ? Role::second : Role::highlight; }

Role role_of(Stage::Kind kind) {
  switch (kind) {
    case Stage::Kind::doubles:
      return Role::first;
    case Stage::Kind::grid:
      return Role::highlight;
    case Stage::Kind::compensated:
      return Role::second;
    case Stage::Kind::triple_double:
      return Role::construction;
    case Stage::Kind::exact:
      return Role::text;
    default:
      return Role::muted;
  }
}

class Cells {
 public:
  Cells(Script& script, const Setup& s)
      : script_(script), s_(s), all_(neighbours(s)), ringed_(all_[microscope::place_of(s.selected)]) {}

  void tell() {
    say_truth();
    say_stages();
    say_filter();
  }

 private:
  int count(const auto& holds) const { return static_cast<int>(std::ranges::count_if(all_, holds)); }
  int total() const { return static_cast<int>(all_.size()); }

  template <class RoleOf>
  Step& add(const std::string& slug, const std::string& title, const std::string& caption, const std::string& ringed,
            const RoleOf& role) {
    Step& step = script_.add(slug, title, 8, caption, "ringed: " + ringed);
    std::vector<Cell> cells;
    for (const Neighbour& n : all_) cells.push_back({role(n), {}});
    microscope::add_cells(step.scene, std::move(cells), s_.selected);
    return step;
  }
  static void add_key(microscope::Keys& keys, Role ink, const std::string& text, int how_many) {
    if (how_many > 0) keys.add(ink, text + ": " + counted(how_many));
  }

  void say_truth() {
    Step& step =
        add("truth", "The neighbours of **a**",
            "Each cell is one position of **a**. Its right neighbour is the next double in *x*, its upper one in *y*.\n"
            "Each sign here is exact. The handles at the border select the ringed neighbour, the one just tested.",
            place(ringed_.truth), [](const Neighbour& n) { return role_of(n.truth); });
    microscope::Keys keys(step.scene);
    for (const int sign : {1, 0, -1})
      add_key(keys, role_of(sign),
              sign > 0   ? "left"
              : sign < 0 ? "right"
                         : "on the line",
              count([&](const Neighbour& n) { return n.truth == sign; }));
  }

  void say_stages() {
    const int doubles = count([](const Neighbour& n) { return n.decided == Stage::Kind::doubles; });
    const std::string caption =
        doubles == total() ? "With the whole bound, doubles decide every cell: all lie far enough from the line."
        : doubles > 0 ? "With the whole bound, doubles decide where |*det*| reaches it. Elsewhere a finer stage must."
        : count([](const Neighbour& n) { return std::isfinite(n.det); }) == 0
            ? "Doubles decide none of these cells: *det* is no finite number in any of them."
            : "With the whole bound, doubles decide none of these cells: |*det*| does not reach it.";
    Step& step = add("stages", "Which stage decides",
                     caption + "\nA finer stage runs only where all those before it leave the sign open.",
                     std::string("with the whole bound: ") + words_of(ringed_.decided).name,
                     [](const Neighbour& n) { return role_of(n.decided); });
    std::map<Stage::Kind, int> found;
    for (const Neighbour& n : all_) ++found[n.decided];
    microscope::Keys keys(step.scene);
    for (const auto& [kind, cells] : found) add_key(keys, role_of(kind), words_of(kind).name, cells);
  }

  void say_filter() {
    const double factor = s_.factor;
    const auto through = [&](const Neighbour& n) { return n.passes(factor); };
    const auto on = [&](const Neighbour& n) { return n.wrong(factor) && n.det == 0; };
    const auto side = [&](const Neighbour& n) { return n.wrong(factor) && n.det != 0; };
    const int passing = count(through), called_on = count(on), wrong_side = count(side), wrong = called_on + wrong_side;
    script_.value("cells", total());
    script_.value("signs that get through", passing);
    script_.value("wrong ones among these", wrong, {}, wrong > 0 ? Role::miss : Role::muted);
    script_.settle(
        wrong > 0 ? Verdict::Kind::no : Verdict::Kind::yes,
        fmt::format("bound times {}: {} of {} wrong", shown(factor), counted(wrong), plural(passing, "sign")));
    Step& step = add("filter", "What the filter lets through", filter_caption(passing, wrong_side, called_on),
                     place(ringed_.truth) + (ringed_.wrong(factor)    ? ", and a wrong sign gets through"
                                             : ringed_.passes(factor) ? ", and its sign gets through"
                                                                      : ", left open by the filter"),
                     [&](const Neighbour& n) {
                       return !through(n) ? Role::muted : side(n) ? Role::miss : on(n) ? Role::text : role_of(n.truth);
                     });
    step.decides = true;
    microscope::Keys keys(step.scene);
    for (const int sign : {1, 0, -1})
      add_key(keys, role_of(sign),
              sign > 0   ? "left"
              : sign < 0 ? "right"
                         : "on the line",
              count([&](const Neighbour& n) { return through(n) && !n.wrong(factor) && n.truth == sign; }));
    add_key(keys, Role::muted, "left open", total() - passing);
    add_key(keys, Role::miss, "wrong side", wrong_side);
    add_key(keys, Role::text, "wrongly on", called_on);
    if (passing == 0) return;  // what gets through is known
    step.question =
        Question{fmt::format("In how many of these cells does the filter let a wrong sign through, with the "
                             "bound times {}?",
                             shown(factor)),
                 {"in none of them", "in less than a tenth", "in a tenth or more"},
                 wrong == 0             ? 0
                 : 10 * wrong < total() ? 1
                                        : 2,
                 fmt::format("In {} of {}, counted.", counted(wrong), counted(total()))};
  }

  std::string filter_caption(int passing, int wrong_side, int called_on) const {
    const double factor = s_.factor;
    const bool all = passing == total();
    const int wrong = wrong_side + called_on;
    const int whole = count([](const Neighbour& n) { return n.passes(1); });
    std::string text =
        passing == 0         ? "No sign gets through: the finer stages decide all of these cells."
        : factor == 0 && all ? "With the bound times 0 every sign gets through: this is the naive test."
        : factor == 1
            ? fmt::format("With the bound as derived {} of {} signs get through.", counted(passing), counted(total()))
            : fmt::format("With the bound times {}, {} of {} signs get through, instead of {}.", shown(factor),
                          counted(passing), counted(total()), counted(whole));
    if (passing == 0) return text;
    text += wrong == 0 ? "\nAll of them are right."
                       : fmt::format("\n{} {} wrong: the wrong side in {}, “on the line” of points beside it in {}.",
                                     plural(wrong, "sign"), wrong == 1 ? "is" : "are", counted(wrong_side),
                                     counted(called_on));
    if (factor == 1) return text + " That is proved, for any three points, and needs no counting.";
    if (factor <= 0.6 + 1e-9)
      return text +
             "\nCounting here proves nothing elsewhere: other points need a factor of nearly 0.6, 3 *u* · *size*.";
    return s_.unit == 1 ? text + " The proof of Shewchuk's constant, 3 *u* and a little, covers this factor." : text;
  }

  Script& script_;
  const Setup& s_;
  const std::vector<Neighbour> all_;
  const Neighbour& ringed_;
};

}  // namespace

void tell_cells(Script& script, const Setup& s) { Cells(script, s).tell(); }

}  // namespace isect::lessons::rounding_bound_lesson
