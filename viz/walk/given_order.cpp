#include "viz/walk/given_order.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "viz/lang/language.h"
#include "viz/lang/message.h"
#include "viz/text/count_words.h"

namespace isect::viz {
namespace {

int rank_of(const OrderAsked& asked, int tile) { return asked.ranks.at(static_cast<std::size_t>(tile)); }

std::vector<int> sorted_ranks(const OrderAsked& asked) {
  std::vector<int> ranks = asked.ranks;
  std::ranges::sort(ranks);
  return ranks;
}

}  // namespace

std::vector<int> order_from(const std::string& typed, int tiles) {
  std::vector<int> order;
  for (const char typed_letter : typed) {
    const char c = static_cast<char>(std::tolower(static_cast<unsigned char>(typed_letter)));
    if (c == ' ' || c == ',') continue;
    const int tile = c - 'a';
    if (tile < 0 || tile >= tiles) throw BadInput(fmt::format("the letters are a to {}", tile_letter(tiles - 1)));
    if (std::ranges::count(order, tile) > 0) throw BadInput(fmt::format("{} is there twice", c));
    order.push_back(tile);
  }
  for (int tile = 0; tile < tiles; ++tile)
    if (std::ranges::count(order, tile) == 0) throw BadInput(fmt::format("{} is missing", tile_letter(tile)));
  return order;
}

std::string letters_of(const std::vector<int>& order) {
  std::string letters;
  for (const int tile : order) letters += tile_letter(tile);
  return letters;
}

bool has_ties(const OrderAsked& asked) {
  const std::vector<int> ranks = sorted_ranks(asked);
  return std::ranges::adjacent_find(ranks) != ranks.end();
}

std::string how_to_order(const OrderAsked& asked) {
  return tr("Take one tile after the other, or type the letters.") +
         (has_ties(asked) ? " " + tr("Of equal ones, any may come first.") : "");
}

int first_wrong(const OrderAsked& asked, const std::vector<int>& order) {
  const std::vector<int> ranks = sorted_ranks(asked);
  for (std::size_t i = 0; i < order.size(); ++i)
    if (rank_of(asked, order[i]) != ranks.at(i)) return static_cast<int>(i);
  return -1;
}

std::string reply_to(const OrderAsked& asked, const std::vector<int>& order) {
  const int place = first_wrong(asked, order);
  if (place < 0) return {};
  const auto known = std::ranges::find(asked.wrong, order, &WrongOrder::order);
  if (known != asked.wrong.end()) return known->reply;
  const std::string& name = asked.tiles.at(static_cast<std::size_t>(order[static_cast<std::size_t>(place)]));
  if (place == 0) return tr("The first is not {tile}.", {{"tile", name}});
  return place == 1 ? tr("The first is right. The next is not {tile}.", {{"tile", name}})
                    : tr("The first {n} are right. The next is not {tile}.",
                         {{"n", spoken() == "en" ? in_words(place) : std::to_string(place)}, {"tile", name}});
}

std::string tiles_in(const OrderAsked& asked, const std::vector<int>& order) {
  std::vector<std::string> names;
  for (const int tile : order) names.push_back(asked.tiles.at(static_cast<std::size_t>(tile)));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Returns "(a) x and (b) y in any order"; one alone as it is.
static std::string in_any_order(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all = all.empty() ? name : tr("{a} and {b}", {{"a", all}, {"b", name}});
  return names.size() > 1 ? tr("{names} in any order", {{"names", all}}) : all;
}

std::string right_order(const OrderAsked& asked) {
  std::vector<int> ranks = sorted_ranks(asked);
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  std::vector<std::string> groups;
  for (const int rank : ranks) {
    std::vector<std::string> names;
    for (int tile = 0; tile < static_cast<int>(asked.tiles.size()); ++tile)
      if (rank_of(asked, tile) == rank)
        names.push_back(fmt::format("({}) {}", tile_letter(tile), asked.tiles[static_cast<std::size_t>(tile)]));
    groups.push_back(in_any_order(names));
  }
  std::string all;
  for (const std::string& group : groups) all = all.empty() ? group : tr("{a}, then {b}", {{"a", all}, {"b", group}});
  return all;
}

int choice_of_order(const Question& question, const std::vector<int>& order) {
  if (first_wrong(*question.order, order) < 0) return question.answer;
  const std::vector<std::vector<int>>& offered = question.order->offered;
  const auto found = std::ranges::find(offered, order);
  return found == offered.end() ? -1 : static_cast<int>(found - offered.begin());
}

}  // namespace isect::viz
