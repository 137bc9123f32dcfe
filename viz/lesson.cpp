#include "viz/lesson.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/text/spelling.h"

namespace isect::viz {

namespace {

/// Reads the whole of `text` as a number, whatever the locale; a leading '+' is fine.
std::optional<double> number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

/// Reads a point. In the plane the third number may be left out.
std::optional<Vec3> point(std::string_view text, bool flat) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',');
    const bool last = i == 2 || (flat && i == 1 && comma == text.npos);
    if ((comma == text.npos) != last) return {};
    const std::optional<double> x = number(text.substr(0, comma));
    if (!x) return {};
    p[i] = *x;
    if (last) break;
    text.remove_prefix(comma + 1);
  }
  return p;
}

std::string shortest(double x) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}

/// Returns the shortest text of a number, but a large whole number with all its digits.
std::string in_digits(double x) {
  return std::abs(x) < 1e15 && x == std::trunc(x) ? fmt::format("{:.0f}", x) : shortest(x);
}

std::vector<std::string> parameter_names(const Lesson& lesson) {
  std::vector<std::string> names;
  for (const Parameter& p : lesson.parameters) names.push_back(p.name);
  return names;
}

/// Returns "p2" for "**p**_2" and for "p_2".
std::string letters(std::string symbol) {
  std::erase_if(symbol, [](char c) { return std::string_view("*_{}").find(c) != std::string_view::npos; });
  return symbol;
}

const Parameter& parameter(const Lesson& lesson, const std::string& name) {
  const auto found = std::ranges::find(lesson.parameters, name, &Parameter::name);
  if (found != lesson.parameters.end()) return *found;
  for (const Parameter& p : lesson.parameters)
    if (!p.label.empty() && letters(p.label) == letters(name))
      throw BadInput(fmt::format("parameter: \"{}\" is unknown; {} in the pictures is called \"{}\"", name,
                                 plain(p.label), p.name));
  throw unknown("parameter", name, parameter_names(lesson));
}

/// Throws BadInput unless the value is allowed; `given` is the value as it was written.
void check(const Parameter& p, const Setting& value, const std::string& given) {
  const auto in_range = [&](double x) { return x >= p.lo && x <= p.hi; };  // no for NaN
  bool good = value.index() == p.initial.index();
  if (good && std::holds_alternative<std::string>(value)) {
    const std::string& choice = std::get<std::string>(value);
    if (std::ranges::find(p.choices, choice) == p.choices.end()) throw unknown(p.name, choice, p.choices);
  } else if (good && std::holds_alternative<double>(value)) {
    good = in_range(std::get<double>(value));
  } else if (good) {
    const Vec3& v = std::get<Vec3>(value);
    good = in_range(v.x()) && in_range(v.y()) && in_range(v.z());
  }
  if (good) return;
  if (!p.choices.empty()) throw unknown(p.name, given, p.choices);
  throw BadInput(fmt::format("{}: \"{}\" is not allowed; give {}", p.name, given, wanted(p)));
}

/// Returns the first condition that these parameters break, if any.
const Condition* broken(const Lesson& lesson, const Parameters& parameters) {
  const auto found =
      std::ranges::find_if_not(lesson.conditions, [&](const Condition& c) { return c.holds(parameters); });
  return found == lesson.conditions.end() ? nullptr : &*found;
}

Vec3 in_range(const Parameter& p, const Vec3& v) { return v.cwiseMax(p.lo).cwiseMin(p.hi); }

/// Returns v after the shortest turn that brings `from` into the direction of `to`, in the plane if they lie there.
Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to) {
  const Vec3 a = from.stableNormalized(), b = to.stableNormalized(), axis = a.cross(b);
  const double cosine = a.dot(b);
  if (1 + cosine > 1e-9) return cosine * v + axis.cross(v) + axis.dot(v) / (1 + cosine) * axis;
  const Vec3 half = a.z() == 0 && b.z() == 0 ? Vec3::UnitZ() : a.unitOrthogonal();  // the axis of half a turn
  return 2 * half.dot(v) * half - v;
}

/// Returns a number of the handle on its line, within the ends of that and of the parameter.
double on_line(const Parameter& p, const Handle& handle, const Vec3& arm) {
  return std::clamp(std::clamp(arm.dot(handle.direction), handle.lo, handle.hi), p.lo, p.hi);
}

double angle(const Handle& handle, const Vec3& arm) {
  constexpr double degrees = 180 / std::numbers::pi;
  return handle.scale * degrees * std::atan2(arm.dot(handle.across), arm.dot(handle.direction));
}

/// Returns v turned so that it points where the arm does; v itself where that has no direction.
Vec3 turned_along(const Vec3& v, const Vec3& arm) {
  const Vec3 way = arm.stableNormalized();
  return way.isZero(0.5) ? v : Vec3(v.stableNorm() * way);
}

/// Returns v shifted as the handle is. What is not meant to move stays to the last bit; a handle that is not the latest
/// leads to the same place.
Vec3 shifted(const Vec3& v, const Handle& handle, const Vec3& to) {
  Vec3 before = handle.at - handle.anchor - v;
  for (int i = 0; i < 3; ++i)
    if (std::abs(before[i]) <= 1e-12 * (std::abs(handle.at[i]) + std::abs(v[i]))) before[i] = 0;
  return v + (to - handle.at + before);
}

/// Returns the point nearest to `to` of the plane through the handle.
Vec3 on_plane(const Handle& handle, const Vec3& to) {
  const Vec3 n = handle.direction.cross(handle.across);
  return to - n.dot(to - handle.at) / n.squaredNorm() * n;
}

/// Returns the arm's two coordinates along the directions that span the handle's plane.
Vec3 in_plane(const Handle& handle, const Vec3& arm) {
  const Vec3 &u = handle.direction, &v = handle.across;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), au = arm.dot(u), av = arm.dot(v), det = uu * vv - uv * uv;
  return Vec3(au * vv - av * uv, av * uu - au * uv, 0) / det;
}

/// Returns the parameter's value when its handle is dragged to `to`, clamped to the parameter's range. `now`: its
/// value.
Setting clamped(const Parameter& p, const Handle& handle, const Vec3& to, const Setting& now) {
  const Vec3 arm = to - handle.anchor;
  switch (handle.kind) {
    case Handle::Kind::on_line: {
      const double x = on_line(p, handle, arm);
      if (std::holds_alternative<double>(now)) return x;
      Vec3 v = std::get<Vec3>(now);
      v[handle.axis] = x;
      return v;
    }
    case Handle::Kind::angle:
      return std::clamp(angle(handle, arm), p.lo, p.hi);
    case Handle::Kind::length:
      return std::clamp(arm.norm(), p.lo, p.hi);
    case Handle::Kind::along:
      return std::clamp(arm.dot(handle.direction), p.lo, p.hi);
    case Handle::Kind::turn:
      return in_range(p, turned_along(std::get<Vec3>(now), arm));
    case Handle::Kind::shift:
      return in_range(p, shifted(std::get<Vec3>(now), handle, to));
    case Handle::Kind::point:
      return in_range(p, to);
    case Handle::Kind::vector:
      return in_range(p, arm / handle.scale);
    case Handle::Kind::on_plane:
      return in_range(p, on_plane(handle, to));
    case Handle::Kind::plane:
      return in_range(p, in_plane(handle, arm));
  }
  return now;
}

/// Moves the other parameters of a handle whose own one has moved.
void drag_others(const Lesson& lesson, Parameters& moved, const Handle& handle, const Vec3& before, const Vec3& now) {
  for (const std::string& name : handle.with) {
    const Parameter& p = parameter(lesson, name);
    Setting& value = moved.try_emplace(name, p.initial).first->second;
    if (double* d = std::get_if<double>(&value))
      *d = std::clamp(-now.dot(handle.anchor), p.lo, p.hi);
    else if (Vec3* v = std::get_if<Vec3>(&value))
      *v = in_range(p, handle.kind == Handle::Kind::turn ? turned(*v, before, now) : Vec3(*v + (now - before)));
  }
}

bool is_finite(const Setting& setting) {
  if (const double* x = std::get_if<double>(&setting)) return std::isfinite(*x);
  const Vec3* v = std::get_if<Vec3>(&setting);
  return !v || v->allFinite();
}

}  // namespace

Camera opening(const Lesson& lesson) {
  Camera camera = lesson.camera;
  if (lesson.flat) camera.azimuth = camera.elevation = 0, camera.perspective = false;
  return camera;
}

Camera opening(const Lesson& lesson, const std::optional<StepView>& view) {
  return view ? view->camera : opening(lesson);
}

bool has_own_views(const Walk& walk) {
  return std::ranges::any_of(walk.steps, [](const Step& s) { return s.view.has_value(); });
}

bool counts(const Parameter& p, const Parameters& values) {
  return std::ranges::all_of(p.where, [&](const auto& where) {
    const auto& [choice, with] = where;
    return std::ranges::find(with, std::get<std::string>(values.at(choice))) != with.end();
  });
}

std::string told_where(const Parameter& p) {
  std::string words;
  for (const auto& [choice, with] : p.where)
    words += (words.empty() ? "Counts where " : ", and ") + fmt::format("{} is {}", choice, fmt::join(with, " or "));
  return words;
}

std::string wanted(const Parameter& p) {
  if (!p.choices.empty()) return fmt::format("one of {}", fmt::join(p.choices, ", "));
  std::string range;
  if (p.lo > -1e300 && p.hi < 1e300)
    range = fmt::format(" from {} to {}", in_digits(p.lo), in_digits(p.hi));
  else if (p.lo > -1e300)
    range = fmt::format(" of at least {}", in_digits(p.lo));
  else if (p.hi < 1e300)
    range = fmt::format(" of at most {}", in_digits(p.hi));
  if (std::holds_alternative<double>(p.initial)) return "a number" + range;
  return "three numbers" + (range.empty() ? range : ", each" + range) + ", such as " + to_text(p.initial);
}

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  return spelling::nearest(word, candidates);
}

BadInput unknown(const std::string& field, const std::string& given, const std::vector<std::string>& allowed) {
  if (allowed.empty())
    return BadInput(fmt::format("{}: \"{}\" is unknown; there is none to choose from", field, given));
  return BadInput(fmt::format("{}: \"{}\" is unknown{}", field, given,
                              spelling::instead(given, allowed, "allowed: " + spelling::listed(allowed))));
}

bool has_axis(const Walk& walk) {
  return std::ranges::any_of(walk.steps, [](const Step& step) { return step.scene.axis.has_value(); });
}

bool has_time(const Walk& walk) {
  return std::ranges::any_of(walk.steps, [](const Step& step) { return step.scene.time != nullptr; });
}

const Preset& preset(const Lesson& lesson, const std::string& id) {
  const auto found = std::ranges::find(lesson.presets, id, &Preset::id);
  if (found != lesson.presets.end()) return *found;
  std::vector<std::string> ids;
  for (const Preset& p : lesson.presets) ids.push_back(p.id);
  throw unknown("preset", id, ids);
}

void set(const Lesson& lesson, Parameters& to, const std::string& name, const std::string& text) {
  const Parameter& p = parameter(lesson, name);
  std::optional<Setting> value;
  if (std::holds_alternative<std::string>(p.initial)) {
    value = text;
  } else if (std::holds_alternative<double>(p.initial)) {
    value = number(text);
  } else {
    value = point(text, lesson.flat);
  }
  if (!value) throw BadInput(fmt::format("{}: \"{}\" is not allowed; give {}", name, text, wanted(p)));
  check(p, *value, text);
  to.insert_or_assign(name, *value);
}

void set_value(const Lesson& lesson, Parameters& to, const std::string& name, const Setting& value) {
  check(parameter(lesson, name), value, to_text(value));
  to.insert_or_assign(name, value);
}

void validate(const Lesson& lesson, const Parameters& parameters) {
  std::unordered_map<std::string_view, const Parameter*> known;  // a scene may have thousands
  for (const Parameter& p : lesson.parameters) known.emplace(p.name, &p);
  for (const auto& [name, value] : parameters) {
    const auto found = known.find(name);
    check(found == known.end() ? parameter(lesson, name) : *found->second, value, to_text(value));
  }
  for (const Parameter& p : lesson.parameters)
    if (!p.optional && !parameters.contains(p.name))
      throw BadInput(fmt::format("{}: missing; every parameter of {} is needed", p.name, lesson.id));
  if (const Condition* c = broken(lesson, parameters))
    throw BadInput(fmt::format("{}: \"{}\" is not allowed; give {}", c->parameter, to_text(parameters.at(c->parameter)),
                               c->allowed));
}

const Condition* drag(const Lesson& lesson, Parameters& parameters, const Handle& handle, const Vec3& p) {
  if (!p.allFinite()) return nullptr;
  const Parameter& knob = parameter(lesson, handle.parameter);
  Parameters moved = parameters;
  const auto known = parameters.find(knob.name);
  const Setting before = known == parameters.end() ? knob.initial : known->second;
  const Setting now = clamped(knob, handle, p, before);
  moved.insert_or_assign(knob.name, now);
  if (!handle.with.empty()) drag_others(lesson, moved, handle, std::get<Vec3>(before), std::get<Vec3>(now));
  const auto finite = [&](const std::string& name) { return is_finite(moved.at(name)); };
  if (!finite(knob.name) || !std::ranges::all_of(handle.with, finite)) return nullptr;
  const Condition* forbids = broken(lesson, moved);
  if (!forbids) parameters = std::move(moved);
  return forbids;
}

void choose(const Lesson& lesson, Parameters& parameters, const std::string& name, const Setting& value) {
  const bool anew = std::holds_alternative<std::string>(value) && name != lesson.group_by;
  for (const Parameter& p : lesson.parameters)
    if (anew && p.optional) parameters.erase(p.name);
  parameters.insert_or_assign(name, value);
}

std::string to_text(const Setting& setting) {
  if (const auto* x = std::get_if<double>(&setting)) return shortest(*x);
  if (const auto* v = std::get_if<Vec3>(&setting))
    return shortest(v->x()) + "," + shortest(v->y()) + "," + shortest(v->z());
  return std::get<std::string>(setting);
}

std::string shown(double value) {
  if (std::isnan(value)) return "NaN";
  const std::string sign = std::signbit(value) && value != 0 ? "−" : "";
  if (std::isinf(value)) return sign + "∞";

  // Five digits in scientific form say how large the number is once it has been rounded.
  const std::string scientific = fmt::format("{:.4e}", std::abs(value));
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  const bool plain = exponent >= -4 && exponent <= 6;
  std::string digits = plain ? fmt::format("{:.{}f}", std::abs(value), std::max(0, 4 - exponent))
                             : scientific.substr(0, scientific.find('e'));
  if (digits.find('.') != std::string::npos) {
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
  } else if (digits.size() > 4) {
    for (std::size_t i = digits.size(); i > 3; i -= 3)
      if (i > 3) digits.insert(i - 3, "\u2009");  // a thin space: 26 654
  }
  if (plain) return sign + digits;

  static constexpr std::array raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string power = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) power += raised[digit - '0'];
  return sign + digits + "\u2009·\u200910" + power;
}

std::string shown_with_sign(double value) { return value == 0 && std::signbit(value) ? "−0" : shown(value); }

std::pair<std::string, std::string> shown_apart(double a, double b) {
  if (a == b || shown(a) != shown(b)) return {shown(a), shown(b)};
  return {to_text(a), to_text(b)};
}

}  // namespace isect::viz
