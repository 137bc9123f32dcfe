#include "viz/snapshot/drawing_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace isect::viz::snap {
namespace {

/// Rounds to this many decimals; a whole number has none.
Json rounded(double x, int decimals) {
  const double unit = std::pow(10.0, decimals), scaled = std::round(x * unit);
  if (!std::isfinite(scaled)) return "no number";
  if (std::fmod(scaled, unit) == 0 && std::abs(x) < 1e15) return static_cast<std::int64_t>(std::llround(x));
  return scaled / unit;
}

Json places(std::initializer_list<double> numbers) {
  Json list = Json::array();
  for (const double x : numbers) list.push_back(rounded(x, 2));
  return list;
}
Json place(const Vec2& p) { return places({p.x(), p.y()}); }

using Tint = std::array<double, 4>;  ///< red, green, blue, alpha, each up to 255
Tint tint(const Colour& c) { return {255 * c.r, 255 * c.g, 255 * c.b, 255 * c.a}; }
/// Returns "#0b60c8", followed by the alpha if it is not opaque; a list if a channel is no whole number.
Json json_of(const Tint& t, int decimals = 1) {
  const bool whole = std::all_of(t.begin(), t.begin() + 3, [](double x) { return std::abs(x - std::round(x)) < 1e-6; });
  if (!whole) {
    Json list = Json::array();
    for (const double x : t) list.push_back(rounded(x, decimals));
    return list;
  }
  const std::string hex = fmt::format("#{:02x}{:02x}{:02x}", std::lround(t[0]), std::lround(t[1]), std::lround(t[2]));
  return t[3] == 255 ? hex : fmt::format("{} {}", hex, rounded(t[3], decimals).dump());
}

/// Box, length, middle and slant of lines, weighted by length: they tell a figure from one that is moved, larger,
/// turned or mirrored.
class Extent {
 public:
  void add(const Path& path) {
    std::vector<Vec2> points = flatten(path, 0.01);
    if (path.closed && points.size() > 1) points.push_back(points.front());
    for (const Vec2& p : points) {
      lo_ = lo_.cwiseMin(p), hi_ = hi_.cwiseMax(p);
      if (count_++ == 0) first_ = p;
      last_ = p;
    }
    for (std::size_t i = 1; i < points.size(); ++i) segment(points[i - 1], points[i]);
  }
  void add(const Extent& other) {
    lo_ = lo_.cwiseMin(other.lo_), hi_ = hi_.cwiseMax(other.hi_);
    if (count_ == 0) first_ = other.first_;
    last_ = other.last_;
    count_ += other.count_;
    sum_ += other.sum_, length_ += other.length_, product_ += other.product_;
  }
  double length() const { return length_; }

  void tell(Json& part) const {
    if (count_ == 0) return;
    if (count_ == 2) {  // one straight line
      part["line"] = places({first_.x(), first_.y(), last_.x(), last_.y()});
      return;
    }
    part["box"] = places({lo_.x(), lo_.y(), hi_.x(), hi_.y()});
    if (!(length_ > 0)) return;
    const Vec2 mean = sum_ / length_;
    const double slant = product_ / length_ - mean.x() * mean.y(), size = std::max((hi_ - lo_).norm(), 1.0);
    part["weight"] = places({mean.x(), mean.y(), length_, slant / size});
  }
  const Vec2& first() const { return first_; }

 private:
  void segment(const Vec2& a, const Vec2& b) {
    const double l = (b - a).norm();
    if (!std::isfinite(l)) return;
    length_ += l;
    sum_ += l / 2 * (a + b);
    product_ += l / 6 * (2 * a.x() * a.y() + 2 * b.x() * b.y() + a.x() * b.y() + b.x() * a.y());
  }

  Vec2 lo_ = Vec2::Constant(std::numeric_limits<double>::infinity()), hi_ = -lo_;
  Vec2 first_ = Vec2::Zero(), last_ = Vec2::Zero(), sum_ = Vec2::Zero();
  double length_ = 0, product_ = 0;
  int count_ = 0;
};

/// The style of a shape: what two shapes of one part must have in common. Colours are compared separately.
Json style(const Fill& f) {
  Json s = {{"draws", "fill"}};
  if (f.hatch_gap > 0) {
    s["hatch"] = {rounded(f.hatch_gap, 3), rounded(f.hatch_line, 3)};
    s["hatch colour"] = json_of(tint(f.hatch_colour));
  }
  return s;
}
Json style(const Stroke& l) {
  Json s = {{"draws", "stroke"}, {"width", rounded(l.width, 3)}};
  if (l.dash[0] > 0) s["dash"] = {rounded(l.dash[0], 3), rounded(l.dash[1], 3)};
  if (!l.round_cap) s["cap"] = "flat";
  return s;
}
Json style(const Gradient& g) {
  return {{"draws", "gradient"}, {"focus", place(g.focus)}, {"rim", json_of(tint(g.outer))}};
}
Json style(const Text& t) {
  Json s = {{"draws", "text"}, {"text", t.markup}, {"at", place(t.at)}, {"size", rounded(t.size, 2)}};
  if (t.align != 0) s["align"] = rounded(t.align, 3);
  if (t.bold) s["bold"] = true;
  if (t.halo > 0) {
    s["halo"] = rounded(t.halo, 3);
    s["halo colour"] = json_of(tint(t.halo_colour));
  }
  return s;
}

Json style(const Facets&) { return {}; }  // never called: drawing_summary() expands them

Colour colour_of(const Gradient& g) { return g.inner; }
Colour colour_of(const Facets&) { return {}; }
template <class S>
Colour colour_of(const S& s) {
  return s.colour;
}

std::string colour_key(const Shape& shape) {
  return json_of(tint(std::visit([](const auto& s) { return colour_of(s); }, shape))).dump();
}

void measure_into(Extent& e, const Fill& f) {
  e.add(f.path);
  for (const Path& path : f.more) e.add(path);
}
void measure_into(Extent& e, const Stroke& s) { e.add(s.path); }
void measure_into(Extent& e, const Gradient& g) { e.add(ellipse(g.center, g.major, g.minor)); }
void measure_into(Extent&, const Text&) {}
void measure_into(Extent&, const Facets&) {}

/// Consecutive shapes of one style within one object.
struct Part {
  Json style;
  std::string key;  ///< the style, and the colour unless the object is shaded
  Extent extent;
  bool shaded;
  Tint colour = {};  ///< weighted by length
  double weight = 0;

  Part(const Shape& shape, bool is_shaded)
      : style(std::visit([](const auto& s) { return snap::style(s); }, shape)),
        key(style.dump() + (is_shaded ? "" : colour_key(shape))),
        shaded(is_shaded) {
    std::visit([&](const auto& s) { measure_into(extent, s); }, shape);
    weight = std::max(extent.length(), 1e-6);
    colour = tint(std::visit([](const auto& s) { return colour_of(s); }, shape));
    for (double& x : colour) x *= weight;
  }
  void add(const Part& other) {
    extent.add(other.extent);
    for (std::size_t i = 0; i < colour.size(); ++i) colour[i] += other.colour[i];
    weight += other.weight;
  }
  /// Returns the part. A shaded object's mean is kept to thousandths: one tint of hundreds hardly moves it.
  Json told() const {
    Json part = style;
    Tint mean = colour;
    for (double& x : mean) x /= weight;
    if (std::abs(mean[3] - 255) < 1e-6) mean[3] = 255;
    part[shaded ? "mean colour" : "colour"] = json_of(mean, shaded ? 3 : 1);
    extent.tell(part);
    if (part.contains("dash") && part.contains("box")) part["start"] = place(extent.first());
    return part;
  }
};

/// Objects of more colours than this are shaded: only their mean colour is recorded.
constexpr std::size_t most_colours = 8;

std::string name_in(const Drawing& drawing, int object) {
  const bool known = object >= 0 && object < static_cast<int>(drawing.objects.size());
  return known ? full_name(drawing.objects[object]) : "rest";
}

/// Consecutive parts of one object in the paint order.
struct Run {
  int object = no_object;
  std::vector<Part> parts;
};

/// An object painted in more turns than this lies among others like a mosaic: its parts are merged into one.
constexpr std::size_t most_runs = 6;

/// Adds it to the part of the same style, or as a new part.
void join(std::vector<Part>& parts, const Part& part) {
  const auto same = std::ranges::find(parts, part.key, &Part::key);
  if (same == parts.end())
    parts.push_back(part);
  else
    same->add(part);
}

std::vector<Run> runs_of(const Drawing& drawing, const std::map<int, std::set<std::string>>& colours) {
  std::vector<Run> runs;
  for (const Shape& shape : drawing.shapes) {
    const int object = object_of(shape);
    if (runs.empty() || runs.back().object != object) runs.push_back({object, {}});
    join(runs.back().parts, Part(shape, colours.at(object).size() > most_colours));
  }
  return runs;
}

}  // namespace

Json drawing_summary(const Drawing& with_facets) {
  Drawing drawing = with_facets;
  drawing.shapes = expanded(with_facets.shapes);
  std::map<int, std::set<std::string>> colours;
  for (const Shape& shape : drawing.shapes) colours[object_of(shape)].insert(colour_key(shape));

  const std::vector<Run> runs = runs_of(drawing, colours);
  std::map<int, std::size_t> count;
  for (const Run& run : runs) ++count[run.object];

  Json order = Json::array(), objects = Json::object();
  objects["page"] = {{"parts",
                      {{{"draws", "page"},
                        {"box", places({0, 0, drawing.width, drawing.height})},
                        {"colour", json_of(tint(drawing.background))}}}}};
  std::map<int, std::vector<Part>> scattered;
  for (const Run& run : runs) {
    const std::string name = name_in(drawing, run.object);
    const bool one = count[run.object] <= most_runs;
    if (one || !objects.contains(name)) order.push_back(name);
    if (!objects.contains(name)) {
      objects[name] = Json::object();
      if (name != "rest") objects[name]["role"] = name_of(drawing.objects[run.object].role);
      objects[name]["parts"] = Json::array();
    }
    for (const Part& part : run.parts) {
      if (one)
        objects[name]["parts"].push_back(part.told());
      else
        join(scattered[run.object], part);
    }
  }
  for (const auto& [object, parts] : scattered)
    for (const Part& part : parts) objects[name_in(drawing, object)]["parts"].push_back(part.told());
  return {{"order", order}, {"objects", objects}};
}

Json change(const Json& before, const Json& after) {
  Json told = Json::object();
  const Json &old_ones = at(before, "objects"), &new_ones = at(after, "objects");
  for (const auto& item : new_ones.items())
    if (at(old_ones, item.key()) != item.value()) told[item.key()] = item.value();
  if (old_ones.is_object())
    for (const auto& item : old_ones.items())
      if (!new_ones.contains(item.key())) told[item.key()] = nullptr;
  Json result = {{"objects", told}};
  if (at(before, "order") != at(after, "order")) result["order"] = at(after, "order");
  return result;
}

Json after(Json before, const Json& change) {
  if (!before.is_object()) before = {{"order", Json::array()}, {"objects", Json::object()}};
  if (at(change, "order").is_array()) before["order"] = change["order"];
  if (at(change, "objects").is_object())
    for (const auto& item : change["objects"].items()) {
      before["objects"].erase(item.key());
      if (!item.value().is_null()) before["objects"][item.key()] = item.value();
    }
  return before;
}

}  // namespace isect::viz::snap
