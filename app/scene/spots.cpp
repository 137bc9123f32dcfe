#include "app/scene/spots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "app/scene/answered.h"
#include "app/scene/contact.h"
#include "app/scene/questions.h"
#include "app/scene/read_objects.h"
#include "app/scene/types.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/text/spelling.h"

namespace isect::program::scene {

using viz::Vec3;

namespace {

constexpr const char* spots_expected =
    "a place is expected: [1, 2], a point's name, \"A.center\", \"r x S\" where both meet, or \"foot of p on T\"";

std::vector<std::string> words_of_place(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

/// Returns which of a place's words are names of objects, or begin with one.
std::vector<std::size_t> names_among(const std::vector<std::string>& words) {
  if (words.size() == 1) return {0};
  if (words.size() == 3 && (words[1] == "x" || words[1] == "×")) return {0, 2};
  if (words.size() == 5 && words[0] == "foot" && words[1] == "of" && words[3] == "on") return {2, 4};
  return {};
}

std::string before_dot(const std::string& word) { return word.substr(0, word.find('.')); }

bool has_foot(Type t) {
  return runs_along_a_line(t) || t == Type::point || t == Type::plane || t == Type::sphere || t == Type::box ||
         t == Type::obb || t == Type::capsule;
}

/// Returns the fields of an object that are places.
std::vector<std::string> places_in(const Object& o) {
  std::vector<std::string> all;
  for (const std::string& field : o.fields) {
    const auto known = std::ranges::find(spec(o.type).fields, field, &FieldSpec::name);
    const bool vertex = known == spec(o.type).fields.end() && o.type != Type::kdop && field != "at";
    if (vertex || (known != spec(o.type).fields.end() && known->means == Means::place)) all.push_back(field);
  }
  return all;
}

/// Reads a word: a point, an earlier mark, or a place of an object.
Spot named_spot(const Source& source, const File& file, const std::string& word, const Path& path) {
  Spot spot;
  const auto mark = std::ranges::find(file.marks, word, &AuthorMark::name);
  if (!word.empty() && mark != file.marks.end()) {
    spot.kind = Spot::Kind::mark, spot.a = static_cast<std::size_t>(mark - file.marks.begin());
    spot.text = shown_name(word);
    return spot;
  }
  spot.kind = Spot::Kind::field;
  spot.a = object_named(source, file.objects, before_dot(word), path);
  const Object& o = file.objects[spot.a];
  const std::vector<std::string> allowed = places_in(o);
  const std::size_t dot = word.find('.');
  const std::string in_words = with_article(o.type);
  if (dot == word.npos && o.type != Type::point)
    source.refuse(path, allowed.empty() ? fmt::format("\"{}\" is {}, which has no place of its own", o.name, in_words)
                                        : fmt::format("\"{0}\" is {1}; name a place of it, such as \"{0}.{2}\"", o.name,
                                                      in_words, allowed.front()));
  spot.field = dot == word.npos ? "at" : word.substr(dot + 1);
  if (std::ranges::find(allowed, spot.field) == allowed.end())
    source.refuse(path, fmt::format("{} has no place \"{}\"{}", o.name, spot.field,
                                    spelling::instead(
                                        spot.field, allowed,
                                        allowed.empty() ? "it has none" : "allowed: " + spelling::listed(allowed))));
  spot.text = shown_name(o.name) + (o.type == Type::point ? "" : "." + spot.field);
  return spot;
}

/// Returns the two points that both circles have, the one on the left of the way from `a` to `b` first. They cross.
std::vector<Vec3> of_circles(const NamedValues& s, const Object& a, const Object& b) {
  const Vec3 from = s.point(a, "center"), way = s.point(b, "center") - from;
  const double r = s.number(a, "radius"), q = s.number(b, "radius"), d = way.norm();
  const Vec3 along = way / d, left(-along.y(), along.x(), 0);
  const double share = (d * d + (r - q) * (r + q)) / (2 * d), height = std::sqrt(std::max(0.0, r * r - share * share));
  return {from + share * along + height * left, from + share * along - height * left};
}

/// Where something that runs along a line begins, and its direction.
struct Run {
  ExactVector origin, dir;
  std::optional<double> least = {}, most = {};
};
Run run_of(const NamedValues& s, const Object& o) {
  if (o.type == Type::segment) {
    const ExactPoint p = exact_point(s.point(o, "from")), q = exact_point(s.point(o, "to"));
    return {p.x, from_to(p, q), 0.0, 1.0};
  }
  Run run = {exact_vector(s.point(o, "origin")), exact_vector(s.point(o, "dir"))};
  if (o.type == Type::ray) run.least = s.has(o, "tmin") ? s.number(o, "tmin") : 0;
  if (o.type == Type::ray && s.has(o, "tmax")) run.most = s.number(o, "tmax");
  return run;
}

/// Returns the one point that both have, without rounding, if it has such a form.
std::optional<ExactPoint> exact_meeting(const Context& c, const Object& a, const Object& b) {
  if (runs_along_a_line(b.type) && !runs_along_a_line(a.type)) return exact_meeting(c, b, a);
  if (!runs_along_a_line(a.type)) return {};
  const Run run = run_of(c.numbers, a);
  if (b.type == Type::plane)
    return meeting(run.origin, run.dir, exact_vector(c.numbers.point(b, "normal")), Exact(c.numbers.number(b, "d")));
  if (!runs_along_a_line(b.type) || !c.file.flat) return {};
  const Run other = run_of(c.numbers, b);
  const ExactVector n = {-other.dir[1], other.dir[0], Exact(0.0)};
  return meeting(run.origin, run.dir, n, -dot(n, other.origin));
}

FoundSpot found_meeting(const Context& c, const Spot& spot) {
  const Object &a = c.object(spot.a), &b = c.object(spot.b);
  const Told told = ask(c.shaped(spot.a), c.shaped(spot.b));
  if (told.open || told.verdict.kind == viz::Verdict::Kind::no) return {.why = told.verdict.text};
  std::vector<viz::Item> marks = told.marks;
  if (marks.empty()) marks = contact(c.numbers, a, b, told.answer);
  std::vector<Vec3> points;
  for (const viz::Item& item : marks)
    if (const viz::Dot* dot = std::get_if<viz::Dot>(&item); dot && dot->role == viz::Role::hit)
      points.push_back(dot->at);
  const bool crossing = told.answer.relation == Relation::overlapping;
  if (points.empty() && crossing && c.file.flat && a.type == Type::sphere && b.type == Type::sphere)
    points = of_circles(c.numbers, a, b);
  if (points.empty() && told.answer.one_point)
    if (const std::optional<ExactPoint> exact = exact_meeting(c, a, b)) points = {nearest_doubles(*exact)};
  if (points.empty())
    return {.why = viz::tr("{verdict}, and no point of all that they share is told", {{"verdict", told.verdict.text}})};
  if (static_cast<std::size_t>(spot.nth) > points.size())
    return {.why = viz::tr_count(points.size(), "{a} and {b} have {n} such point", "{a} and {b} have {n} such points",
                                 {{"a", c.name(spot.a)}, {"b", c.name(spot.b)}})};
  const Vec3& at = points[static_cast<std::size_t>(spot.nth) - 1];
  if (!at.allFinite()) return {.why = viz::tr("it lies beyond all numbers")};
  if (points.size() > 1) return {.at = at};
  if (std::optional<ExactPoint> exact = exact_meeting(c, a, b)) {
    const Vec3 nearest = nearest_doubles(*exact);
    if (nearest.allFinite()) return {.at = nearest, .exact = std::move(exact)};
  }
  return {.at = at};
}

FoundSpot found_foot(const Context& c, const Spot& spot) {
  const FoundSpot from = find_spot(c, spot.of.front());
  if (!from.at) return from;
  const Object& o = c.object(spot.b);
  const ExactPoint p = from.exact.value_or(exact_point(*from.at));
  std::optional<ExactPoint> foot;
  if (o.type == Type::plane) {
    foot = foot_on_plane(p, exact_vector(c.numbers.point(o, "normal")), Exact(c.numbers.number(o, "d")));
  } else if (runs_along_a_line(o.type)) {
    const Run run = run_of(c.numbers, o);
    const bool is_point = dot(run.dir, run.dir).sign() == 0;
    foot = is_point ? ExactPoint{run.origin} : foot_on_line(p, run.origin, run.dir, run.least, run.most);
  }
  if (!foot) {
    const std::optional<Vec3> nearest = nearest_point(c.numbers, o, *from.at);
    if (!nearest || !nearest->allFinite())
      return {.why = viz::tr("{a} has no point that is nearest to it", {{"a", c.name(spot.b)}})};
    return {.at = nearest};
  }
  const Vec3 nearest = nearest_doubles(*foot);
  if (!nearest.allFinite()) return {.why = viz::tr("it lies beyond all numbers")};
  return {.at = nearest, .exact = from.exact ? std::move(foot) : std::nullopt};
}

}  // namespace

bool Spot::tells(const File& file) const {
  if (kind == Kind::meeting) return true;
  if (kind == Kind::mark) return file.marks[a].tells(file);
  return std::ranges::any_of(of, [&](const Spot& one) { return one.tells(file); });
}

Spot read_spot(Source& source, const File& file, const Json& json, const Path& path) {
  if (json.is_array()) {
    Spot spot;
    spot.at = source.vector(json, path);
    std::string digits;
    for (int i = 0; i < (file.flat ? 2 : 3); ++i) digits += (i == 0 ? "" : ", ") + viz::shown(spot.at[i]);
    spot.text = viz::as_markup("(" + digits + ")");
    return spot;
  }
  if (!json.is_string()) source.refuse(path, spots_expected);
  const std::vector<std::string> words = words_of_place(json.get<std::string>());
  if (names_among(words).empty()) source.refuse(path, spots_expected);
  if (words.size() == 1) return named_spot(source, file, words[0], path);
  Spot spot;
  spot.b = object_named(source, file.objects, words.back(), path);
  if (words.size() == 3) {
    spot.kind = Spot::Kind::meeting;
    spot.a = object_named(source, file.objects, words[0], path);
    if (spot.a == spot.b) source.refuse(path, "an object can't be asked about itself");
    const Object &a = file.objects[spot.a], &b = file.objects[spot.b];
    if (!is_decided(a.type, b.type, file.flat))
      source.refuse(path, fmt::format("no test is made for {} and {}", with_article(a.type), with_article(b.type)));
    spot.text = viz::tr("where {a} and {b} meet", {{"a", shown_name(a.name)}, {"b", shown_name(b.name)}});
    return spot;
  }
  spot.kind = Spot::Kind::foot;
  spot.of.push_back(named_spot(source, file, words[2], path));
  const Object& on = file.objects[spot.b];
  if (!has_foot(on.type))
    source.refuse(path, fmt::format("\"{}\" is {}; a foot is found on a point, a segment, a ray, a line, a plane, a "
                                    "ball, a capsule or a box",
                                    on.name, with_article(on.type)));
  spot.text = viz::tr("the foot of {a} on {b}", {{"a", spot.of.front().text}, {"b", shown_name(on.name)}});
  return spot;
}

FoundSpot find_spot(const Context& c, const Spot& spot) {
  switch (spot.kind) {
    case Spot::Kind::given:
      return {.at = spot.at, .exact = exact_point(spot.at)};
    case Spot::Kind::field: {
      const Vec3 at = c.numbers.point(c.object(spot.a), spot.field);
      return {.at = at, .exact = exact_point(at)};
    }
    case Spot::Kind::mark:
      return find_spot(c, c.file.marks[spot.a].spots.front());
    case Spot::Kind::meeting:
      return found_meeting(c, spot);
    case Spot::Kind::foot:
      return found_foot(c, spot);
  }
  return {};
}

std::string place_with_name(const std::string& place, const std::string& name, const std::string& now) {
  std::vector<std::string> words = words_of_place(place);
  if (!place_names(place, name)) return place;
  for (const std::size_t i : names_among(words))
    if (before_dot(words[i]) == name) words[i].replace(0, name.size(), now);
  return fmt::format("{}", fmt::join(words, " "));
}

bool place_names(const std::string& place, const std::string& name) {
  const std::vector<std::string> words = words_of_place(place);
  return std::ranges::any_of(names_among(words), [&](std::size_t i) { return before_dot(words[i]) == name; });
}

}  // namespace isect::program::scene
