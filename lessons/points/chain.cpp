// Three points: near to near need not be near.

#include <isect/point_point.h>
#include "lessons/points/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::points_lesson {

using namespace viz;

namespace {

class Chain {
 public:
  explicit Chain(const Setup& setup)
      : s_(setup),
        script_({"Lecture note Intersection Detection, points; the tolerance is ours",
                 "Three points in space, p, q and r, and a ball of one tolerance.",
                 {"is q near to p?", "is r near to q?", "does it follow that r is near to p? test it",
                  "tell whether nearness was transitive here"},
                 "nearness of three"}) {}

  Walk tell() {
    const bool pq =
        ask("p-q", "First and second", 0, s_.p, s_.q, nearly_equal(s_.tp, s_.tq, s_.tested_within), "p", "q");
    const bool qr =
        ask("q-r", "Second and third", 1, s_.q, s_.r, nearly_equal(s_.tq, s_.tr, s_.tested_within), "q", "r");
    const bool pr = nearly_equal(s_.tp, s_.tr, s_.tested_within);
    ask("p-r", "First and third", 2, s_.p, s_.r, pr, "p", "r");
    const bool broken = pq && qr && !pr;
    // "At most the tolerance" is what transitivity would give; twice 0 is no more.
    if (s_.tested_within > 0)
      script_.walk().steps.back().question = Question{
          "How far may **r** be from **p**, if both are near to **q**?",
          {"at most the tolerance", "at most twice the tolerance", "any distance"},
          1,
          "By the triangle inequality |**p** − **r**| ≤ |**p** − **q**| + |**q** − **r**|, and both may be the "
          "tolerance."};
    script_.settle(broken ? Verdict::Kind::no : Verdict::Kind::yes,
                   broken ? "not transitive: **p** near **q**, **q** near **r**, but **p** not near **r**"
                          : "no contradiction here");
    Step& step = script_.add(
        "verdict", broken ? "Nearness is not transitive" : "No contradiction", 3,
        broken ? "Nearness is not an equivalence relation: clusters depend on the order of merging.\n"
                 "If **q** joins **p** first, **r** stays alone; if it joins **r** first, **p** does. Equality has no "
                 "such trouble."
        : pq && qr && s_.tested_within == 0
            ? "All three are equal. With tolerance 0 near means equal, and equality is transitive."
        : pq && qr ? "All three are near to each other. Drag **r** away from **p**, but keep it near to **q**."
                   : "Transitivity is about two near pairs that share **q**. Here one of them is not near.");
    step.scene = picture(s_.p);
    for (const auto& [from, to, near] : asked_)
      step.scene.items.emplace_back(Line{from, to, near ? Role::hit : Role::miss, near ? Pen::thick : Pen::excluded});
    return std::move(script_.walk());
  }

 private:
  struct Asked {
    Vec3 from, to;
    bool near;
  };

  bool ask(const char* slug, const char* title, int line, const Vec3& from, const Vec3& to, bool near,
           const std::string& a, const std::string& b) {
    asked_.push_back({from, to, near});
    if (!s_.is_nan || (a != "q" && b != "q"))
      script_.value("|**" + a + "** − **" + b + "**|", (from - to).norm(), "length", near ? Role::hit : Role::miss);
    const std::string first = "**" + a + "**", second = "**" + b + "**";
    const bool equality = s_.tested_within == 0;  // the ball is a point
    Step& step =
        script_.add(slug, title, line,
                    equality ? second + (near ? " equals " : " does not equal ") + first +
                                   ", and with tolerance 0 that is all that counts: " + (near ? "near." : "far.")
                    : near ? second + " lies in the ball of tolerance around " + first + ": near."
                           : second + " lies outside the ball of tolerance around " + first + ": far.");
    step.scene = picture(from);
    step.scene.items.emplace_back(Line{from, to, near ? Role::hit : Role::miss, near ? Pen::thick : Pen::excluded});
    step.decides = true;
    return near;
  }

  Scene picture(const Vec3& around) const {
    Scene scene;
    add_tolerance(scene, s_, around, 1.1);
    add_point(scene, "p", s_.p, "**p**", Role::first);
    add_point(scene, "q", s_.q, "**q**", Role::second);
    add_point(scene, "r", s_.r, "**r**", Role::text);
    return scene;
  }

  const Setup& s_;
  Script script_;
  std::vector<Asked> asked_;
};

}  // namespace

Walk chain(const Setup& setup) { return Chain(setup).tell(); }

}  // namespace isect::lessons::points_lesson
