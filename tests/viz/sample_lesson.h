#pragma once
// A small lesson of the tests' own: does a point lie in a disc? Two ways to ask, four steps, one question.

#include "viz/lesson.h"

namespace isect::viz::sample {

inline Parameters parameters(const std::string& way, const Vec3& point, const Vec3& center, double radius) {
  return {{"way", way}, {"p", point}, {"c", center}, {"r", radius}};
}

inline Scene scene(const Vec3& p, const Vec3& c, double r) {
  Scene scene;
  scene.items = {Ball{c, r}, Line{p, c, Role::construction, Pen::construction}, Dot{p, Mark::disc, Role::first},
                 Label{p, "**p**", Role::first}, Label{c, "**c**", Role::second}};
  scene.handles = {{"p", Handle::Kind::point, p},
                   {"c", Handle::Kind::point, c, Vec3::Zero(), Role::second},
                   {"r", Handle::Kind::length, c + Vec3(0, r, 0), c, Role::second}};
  return scene;
}

inline Walk walk(const Parameters& values) {
  const Vec3 p = std::get<Vec3>(values.at("p")), c = std::get<Vec3>(values.at("c"));
  const double r = std::get<double>(values.at("r"));
  const bool squared = std::get<std::string>(values.at("way")) == "squared";
  const double l2 = (p - c).squaredNorm();
  const double left = squared ? l2 : std::sqrt(l2), right = squared ? r * r : r;
  const bool inside = left <= right;

  Walk w;
  w.method = squared ? "By squares" : "By distance";
  w.pseudocode = {"l ← c − p", squared ? "l² ← l · l" : "d ← |l|", squared ? "if l² > r²" : "if d > r", "  return OUT",
                  "return IN"};
  w.alt = "A point and a disc.";
  w.steps.reserve(5);  // references to steps stay good
  const auto add = [&](const char* slug, const char* title, int line) -> Step& {
    Step step;
    step.slug = slug;
    step.title = title;
    step.caption = "From the point to the centre leads **l**. Its length *l* decides.\nNothing else is needed.";
    step.line = line;
    step.scene = scene(p, c, r);
    w.steps.push_back(step);
    return w.steps.back();
  };
  add("way", "The way to the centre", 0).verdict.text = "not yet known";
  Step& length = add("length", "Its length *l*", 1);
  length.formula = squared ? "*l*^2 = **l** · **l**" : "*d* = √(**l** · **l**)";
  length.values = {{squared ? "*l*^2" : "*d*", left, "length", Role::muted, true}};
  length.counters = {.mul = 3, .add = 5, .sqrt = squared ? 0 : 1};
  Step& decide = add("compare", "Compare", 2);
  decide.decides = true;
  decide.values = {{squared ? "*l*^2" : "*d*", left, "length"},
                   {squared ? "*r*^2" : "*r*", right, "length", Role::second, true}};
  decide.comparison =
      Comparison{squared ? "*l*^2 ≤ *r*^2" : "*d* ≤ *r*", left, right, inside, "the disc holds the point"};
  decide.question = Question{"Where is **p**?", {"inside", "outside"}, inside ? 0 : 1, "Its distance decides."};
  decide.counters = {.mul = 4, .add = 5, .sqrt = squared ? 0 : 1, .compare = 1};
  if (inside) decide.refused = {2}, decide.untaken = {3};
  if (!inside) {
    add("out", "Out", 3).verdict = {Verdict::Kind::no, "**p** is outside"};
    w.steps.back().untaken = {4};
    return w;
  }
  Step& in = add("in", "In", 4);
  in.verdict = {Verdict::Kind::yes, "**p** is inside"};
  in.refused = {2}, in.untaken = {3};
  add("end", "The end", 4).verdict = in.verdict;
  return w;
}

inline Preset preset(const std::string& way, const std::string& name, const Vec3& point) {
  return {way + "-" + name, name, way, parameters(way, point, Vec3::Zero(), 1.5)};
}

inline Lesson lesson() {
  Lesson l;
  l.id = "point-disc";
  l.title = "Point and disc";
  l.rows = "N00";
  l.summary = "Does a disc hold a point?";
  l.group_by = "way";
  l.parameters = {{"way", "way", "how to compare", std::string("squared"), 0, 0, 0, 0, {"squared", "distance"}},
                  {"p", "**p**", "the point", Vec3(0.5, 0.5, 0), -100, 100, -5, 5},
                  {"c", "**c**", "the centre", Vec3(0, 0, 0), -100, 100, -5, 5},
                  {"r", "*r*", "the radius", 1.5, 0, 100, 0, 5}};
  for (const std::string way : {"squared", "distance"}) {
    l.presets.push_back(preset(way, "inside", {0.5, 0.5, 0}));
    l.presets.push_back(preset(way, "outside", {2.5, 1, 0}));
    l.presets.push_back(preset(way, "on", {1.5, 0, 0}));
  }
  l.steps = walk;
  return l;
}

/// The same lesson, whose question asks for a number: 3/4.
inline Lesson asking_for_a_number() {
  Lesson l = lesson();
  l.id = "point-number";
  l.steps = [](const Parameters& values) {
    Walk w = walk(values);
    Question& question = *w.steps[2].question;
    question.prompt = "What is *t*?";
    question.choices = {"−0.75", "0.75", "1.3333", "3"};
    question.answer = 1;
    question.number = Numeric{0.75, 3, {{4.0 / 3, "You divided the other way round."}, {3, "You did not divide."}}};
    return w;
  };
  return l;
}

/// The same lesson, whose question asks for a line: the third.
inline Lesson asking_for_a_line() {
  Lesson l = lesson();
  l.id = "point-line";
  l.steps = [](const Parameters& values) {
    Walk w = walk(values);
    Question& question = *w.steps[2].question;
    question.prompt = "Which line decides?";
    question.choices = {w.pseudocode[1], w.pseudocode[2], "return IN"};
    question.answer = 1;
    question.line = LineAsked{2, {1, 2, 4}, {{4, "That line returns."}}};
    return w;
  };
  return l;
}

/// The same lesson, whose question asks for an order: near, middle, far, which are the tiles a, c, b.
inline Lesson asking_for_an_order() {
  Lesson l = lesson();
  l.id = "point-order";
  l.steps = [](const Parameters& values) {
    Walk w = walk(values);
    Question& question = *w.steps[2].question;
    question.prompt = "In which order?";
    question.choices = {"near, middle, far", "near, far, middle", "far, middle, near"};
    question.answer = 0;
    question.order = OrderAsked{{"near", "far", "middle"},
                                {0, 2, 1},
                                {{0, 2, 1}, {0, 1, 2}, {1, 2, 0}},
                                {{{1, 2, 0}, "That begins with the farthest."}}};
    return w;
  };
  return l;
}

/// The same lesson under another name: a second one to go to.
inline Lesson other_lesson() {
  Lesson l = lesson();
  l.id = "point-ball";
  l.title = "Point and ball";
  l.summary = "Does a ball hold a point?";
  return l;
}

}  // namespace isect::viz::sample
