// Compares two drawings' summaries: tells what happened to each object, in words.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "viz/snapshot/drawing_summary.h"
#include "viz/text/rich_text.h"

namespace isect::viz::snap {
namespace {

/// What may be said of an object, ordered by how much it explains.
enum class Said { gone, fresh, text, moved, size, shape, role, style, order };

struct Saying {
  Said kind;
  std::string subject, verb;  ///< "the ball b", "moved"
  double pixels = 0;          ///< how far, where that is said
  std::string what = {};      ///< the subject's part that the verb is about: "width"; empty: the subject itself
  std::string plainly = {};  ///< the verb without numbers that differ from drawing to drawing; empty: the verb has none
};

bool is_colour(const std::string& key) { return key.ends_with("colour") || key == "rim"; }

/// Returns one of a list of numbers; NaN if there is none.
double number(const Json& list, std::size_t i) {
  return list.is_array() && i < list.size() && list[i].is_number() ? list[i].get<double>() : NAN;
}

/// Returns a tolerance of two steps of the recorded precision: a hundredth of a pixel for places, a tenth of a level
/// for tints, a thousandth for pens and the means of many tints.
double tolerance(const std::string& key) {
  if (key == "mean colour") return 0.0025;
  if (is_colour(key)) return 0.25;
  if (key == "width" || key == "dash" || key == "hatch" || key == "halo" || key == "align") return 0.0025;
  return 0.025;
}

/// Returns red, green, blue, alpha, each up to 255, of "#0b60c8", "#0b60c8 35.7" or a list; else nothing.
std::vector<double> tint_of(const Json& colour) {
  std::vector<double> tint;
  if (colour.is_array())
    for (std::size_t i = 0; i < colour.size(); ++i) tint.push_back(number(colour, i));
  unsigned rgb = 0;
  double alpha = 255;
  if (colour.is_string() && std::sscanf(colour.get<std::string>().c_str(), "#%6x %lf", &rgb, &alpha) >= 1)
    tint = {double(rgb >> 16 & 255), double(rgb >> 8 & 255), double(rgb & 255), alpha};
  return tint;
}

bool same(const std::string& key, const Json& a, const Json& b) {
  if (a == b) return true;
  if (is_colour(key)) {
    const std::vector<double> p = tint_of(a), q = tint_of(b);
    return !p.empty() && std::ranges::equal(p, q, [&](double x, double y) { return std::abs(x - y) < tolerance(key); });
  }
  if (a.is_number() && b.is_number()) return std::abs(a.get<double>() - b.get<double>()) < tolerance(key);
  if (!a.is_array() || !b.is_array() || a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same(key, a[i], b[i])) return false;
  return true;
}

bool is_place(const std::string& key) {
  return key == "line" || key == "box" || key == "weight" || key == "focus" || key == "at" || key == "start";
}

/// Returns left, top, right, bottom of a part; empty for a text, whose extent depends on its font.
std::optional<std::array<double, 4>> box_of(const Json& part) {
  const Json& line = at(part, "line");
  const Json& box = line.is_array() ? line : at(part, "box");
  if (!box.is_array()) return {};
  const double x0 = number(box, 0), y0 = number(box, 1), x1 = number(box, 2), y1 = number(box, 3);
  return std::array{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
}

/// The largest distance that a part's points moved, and whether all moved alike.
struct Motion {
  double most = 0;
  std::vector<Vec2> shifts;

  void add(double x, double y) {
    shifts.emplace_back(x, y);
    most = std::max(most, shifts.back().norm());
  }
  bool alike() const {
    return std::ranges::all_of(shifts, [&](const Vec2& s) { return (s - shifts.front()).norm() < 0.05; });
  }
};

void add_motion(Motion& motion, const Json& was, const Json& is) {
  for (const std::string key : {"line", "box", "at"}) {
    const Json &a = at(was, key), &b = at(is, key);
    if (!a.is_array() || !b.is_array() || a.size() != b.size()) continue;
    for (std::size_t i = 0; i + 1 < a.size(); i += 2)
      motion.add(number(b, i) - number(a, i), number(b, i + 1) - number(a, i + 1));
  }
}

std::string in_words(const Json& colour) {
  const std::vector<double> t = tint_of(colour);
  if (t.size() != 4) return shown(colour);
  std::string text =
      colour.is_string() ? shown(colour).substr(0, 7) : fmt::format("rgb({:.6g} {:.6g} {:.6g})", t[0], t[1], t[2]);
  return t[3] == 255 ? text : text + fmt::format(" at {:.1f} %", t[3] / 2.55);
}

/// Returns "is dashed now"; empty where values say it.
std::string turn_of_style(const std::string& key, const Json& was, const Json& is) {
  const auto absent = [](const Json& j) { return j.is_string() && j == "absent"; };
  if (key == "dash" && absent(was)) return "is dashed now";
  if (key == "dash" && absent(is)) return "is solid now";
  if (key == "hatch" && absent(was)) return "is hatched now";
  if (key == "hatch" && absent(is)) return "is not hatched any more";
  return {};
}

std::string style_value(const std::string& key, const Json& value) {
  if (key == "width") return value.dump() + " px";
  return is_colour(key) ? in_words(value) : shown(value);
}

/// Collects what is to be said of one object.
class Comparer {
 public:
  Comparer(const std::string& name, std::vector<Saying>& out) : subject_("the " + name), out_(out) {}

  void compare(const Json& was, const Json& is) {
    if (at(was, "role") != at(is, "role")) say_value(Said::role, "role", shown(at(was, "role")), shown(at(is, "role")));
    std::vector<Json> old_parts = parts_of(was), new_parts = parts_of(is);
    match(old_parts, new_parts);
    for (const auto& [a, b] : pairs_) compare_parts(a, b);
    place();
    if (!shape_said_ && !old_parts.empty()) say(Said::shape, fmt::format("has lost a {}", what(old_parts[0])));
    if (!shape_said_ && !new_parts.empty()) say(Said::shape, fmt::format("has one more {}", what(new_parts[0])));
  }

 private:
  static std::vector<Json> parts_of(const Json& object) {
    const Json& parts = at(object, "parts");
    return parts.is_array() ? parts.get<std::vector<Json>>() : std::vector<Json>{};
  }
  static std::string what(const Json& part) {
    return at(part, "draws") == "text" ? "text “" + plain(shown(at(part, "text"))) + "”" : shown(at(part, "draws"));
  }
  static int likeness(const Json& a, const Json& b) {
    if (at(a, "draws") != at(b, "draws")) return -1;
    int score = 0;
    for (const auto& item : a.items())
      score += !is_place(item.key()) && same(item.key(), item.value(), at(b, item.key()));
    if (at(a, "text") == at(b, "text")) score += 4;
    return score;
  }
  /// Pairs the parts that are most alike, in order; parts without a partner stay.
  void match(std::vector<Json>& was, std::vector<Json>& is) {
    for (auto b = is.begin(); b != is.end();) {
      const auto a = std::max_element(was.begin(), was.end(),
                                      [&](const Json& x, const Json& y) { return likeness(x, *b) < likeness(y, *b); });
      if (a == was.end() || likeness(*a, *b) < 0) {
        ++b;
        continue;
      }
      pairs_.emplace_back(*a, *b);
      was.erase(a);
      b = is.erase(b);
    }
  }

  void compare_parts(const Json& was, const Json& is) {
    bool moved = false;
    const auto one = [&](const std::string& key, const Json& a, const Json& b) {
      if (same(key, a, b)) return;
      if (is_place(key)) {
        moved = true;
      } else if (key == "text") {
        const std::string old_text = plain(shown(a)), new_text = plain(shown(b));
        if (old_text == new_text)
          say_value(Said::text, "markup", a.dump(), b.dump());
        else
          say_value(Said::text, "text", "“" + old_text + "”", "“" + new_text + "”");
      } else if (const std::string turn = turn_of_style(key, a, b); !turn.empty()) {
        say(Said::style, turn);
      } else {
        say_value(Said::style, key, style_value(key, a), style_value(key, b));
      }
    };
    for (const auto& item : is.items()) one(item.key(), at(was, item.key()), item.value());
    for (const auto& item : was.items())
      if (!is.contains(item.key())) one(item.key(), item.value(), at(is, item.key()));
    if (moved) moved_ = true;
    add_motion(motion_, was, is);
    if (const auto a = box_of(was), b = box_of(is); moved && a && b) {
      const double old_size = std::hypot((*a)[2] - (*a)[0], (*a)[3] - (*a)[1]);
      const double new_size = std::hypot((*b)[2] - (*b)[0], (*b)[3] - (*b)[1]);
      if (old_size > 0 && std::abs(new_size - old_size) > 0.05 && !grown_) grown_ = new_size / old_size;
    }
  }

  /// Says one thing for all parts: moved as a whole, larger, or of another shape.
  void place() {
    if (!moved_) return;
    shape_said_ = true;
    if (!motion_.shifts.empty() && motion_.most >= 0.02 && motion_.alike())
      say(Said::moved, "moved", motion_.most);
    else if (grown_ && std::abs(*grown_ - 1) >= 5e-5)
      out_.push_back({Said::size, subject_, fmt::format("is {:.4g} times as large", *grown_), 0, {}, resized(*grown_)});
    else
      say(Said::shape, motion_.most >= 0.02 ? "changed its shape" : "changed its inner shape", motion_.most);
  }
  void say(Said kind, const std::string& verb, double pixels = 0) { out_.push_back({kind, subject_, verb, pixels}); }
  void say_value(Said kind, const std::string& what, const std::string& was, const std::string& is) {
    const bool of_one = kind == Said::text || what == "mean colour";  // other drawings have other values
    out_.push_back({kind, subject_, fmt::format("was {}, is {}", was, is), 0, what, of_one ? "changed" : ""});
  }
  static std::string resized(double times) { return times > 1 ? "is larger" : "is smaller"; }

  std::string subject_;
  std::vector<Saying>& out_;
  std::vector<std::pair<Json, Json>> pairs_;
  Motion motion_;
  std::optional<double> grown_;
  bool moved_ = false, shape_said_ = false;
};

using Bounds4 = std::optional<std::array<double, 4>>;

Bounds4 bounds_of(const Json& object) {
  Bounds4 all;
  const Json& parts = at(object, "parts");
  if (!parts.is_array()) return all;
  for (const Json& part : parts)
    if (const auto box = box_of(part)) {
      if (!all) all = box;
      for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        (*all)[i] = std::min((*all)[i], (*box)[i]);
        (*all)[i + 2] = std::max((*all)[i + 2], (*box)[i + 2]);
      }
    }
  return all;
}

/// Whether two objects meet; the extent of a text is unknown, so it may meet anything.
bool meet(const Bounds4& a, const Bounds4& b) {
  return !a || !b || ((*a)[0] <= (*b)[2] && (*b)[0] <= (*a)[2] && (*a)[1] <= (*b)[3] && (*b)[1] <= (*a)[3]);
}

/// Returns the places of each object in the paint order.
std::map<std::string, std::vector<std::size_t>> places_in(const Json& order) {
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i].is_string()) places[order[i].get<std::string>()].push_back(i);
  return places;
}

/// Returns the order in which two objects are painted, as "ab" or "aba"; a run of one counts once.
std::string turns(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::string text;
  for (std::size_t i = 0, k = 0; i < a.size() || k < b.size();) {
    const bool first = k == b.size() || (i < a.size() && a[i] < b[k]);
    if (text.empty() || text.back() != (first ? 'a' : 'b')) text += first ? 'a' : 'b';
    ++(first ? i : k);
  }
  return text;
}

/// Reports objects that meet and are painted in another order than before. Nobody sees the order of the others.
void compare_orders(const Json& was, const Json& is, std::vector<Saying>& out) {
  if (at(was, "order") == at(is, "order") || !at(was, "order").is_array()) return;
  const auto before = places_in(was["order"]), now = places_in(is["order"]);
  std::map<std::string, Bounds4> bounds;
  for (const auto& [name, places] : now) bounds[name] = bounds_of(at(is["objects"], name));
  for (auto a = now.begin(); a != now.end(); ++a)
    for (auto b = std::next(a); b != now.end(); ++b) {
      const auto old_a = before.find(a->first), old_b = before.find(b->first);
      if (old_a == before.end() || old_b == before.end() || !meet(bounds[a->first], bounds[b->first])) continue;
      const std::string old_turns = turns(old_a->second, old_b->second), new_turns = turns(a->second, b->second);
      if (old_turns == new_turns) continue;
      const bool over = new_turns.back() == 'a';
      out.push_back({Said::order, "the " + (over ? a : b)->first,
                     old_turns.back() == new_turns.back()
                         ? fmt::format("and the {} are painted in another order", (over ? b : a)->first)
                         : fmt::format("lies over the {} now", (over ? b : a)->first)});
    }
}

std::string joined(const std::vector<std::string>& subjects) {
  constexpr std::size_t enough = 3;
  std::string text = subjects.front();
  const std::size_t named = std::min(subjects.size(), enough);
  for (std::size_t i = 1; i < named; ++i) text += (i + 1 == subjects.size() ? " and " : ", ") + subjects[i];
  if (subjects.size() > named) text += fmt::format(" and {} more", subjects.size() - named);
  return text;
}

std::string of_several(const std::string& verb) {
  constexpr std::pair<std::string_view, std::string_view> forms[] = {
      {"is ", "are "}, {"has ", "have "}, {"lies ", "lie "}};
  for (const auto& [one, many] : forms)
    if (verb.starts_with(one)) return std::string(many) + verb.substr(one.size());
  return verb;
}

/// Returns "the width of the ball b and the line t" or the subjects alone.
std::string subject_of(const std::string& what, const std::vector<std::string>& subjects) {
  return (what.empty() ? "" : "the " + what + " of ") + joined(subjects);
}

/// Joins what is said of several objects alike into one sentence, the farthest moved first. In the cause, which is
/// compared, they stand in order of their names.
std::vector<Sentence> sentences(std::vector<Saying> sayings) {
  std::ranges::stable_sort(sayings, [](const Saying& a, const Saying& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.pixels > b.pixels;
  });
  std::vector<Sentence> texts;
  while (!sayings.empty()) {
    const Saying first = sayings.front();
    std::vector<std::string> subjects;
    std::erase_if(sayings, [&](const Saying& s) {
      if (s.kind != first.kind || s.what != first.what || s.verb != first.verb) return false;
      if (std::ranges::find(subjects, s.subject) == subjects.end()) subjects.push_back(s.subject);
      return true;
    });
    const bool many = subjects.size() > 1 && first.what.empty();
    const auto said = [&](const std::string& verb) {
      return subject_of(first.what, subjects) + ' ' + (many ? of_several(verb) : verb);
    };
    std::string text = said(first.verb);
    if (first.pixels > 0)
      text += fmt::format(" {}{:.2g} px", subjects.size() > 1 || first.kind == Said::shape ? "by up to " : "",
                          first.pixels);
    std::ranges::sort(subjects);
    texts.push_back({text, said(first.plainly.empty() ? first.verb : first.plainly)});
  }
  return texts;
}

}  // namespace

std::vector<Sentence> differences(const Json& was, const Json& is) {
  if (was == is) return {};
  std::vector<Saying> sayings;
  const Json &old_ones = at(was, "objects"), &new_ones = at(is, "objects");
  if (!old_ones.is_object()) return {{"the drawing was not kept", "the drawing was not kept"}};
  for (const auto& item : old_ones.items())
    if (!new_ones.contains(item.key())) sayings.push_back({Said::gone, "the " + item.key(), "is gone"});
  for (const auto& item : new_ones.items()) {
    const Json& old_one = at(old_ones, item.key());
    if (!old_one.is_object())
      sayings.push_back({Said::fresh, "the " + item.key(), "is new"});
    else if (old_one != item.value())
      Comparer(item.key(), sayings).compare(old_one, item.value());
  }
  compare_orders(was, is, sayings);
  return sentences(sayings);
}

}  // namespace isect::viz::snap
