#include "viz/formats/colour_table.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>

namespace isect::viz {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

struct Counted {
  Rgb colour;
  double count;
};
using Iterator = std::vector<Counted>::iterator;

/// Colours that one colour will stand for.
struct ColourGroup {
  Iterator first, last;
  std::array<double, 3> mean = {}, error = {};  ///< squared, of all its pixels, by channel
  double count = 0;

  ColourGroup(Iterator from, Iterator to) : first(from), last(to) {
    for (auto c = first; c != last; ++c) count += c->count;
    for (std::size_t i = 0; i < 3; ++i) {
      for (auto c = first; c != last; ++c) mean[i] += c->count * c->colour[i] / count;
      for (auto c = first; c != last; ++c) error[i] += c->count * (c->colour[i] - mean[i]) * (c->colour[i] - mean[i]);
    }
  }

  std::size_t widest() const { return static_cast<std::size_t>(std::ranges::max_element(error) - error.begin()); }

  /// Partitions the group: first the colours below the mean. Neither part is empty, as at least two colours differ.
  Iterator halves() const {
    const std::size_t i = widest();
    return std::partition(first, last, [&](const Counted& c) { return c.colour[i] < mean[i]; });
  }

  Rgb representative() const {
    const auto most = std::max_element(first, last, [](const auto& a, const auto& b) { return a.count < b.count; });
    if (2 * most->count >= count) return most->colour;
    Rgb colour;
    for (std::size_t i = 0; i < 3; ++i) colour[i] = static_cast<std::uint8_t>(mean[i] + 0.5);
    return colour;
  }
};

Rgb pixel(const Picture& picture, std::size_t i) { return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]}; }

std::map<Rgb, int> counts_in(const Picture& picture) {
  std::map<Rgb, int> counts;
  auto last = counts.end();
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    if (last == counts.end() || last->first != pixel(picture, i)) last = counts.try_emplace(pixel(picture, i)).first;
    ++last->second;
  }
  return counts;
}

std::vector<Counted> counted(const std::map<Rgb, int>& counts) {
  std::vector<Counted> colours;
  for (const auto& [colour, count] : counts) colours.push_back({colour, static_cast<double>(count)});
  return colours;
}

/// Whether no channel differs by more than `slack`.
bool near(const Rgb& a, const Rgb& b, int slack) {
  return std::ranges::equal(a, b, [&](int x, int y) { return std::abs(x - y) <= slack; });
}

bool errs_less(const ColourGroup& a, const ColourGroup& b) { return a.error[a.widest()] < b.error[b.widest()]; }

}  // namespace

std::optional<ColourTable> own_colours(const Picture& picture) {
  ColourTable table;
  table.places.reserve(picture.rgba.size() / 4);
  std::map<Rgb, std::uint8_t> place;
  auto last = place.end();
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const Rgb colour = pixel(picture, i);
    if (last == place.end() || last->first != colour) {
      const auto [found, is_new] = place.try_emplace(colour, static_cast<std::uint8_t>(place.size()));
      if (is_new) table.colours.push_back(colour);
      if (table.colours.size() > 256) return {};
      last = found;
    }
    table.places.push_back(last->second);
  }
  return table;
}

ColourTable colour_table(const Picture& picture, int most) {
  std::map<Rgb, int> counts = counts_in(picture);
  std::vector<Counted> colours = counted(counts);

  std::vector<ColourGroup> groups = {{colours.begin(), colours.end()}};
  while (groups.size() < std::min(static_cast<std::size_t>(most), colours.size())) {
    const auto worst = std::ranges::max_element(groups, errs_less);
    const Iterator middle = worst->halves();
    const ColourGroup upper(middle, worst->last);
    *worst = ColourGroup(worst->first, middle);
    groups.push_back(upper);
  }

  ColourTable table;
  for (const ColourGroup& group : groups) {
    for (auto c = group.first; c != group.last; ++c) counts[c->colour] = static_cast<int>(table.colours.size());
    table.colours.push_back(group.representative());
  }
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    table.places.push_back(static_cast<std::uint8_t>(counts[pixel(picture, i)]));
  return table;
}

Picture with_fewer_colours(const Picture& picture, int slack) {
  std::vector<Counted> colours = counted(counts_in(picture));
  std::ranges::stable_sort(colours, std::greater(), &Counted::count);
  std::vector<Rgb> kept;
  std::map<Rgb, Rgb> kept_for;
  for (const Counted& c : colours) {
    const auto first = std::ranges::find_if(kept, [&](const Rgb& k) { return near(k, c.colour, slack); });
    kept_for[c.colour] = first == kept.end() ? kept.emplace_back(c.colour) : *first;
  }

  Picture result = picture;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    std::ranges::copy(kept_for[pixel(picture, i)], result.rgba.begin() + static_cast<std::ptrdiff_t>(i));
  return result;
}

}  // namespace isect::viz
