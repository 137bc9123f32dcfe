#include "viz/walk/scene_in_words.h"

#include <algorithm>
#include <map>
#include <set>

#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

using Points = std::vector<Vec3>;

/// Limits of what is told in numbers: nobody would compute along with more.
constexpr std::size_t most_vertices = 24, most_objects = 20;

/// Returns a number in full where that is short.
std::string number(double x) {
  const std::string full = to_text(x);
  if (full.size() <= 12) return full;
  std::string text = shown(x);
  if (text.starts_with("−")) text.replace(0, std::string("−").size(), "-");
  return text;
}

struct Limits {
  Vec3 lo, hi;
  bool holds(const Vec3& p) const { return (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all(); }
};
Limits limits_of(const Points& points) {
  Limits e = {points.front(), points.front()};
  for (const Vec3& p : points) e.lo = e.lo.cwiseMin(p), e.hi = e.hi.cwiseMax(p);
  return e;
}

/// Whether the points are the corners of a box with sides along the axes, each once.
bool is_box(const Points& points) {
  const Limits e = limits_of(points);
  const auto at_a_corner = [&](const Vec3& p) {
    return ((p.array() == e.lo.array()) || (p.array() == e.hi.array())).all();
  };
  const int dimensions = static_cast<int>((e.lo.array() != e.hi.array()).count());
  return points.size() == std::size_t{1} << dimensions && std::ranges::all_of(points, at_a_corner);
}

class SceneInWords {
 public:
  SceneInWords(const Scene& scene, const Parameters& parameters, bool flat)
      : scene_(scene), parameters_(parameters), flat_(flat) {
    for (const Item& item : scene.items) std::visit(*this, item);
    if (!points_.empty() && points_.size() <= most_vertices) say(tr_as("object", "points"), {}, list(points_));
  }

  std::vector<std::string> take() {
    if (told_.size() <= most_objects) return std::move(told_);
    std::string counts;
    for (const auto& [kind, count] : counts_)
      counts +=
          (counts.empty() ? "" : ", ") + tr("{n} of the kind {kind}", {{"n", std::to_string(count)}, {"kind", kind}});
    return {counts};
  }

  void operator()(const Ball& it) {
    if (is_body(it.role)) round(tr_as("object", "ball"), it.center, it.radius, it.role);
  }
  void operator()(const Circle& it) {
    if (is_object(it.role, it.pen) || it.role == Role::text)
      round(tr_as("object", "circle"), it.center, it.radius, it.role);
  }
  void operator()(const Region& it) {
    const bool body = it.hides && is_body(it.role);  // a floor has the colour of a grid, and its name is muted
    const Role role = body && it.role == Role::grid ? Role::muted : it.role;
    if (it.outlined && (body || is_object(it.role, it.pen)))
      for (const Points& ring : it.rings) corners(tr_as("object", "polygon"), ring, role, it.name);
  }
  void operator()(const Solid& it) {
    if (!is_body(it.role)) return;
    it.round ? round(*it.round, it) : corners(tr_as("object", "solid"), it.vertices, it.role, it.name);
  }
  void operator()(const Mesh& it) {
    if (is_body(it.role)) corners(tr_as("object", "mesh"), it.vertices, it.role, it.name);
  }
  void operator()(const Line& it) {
    if (!it.name.empty()) return;  // a part of what is told as a whole
    if (is_object(it.role, it.pen) && !(is_parameter(it.from) && is_parameter(it.to)) && !is_measured(it))
      say(tr_as("object", "segment"), name_along(it), tr("{p} to {q}", {{"p", place(it.from)}, {"q", place(it.to)}}));
  }
  void operator()(const Dot& it) {
    if (flat_ && it.role == Role::text && name_at(it.at).empty()) points_.push_back(it.at);
  }
  void operator()(const auto&) {}

 private:
  static bool is_object(Role role, Pen pen = Pen::solid) {
    return (role == Role::first || role == Role::second || role == Role::muted || role >= own_role(0)) &&
           (pen == Pen::solid || pen == Pen::thick);
  }

  /// Whether a solid thing is an object: also in the colours of what is hit or missed.
  static bool is_body(Role role) { return role != Role::construction && role != Role::highlight; }

  bool is_parameter(const Setting& value) const {
    return std::ranges::any_of(parameters_, [&](const auto& p) { return p.second == value; });
  }
  std::string place(const Vec3& p) const {
    const std::string xy = number(p.x()) + ", " + number(p.y());
    return "(" + xy + (flat_ ? ")" : ", " + number(p.z()) + ")");
  }
  std::string list(const Points& points) const {
    std::string text;
    for (const Vec3& p : points) text += (text.empty() ? "" : ", ") + place(p);
    return text;
  }

  std::string name_at(const Vec3& p) const {
    for (const Item& item : scene_.items)
      if (const auto* label = std::get_if<Label>(&item); label && !label->until && (label->at - p).norm() <= 1e-12)
        return plain(label->text);
    return {};
  }
  /// Whether a line is a length rather than an object: its label runs along it.
  bool is_measured(const Line& line) const {
    return std::ranges::any_of(scene_.items, [&](const Item& item) {
      const auto* label = std::get_if<Label>(&item);
      return label && label->until &&
             ((label->at == line.from && *label->until == line.to) ||
              (label->at == line.to && *label->until == line.from));
    });
  }
  /// Whether a ball or a circle is centred at `p`: then its name stands there.
  bool is_round_at(const Vec3& p) const {
    return std::ranges::any_of(scene_.items, [&](const Item& item) {
      const auto* ball = std::get_if<Ball>(&item);
      const auto* circle = std::get_if<Circle>(&item);
      return (ball && ball->center == p) || (circle && circle->center == p && is_object(circle->role, circle->pen));
    });
  }
  bool is_dotted(const Vec3& p) const {
    return std::ranges::any_of(scene_.items, [&](const Item& item) {
      const auto* dot = std::get_if<Dot>(&item);
      return dot && dot->at == p;
    });
  }
  /// Whether a label may name an object. In bold it names a point or a vector; only balls are named by their centres.
  static bool names_an_object(const std::string& markup) { return !markup.starts_with("**"); }
  /// Returns the label at the middle of the box. Else the one label of the role that stands within it and names no
  /// point, or the one heading of the role; that of a first or second object may stand beside the box.
  std::string name_within(const Limits& e, Role role, bool is_round = false) const {
    const Vec3 middle = (e.lo + e.hi) / 2;
    if (const std::string centre = name_at(middle); !centre.empty() && (is_round || !is_round_at(middle)))
      return centre;
    std::set<std::string> names;
    for (const Item& item : scene_.items) {
      const auto* label = std::get_if<Label>(&item);
      if (label && !label->until && label->role == role && e.holds(label->at) &&
          (names_an_object(label->text) || (is_round && !is_dotted(label->at))))
        names.insert(plain(label->text));
      const auto* heading = std::get_if<Heading>(&item);
      if (heading && heading->role == role && (e.holds(heading->at) || role == Role::first || role == Role::second))
        names.insert(plain(heading->text));
    }
    return names.size() == 1 ? *names.begin() : "";
  }

  /// Returns the name of a line; a label at a marked midpoint names that point instead.
  std::string name_along(const Line& it) const {
    return is_dotted((it.from + it.to) / 2) ? "" : name_within(limits_of({it.from, it.to}), it.role);
  }

  void say(const std::string& kind, const std::string& name, const std::string& where) {
    const std::string text = kind + (name.empty() || name == kind ? "" : " " + name) + ": " + where;
    if (std::ranges::find(told_, text) != told_.end()) return;
    told_.push_back(text);
    ++counts_[kind];
  }
  void round(const std::string& kind, const Vec3& c, double radius, Role role) {
    if (is_parameter(c) && is_parameter(radius)) return;
    const Vec3 reach = Vec3::Constant(radius);
    const std::string centre = name_at(c);
    say(kind, centre.empty() ? name_within({c - reach, c + reach}, role, true) : centre,
        tr("centre {p}, radius {r}", {{"p", place(c)}, {"r", number(radius)}}));
  }
  void round(const RoundSolid& r, const Solid& it) {
    if (is_parameter(r.from) && is_parameter(r.to) && is_parameter(r.radius)) return;
    const std::string name = it.name.empty() ? name_within(limits_of(it.vertices), it.role) : plain(it.name);
    constexpr Message of_cone = message("apex {p} to {q}, radius {r}"),
                      of_cylinder = message("from {p} to {q}, radius {r}");
    say(r.pointed ? tr_as("object", "cone") : tr_as("object", "cylinder"), name,
        tr(r.pointed ? of_cone : of_cylinder, {{"p", place(r.from)}, {"q", place(r.to)}, {"r", number(r.radius)}}));
  }
  void corners(const std::string& kind, const Points& points, Role role, const std::string& given) {
    if (std::ranges::all_of(points, [&](const Vec3& p) { return is_parameter(p); })) return;  // told already
    const Limits e = limits_of(points);
    const bool within = points.size() > most_vertices;
    if (e.lo == e.hi || (within && kind == tr_as("object", "polygon"))) return;  // nothing, or a curve
    const std::string name = given.empty() ? name_within(e, role) : plain(given),
                      ends = tr("{p} to {q}", {{"p", place(e.lo)}, {"q", place(e.hi)}});
    if (is_box(points))
      say(!flat_ && (e.lo.array() == e.hi.array()).any() ? tr_as("object", "rectangle") : tr_as("object", "box"), name,
          ends);
    else
      say(kind, name,
          within ? tr_count(points.size(), "{n} vertices within {ends}", "{n} vertices within {ends}", {{"ends", ends}})
                 : list(points));
  }

  const Scene& scene_;
  const Parameters& parameters_;
  const bool flat_;
  std::vector<std::string> told_;
  std::map<std::string, int> counts_;
  Points points_;
};

}  // namespace

std::vector<std::string> scene_in_words(const Scene& scene, const Parameters& parameters, bool flat) {
  return SceneInWords(scene, parameters, flat).take();
}

}  // namespace isect::viz
