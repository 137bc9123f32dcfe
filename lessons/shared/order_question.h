#pragma once
// Questions for an order: it is computed, as are the usual wrong ones.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viz/lesson.h"
#include "viz/walk/given_order.h"

namespace isect::lessons {

/// Something to put in order. The one with the smaller key comes first; those with equal keys come in any order.
struct InOrder {
  std::string name;  ///< markup, short
  double key = 0;
};

/// A usual wrong order: by these keys, one for each thing.
struct WrongKeys {
  std::vector<double> keys;
  std::string reply;  ///< the mistake behind it
};

/// Returns 0, 1, ... n − 1 shuffled; the same for the same things.
inline std::vector<int> shuffled(const std::vector<InOrder>& things) {
  std::uint64_t state = 14695981039346656037u;  // FNV-1a of their names and keys
  for (const InOrder& thing : things)
    for (const char c : thing.name + viz::shown(thing.key))
      state = (state ^ static_cast<unsigned char>(c)) * 1099511628211u;
  std::vector<int> order(things.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::swap(order[i - 1], order[static_cast<std::size_t>((state >> 33) % i)]);
  }
  return order;
}

/// Returns the tiles by rising key, those with equal keys as they stand.
inline std::vector<int> sorted_by(const std::vector<double>& keys) {
  std::vector<int> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return keys[static_cast<std::size_t>(a)] < keys[static_cast<std::size_t>(b)]; });
  return order;
}

/// Whether a reader can tell the order of these numbers, which are sorted: those that differ are shown with different
/// digits, and by more than rounding.
inline bool can_be_told(const std::vector<double>& sorted) {
  const double largest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
  const auto too_near = [&](double a, double b) {
    return a != b && (b - a <= 1e-9 * largest || viz::shown(a) == viz::shown(b));
  };
  return std::adjacent_find(sorted.begin(), sorted.end(), too_near) == sorted.end();
}

/// "In which order are the boxes visited?": tiles in a shuffled order, which is not the right one. None where there are
/// fewer than three things, more than eight, all keys are equal, or some differ too little.
inline std::optional<viz::Question> which_order(const std::string& prompt, const std::vector<InOrder>& things,
                                                const std::vector<WrongKeys>& wrong, const std::string& because) {
  const auto has_no_key = [](const InOrder& thing) { return !std::isfinite(thing.key); };
  if (things.size() < 3 || things.size() > 8 || std::ranges::any_of(things, has_no_key)) return {};
  std::vector<double> keys;
  for (const InOrder& thing : things) keys.push_back(thing.key);
  std::sort(keys.begin(), keys.end());
  if (!can_be_told(keys)) return {};
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  if (keys.size() < 2) return {};

  std::vector<int> tiles = shuffled(things);
  viz::OrderAsked asked;
  const auto set_tiles = [&] {
    asked.tiles.clear(), asked.ranks.clear();
    for (const int thing : tiles) {
      asked.tiles.push_back(things[static_cast<std::size_t>(thing)].name);
      const double key = things[static_cast<std::size_t>(thing)].key;
      asked.ranks.push_back(static_cast<int>(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin()));
    }
  };
  set_tiles();
  while (std::is_sorted(asked.ranks.begin(), asked.ranks.end())) {
    std::rotate(tiles.begin(), tiles.begin() + 1, tiles.end());
    set_tiles();
  }

  const std::vector<int> right = sorted_by({asked.ranks.begin(), asked.ranks.end()});
  asked.offered = {right};
  const auto offer = [&](const std::vector<int>& order) {
    const bool is_new = first_wrong(asked, order) >= 0 && std::ranges::count(asked.offered, order) == 0;
    if (is_new) asked.offered.push_back(order);
    return is_new;
  };
  for (const WrongKeys& w : wrong) {
    std::vector<double> of_tiles;
    for (const int thing : tiles) of_tiles.push_back(w.keys.at(static_cast<std::size_t>(thing)));
    const std::vector<int> order = sorted_by(of_tiles);
    if (offer(order)) asked.wrong.push_back({order, w.reply});
  }
  offer({right.rbegin(), right.rend()});
  for (std::size_t i = 0; i + 1 < right.size() && asked.offered.size() < 3; ++i) {
    std::vector<int> order = right;
    std::swap(order[i], order[i + 1]);
    offer(order);
  }
  std::sort(asked.offered.begin(), asked.offered.end());

  viz::Question question = {prompt, {}, 0, because};
  for (const std::vector<int>& order : asked.offered) question.choices.push_back(tiles_in(asked, order));
  question.answer = static_cast<int>(std::ranges::find(asked.offered, right) - asked.offered.begin());
  question.order = std::move(asked);
  return question;
}

}  // namespace isect::lessons
