// Answers about two objects, and about what a ray meets first.

#include "app/scene/answered.h"

#include "app/scene/contact.h"
#include "app/scene/first_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <isect/convex_hull.h>
#include <isect/many/all_pairs.h>
#include "app/query/reply.h"
#include "app/scene/questions.h"
#include "app/scene/shapes.h"
#include "app/scene/walks.h"
#include "viz/lang/lesson_texts.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

using viz::tr;
using viz::tr_count;

namespace {

struct Hit {
  std::size_t object;
  double t;
  mutable std::optional<Place> place = {};  ///< t itself, if it was asked for
  std::optional<viz::Item> mark = {};       ///< what shows where they meet
};

/// Whether their doubles, each within 4 ulp of the true t, leave no doubt that x is less than y.
bool surely_less(double x, double y) {
  using Limits = std::numeric_limits<double>;
  return std::isfinite(x) && std::isfinite(y) &&
         y - x > 8 * (Limits::epsilon() * std::max(std::abs(x), std::abs(y)) + Limits::denorm_min());
}

/// Returns the sign of x's t minus y's, exactly.
int order(const Context& c, std::size_t ray, const Hit& x, const Hit& y) {
  if (surely_less(x.t, y.t)) return -1;
  if (surely_less(y.t, x.t)) return 1;
  for (const Hit* hit : {&x, &y})
    if (!hit->place) hit->place = first_place(c.shaped(ray), c.shaped(hit->object)).value();
  return compare(*x.place, *y.place);
}

/// Returns the hit for pairs whose answer has no t: a ray that lies in a plane, and other thin objects.
std::optional<Hit> thin_hit(const Context& c, std::size_t ray, std::size_t i) {
  const Type type = c.object(i).type;
  if (!(type == Type::point || type == Type::cloud || type == Type::plane || runs_along_a_line(type))) return {};
  const std::optional<Place> place = first_place(c.shaped(ray), c.shaped(i));
  if (!place) return {};
  return Hit{i, nearest(*place), place, {}};
}

/// Returns what shows where two objects meet.
std::optional<viz::Item> mark_of(const Told& told) {
  return told.marks.empty() ? std::nullopt : std::optional(told.marks.front());
}

/// What a ray meets of some objects.
struct Hits {
  std::vector<Hit> in_order;      ///< by rising t
  std::vector<std::size_t> open,  ///< no test decides whether it meets them
      endless;                    ///< a whole line lies in them, so there is no first t
};

Hits hits_of(const Context& c, std::size_t ray, const std::vector<std::size_t>& objects) {
  Hits hits;
  for (const std::size_t i : objects) {
    const Told told = ask(c.shaped(ray), c.shaped(i));
    if (told.open)
      hits.open.push_back(i);
    else if (told.answer.t)
      hits.in_order.push_back({i, *told.answer.t, {}, mark_of(told)});
    else if (const std::optional<Hit> hit = thin_hit(c, ray, i))
      hits.in_order.push_back({i, hit->t, hit->place, mark_of(told)});
    else if (c.object(ray).type == Type::line && told.verdict.kind != viz::Verdict::Kind::no)
      hits.endless.push_back(i);
  }
  std::ranges::stable_sort(hits.in_order, [&](const Hit& x, const Hit& y) { return order(c, ray, x, y) < 0; });
  return hits;
}
Hits hits_of(const Context& c, std::size_t ray) {
  std::vector<std::size_t> objects;
  for (std::size_t i = 0; i < c.file.objects.size(); ++i)
    if (i != ray) objects.push_back(i);
  return hits_of(c, ray, objects);
}

std::string shown_t(double t) { return std::isinf(t) ? tr("a number too large for a double") : viz::shown(t); }

viz::Verdict first_of(const Context& c, std::size_t ray, const Hits& found) {
  const auto names_of = [&](const std::vector<std::size_t>& objects) {
    std::string names;
    for (const std::size_t i : objects) names += (names.empty() ? "" : ", ") + c.name(i);
    return names;
  };
  if (!found.open.empty())
    return {viz::Verdict::Kind::open,
            tr("what {a} meets first is not decided, as no test decides whether and where it meets {names}",
               {{"a", c.name(ray)}, {"names", names_of(found.open)}})};
  if (!found.endless.empty())
    return {viz::Verdict::Kind::on, tr("{a} meets nothing first, as all of it lies in {names}",
                                       {{"a", c.name(ray)}, {"names", names_of(found.endless)}})};
  const std::vector<Hit>& hits = found.in_order;
  if (hits.empty()) return {viz::Verdict::Kind::no, tr("{a} meets none of them", {{"a", c.name(ray)}})};
  const std::string first = c.name(hits[0].object);
  std::string names = first, last;
  for (std::size_t i = 1; i < hits.size() && order(c, ray, hits[0], hits[i]) == 0; ++i) {
    if (!last.empty()) names += ", " + last;
    last = c.name(hits[i].object);
  }
  if (!last.empty())
    return {viz::Verdict::Kind::on,
            tr("{a} meets {names} and {last} at the same *t*", {{"a", c.name(ray)}, {"names", names}, {"last", last}})};
  return {viz::Verdict::Kind::yes,
          tr("{a} meets {b} first, at *t* = {t}", {{"a", c.name(ray)}, {"b", first}, {"t", shown_t(hits[0].t)}})};
}

}  // namespace

std::string Context::name(std::size_t i) const { return shown_name(object(i).name); }

std::string slug_of(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == ' ') c = '-';
  }
  return text;
}

Answered answered(const Context& c, const PairAsked& asked) {
  const Object &a = c.object(asked.a), &b = c.object(asked.b);
  Told told = ask(c.shaped(asked.a), c.shaped(asked.b));
  Answered out = {slug_of(a.name + "-" + b.name), tr("{a} and {b}", {{"a", c.name(asked.a)}, {"b", c.name(asked.b)}}),
                  told.open ? told.verdict.text + "."
                            : tr("Decided exactly for these numbers: {verdict}.", {{"verdict", told.verdict.text}}),
                  told.verdict};
  if (!told.note.empty()) out.caption += "\n" + told.note;
  for (const std::size_t i : {asked.a, asked.b})
    if (c.object(i).type == Type::frustum)
      out.caption += "\n" + tr("The planes of {a} are those of its angle, rounded.", {{"a", c.name(i)}});
  out.formula = told.formula, out.values = told.values, out.items = std::move(told.marks);
  if (out.items.empty()) out.items = contact(c.numbers, a, b, told.answer);
  out.lit = {asked.a, asked.b};
  out.json = {{"ask", {a.name, b.name}}, {"verdict", viz::plain(told.verdict.text)}};
  if (!told.query.is_null()) out.json["query"] = std::move(told.query);
  out.json["result"] = std::move(told.result);
  return out;
}

Answered answered(const Context& c, const FirstHitAsked& asked) {
  const Hits found = hits_of(c, asked.ray);
  const std::vector<Hit>& hits = found.in_order;
  Answered out = {"first-hit-" + slug_of(c.object(asked.ray).name),
                  tr("What {a} meets first", {{"a", c.name(asked.ray)}}), "", first_of(c, asked.ray, found)};
  out.lit = {asked.ray};
  out.json = {
      {"first hit", c.object(asked.ray).name}, {"verdict", viz::plain(out.verdict.text)}, {"hits", Json::array()}};
  std::string order;
  for (const Hit& hit : hits) {
    order += order.empty() ? "" : ", ";
    order += tr("{a} at {t}", {{"a", c.name(hit.object)}, {"t", shown_t(hit.t)}});
    if (std::isfinite(hit.t))
      out.values.push_back({tr("*t* of {a}", {{"a", c.name(hit.object)}}), hit.t, "t", viz::Role::hit, true});
    out.lit.push_back(hit.object);
    out.json["hits"].push_back({{"object", c.object(hit.object).name}, {"t", query::number(hit.t)}});
    if (hit.mark) out.items.push_back(*hit.mark);
  }
  out.caption = hits.empty() && found.endless.empty() ? tr("Each object was asked; none is met.")
                : hits.empty()                        ? tr("Each object was asked.")
                               : tr("Each object was asked; by rising *t* these are met: {order}.", {{"order", order}});
  return out;
}

namespace {

/// Answers which pairs of boxes meet.
Answered all_that_meet(const Context& c, const WalkAsked& asked) {
  std::vector<Aabb<double, 2>> boxes;
  Json names = Json::array(), found = Json::array();
  for (const std::size_t i : asked.many) {
    boxes.push_back(made<Aabb<double, 2>>(c.numbers, c.object(i)));
    names.push_back(c.object(i).name);
  }
  std::string told;
  all_pairs::brute_force(boxes, [&](int i, int j) {
    const std::size_t a = asked.many[static_cast<std::size_t>(i)], b = asked.many[static_cast<std::size_t>(j)];
    told += told.empty() ? "" : ", ";
    told += tr("{a} and {b}", {{"a", c.name(a)}, {"b", c.name(b)}});
    found.push_back({c.object(a).name, c.object(b).name});
  });
  Answered out;
  out.verdict = found.empty() ? viz::Verdict{viz::Verdict::Kind::no, tr_count(boxes.size(), "no two of {n} boxes meet",
                                                                              "no two of {n} boxes meet")}
                              : viz::Verdict{viz::Verdict::Kind::yes, tr("these meet: {pairs}", {{"pairs", told}})};
  out.json = {{"walk", names},
              {"lesson", asked.lesson},
              {"verdict", viz::plain(out.verdict.text)},
              {"result", {{"pairs", found}}}};
  return out;
}

/// Answers about the boxes' hierarchy: its nodes, or the box that the ray meets first.
Answered of_hierarchy(const Context& c, const WalkAsked& asked) {
  const std::size_t boxes = asked.many.size() - (asked.with_ray ? 1 : 0);
  Json names = Json::array();
  for (std::size_t i = 0; i < boxes; ++i) names.push_back(c.object(asked.many[i]).name);
  Answered out;
  Json result;
  if (asked.with_ray) {
    const std::size_t ray = asked.many.back();
    const Hits hits = hits_of(c, ray, {asked.many.begin(), asked.many.end() - 1});
    out.verdict = first_of(c, ray, hits);
    result["hits"] = Json::array();
    for (const Hit& hit : hits.in_order)
      result["hits"].push_back({{"object", c.object(hit.object).name}, {"t", query::number(hit.t)}});
  } else {
    std::vector<const Object*> all;
    for (const std::size_t i : asked.many) all.push_back(&c.object(i));
    out.verdict =
        viz::spoken_walk(asked.lesson, [&] { return walk(*walk_of_many(asked.lesson, asked.method), c.numbers, all); })
            .steps.back()
            .verdict;
    result["hierarchy"] = viz::plain(out.verdict.text);
  }
  out.json = {{"walk", names}, {"lesson", asked.lesson}};
  if (asked.with_ray) out.json["ray"] = c.object(asked.many.back()).name;
  out.json["verdict"] = viz::plain(out.verdict.text), out.json["result"] = result;
  return out;
}

}  // namespace

/// Returns the walk's last verdict as an answer.
Answered answered(const Context& c, const WalkAsked& asked) {
  if (!asked.many.empty()) return asked.lesson == "hierarchy" ? of_hierarchy(c, asked) : all_that_meet(c, asked);
  const Object &a = c.object(asked.a), &b = c.object(asked.b);
  if (asked.a == asked.b) {
    const Ring<double, 2> hull = convex_hull(points_of<2>(c.numbers.points(a)));
    Answered out;
    out.verdict = {viz::Verdict::Kind::yes, tr_count(hull.size(), "the hull of {a} has {n} corner",
                                                     "the hull of {a} has {n} corners", {{"a", c.name(asked.a)}})};
    Json corners = Json::array();
    for (const Point<double, 2>& v : hull) corners.push_back({v.x(), v.y()});
    out.json = {{"walk", a.name}, {"verdict", viz::plain(out.verdict.text)}, {"result", {{"hull", corners}}}};
    return out;
  }
  const bool clips = std::string_view(walk_of(a.type, b.type, c.file.flat, false, asked.lesson)->lesson) == "clipping";
  Answered out = clips ? answered(c, ClipAsked{asked.a, asked.b}) : answered(c, PairAsked{asked.a, asked.b});
  Json json = {{"walk", {a.name, b.name}}};
  for (const auto& [key, value] : out.json.items())
    if (key != "ask" && key != "clip" && key != "to") json[key] = value;
  out.json = std::move(json);
  return out;
}

}  // namespace isect::program::scene
