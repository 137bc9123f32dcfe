#include "viz/snap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>
#include <vector>

#include "viz/rich_text.h"

namespace isect::viz {
namespace {

constexpr int asked_places = 40;
/// A lesson that takes longer over one setting, a traced picture say, is not searched: it asks for about a hundred.
/// By processor time, so that a busy machine snaps as an idle one does.
constexpr std::clock_t most_a_setting = CLOCKS_PER_SEC / 80;

/// Nor are what is counted, one or several, two cases.
std::string without_numbers(const std::string& text) {
  std::string words;
  std::istringstream in(text);
  bool counted = false;
  for (std::string word; in >> word;) {
    const bool number = std::ranges::any_of(word, [](char c) { return c >= '0' && c <= '9'; });
    std::size_t end = word.find_last_not_of(",.:;") + 1;
    if (counted && end > 1 && word[end - 1] == 's') word.erase(end - 1, 1);
    if (!number) words += (words.empty() ? "" : " ") + word;
    counted = number;
  }
  return words;
}

/// A setting of the way, with its case.
struct Found {
  double share = 0;
  std::optional<Parameters> setting = {};
  std::string is = {};
};

std::vector<double*> numbers(Parameters& setting) {
  std::vector<double*> all;
  for (auto& [name, value] : setting) {
    if (double* number = std::get_if<double>(&value)) all.push_back(number);
    if (Vec3* v = std::get_if<Vec3>(&value))
      for (int i = 0; i < 3; ++i) all.push_back(&(*v)[i]);
  }
  return all;
}

/// The only number in which two settings differ; none where there are several.
std::optional<std::size_t> only_difference(Parameters a, Parameters b) {
  const std::vector<double*> left = numbers(a), right = numbers(b);
  if (left.size() != right.size()) return {};
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (*left[i] == *right[i]) continue;
    if (found) return {};
    found = i;
  }
  return found;
}

/// Two settings that differ in one number, brought together until that is a pair of neighbouring doubles.
void bisect_number(const Lesson& lesson, Found& near, Found& far) {
  const auto which = only_difference(*near.setting, *far.setting);
  if (!which) return;
  const auto number = [&](Found& place) -> double& { return *numbers(*place.setting)[*which]; };
  for (;;) {
    Found middle = near;
    const double x = number(near) / 2 + number(far) / 2;
    if (x == number(near) || x == number(far)) return;
    number(middle) = x;
    middle.is = case_of(lesson, *middle.setting);
    (middle.is == near.is ? near : far) = middle;
  }
}

}  // namespace

std::string case_of(const Lesson& lesson, const Parameters& setting) {
  if (lesson.map && lesson.map->place(setting).allFinite())
    return plain(lesson.map->branches[static_cast<std::size_t>(lesson.map->branch(setting))]);
  const Walk walk = lesson.steps(setting);
  const auto decided = std::find_if(walk.steps.rbegin(), walk.steps.rend(),
                                    [](const Step& s) { return s.verdict.kind != Verdict::Kind::open; });
  return decided == walk.steps.rend() ? std::string() : without_numbers(plain(decided->verdict.text));
}

std::optional<Snapped> find_border(const Lesson& lesson, const Way& way, double begin, double end, double wish) {
  const auto at = [&](double share) {
    Found place = {share, way(share)};
    if (place.setting) place.is = case_of(lesson, *place.setting);
    return place;
  };
  const std::clock_t begun = std::clock();
  at(begin);
  if (std::clock() - begun > most_a_setting) return {};
  std::vector<Found> all;
  for (int i = 0; i <= asked_places; ++i) all.push_back(at(begin + (end - begin) * i / asked_places));
  std::optional<std::size_t> best;
  const auto distance = [&](std::size_t i) { return std::abs((all[i].share + all[i + 1].share) / 2 - wish); };
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
    if (all[i].setting && all[i + 1].setting && all[i].is != all[i + 1].is && (!best || distance(i) < distance(*best)))
      best = i;
  if (!best) return {};

  Found near = all[*best], far = all[*best + 1];
  const std::string beyond = far.is;
  for (;;) {
    Found middle = at(near.share / 2 + far.share / 2);
    if (middle.share == near.share || middle.share == far.share || !middle.setting) break;
    (middle.is == near.is ? near : far) = middle;
  }
  bisect_number(lesson, near, far);
  // The first setting of another case is the border itself where it is neither of the two that meet there.
  if (far.is != beyond) return Snapped{*far.setting, true, far.is + ", exactly"};
  const Found& side = near.share < wish ? far : near;
  return Snapped{*side.setting, false,
                 fmt::format("Between two neighbouring doubles: “{}” on one side, “{}” on the other", near.is, far.is)};
}

Way way_of(const Lesson& lesson, const Parameters& setting, const Handle& handle, const Vec3& from, const Vec3& to) {
  constexpr double little = 0.09;  // five degrees
  Vec3 way = to - from;
  const double most = way.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i)
    if (std::abs(way[i]) < little * most) way[i] = 0;
  return [&lesson, setting, handle, from, way](double share) -> std::optional<Parameters> {
    Parameters dragged = setting;
    if (drag(lesson, dragged, handle, from + share * way)) return {};
    return dragged;
  };
}

Way way_of(const Lesson& lesson, const Parameters& setting, const Vec2& from, const Vec2& to) {
  return [&lesson, setting, from, to](double share) -> std::optional<Parameters> {
    const CaseMap& map = *lesson.map;
    const Vec2 place = from + share * (to - from);
    Parameters moved = map.moved(setting, place.cwiseMax(map.lo).cwiseMin(map.hi));
    try {
      validate(lesson, moved);
    } catch (const BadInput&) {
      return {};
    }
    return moved;
  };
}

}  // namespace isect::viz
