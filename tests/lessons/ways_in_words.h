#pragma once
// How readers without the picture find answers that are words, counts, lines or orders, from what is on show.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "tests/catch.h"
#include "tests/lessons/on_show.h"
#include "viz/walk/given_order.h"
#include "viz/walk/pointed_line.h"

namespace isect::tests::on_show {

using Plane = std::array<double, 4>;

/// "3 x − 8 z + 12 ≥ 0" as its four coefficients.
Plane plane_in(std::string text) {
  for (std::size_t at; (at = text.find("−")) != text.npos;) text.replace(at, 3, "-");
  std::erase(text, ' ');
  Plane plane{};
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

/// The planes of "1.6 ≤ x ≤ 7.1, 4 |y − 1| ≤ x − 0.1 and 8 |z + 2| ≤ 3 (x − 0.1)"; what is 0 is left out there.
inline std::array<Plane, 6> frustum_in(const std::string& prompt) {
  static const std::regex words(
      "(\\S+) ≤ x ≤ (\\S+), 4 \\|y(?: (\\+|−) ([0-9.]+))?\\| ≤ x(?: (\\+|−) ([0-9.]+))? and 8 \\|z(?: "
      "(\\+|−) ([0-9.]+))?\\|");
  std::smatch found;
  REQUIRE(std::regex_search(prompt, found, words));
  const auto added = [&](std::size_t sign) {
    return !found[sign].matched ? 0 : std::stod(found[sign + 1]) * (found[sign] == "+" ? 1 : -1);
  };
  const double y = added(3), x = added(5), z = added(7), near = number_in(found[1]).value(),
               far = number_in(found[2]).value();
  return {Plane{1, 0, 0, -near},      Plane{-1, 0, 0, far},          Plane{1, 4, 0, x + 4 * y},
          Plane{1, -4, 0, x - 4 * y}, Plane{3, 0, 8, 3 * x + 8 * z}, Plane{3, 0, -8, 3 * x - 8 * z}};
}

/// How a box from n[0..2] to n[3..5] lies to a plane: 0: all of it on the inner side; 1: beyond; 2: neither.
inline int against(const Numbers& n, const Plane& plane) {
  double least = plane[3], greatest = plane[3];
  for (std::size_t k = 0; k < 3; ++k) {
    least += std::min(plane[k] * n[k], plane[k] * n[k + 3]);
    greatest += std::max(plane[k] * n[k], plane[k] * n[k + 3]);
  }
  return greatest < 0 ? 1 : least >= 0 ? 0 : 2;
}

inline double cross(const Numbers& n, std::size_t a, std::size_t b, std::size_t c) {
  return (n[b] - n[a]) * (n[c + 1] - n[a + 1]) - (n[b + 1] - n[a + 1]) * (n[c] - n[a]);
}

/// Whether the ray from n[0..1] along n[2..3] meets the box at n[at..at + 3].
inline bool ray_meets(const Numbers& n, std::size_t at) {
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
inline int choice(const Question& q, const std::string& text) {
  const auto found = std::ranges::find_if(q.choices, [&](const std::string& markup) { return plain(markup) == text; });
  return static_cast<int>(found - q.choices.begin());
}

/// The name with the least "t of ..."; those later in `order` lose ties.
inline std::string nearest(const OnShow& o, const std::vector<std::string>& order, const std::string& none) {
  std::string best = none;
  double least = INFINITY;
  for (const std::string& name : order)
    if (const auto t = o.values.find("t of " + name); t != o.values.end() && t->second < least)
      least = t->second, best = name;
  return best;
}

inline std::vector<std::string> plain_choices(const Question& q) {
  std::vector<std::string> all;
  for (const std::string& c : q.choices) all.push_back(plain(c));
  return all;
}

/// The choice that is the order of the tiles by a key of their names. Keys that differ by rounding alone are equal.
inline int by_key(const Question& q, const std::function<double(const std::string&)>& key) {
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
inline const std::vector<std::pair<std::string, InWords>>& ways_in_words() {
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
       [](const Question&, const std::string& prompt, const OnShow& o) {
         const std::size_t number = prompt.find("box of node") != prompt.npos ? 1 : 0;  // the node's stands before
         const Numbers box(o.told.begin() + static_cast<std::ptrdiff_t>(number), o.told.end());
         bool inside = true;
         for (const Plane& plane : frustum_in(prompt)) {
           const int side = against(box, plane);
           if (side == 1) return 0;
           inside = inside && side == 0;
         }
         return inside ? 1 : 2;
       }},
      {"the intervals on",
       [](const Question&, const std::string& prompt, const OnShow& o) {
         const std::string i = "_" + prompt.substr(prompt.find(" on ") + 4, 1);
         if (o("a.min" + i) > o("b.max" + i) || o("b.min" + i) > o("a.max" + i)) return 0;
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

}  // namespace isect::tests::on_show
