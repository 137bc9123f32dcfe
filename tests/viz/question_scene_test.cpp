// The picture and the window while a question is open.

#include "viz/walk/question_scene.h"
#include "viz/walk/closing.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <regex>
#include <string>
#include <utility>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "tests/viz/window_driver.h"
#include "viz/text/rich_text.h"
#include "viz/walk/branch.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"

namespace question_scene_test {
using namespace isect;
using namespace isect::viz;

namespace {

ReaderState at(const std::string& lesson, const std::string& preset, int step) {
  ReaderState state;
  state.lesson = lesson, state.preset = preset, state.step = step;
  return state;
}

bool is_lit(const Item& item) {
  return std::visit(
      [](const auto& it) {
        if constexpr (requires { it.pen; })
          return it.pen == Pen::highlight;
        else
          return false;
      },
      item);
}

std::vector<Line> lit_lines(const Scene& scene) {
  std::vector<Line> lines;
  for (const Item& item : scene.items)
    if (const Line* line = std::get_if<Line>(&item); line && is_lit(item)) lines.push_back(*line);
  return lines;
}

/// How many items are a hit or a miss.
std::ptrdiff_t findings(const Scene& scene) {
  return std::ranges::count_if(scene.items, [](const Item& item) {
    return std::visit(
        [](const auto& it) {
          if constexpr (requires { it.role; })
            return it.role == Role::hit || it.role == Role::miss;
          else
            return false;
        },
        item);
  });
}

/// Calls ask(walk, index) at each step with a question, of all lessons and presets. It is never the first step.
template <class Ask>
void at_each_question(const Ask& ask) {
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (int k = 0; k < static_cast<int>(walk.steps.size()); ++k) {
        const Step& step = walk.steps[static_cast<std::size_t>(k)];
        if (!step.question) continue;
        INFO(lesson->id << " " << preset.id << ", " << step.slug << ": " << plain(step.question->prompt));
        REQUIRE(k > 0);
        ask(walk, k);
      }
    }
}

const Step& step_of(const Walk& walk, int k) { return walk.steps[static_cast<std::size_t>(k)]; }

}  // namespace

TEST_CASE("a question lights what its own step is about, and tells no hit and no miss before its answer", "[player]") {
  int asked = 0, lit = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step& step = step_of(walk, k);
    ++asked;
    const Scene scene = question_scene(walk, k);
    CHECK(findings(scene) <= findings(step_of(walk, k - 1).scene));
    if (step.question->over || step.scene.chart) return;
    const auto wanted = std::ranges::count_if(step.scene.items, is_lit);
    CHECK(std::ranges::count_if(scene.items, is_lit) == wanted);
    lit += wanted > 0;
  });
  CHECK(asked > 500);
  CHECK(lit > 100);
}

TEST_CASE("while a question is open, all on show is of its own step, or was given with it", "[question_scene]") {
  int asked = 0, shown_values = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step &step = step_of(walk, k), &last = step_of(walk, k - 1);
    ++asked;
    const Step shown = asking_step(walk, k);
    CHECK((shown.title.empty() && shown.caption.empty() && shown.formula.empty()));
    CHECK(shown.line == -1);
    CHECK_FALSE(shown.comparison);
    for (const Value& value : shown.values) {
      INFO(value.name << " = " << value.value);
      ++shown_values;
      CHECK_FALSE(value.fresh);
      const auto is_it = [&](const Value& v) {
        return v.name == value.name && (v.value == value.value || std::isnan(value.value));
      };
      const bool given = std::ranges::any_of(step.question->given, is_it);
      CHECK((given || (std::ranges::any_of(step.values, is_it) && std::ranges::any_of(last.values, is_it))));
    }
    for (const int line : shown.refused) CHECK((line != step.line && std::ranges::count(step.refused, line) > 0));
    for (const int line : shown.untaken) CHECK((line != step.line && std::ranges::count(step.untaken, line) > 0));
    CHECK((shown.verdict.text.empty() || shown.verdict.text == step.verdict.text));
  });
  CHECK(asked >= 583);
  CHECK(shown_values > 500);
}

namespace {

/// 500 000 is one number.
std::string without_thin_spaces(std::string text) {
  for (std::size_t at; (at = text.find("\u2009")) != text.npos;) text.erase(at, 3);
  return text;
}

/// A number as readers see it: "−1.121 · 10⁸" is not one here, as no question has such.
std::optional<double> number_in(std::string text) {
  text = without_thin_spaces(std::move(text));
  for (std::size_t at; (at = text.find("−")) != text.npos;) text.replace(at, 3, "-");
  std::size_t end = 0;
  try {
    const double x = std::stod(text, &end);
    return end == text.size() ? std::optional(x) : std::nullopt;
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
}

/// The text with powers of ten written out: "5.5 · 10⁻³" becomes 0.0055.
std::string without_powers(std::string text) {
  static const std::vector<std::string> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  static const std::regex power("([0-9.]+)[^0-9a-z]{0,4}·[^0-9a-z]{0,4}10((⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)+)");
  for (std::smatch found; std::regex_search(text, found, power);) {
    std::string exponent = found[2];
    for (std::size_t i = 0; i < raised.size(); ++i)
      for (std::size_t at; (at = exponent.find(raised[i])) != exponent.npos;)
        exponent.replace(at, raised[i].size(), std::to_string(i));
    if (exponent.starts_with("⁻")) exponent.replace(0, std::string("⁻").size(), "-");
    const std::string number = fmt::format("{:.40f}", std::stod(found[1].str() + "e" + exponent));
    text = found.prefix().str() + number + found.suffix().str();
  }
  return text;
}

/// All numbers of a text, in their order.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> all;
  std::string word;
  const std::string digits = "0123456789.";
  const std::string words = without_powers(without_thin_spaces(text)) + " ";
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool minus = words.compare(i, 3, "−") == 0;
    if (minus && word.empty()) {
      word = "-", i += 2;
    } else if (digits.find(words[i]) != digits.npos) {
      word += words[i];
    } else {
      while (word.ends_with('.')) word.pop_back();
      if (const auto x = number_in(word)) all.push_back(*x);
      word = minus ? "-" : "", i += minus ? 2 : 0;
    }
  }
  return all;
}

/// The numbers that a reader can answer from: the prompt's, and the values on show by their plain names.
struct OnShow {
  std::vector<double> told;
  std::map<std::string, double> values;
  std::string code = {};  ///< the pseudocode beside it
  double operator()(const std::string& name) const { return values.at(name); }
};

double distance(double x, double y, double px, double py, double qx, double qy) {
  const double dx = qx - px, dy = qy - py, length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp(((x - px) * dx + (y - py) * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(px + t * dx - x, py + t * dy - y);
}

/// How a reader computes answers with digits behind the point, by a part of the prompt.
const std::vector<std::pair<std::string, double (*)(const OnShow&)>>& ways() {
  static const std::vector<std::pair<std::string, double (*)(const OnShow&)>> all = {
      {"What is r_b",
       [](const OnShow& o) {
         return o.told[0] * o("h_u of b") + o.told[1] * o("h_v of b") + o.told[2] * o("h_w of b");
       }},
      {"What is the discriminant",
       [](const OnShow& o) {
         const double four = o.code.find("4 A C") == o.code.npos ? 1 : 4;
         return o("B") * o("B") - four * o("A") * o("C");
       }},
      {"What is the least d so far?",
       [](const OnShow& o) {
         const std::vector<double>& n = o.told;
         double least = o.values.contains("least d so far before") ? o("least d so far before") : INFINITY;
         for (std::size_t i = 0; i + 4 < n.size(); i += 2)
           least =
               std::min(least, distance(n[i], n[i + 1], n[n.size() - 4], n[n.size() - 3], n[n.size() - 2], n.back()));
         return least;
       }},
      {"after all three axes?",
       [](const OnShow& o) {
         const double gap = std::max({o.told[0] - o.told[2], o.told[2] - o.told[1], 0.0});
         return o("d² before") + gap * gap;
       }},
      {"add to d²?",
       [](const OnShow& o) {
         const double gap = std::max({o.told[0] - o.told[2], o.told[2] - o.told[1], 0.0});
         return gap * gap;
       }},
      {"What is m²?", [](const OnShow& o) { return o("l²") - o("s") * o("s"); }},
      {"At which t is", [](const OnShow& o) { return (o.told[2] - o.told[0]) / o.told[1]; }},
      {"At which t does the line meet the wall", [](const OnShow& o) { return (o.told[4] - o.told[0]) / o.told[2]; }},
      {"do they first meet?", [](const OnShow& o) { return o.told[0] / o.told[2]; }},
      {"How long may one step be", [](const OnShow& o) { return o.told[0] + o.told[1]; }},
      {"When do these extents meet",
       [](const OnShow& o) {
         return std::min((o.told[0] - o.told[3]) / o.told[4], (o.told[1] - o.told[2]) / o.told[4]);
       }},
      {"x-component of the velocity of b", [](const OnShow& o) { return o.told[2] - o.told[0]; }},
      {"y-component of the velocity of b", [](const OnShow& o) { return o.told[3] - o.told[1]; }},
      {"How long is what they share",  // the interval of a, and that of b
       [](const OnShow& o) { return std::min(o.told[1], o.told[3]) - std::max(o.told[0], o.told[2]); }},
      {"What is the volume of what the boxes share",
       [](const OnShow& o) {
         const double length = std::min(o.told[1], o.told[3]) - std::max(o.told[0], o.told[2]);
         return o("common length on x") * o("common length on y") * std::max(length, 0.0);
       }},
      {"What is the weight of a", [](const OnShow& o) { return 1 - o.told[0] - o.told[1]; }},
      {"What does it compute there", [](const OnShow& o) { return -o.told[0]; }},
      {"For how long do they share points", [](const OnShow& o) { return (o.told[0] + o.told[1]) / o.told[2]; }},
      {"What is it at the hit",
       [](const OnShow& o) {
         const double u = o("u"), v = o("v");
         return (1 - u - v) * o.told[0] + u * o.told[1] + v * o.told[2];
       }},
      {"What is the longest step that surely passes no contact", [](const OnShow& o) { return o.told[0] / o.told[1]; }},
      {"At which share of the edge", [](const OnShow& o) { return o.told[0] / (o.told[0] - o.told[1]); }},
      {"What is their dot product?",
       [](const OnShow& o) { return o.told[0] * o.told[3] + o.told[1] * o.told[4] + o.told[2] * o.told[5]; }},
      {"is the line of b nearest to it?",
       [](const OnShow& o) {
         double along = 0, length2 = 0;  // a point, the start of a line, its direction
         for (std::size_t k = 0; k < 3; ++k) {
           along += (o.told[k] - o.told[k + 3]) * o.told[k + 6];
           length2 += o.told[k + 6] * o.told[k + 6];
         }
         return along / length2;
       }},
      {"What is the square of the gap?",
       [](const OnShow& o) {
         const double gap = std::max({o.told[2] - o.told[1], o.told[0] - o.told[3], 0.0});
         return gap * gap;
       }},
      {"What is d² after z?",
       [](const OnShow& o) {
         const double gap = std::max({o.told[3] - o.told[2], o.told[1] - o.told[4], 0.0});
         return o.told[0] + gap * gap;
       }},
      {"How far apart may the segments be", [](const OnShow& o) { return o.told[0] + o.told[1] + o.told[2]; }},
  };
  return all;
}

}  // namespace

TEST_CASE("an answer that is a computed number follows from what is on show while its question is open",
          "[question_scene]") {
  int computed = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Question& question = *step_of(walk, k).question;
    std::vector<double> choices;
    for (const std::string& choice : question.choices)
      if (const auto x = number_in(plain(choice))) choices.push_back(*x);
    const bool counts = std::ranges::all_of(choices, [](double x) { return x == std::round(x); });
    if (choices.size() != question.choices.size() || counts) return;
    const std::string prompt = plain(question.prompt);
    const auto way = std::ranges::find_if(ways(), [&](const auto& w) { return prompt.find(w.first) != prompt.npos; });
    REQUIRE(way != ways().end());
    OnShow on_show = {numbers_in(prompt), {}};
    for (const std::string& line : walk.pseudocode) on_show.code += line + "\n";
    for (const Value& value : asking_step(walk, k).values) on_show.values[plain(value.name)] = value.value;
    const double found = way->second(on_show);
    CAPTURE(found);
    const auto nearest = std::ranges::min_element(choices, {}, [&](double x) { return std::abs(x - found); });
    CHECK(nearest - choices.begin() == question.answer);
    ++computed;
  });
  CHECK(computed > 60);
}

namespace {

/// "3 x − 8 z + 12 ≥ 0" as its four coefficients.
std::array<double, 4> plane_in(std::string text) {
  for (std::size_t at; (at = text.find("−")) != text.npos;) text.replace(at, 3, "-");
  std::erase(text, ' ');
  std::array<double, 4> plane{};
  static const std::regex term("([-+]?)([0-9.]*)([xyz]?)");
  for (std::smatch found; !text.starts_with("≥"); text = found.suffix()) {
    REQUIRE(std::regex_search(text, found, term, std::regex_constants::match_continuous));
    REQUIRE(found.length(0) > 0);
    const double size = found[2].length() > 0 ? std::stod(found[2]) : 1;
    const std::size_t of = found[3].length() > 0 ? static_cast<std::size_t>(*found[3].first - 'x') : 3;
    plane[of] = found[1] == "-" ? -size : size;
  }
  return plane;
}

using Numbers = std::vector<double>;

/// How a box from n[0..2] to n[3..5] lies to a plane: 0: all of it on the inner side; 1: beyond; 2: neither.
int against(const Numbers& n, const std::array<double, 4>& plane) {
  double least = plane[3], greatest = plane[3];
  for (std::size_t k = 0; k < 3; ++k) {
    least += std::min(plane[k] * n[k], plane[k] * n[k + 3]);
    greatest += std::max(plane[k] * n[k], plane[k] * n[k + 3]);
  }
  return greatest < 0 ? 1 : least >= 0 ? 0 : 2;
}

double cross(const Numbers& n, std::size_t a, std::size_t b, std::size_t c) {
  return (n[b] - n[a]) * (n[c + 1] - n[a + 1]) - (n[b + 1] - n[a + 1]) * (n[c] - n[a]);
}

/// Whether the ray from n[0..1] along n[2..3] meets the box at n[at..at + 3].
bool ray_meets(const Numbers& n, std::size_t at) {
  double from = 0, to = INFINITY;
  for (std::size_t k = 0; k < 2; ++k) {
    const double o = n[k], d = n[2 + k], lo = n[at + k], hi = n[at + 2 + k];
    if (d == 0) {
      if (o < lo || o > hi) return false;
      continue;
    }
    from = std::max(from, std::min((lo - o) / d, (hi - o) / d));
    to = std::min(to, std::max((lo - o) / d, (hi - o) / d));
  }
  return from <= to;
}

/// The index of the choice with this text.
int choice(const Question& q, const std::string& text) {
  const auto found = std::ranges::find_if(q.choices, [&](const std::string& markup) { return plain(markup) == text; });
  return static_cast<int>(found - q.choices.begin());
}

/// The name with the least "t of ..."; those later in `order` lose ties.
std::string nearest(const OnShow& o, const std::vector<std::string>& order, const std::string& none) {
  std::string best = none;
  double least = INFINITY;
  for (const std::string& name : order)
    if (const auto t = o.values.find("t of " + name); t != o.values.end() && t->second < least)
      least = t->second, best = name;
  return best;
}

std::vector<std::string> plain_choices(const Question& q) {
  std::vector<std::string> all;
  for (const std::string& c : q.choices) all.push_back(plain(c));
  return all;
}

/// The choice that is the order of the tiles by a key of their names. Keys that differ by rounding alone are equal.
int by_key(const Question& q, const std::function<double(const std::string&)>& key) {
  std::vector<double> keys;
  for (const std::string& tile : q.order->tiles) keys.push_back(key(plain(tile)));
  std::vector<int> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int tile) {
    const int rank = q.order->ranks.at(static_cast<std::size_t>(tile));
    double sum = 0, count = 0;  // the mean of those that may change places
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (q.order->ranks[i] == rank) sum += keys[i], ++count;
    const double own = keys[static_cast<std::size_t>(tile)];
    return std::abs(sum / count - own) < 1e-6 ? sum / count : own;
  });
  return choice_of_order(q, order);
}

/// How a reader without the picture finds answers that are words or counts, from the words and values on show alone.
using InWords = int (*)(const Question&, const std::string& prompt, const OnShow&);
const std::vector<std::pair<std::string, InWords>>& ways_in_words() {
  static const std::vector<std::pair<std::string, InWords>> all = {
      {"does it lie, relative to the",
       [](const Question&, const std::string& prompt, const OnShow& o) {
         return against(o.told, plane_in(prompt.substr(prompt.find("plane, ") + 7)));
       }},
      {"does the ball lie, relative to the",
       [](const Question&, const std::string&, const OnShow& o) {
         return o("n · c + D") < -o("r") ? 1 : o("n · c + D") >= o("r") ? 0 : 2;
       }},
      {"the six planes say about the box", [](const Question&, const std::string&, const OnShow&) { return 1; }},
      {"the six planes say about the ball",
       [](const Question&, const std::string&, const OnShow& o) { return o("least n · c + D") >= 0 ? 0 : 1; }},
      {"the frustum is",
       [](const Question&, const std::string&, const OnShow& o) {
         REQUIRE(o.told.size() >= 13);                      // a node's number stands before
         const Numbers n(o.told.end() - 13, o.told.end());  // ... −2.5 ≤ x ≤ 3, 4 |y| ≤ x + 4 and 8 |z| ≤ 3 (x + 4)
         bool inside = true;
         for (const std::array<double, 4>& plane : {std::array{1.0, 0.0, 0.0, -n[6]},
                                                    {-1, 0, 0, n[7]},
                                                    {1, n[8], 0, n[9]},
                                                    {1, -n[8], 0, n[9]},
                                                    {n[11], 0, n[10], n[11] * n[12]},
                                                    {n[11], 0, -n[10], n[11] * n[12]}}) {
           const int side = against(n, plane);
           if (side == 1) return 0;
           inside = inside && side == 0;
         }
         return inside ? 1 : 2;
       }},
      {"the intervals on",
       [](const Question&, const std::string& prompt, const OnShow& o) {
         const std::string i = "_" + prompt.substr(prompt.find(" on ") + 4, 1);
         if (o("a.min" + i) > o("b.max" + i) || o("b.min" + i) > o("a.max" + i) || o("a.min" + i) > o("a.max" + i) ||
             o("b.min" + i) > o("b.max" + i))
           return 0;
         return i == "_z" ? 1 : 2;
       }},
      {"has a gap, or comes nearest to one",
       [](const Question&, const std::string& prompt, const OnShow& o) {
         if (o("d = |n · l|") > o("r_a + r_b")) return 0;
         return prompt.find("cross products") != prompt.npos ? 1 : 2;
       }},
      {"how are the two balls related",
       [](const Question& q, const std::string&, const OnShow& o) {
         double d2 = o("d²"), sum = o("R²"), difference = std::pow(o("r_a") - o("r_b"), 2);
         if (!std::isnormal(sum)) d2 = o("d"), sum = o("r_a") + o("r_b"), difference = std::abs(o("r_a") - o("r_b"));
         if (d2 == 0 && difference == 0) return choice(q, "the same set");
         return choice(q, d2 > sum           ? "disjoint"
                          : d2 <= difference ? "one inside the other"
                          : d2 == sum        ? "touching from outside"
                                             : "overlapping");
       }},
      {"of the two children does it meet",
       [](const Question&, const std::string&, const OnShow& o) {
         return static_cast<int>(ray_meets(o.told, 4)) + static_cast<int>(ray_meets(o.told, 8));
       }},
      {"along which axis are the boxes split",
       [](const Question&, const std::string&, const OnShow& o) {
         return o("spread of centres on x") >= o("spread of centres on y") ? 0 : 1;
       }},
      {"the fan is halved at",
       [](const Question&, const std::string&, const OnShow& o) {
         const Numbers& n = o.told;  // p, v₀, v_mid, the next; its own numbers are in subscripts
         if (n.size() == 8 && cross(n, 4, 6, 0) < 0) return 2;
         return cross(n, 2, 4, 0) >= 0 ? 1 : 0;
       }},
      {"tests to each update on does",
       [](const Question& q, const std::string&, const OnShow& o) {
         double update = 0, test = 0;
         for (const auto& [name, x] : o.values) {
           if (name.ends_with("-DOP: update")) update = x;
           if (name.ends_with("-DOP: test")) test = x;
         }
         const double more = (update - o("OBB: update")) / (o("OBB: test") - test);
         return choice(q, std::to_string(1 + static_cast<int>(std::max(0.0, more))));
       }},
      {"how many points leave the chain",
       [](const Question& q, const std::string&, const OnShow& o) {
         Numbers chain = o.told;
         const std::size_t points = chain.size();
         const auto turns_left = [&] { return cross(chain, chain.size() - 6, chain.size() - 4, chain.size() - 2) > 0; };
         while (chain.size() > 4 && !turns_left()) chain.erase(chain.end() - 4, chain.end() - 2);
         return choice(q, std::to_string((points - chain.size()) / 2));
       }},
      {"need a closer look",
       [](const Question& q, const std::string&, const OnShow& o) {
         int met = 0;
         for (std::size_t i = 0; i + 1 < o.told.size(); i += 2) met += o.told[i] >= o.told[i + 1];
         return choice(q, std::to_string(met));
       }},
      {"which object is kept then",
       [](const Question& q, const std::string&, const OnShow& o) {
         return choice(q, nearest(o, plain_choices(q), "none yet"));
       }},
      {"what does the pixel show", [](const Question& q, const std::string&,
                                      const OnShow& o) { return choice(q, nearest(o, plain_choices(q), "the sky")); }},
      {"when do the boxes first meet",
       [](const Question& q, const std::string&, const OnShow& o) {
         const Numbers& n = o.told;  // the times on x, those on y, and those of the motion
         const double begin = std::max({n[0], n[2], n[4]}), end = std::min({n[1], n[3], n[5]});
         return choice(q, begin <= end ? shown(begin) : "not within the motion");
       }},
      {"which point of the segment is nearest to c",
       [](const Question&, const std::string&, const OnShow& o) {
         return o.told[0] <= 0 ? 0 : o.told[0] >= o.told[1] ? 1 : 2;
       }},
      {"adds the square of the gap",
       [](const Question& q, const std::string&, const OnShow& o) {
         return choice_of_line(q, o.told[2] < o.told[0] ? 1 : 2);  // the ends of the interval, and c
       }},
      {"changes the chain first",
       [](const Question& q, const std::string&, const OnShow& o) {
         const Numbers& n = o.told;  // the chain, and q
         return choice_of_line(q, cross(n, n.size() - 6, n.size() - 4, n.size() - 2) > 0 ? 2 : 1);
       }},
      {"the wedges that are left reach",
       [](const Question& q, const std::string&, const OnShow& o) {
         return choice_of_line(q, cross(o.told, 2, 4, 0) < -1e-5 ? 6 : 7);
       }},
      {"comparisons of the ends",
       [](const Question& q, const std::string&, const OnShow& o) {
         const Numbers& n = o.told;  // the box, p, q
         bool inside = true, beyond = false;
         for (const std::size_t k : {0U, 1U}) {
           beyond = beyond || (n[4 + k] < n[k] && n[6 + k] < n[k]) || (n[4 + k] > n[2 + k] && n[6 + k] > n[2 + k]);
           for (const std::size_t end : {4U, 6U}) inside = inside && n[end + k] >= n[k] && n[end + k] <= n[2 + k];
         }
         return choice_of_line(q, inside ? 0 : beyond ? 2 : 1);
       }},
      {"cuts the range at",
       [](const Question& q, const std::string& prompt, const OnShow& o) {
         const bool x = prompt.find("left") != prompt.npos || prompt.find("right side") != prompt.npos;
         const bool upper = prompt.find("top") != prompt.npos || prompt.find("right side") != prompt.npos;
         const double d = x ? o.told[2] - o.told[0] : o.told[3] - o.told[1];
         return choice_of_line(q, (upper ? -d : d) > 0 ? 6 : 7);
       }},
      {"cross these four lines",
       [](const Question& q, const std::string&, const OnShow& o) {
         return by_key(q, [&](const std::string& side) {
           const Numbers& n = o.told;  // p, q, the sides
           const bool x = side == "the left side" || side == "the right side";
           const double at = side == "the left side"     ? n[4]
                             : side == "the right side"  ? n[5]
                             : side == "the bottom side" ? n[6]
                                                         : n[7];
           return x ? (at - n[0]) / (n[2] - n[0]) : (at - n[1]) / (n[3] - n[1]);
         });
       }},
      {"do the centres of its boxes come",
       [](const Question& q, const std::string& prompt, const OnShow& o) {
         const std::string on = prompt.find("along x") != prompt.npos ? " on x" : " on y";
         return by_key(q, [&](const std::string& box) { return o("centre of " + box + on); });
       }},
      {"in which order do the boxes begin",
       [](const Question& q, const std::string&, const OnShow& o) {
         return by_key(q, [&](const std::string& box) { return o("lower end of " + box); });
       }},
      {"by their void",
       [](const Question& q, const std::string&, const OnShow& o) {
         return by_key(q, [&](const std::string& volume) { return o(volume); });
       }},
      {"do these t come along",
       [](const Question& q, const std::string&, const OnShow& o) {
         const double s = o("s"), half = std::sqrt(std::max(0.0, o("r²") - o("m²")));
         return by_key(q, [&](const std::string& t) {
           return t == "0" ? 0 : t == "s" ? s : t == "s − q" ? s - half : s + half;
         });
       }},
      {"does the ray first meet the sphere",
       [](const Question&, const std::string&, const OnShow& o) {
         const bool haines = o.values.contains("q");  // of both roots one lies in the range
         return (haines ? o("s") - o("q") : o("t₁")) >= 0 ? 0 : 1;
       }},
      {"what does n · l tell",
       [](const Question&, const std::string&, const OnShow& o) {
         const Numbers& n = o.told;
         return n[0] * n[3] + n[1] * n[4] + n[2] * n[5] > 0 ? 1 : 0;
       }},
  };
  return all;
}

/// Questions answered by the parameters and objects, which every page gives in words, and by what was said on the way.
const std::vector<std::string>& from_what_is_given() {
  static const std::vector<std::string> all = {"which set is a subset",
                                               "which points do they share",
                                               "one pose, four kinds",
                                               "coordinates on",
                                               "how many say near",
                                               "of the four differences",
                                               "which face of the triangle",
                                               "is compared with",
                                               "how are the intervals related",
                                               "which t belong",
                                               "which line returns",
                                               "find the bullet in the wall",
                                               "when does the bullet hit",
                                               "how are the two boxes related",
                                               "how are the ball and the box related",
                                               "of the two segments' lines",
                                               "how are the two capsules related",
                                               "what do they tell",
                                               "the whole line share with the sphere",
                                               "the ray's first hit",
                                               "which has less void",
                                               "what does the volume's test show",
                                               "compared with the hull",
                                               "how many edges count",
                                               "which line settles",
                                               "does the boundary wind",
                                               "where does the line meet the plane",
                                               "coordinate is best dropped",
                                               "does the point have on its right",
                                               "each counts once for every slab",
                                               "where is p =",
                                               "boxes are active then",
                                               "comparisons of the vertices",
                                               "side do to the range",
                                               "left after the cut",
                                               "how many does it reject",
                                               "from the point",
                                               "may a mesh that bounds a solid",
                                               "how many pairs of points",
                                               "what follows"};
  return all;
}

/// Questions on rules, counts of parts, and guesses at measurements: no number of the setting decides them.
const std::vector<std::string>& from_what_is_known() {
  static const std::vector<std::string> all = {"of the six relations remain",
                                               "how far may r be",
                                               "numbers are that",
                                               "-dop have",
                                               "where does b lie",
                                               "at most",
                                               "does that rule out",
                                               "grow with n",
                                               "does the complete map have",
                                               "the new edge",
                                               "why must no edge",
                                               "and the holes are filled",
                                               "double loop",
                                               "fewest tests",
                                               "how long may one step be",
                                               "box around the whole path",
                                               "single out one wedge",
                                               "which boxes cost",
                                               "of the count is left",
                                               "of c++ return",
                                               "becomes of the expected cost",
                                               "by the time measured",
                                               "naive test",
                                               "how many roundings",
                                               "how many further signs",
                                               "let a wrong sign through",
                                               "miss both triangles",
                                               "what does it compute there",
                                               "which point must be tested",
                                               "errs most",
                                               "does the exact call take",
                                               "dominated"};
  return all;
}

bool is_among(const std::vector<std::string>& parts, const std::string& text) {
  return std::ranges::any_of(parts, [&](const std::string& part) { return text.find(part) != text.npos; });
}

}  // namespace

TEST_CASE("every question can be answered without its picture", "[question_scene]") {
  std::map<std::string, int> answered;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (int k = 0; k < static_cast<int>(walk.steps.size()); ++k) {
        const Step& step = walk.steps[static_cast<std::size_t>(k)];
        if (!step.question) continue;
        const Question& question = *step.question;
        std::string prompt = plain(question.prompt);
        INFO(lesson->id << " " << preset.id << ", " << step.slug << ": " << prompt);
        OnShow on_show = {numbers_in(prompt), {}};
        for (const Value& value : asking_step(walk, k).values) on_show.values[plain(value.name)] = value.value;
        std::ranges::transform(prompt, prompt.begin(), [](unsigned char c) { return std::tolower(c); });
        const auto way =
            std::ranges::find_if(ways_in_words(), [&](const auto& w) { return prompt.find(w.first) != prompt.npos; });
        if (way != ways_in_words().end()) {
          CHECK(way->second(question, plain(question.prompt), on_show) == question.answer);
          ++answered[way->first];
          continue;
        }
        const bool computed = std::ranges::any_of(
            ways(), [&](const auto& w) { return plain(question.prompt).find(w.first) != std::string::npos; });
        CHECK((computed || is_among(from_what_is_given(), prompt) || is_among(from_what_is_known(), prompt)));
      }
    }
  for (const auto& [words, way] : ways_in_words()) {
    INFO(words);
    CHECK(answered[words] > 0);
  }
}

TEST_CASE("no number on show bears the name that is asked for", "[question_scene]") {
  int told_by_the_step = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step& step = step_of(walk, k);
    const std::string prompt = plain(step.question->prompt);
    const auto asks_for = [&](const Value& value) {
      const std::string name = plain(value.name);
      return prompt.find("What is " + name + "?") != prompt.npos ||
             prompt.find("What is the " + name + "?") != prompt.npos ||
             prompt.find("What is the discriminant " + name) != prompt.npos;
    };
    CHECK(std::ranges::none_of(asking_step(walk, k).values, asks_for));
    told_by_the_step += std::ranges::any_of(step.values, asks_for);
  });
  CHECK(told_by_the_step > 40);
}

TEST_CASE("the card never says the opposite of what the lit line does", "[branch]") {
  int refused = 0, entered = 0, alone = 0;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (int k = 0; k + 1 < static_cast<int>(walk.steps.size()); ++k) {
        const Step &step = walk.steps[static_cast<std::size_t>(k)], &next = walk.steps[static_cast<std::size_t>(k) + 1];
        if (!step.comparison || step.line < 0) continue;
        const std::string line = walk.pseudocode[static_cast<std::size_t>(step.line)];
        if (!has_condition(line)) continue;
        INFO(lesson->id << " " << preset.id << ", " << step.slug << ": " << line << " | " << step.comparison->text);
        const auto refusals = [&](const Step& s) { return std::ranges::count(s.refused, step.line); };
        const bool enters =
            next.line == step.line + 1 && !line.empty() && line.back() != ':' &&
            walk.pseudocode[static_cast<std::size_t>(next.line)].find_first_not_of(' ') > line.find_first_not_of(' ');
        const bool does_all = line.find(": ") != line.npos && step.decides;  // "if ...: return ..."
        if (refusals(next) > refusals(step)) {
          ++refused;
          CHECK_FALSE(step.comparison->holds);
          CHECK(taken(walk, k) == false);
        } else if (enters || does_all) {
          enters ? ++entered : ++alone;
          CHECK(step.comparison->holds);
          CHECK(taken(walk, k) == true);
        }
      }
    }
  CHECK(refused > 60);
  CHECK(entered > 20);
  CHECK(alone > 20);
}

TEST_CASE("a condition that joins several inequalities holds as they do, each with its own numbers", "[branch]") {
  int joined = 0;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets)
      for (const Step& step : lesson->walk(preset.parameters).steps) {
        if (!step.comparison || step.comparison->parts.empty()) continue;
        INFO(lesson->id << " " << preset.id << ", " << step.slug << ": " << step.comparison->text);
        ++joined;
        const std::vector<Comparison>& parts = step.comparison->parts;
        for (const Comparison& part : parts) CHECK(step.comparison->text.find(part.text) != std::string::npos);
        const bool both = step.comparison->text.find(" or ") == std::string::npos;
        if (both)
          CHECK(step.comparison->holds == std::ranges::all_of(parts, &Comparison::holds));
        else if (parts.size() == 2)
          CHECK(step.comparison->holds == (parts[0].holds || parts[1].holds));
        else  // A or (B and C)
          CHECK(step.comparison->holds == (parts[0].holds || (parts[1].holds && parts[2].holds)));
      }
  CHECK(joined > 15);
}

TEST_CASE("the current line says yes where its condition is true, and the card shows each half", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  const auto& steps = window.player().walk().steps;
  const auto which = std::ranges::find(steps, "which-root", &Step::slug);
  REQUIRE(which != steps.end());
  window.player().go_to(static_cast<int>(which - steps.begin()));
  window.frames(2);
  CHECK(window.has("yes 10"));
  CHECK_FALSE(window.has("no 10"));
  REQUIRE(window.has("condition 3"));
  const Rect card = window.rect("comparison");
  CHECK(window.rect("condition 1").bottom <= window.rect("condition 2").top);
  CHECK((window.rect("condition 1").top > card.top && window.rect("condition 3").bottom < card.bottom));
}

TEST_CASE("a digit answers where it is an answer, and loads no preset while a question is open", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("crossings", "inside"));
  window.player().first();
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  window.player().show_choices();
  const Question question = *window.player().quiz().asked();
  const std::string preset = window.player().played().preset_id();
  REQUIRE(window.player().played().group().size() > 1);
  const auto is_choice = [&](char c) {
    return std::ranges::any_of(question.choices, [&](const std::string& choice) { return plain(choice)[0] == c; });
  };
  for (char digit = '0'; digit <= '9'; ++digit)
    if (!is_choice(digit)) window.type(std::string(1, digit));
  REQUIRE(window.player().quiz().asked());
  CHECK(window.player().played().preset_id() == preset);
  const std::string right = plain(question.choices[static_cast<std::size_t>(question.answer)]);
  REQUIRE(right.size() == 1);
  window.type(right);
  REQUIRE(window.player().quiz().answered());
  CHECK(window.player().quiz().answered()->right());
  CHECK(window.player().played().preset_id() == preset);
  window.type("2");  // the question is over
  CHECK(window.player().played().preset_id() == window.player().played().group()[1]->id);
}

TEST_CASE("Right to a question about the next edge lights and names that edge", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("crossings", "inside", 2));
  const auto rules = [&] { return lit_lines(window.player().scene()); };
  int asked = 0;
  while (!window.player().at_end()) {
    const std::vector<Line> before = rules();
    const Picture picture = window.picture();
    window.key(key::right);
    if (!window.player().quiz().asked()) continue;
    const Step& next = window.player().walk().steps[static_cast<std::size_t>(window.player().index()) + 1];
    if (lit_lines(next.scene).empty()) continue;
    ++asked;
    REQUIRE(rules().size() == 1);
    CHECK(rules()[0].from == lit_lines(next.scene)[0].from);
    CHECK(rules()[0].to == lit_lines(next.scene)[0].to);
    if (!before.empty()) CHECK(rules()[0].from != before[0].from);
    for (const char* name : {"a", "b"})
      CHECK(std::ranges::any_of(window.player().scene().items, [&](const Item& item) {
        const Label* label = std::get_if<Label>(&item);
        return label && label->text.find(name) != std::string::npos && label->at != Vec3::Zero();
      }));
    CHECK(window.picture().rgba != picture.rgba);
  }
  CHECK(asked > 0);
}

TEST_CASE("clipping asks about a side that is drawn and lit", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("clipping", "both-ends-cut", 3));
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  REQUIRE(lit_lines(window.player().scene()).size() == 1);
  const Line side = lit_lines(window.player().scene())[0];
  CHECK(side.from.x() == 2);  // the right one, and not the left one of the step before
  CHECK(side.to.x() == 2);
}

TEST_CASE("what methods say waits for the outcome, and while a question is open", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("sphere-sphere", "touching", 2));
  REQUIRE(window.player().played().methods_differ());
  CHECK_FALSE(window.has("alarm"));
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  CHECK(window.has("alarm"));
  window.player().go_to(2);
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  window.frames(2);
  CHECK_FALSE(window.has("alarm"));
  CHECK_FALSE(window.has("methods side by side"));
  CHECK_FALSE(window.has("comparison"));
}

TEST_CASE("while a question is open the step before it is told no more, as the picture is of the next one",
          "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("crossings", "vertex-passed", 2));
  const auto ground = [&] {  // of the current line
    const Rect r = window.rect("line 5");
    const Picture picture = window.picture();
    const int x = static_cast<int>(r.left + 6), y = static_cast<int>(r.middle_y());
    return std::array{channel(picture, x, y, 0), channel(picture, x, y, 1), channel(picture, x, y, 2)};
  };
  const std::array<int, 3> marked = ground();
  window.key(key::right);
  window.frames(2);
  REQUIRE(window.player().quiz().asked());
  REQUIRE(window.player().step().line == 4);
  CHECK(ground() != marked);
  const Rect words = window.rect("lesson words");
  CHECK(window.rect("answer").top < words.top + 0.4f * words.height());  // nothing but the prompt stands above it
  window.player().answer(0);
  window.frames(2);
  CHECK(window.has("what came of it"));
}

TEST_CASE("the wall stands nowhere before it is asked where a line meets it", "[question_scene]") {
  const auto named = [](const Scene& scene, const char* name) {
    return std::ranges::any_of(scene.items, [&](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      return label && label->text == name;
    });
  };
  int asked = 0;
  const Lesson& rays = lesson_named(lessons::all_lessons(), "rays");
  for (const Preset& preset : rays.presets) {
    const Walk walk = rays.walk(preset.parameters);
    const auto wall = std::ranges::find(walk.steps, "wall", &Step::slug);
    if (wall == walk.steps.end()) continue;
    CAPTURE(preset.id);
    for (auto step = walk.steps.begin(); step != wall; ++step) CHECK_FALSE(named(step->scene, "wall"));
    const Scene question = question_scene(walk, static_cast<int>(wall - walk.steps.begin()));
    CHECK(named(question, "wall"));
    for (int t = -40; t <= 40; ++t) CHECK_FALSE(named(question, shown(t).c_str()));  // no mark of t stands at it
    ++asked;
  }
  CHECK(asked == 7);
}

TEST_CASE("presets are numbers while a question is open, as their names may tell its answer", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 4));
  const Rect chip = window.rect("preset 2");
  CHECK(window.ui.title().find("two roots") != std::string::npos);
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  window.frames(2);
  CHECK(window.ui.title() == "Ray and sphere, preset 1, step 5 of 13 – isect");
  CHECK(window.rect("preset 2").left == chip.left);  // nothing moves
  for (const Preset* preset : window.player().played().group())
    CHECK(window.player().told_title(*preset).find(plain(preset->title)) == std::string::npos);
  window.player().answer(0);
  window.frames(2);
  CHECK(window.ui.title().find("two roots") != std::string::npos);
  CHECK(window.player().told_title(window.player().lesson().presets[0]) == "two roots");
}

TEST_CASE("two sides that read alike and differ are shown in full", "[window]") {
  const auto card = [](const char* preset) {
    WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", preset, 7));
    REQUIRE(window.player().step().slug == "which-root");
    REQUIRE(window.has("comparison"));
    return std::pair(window.has("meaning in full"), window.rect("comparison").height());
  };
  const auto [near_alike, near_height] = card("near-surface");
  const auto [far_alike, far_height] = card("two-roots");
  CHECK((near_alike && !far_alike));
  CHECK(near_height > far_height);
}

TEST_CASE("play rests at a question without taking time, and says so by its icon", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 2));
  CHECK(std::isinf(window.ui.rest()));
  window.type(" ");
  CHECK(window.ui.rest() > 1);  // until the next step
  CHECK(window.ui.rest() <= 1.6);
  for (int i = 0; i < 9 && !window.player().quiz().asked(); ++i) window.wait(0.5f);
  REQUIRE(window.player().quiz().asked());
  CHECK_FALSE(window.player().running());
  CHECK(std::isinf(window.ui.rest()));
  const int before = window.player().index();
  window.type(" ");  // the question is skipped, and play goes on
  CHECK(window.player().index() == before + 1);
  CHECK(window.player().running());
}

TEST_CASE("N and a button let play pass over questions, and that is kept", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 2));
  window.type("n");
  CHECK(window.ui.message() == "Play passes over questions now");
  CHECK(window.ui.settings().nonstop);
  window.type(" ");
  for (int i = 0; i < 200 && window.player().clock().playing(); ++i) {
    window.wait(0.5f);
    CHECK_FALSE(window.player().quiz().asked());
  }
  CHECK(window.player().at_end());

  Settings kept;
  kept.nonstop = true;
  WindowDriver again(lessons::all_lessons(), 1280, 800, {}, kept);
  CHECK_FALSE(again.player().clock().stops_at_questions());
  again.click("pass questions");
  CHECK(again.player().clock().stops_at_questions());
  CHECK_FALSE(again.ui.settings().nonstop);
}

TEST_CASE("the t-axis of a question's picture marks no t that its own step finds", "[question_scene]") {
  int kept_back = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step& step = step_of(walk, k);
    const std::optional<Axis>& before = step_of(walk, k - 1).scene.axis;
    if (step.question->over || !step.scene.axis || !before) return;
    const Scene asked = question_scene(walk, k);
    REQUIRE(asked.axis);
    CHECK(asked.axis->ticks.size() == before->ticks.size());
    CHECK(asked.axis->shared == before->shared);
    kept_back += step.scene.axis->ticks.size() > before->ticks.size() || step.scene.axis->shared != before->shared;
  });
  CHECK(kept_back > 0);
}

TEST_CASE("what came of an answer is in sight, whatever stands above it", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{1280, 800}, {800, 600}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, layout_only);
  int answered = 0;
  ask_all(window, isect::lessons::all_lessons(), [&](const Question&) {
    window.player().answer(0);
    window.frames(4);
    if (!window.player().quiz().answered()) return;
    ++answered;
    INFO(window.ui.title());
    const Rect told = window.rect("what came of it"), words = window.rect("lesson words");
    CHECK((told.top >= words.top && told.bottom <= words.bottom));
  });
  CHECK(answered > 40);
}

}  // namespace question_scene_test
