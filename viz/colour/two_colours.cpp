#include "viz/colour/two_colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "viz/colour/shades.h"
#include "viz/colour/theme_check.h"
#include "viz/lesson.h"

namespace isect::viz {
namespace {

/// The least distance that is wanted where it can be had: that of the built-in theme for print.
constexpr double well_apart = 18;
/// Colours nearer than this are one colour to most readers.
constexpr double one_colour = 5;

/// A colour that may be taken, as each reader sees it.
struct Taken {
  Shade shade;
  std::array<Vec3, all_visions.size()> seen;

  explicit Taken(const Shade& s) : shade(s) {
    std::ranges::transform(all_visions, seen.begin(), [&](Vision v) { return cie_lab(seen_by(v, s.colour)); });
  }
  const Vec3& in_grey() const { return seen[static_cast<std::size_t>(Vision::grey)]; }
};

/// Whether two colours are at least so far apart for all who see colours, as least_apart counts.
bool are_apart(const Taken& a, const Taken& b, double least) {
  for (const Vision vision : all_visions) {
    const auto i = static_cast<std::size_t>(vision);
    if (vision != Vision::grey && std::round((a.seen[i] - b.seen[i]).norm()) < least) return false;
  }
  return true;
}

/// Two colours, and how far both together are from those that are wanted.
struct Couple {
  const Taken *one, *other;
  double away() const { return one->shade.away + other->shade.away; }
};

class Derivation {
 public:
  Derivation(const OwnTheme& theme, const Colour& first, const Colour& second)
      : theme_(theme),
        firsts_(readable(Role::first, shades_of(first))),
        seconds_(readable(Role::second, shades_of(second))),
        rise_(seen_lightness(second) - seen_lightness(first)) {}

  /// Returns the theme with its four colours; nothing if there are none.
  std::optional<OwnTheme> theme() const {
    if (firsts_.empty() || seconds_.empty()) return {};
    const std::vector<Taken> hits = readable(Role::hit, hues_near(ink(Role::hit)));
    const std::vector<Taken> misses = readable(Role::miss, hues_near(ink(Role::miss)));
    for (const Couple& objects : all_objects())
      for (const double least : {well_apart, demands::apart})
        if (const auto verdicts = nearest(beside(objects, hits, least), beside(objects, misses, least), least)) {
          OwnTheme made = theme_;
          const Taken* const taken[] = {objects.one, objects.other, verdicts->one, verdicts->other};
          for (std::size_t i = 0; i < main_roles.size(); ++i)
            made.colours[static_cast<std::size_t>(main_roles[i])] = taken[i]->shade.colour;
          return made;
        }
    return {};
  }

 private:
  static double seen_lightness(const Colour& c) { return cie_lab(c).x(); }
  const Colour& ink(Role role) const { return theme_.colours[static_cast<std::size_t>(role)]; }

  std::vector<Taken> readable(Role role, const std::vector<Shade>& shades) const {
    std::vector<Taken> all;
    for (const Shade& shade : shades)
      if (contrast_faults(theme_, static_cast<std::size_t>(role), shade.colour).empty()) all.emplace_back(shade);
    return all;
  }

  /// Returns the colours that the two objects may have, the nearest to the two that are wanted first.
  std::vector<Couple> all_objects() const {
    std::vector<Couple> all;
    for (const Taken& a : firsts_)
      for (const Taken& b : seconds_) {
        const Vec3 step = b.in_grey() - a.in_grey();
        const bool keeps_order = step.x() * rise_ >= 0;
        if (keeps_order && std::round(step.norm()) >= demands::in_grey && are_apart(a, b, demands::apart))
          all.push_back({&a, &b});
      }
    std::ranges::stable_sort(all, [](const Couple& a, const Couple& b) { return a.away() < b.away(); });
    return all;
  }

  static std::vector<const Taken*> beside(const Couple& objects, const std::vector<Taken>& all, double least) {
    std::vector<const Taken*> apart;
    for (const Taken& taken : all)
      if (are_apart(taken, *objects.one, least) && are_apart(taken, *objects.other, least)) apart.push_back(&taken);
    return apart;
  }

  /// Returns the nearest two of both lists, which are sorted, that are apart.
  static std::optional<Couple> nearest(const std::vector<const Taken*>& ones, const std::vector<const Taken*>& others,
                                       double least) {
    std::optional<Couple> best;
    for (const Taken* one : ones)
      for (const Taken* other : others) {
        const Couple couple = {one, other};
        if (best && couple.away() >= best->away()) break;
        if (are_apart(*one, *other, least)) best = couple;
      }
    return best;
  }

  const OwnTheme& theme_;
  const std::vector<Taken> firsts_, seconds_;
  const double rise_;  ///< by how much the second is lighter
};

std::optional<OwnTheme> derived(const OwnTheme& theme, const Colour& first, const Colour& second) {
  if (distance_seen(Vision::usual, first, second) < one_colour) return {};
  return Derivation(theme, first, second).theme();
}

}  // namespace

void derive_from(OwnTheme& theme, const Colour& first, const Colour& second) {
  if (theme.based_on == ThemeName::grey)
    throw BadInput("a theme based on grey has no colours; base it on print, screen or dark");
  if (const std::optional<OwnTheme> made = derived(theme, first, second)) {
    theme = *made;
    return;
  }
  const double apart = distance_seen(Vision::usual, first, second);
  const std::string why = apart < one_colour ? fmt::format("{} and {} look alike, {:.1f} apart, and {:g} is wanted",
                                                           hex_of(first), hex_of(second), apart, one_colour)
                                             : fmt::format("{} and {} have no shades that every reader tells apart",
                                                           hex_of(first), hex_of(second));
  const std::optional<Colour> other =
      nearest_that(hues_near(second), [&](const Colour& c) { return derived(theme, first, c).has_value(); });
  throw BadInput(other ? fmt::format("{}; with {} as the second it can be done", why, hex_of(*other))
                       : fmt::format("{}; give two others", why));
}

}  // namespace isect::viz
