#include "viz/window/measures.h"

#include <algorithm>
#include <cmath>

#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"

namespace isect::viz {
namespace {

/// Whether markup is one name and nothing else: no power, no product.
bool is_only_a_name(const std::string& markup) {
  const std::vector<Name> names = names_in(markup);
  std::size_t length = 0;
  for (const Run& run : parse_markup(markup)) length += run.text.size();
  return names.size() == 1 && names[0].begin == 0 && names[0].end == length;
}

}  // namespace

std::optional<Measure> measure_of(const Player& player, const std::string& key) {
  const std::vector<Value>& values = player.shown().values;
  const Value* found = nullptr;
  for (const Value& v : values) {
    if (keys(names_in(v.name)) != std::vector{key} || v.name.find('|') != std::string::npos) continue;
    if (!found || (is_only_a_name(v.name) && !is_only_a_name(found->name))) found = &v;
  }
  if (found) return Measure{plain(found->name), shown(values)[static_cast<std::size_t>(found - values.data())]};
  for (const Parameter& p : player.lesson().parameters) {
    const auto value = player.parameters().find(p.name);
    if (value == player.parameters().end() || !std::holds_alternative<double>(value->second)) continue;
    if (keys(names_in(p.label)) == std::vector{key})
      return Measure{plain(p.label), value_in_words(value->second, player.lesson().flat)};
  }
  return std::nullopt;
}

std::string words_beside(const Measure& measure, const std::string& label) {
  return (measure.name == label ? std::string() : measure.name + " ") + "= " + measure.number;
}

void measure_chip(Ui& ui, const std::string& key, const std::string& words, const Rect& at, const Rect& scene,
                  double strength) {
  constexpr float gap = 5;
  const float width = text_width(ui.fonts.bold, words) + 2 * gap, half = std::max(at.height() / 2, 12.0f);
  const bool right = at.right + width <= scene.right - 4;
  const float most = std::max(scene.left + 4, scene.right - 4 - width);
  const float left = std::clamp(right ? at.right : at.left - width, scene.left + 4, most);
  const float y = std::clamp(at.middle_y(), scene.top + half, std::max(scene.top + half, scene.bottom - half));
  const Rect r{left, y - half, left + width, y + half};
  ui.rects["measure " + key] = r;
  light_up(ui, r, strength);
  text(ui.fonts.bold, r.left + gap, y, packed(ui.palette.on_highlight, strength), words);
}

}  // namespace isect::viz
