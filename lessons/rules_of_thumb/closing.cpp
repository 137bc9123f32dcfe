// What a reader takes along from eight rules, and what there is to do.

#include "lessons/rules_of_thumb/experiment.h"

namespace isect::lessons::rules_of_thumb_lesson {

using namespace viz;

namespace {

bool is(const Parameters& p, const char* rule) { return std::get<std::string>(p.at("rule")) == rule; }
Flat place(const Parameters& p) { return std::get<Vec3>(p.at("p")).head<2>(); }

bool order_costs_more(const Parameters& p) {
  if (!is(p, "3-reorder")) return false;
  const Experiment e = reorder(place(p));
  return e.after > e.before;
}

bool no_sign_is_wrong(const Parameters& p) { return is(p, "8-robust") && robust(place(p)).before == 0; }

}  // namespace

const std::string& opening() {
  static const std::string text =
      "How is a correct test made fast, and a fast test correct? The lecture note *Intersection Detection* gives eight "
      "rules of thumb.\n"
      "None holds everywhere. So each is put to the test here.";
  return text;
}

const Closing& closing() {
  static const Closing closing = {
      .result =
          "Trivial rejects first, results kept, a projection for a dimension less, work prepared: each rule saves "
          "where its assumption holds.",
      .cost = "Each costs something: storage, preprocessing, or a wasted test. Only the clock shows the gain.",
      .choose =
          "Make it right first, by exact predicates (rule 8), then measure (rule 7). Apply the others where the "
          "profile says that time is "
          "spent.",
      .used = "Cached separating axes and sorted sweeps in physics engines; hierarchies built once in ray tracers.",
      .bug = "Optimising by counting operations: methods with similar counts may differ tenfold in time.",
      .bug_preset = "7-measure",
      .reading = {"Tomas Akenine-Möller and Eric Haines, *Real-Time Rendering*, 2nd edition, 2002, chapter 13.",
                  "Christer Ericson, *Real-Time Collision Detection*, 2005, chapters 11 and 13.",
                  "Lutz Kettner et al., Classroom Examples of Robustness Problems in Geometric Computations, "
                  "*Computational Geometry* 40, 2008, pages 61–78."},
      .exercises = {
          {"Rule 3: drag **p** to a place where the other order of axes costs more than it saves.",
           "Beside the long boxes *x* separates at once: at (1.15, 0) the test on *y* is wasted. Of independent tests, "
           "take them in the order of cost divided by the chance to reject, the smallest first.\n"
           "A before B costs *cost A* + (1 − *chance A*) · *cost B*, and likewise B before A. So A goes first if *cost "
           "A* / *chance A* ≤ *cost B* / *chance B*. Both chances are those among all boxes. So it holds "
           "for two tests that depend on each other, too. With costs 2 and 5 and chances 0.2 and 0.8, B goes first: 5 "
           "+ 0.2 · 2 = 5.4, not 2 + 0.8 · 5 "
           "= 6.\n"
           "A third test meets only the boxes which the others let pass. If three tests depend on each other, single "
           "quotients may then mislead: measure whole orders.",
           "3-reorder",
           order_costs_more,
           {{"p", "1.15,0,0"}}},
          {"Rule 8: drag **p** so that no rounded sign is wrong.",
           "Straight above **a**, at (−3.1, 1), all differences of *x* are exactly 0, and so are the determinants.",
           "8-robust",
           no_sign_is_wrong,
           {{"p", "-3.1,1,0"}}},
          {"Rule 6: preprocessing takes 600 steps, a query 10 instead of 50. After how many queries does it pay?",
           "Each query saves 40 steps, and 600/40 = 15. So with 15 queries or more it costs no more."},
          {"Rule 1: a full test costs 150 operations, a ball test 11, and nine boxes in ten are rejected. What is "
           "saved?",
           "Without: 150 a box. With: 11 + 0.1 · 150 = 26, so 83 % are saved. It pays if more than 11/150, about 7 %, "
           "are rejected.\n"
           "With costs *c*_1 and *c*_2 a pair takes *c*_1 + *share* · *c*_2, where the share passes the first test. It "
           "pays if that share is less than 1 − *c*_1 / *c*_2. What passes and yet misses, a false positive, costs "
           "time alone. A false negative is a wrong result: no later test sees that pair again."},
          {"Why does a separating axis of the last frame help, even though it may fail? And which are the eight rules?",
           "If it fails, one more test is lost; if it holds, up to fourteen are saved. In slow motion it usually "
           "holds: that is temporal coherence.\n"
           "The rules: 1 trivial accept and reject; 2 reuse results; 3 reorder the tests; 4 postpone expensive "
           "calculations. Further: 5 reduce the dimension; 6 many against one, precalculate; 7 time and profile; 8 "
           "make it robust."},
      }};
  return closing;
}

}  // namespace isect::lessons::rules_of_thumb_lesson
