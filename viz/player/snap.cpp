#include "viz/player/snap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <numeric>
#include <sstream>
#include <utility>
#include <vector>

#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

constexpr int asked_places = 40;
/// A lesson that takes longer over each of the first two settings is not searched: a frame that asks about one would be
/// late, and a hundred take seconds. Processor time, so that a busy machine snaps like an idle one.
constexpr std::clock_t most_a_setting = CLOCKS_PER_SEC / 30;

/// Returns the words without numbers. Singular and plural of a counted noun are the same case.
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

std::vector<double*> numbers(Parameters& setting) {
  std::vector<double*> all;
  for (auto& [name, value] : setting) {
    if (double* number = std::get_if<double>(&value)) all.push_back(number);
    if (Vec3* v = std::get_if<Vec3>(&value))
      for (int i = 0; i < 3; ++i) all.push_back(&(*v)[i]);
  }
  return all;
}

/// Returns the index of the only number in which two settings differ; none if there are several.
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

/// Returns how many characters the setting's numbers take.
std::size_t digits_in(Parameters setting) {
  std::size_t count = 0;
  for (const double* x : numbers(setting)) count += to_text(*x).size();
  return count;
}

/// Returns the way without its coordinates that change much less than another one.
Vec3 main_part(Vec3 way) {
  constexpr double little = 0.09;  // five degrees
  const double most = way.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i)
    if (std::abs(way[i]) < little * most) way[i] = 0;
  return way;
}

/// Whether the handle moves what the other one stands on.
bool carries(const Handle& handle, const Handle& other) {
  return other.parameter == handle.parameter || std::ranges::find(handle.with, other.parameter) != handle.with.end();
}

/// Returns where other handles, dots and the corners of areas are.
std::vector<Vec3> marked_points(const Scene& scene, const Handle& handle) {
  std::vector<Vec3> points;
  for (const Handle& other : scene.handles)
    if (!carries(handle, other)) points.push_back(other.at);
  for (const Item& item : scene.items) {
    if (const Dot* dot = std::get_if<Dot>(&item); dot && dot->at != handle.at) points.push_back(dot->at);
    if (const Region* region = std::get_if<Region>(&item))
      for (const std::vector<Vec3>& ring : region->rings) points.insert(points.end(), ring.begin(), ring.end());
  }
  return points;
}

/// Returns the verdicts in plain words: the last one of the walk or, for a scene with several questions, all.
std::vector<std::string> verdicts_of(const Lesson& lesson, const Parameters& setting) {
  std::vector<std::string> all;
  for (const Step& s : lesson.steps(setting).steps)
    if (s.verdict.kind != Verdict::Kind::open) all.push_back(plain(s.verdict.of_core()));
  if (lesson.made_from.empty() && all.size() > 1) all.erase(all.begin(), all.end() - 1);
  return all;
}

/// Returns how its case is described: a verdict with its numbers, the first that differs from those at `beyond`.
std::string told_case(const Lesson& lesson, const Parameters& setting, const Parameters& beyond) {
  if (lesson.map && lesson.map->place(setting).allFinite()) return case_of(lesson, setting);
  const std::vector<std::string> here = verdicts_of(lesson, setting);
  if (here.size() == 1) return here.front();
  const std::vector<std::string> there = verdicts_of(lesson, beyond);
  for (std::size_t i = 0; i < here.size(); ++i)
    if (i >= there.size() || without_numbers(here[i]) != without_numbers(there[i])) return here[i];
  return here.empty() ? std::string() : here.back();
}

}  // namespace

std::string case_of(const Lesson& lesson, const Parameters& setting) {
  if (lesson.map && lesson.map->place(setting).allFinite())
    return plain(lesson.map->branches[static_cast<std::size_t>(lesson.map->branch(setting))]);
  std::string all;
  for (const std::string& verdict : verdicts_of(lesson, setting))
    all += (all.empty() ? "" : "\n") + without_numbers(verdict);
  return all;
}

BorderSearch::BorderSearch(const Lesson& lesson, Way way, double begin, double end, double wish,
                           std::vector<Landmark> landmarks)
    : lesson_(lesson), way_(std::move(way)), begin_(begin), end_(end), wish_(wish) {
  std::ranges::copy_if(landmarks, std::back_inserter(landmarks_),
                       [&](const Landmark& l) { return begin < l.share && l.share < end; });
  order_.resize(asked_places + landmarks_.size());
  std::iota(order_.begin(), order_.end(), 0);
  const auto distance = [&](int i) {
    const double at = i < asked_places ? begin + (end - begin) * (i + 0.5) / asked_places
                                       : landmarks_[static_cast<std::size_t>(i - asked_places)].share;
    return std::abs(at - wish);
  };
  std::ranges::stable_sort(order_, {}, distance);
}

bool BorderSearch::go_on() { return (this->*next_)(); }

/// Returns a place of the way; it has no setting if the lesson refuses it.
BorderSearch::Place BorderSearch::of(double share, std::optional<Parameters> setting) const {
  Place place = {share, std::move(setting)};
  if (!place.setting) return place;
  try {
    place.is = case_of(lesson_, *place.setting);
  } catch (const BadInput&) {
    place.setting.reset();
  }
  return place;
}

BorderSearch::Place BorderSearch::at(double share) const { return of(share, way_(share)); }

bool BorderSearch::end() { return false; }

/// Asks about one end of a part; returns false if that was asked before.
bool BorderSearch::ask_at(int i) {
  if (places_.contains(i)) return false;
  const std::clock_t begun = std::clock();
  places_[i] = at(begin_ + (end_ - begin_) * i / asked_places);
  slow_ = slow_ && std::clock() - begun > most_a_setting;
  if (places_.size() == 2 && slow_) next_ = &BorderSearch::end;
  return true;
}

/// Returns false when done. Asks about its part's ends first: if one has its case, the landmark is no case by itself.
bool BorderSearch::ask_at(const Landmark& landmark) {
  const double where = (landmark.share - begin_) / (end_ - begin_) * asked_places;
  const int part = std::clamp(static_cast<int>(where), 0, asked_places - 1);
  if (ask_at(part) || ask_at(part + 1)) return true;
  const double beside = 1e-9 * (end_ - begin_);
  if (about_.empty()) {
    about_.push_back(of(landmark.share, landmark.setting));
    return true;
  }
  const std::string& is = about_[0].is;
  const bool own = about_[0].setting && places_[part].is != is && places_[part + 1].is != is;
  if (own && about_.size() < 3) {
    about_.push_back(at(landmark.share + (about_.size() == 1 ? -beside : beside)));
    return true;
  }
  if (own && std::ranges::none_of(&about_[1], &about_[1] + 2, [&](const Place& p) { return !p.setting || p.is == is; }))
    found_ = Snapped{landmark.setting, true,
                     fmt::format("Here exactly: “{}”", told_case(lesson_, landmark.setting, *about_[1].setting))};
  about_.clear();
  return false;
}

/// Looks at the parts from `wish` outwards, until the case changes between two places.
bool BorderSearch::look_for_change() {
  for (; looked_at_ < order_.size() && !found_; ++looked_at_) {
    const int part = order_[looked_at_];
    if (part >= asked_places) {
      if (ask_at(landmarks_[static_cast<std::size_t>(part - asked_places)])) return true;
      continue;
    }
    if (ask_at(part) || ask_at(part + 1)) return true;
    near_ = places_[part], far_ = places_[part + 1];
    if (!near_.setting || !far_.setting || near_.is == far_.is) continue;
    beyond_ = far_.is;
    next_ = &BorderSearch::bisect;
    return go_on();
  }
  next_ = &BorderSearch::end;
  return false;
}

bool BorderSearch::bisect() {
  Place middle = at(near_.share / 2 + far_.share / 2);
  if (middle.share != near_.share && middle.share != far_.share && middle.setting) {
    (middle.is == near_.is ? near_ : far_) = std::move(middle);
    return true;
  }
  only_different_ = only_difference(*near_.setting, *far_.setting);
  next_ = &BorderSearch::bisect_number;
  return go_on();
}

/// If they differ in one number only, bisects until that is a pair of neighbouring doubles.
bool BorderSearch::bisect_number() {
  if (only_different_) {
    const auto number = [&](Place& place) -> double& { return *numbers(*place.setting)[*only_different_]; };
    const double x = number(near_) / 2 + number(far_) / 2;
    if (x != number(near_) && x != number(far_)) {
      Place middle = near_;
      number(middle) = x;
      middle = of(middle.share, std::move(middle.setting));
      if (middle.setting) {
        (middle.is == near_.is ? near_ : far_) = std::move(middle);
        return true;
      }
    }
  }
  next_ = &BorderSearch::tell;
  return true;
}

bool BorderSearch::tell() {
  next_ = &BorderSearch::end;
  // The first setting of another case is the border itself if its case is neither of the two that meet there.
  if (far_.is != beyond_) {
    found_ = Snapped{*far_.setting, true, told_case(lesson_, *far_.setting, *near_.setting) + ", exactly"};
    return false;
  }
  // The shorter of the two numbers is taken, whichever case it has: readers want to stand on it.
  const std::size_t near_digits = digits_in(*near_.setting), far_digits = digits_in(*far_.setting);
  const Place& side = near_digits != far_digits ? (near_digits < far_digits ? near_ : far_)
                      : near_.share < wish_     ? far_
                                                : near_;
  found_ = Snapped{*side.setting, false,
                   fmt::format("Between two neighbouring doubles: “{}” on one side, “{}” on the other",
                               told_case(lesson_, *near_.setting, *far_.setting),
                               told_case(lesson_, *far_.setting, *near_.setting))};
  return false;
}

std::optional<Snapped> find_border(const Lesson& lesson, const Way& way, double begin, double end, double wish,
                                   std::vector<Landmark> landmarks) {
  BorderSearch search(lesson, way, begin, end, wish, std::move(landmarks));
  while (search.go_on()) continue;
  return search.found();
}

Way way_of(const Lesson& lesson, const Parameters& setting, const Handle& handle, const Vec3& from, const Vec3& to) {
  return [&lesson, setting, handle, from, way = main_part(to - from)](double share) -> std::optional<Parameters> {
    Parameters dragged = setting;
    if (drag(lesson, dragged, handle, from + share * way)) return {};
    return dragged;
  };
}

std::vector<Landmark> landmarks(const Lesson& lesson, const Parameters& setting, const Handle& handle, const Vec3& from,
                                const Vec3& to, const Scene& scene, double wish) {
  constexpr double end = 1.25;
  constexpr std::size_t most = 40;
  const Vec3 way = main_part(to - from);
  struct Level {
    double share;
    int axis;
    double value;
  };
  std::vector<Level> levels;
  for (const Vec3& p : marked_points(scene, handle))
    for (int i = 0; i < 3; ++i)
      if (const double share = (p[i] - from[i]) / way[i]; way[i] != 0 && 0 < share && share < end)
        levels.push_back({share, i, p[i]});
  std::ranges::stable_sort(levels, {}, [&](const Level& l) { return std::abs(l.share - wish); });
  std::vector<Landmark> found;
  for (const Level& level : levels) {
    if (found.size() == most) break;
    Vec3 place = from + level.share * way;
    place[level.axis] = level.value;  // exact, without the product's rounding
    Parameters dragged = setting;
    if (drag(lesson, dragged, handle, place)) continue;
    if (std::ranges::none_of(found, [&](const Landmark& l) { return l.setting == dragged; }))
      found.push_back({level.share, std::move(dragged)});
  }
  return found;
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
