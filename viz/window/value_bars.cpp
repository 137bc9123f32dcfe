#include "viz/window/value_bars.h"

#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

void fill_bar(BarFill fill, const Rect& r, const Colour& ink) {
  if (!(r.width() > 0)) return;
  const float rounding = std::min(4.0f, r.width() / 2);
  switch (fill) {
    case BarFill::full:
      return filled(r, ink, rounding);
    case BarFill::hollow:
      return outlined(r, ink, 1.5f, rounding);
    case BarFill::blocks:
      for (float x = r.left; x < r.right; x += 7) filled({x, r.top, std::min(x + 5, r.right), r.bottom}, ink, 1);
      return;
    case BarFill::hatched:
      outlined(r, ink, 1, 0);
      ImGui::PushClipRect(top_left(r), bottom_right(r), true);
      for (float x = r.left - r.height(); x < r.right; x += 5)
        ImGui::GetWindowDrawList()->AddLine({x, r.bottom}, {x + r.height(), r.top}, packed(ink), 1.5f);
      return ImGui::PopClipRect();
  }
}

/// Returns the usual look of a unit's bars: lengths are full, areas hatched, volumes hollow, and what is counted stands
/// in blocks.
BarFill usual_fill(const std::string& unit) {
  if (unit == "length" || unit == "t") return BarFill::full;
  if (unit == "area") return BarFill::hatched;
  return unit == "volume" ? BarFill::hollow : BarFill::blocks;
}

}  // namespace

std::vector<UnitBars> units_of(const Step& step) {
  std::vector<UnitBars> units;
  const auto taken_by_one = [&](BarFill fill) {
    return std::ranges::find(units, fill, &UnitBars::fill) != units.end();
  };
  for (const Value& v : step.values) {
    if (v.unit.empty()) continue;
    auto found = std::ranges::find(units, v.unit, &UnitBars::unit);
    if (found == units.end()) {
      BarFill fill = usual_fill(v.unit);
      for (const BarFill other : {BarFill::full, BarFill::hatched, BarFill::blocks, BarFill::hollow})
        if (taken_by_one(fill) && !taken_by_one(other)) fill = other;
      units.push_back({v.unit, fill});
      found = units.end() - 1;
    }
    found->scale.take(v.value);
  }
  return units;
}

const UnitBars* unit_of(const std::vector<UnitBars>& units, const Step& step, const Comparison& c) {
  const std::string words = plain(c.text);
  for (const Value& v : step.values) {
    const std::string name = plain(v.name);
    if (v.unit.empty() || !(words.starts_with(name + " ") || words.ends_with(" " + name))) continue;
    const auto found = std::ranges::find(units, v.unit, &UnitBars::unit);
    return found == units.end() ? nullptr : &*found;
  }
  return nullptr;
}

void unit_key(Ui& ui, const std::vector<UnitBars>& units, float left, float right, float y) {
  constexpr float sample = 18, gap = 6, apart = 14;
  for (std::size_t i = units.size(); i-- > 0;) {
    const std::string name = plain(units[i].unit);
    const float begin = right - text_width(ui.fonts.body, name) - gap - sample;
    if (begin < left) return;
    text(ui.fonts.body, right, y, packed(ui.palette.muted), name, 1);
    fill_bar(units[i].fill, {begin, y - 4, begin + sample, y + 4}, ui.palette.muted);
    ui.rects["unit " + name] = {begin, y - 8, right, y + 8};
    right = begin - apart;
  }
}

void value_bar(const Ui& ui, const UnitBars& unit, const Value& v, float x0, float x1, float y) {
  filled({x0, y - 4, x1, y + 4}, ui.palette.card, 4);
  const float zero = unit.scale.at(0, x0, x1), end = unit.scale.at(v.value, x0, x1);
  const float left = std::min(zero, end), right = std::max(zero, end);
  if (!(right - left > 0.25f)) return;
  const Colour& ink = v.role == Role::muted ? ui.palette.theme.ink(Role::construction) : ui.palette.theme.ink(v.role);
  fill_bar(unit.fill, {left, y - 4, std::max(right, left + 3), y + 4}, ink);
}

void comparison_bar(const Ui& ui, const Comparison& comparison, const UnitBars* unit, float x0, float x1, float y) {
  const Palette& c = ui.palette;
  if (unit) x1 -= 8 + text(ui.fonts.body, x1, y, packed(c.muted), plain(unit->unit), 1);
  BarScale scale;
  scale.take(comparison.left);
  scale.take(comparison.right);
  const Colour& ink = comparison.holds ? c.hit : c.miss;
  const float zero = scale.at(0, x0, x1), left = scale.at(comparison.left, x0, x1);
  const float right = scale.at(comparison.right, x0, x1);
  filled({x0, y - 4, x1, y + 4}, c.frame, 4);
  filled({std::min(zero, right), y - 4, std::max(zero, right), y + 4}, c.second.with_alpha(0.35), 4);
  fill_bar(unit ? unit->fill : BarFill::full, {std::min(zero, left), y - 4, std::max(zero, left), y + 4}, ink);
  filled({right - 1, y - 10, right + 1, y + 10}, c.second, 0);
}

}  // namespace isect::viz
