#include "viz/walk/question_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

bool tells(Role role) { return role == Role::hit || role == Role::miss; }

/// Whether an item may give an answer away where it is new.
struct GivesAway {
  bool operator()(const Dot& it) const { return tells(it.role) || (it.mark != Mark::disc && it.mark != Mark::ring); }
  bool operator()(const Heading& it) const {
    return tells(it.role) || std::ranges::any_of(it.text, [](char c) { return c >= '0' && c <= '9'; });
  }
  bool operator()(const RightAngle&) const { return false; }
  bool operator()(const Raster&) const { return true; }
  bool operator()(const Ball& it) const { return tells(it.role); }
  bool operator()(const Label& it) const { return tells(it.role); }
  bool operator()(const Solid& it) const { return tells(it.role); }
  bool operator()(const Mesh& it) const { return tells(it.role); }
  bool operator()(const auto& line) const { return tells(line.role) || line.pen == Pen::excluded; }
};

/// The points of an item, whatever part it plays there.
struct Positions {
  std::vector<Vec3> operator()(const Dot& it) const { return {it.at}; }
  std::vector<Vec3> operator()(const Line& it) const { return {it.from, it.to}; }
  std::vector<Vec3> operator()(const Arrow& it) const { return {it.from, it.to}; }
  std::vector<Vec3> operator()(const Span& it) const { return {it.from, it.to}; }
  std::vector<Vec3> operator()(const Ball& it) const { return {it.center, Vec3::Constant(it.radius)}; }
  std::vector<Vec3> operator()(const Circle& it) const { return {it.center, Vec3::Constant(it.radius), it.normal}; }
  std::vector<Vec3> operator()(const Chain& it) const { return it.points; }
  std::vector<Vec3> operator()(const Region& it) const {
    std::vector<Vec3> all;
    for (const std::vector<Vec3>& ring : it.rings) all.insert(all.end(), ring.begin(), ring.end());
    return all;
  }
  std::vector<Vec3> operator()(const Solid& it) const { return it.vertices; }
  std::vector<Vec3> operator()(const Mesh& it) const { return it.vertices; }
  std::vector<Vec3> operator()(const Raster& it) const { return {it.corner, it.across, it.down}; }
  std::vector<Vec3> operator()(const RightAngle& it) const { return {it.at, it.a, it.b}; }
  std::vector<Vec3> operator()(const Label& it) const {
    return it.until ? std::vector<Vec3>{it.at, *it.until} : std::vector<Vec3>{it.at};
  }
  std::vector<Vec3> operator()(const Heading& it) const { return {it.at}; }
};

std::vector<Vec3> positions(const Item& item) { return std::visit(Positions{}, item); }

/// The part it plays, as far as GivesAway asks.
struct Part {
  std::pair<Role, int> operator()(const Dot& it) const { return {it.role, static_cast<int>(it.mark)}; }
  std::pair<Role, int> operator()(const RightAngle&) const { return {}; }
  std::pair<Role, int> operator()(const Raster&) const { return {}; }
  std::pair<Role, int> operator()(const auto& it) const {
    if constexpr (requires { it.pen; })
      return {it.role, static_cast<int>(it.pen)};
    else
      return {it.role, 0};
  }
};

bool same_part(const Item& a, const Item& b) {
  if (std::visit(Part{}, a) != std::visit(Part{}, b)) return false;
  if (const Label* label = std::get_if<Label>(&a)) return label->text == std::get<Label>(b).text;
  if (const Heading* heading = std::get_if<Heading>(&a)) return heading->text == std::get<Heading>(b).text;
  return true;
}

bool stands_in(const Scene& scene, const Item& item) {
  return std::ranges::any_of(scene.items, [&](const Item& other) {
    return other.index() == item.index() && positions(other) == positions(item) && same_part(other, item);
  });
}

/// Returns the item that stood at this item's place in `before` and no longer stands there.
const Item* replaced(const Item& item, const Scene& before, const Scene& after) {
  const auto found = std::ranges::find_if(before.items, [&](const Item& old) {
    return old.index() == item.index() && positions(old) == positions(item) && !stands_in(after, old);
  });
  return found == before.items.end() ? nullptr : &*found;
}

bool has_raster(const Scene& scene) {
  return std::ranges::any_of(scene.items, [](const Item& item) { return std::holds_alternative<Raster>(item); });
}

/// Returns a t-axis without what gives the answer away.
std::optional<Axis> asked_axis(std::optional<Axis> axis) {
  if (!axis) return axis;
  axis->shared.reset();
  std::erase_if(axis->ticks, [](const Axis::Tick& tick) { return tells(tick.role) || tick.role == Role::highlight; });
  return axis;
}

/// Leaves out what is new in `after` and gives the answer away, or leaves it as it was before.
Scene without_answer(const Scene& after, const Scene& before) {
  Scene scene = after;
  scene.axis = before.axis ? before.axis : asked_axis(after.axis);
  scene.items.clear();
  std::vector<Vec3> left_out;
  for (const Item& item : after.items) {
    const Label* label = std::get_if<Label>(&item);
    const bool names_nothing = label && std::ranges::find(left_out, label->at) != left_out.end();
    if (stands_in(before, item) || (!names_nothing && !std::visit(GivesAway{}, item)))
      scene.items.push_back(item);
    else if (const Item* old = replaced(item, before, after))
      scene.items.push_back(*old);
    else if (const Dot* dot = std::get_if<Dot>(&item))
      left_out.push_back(dot->at);
  }
  return scene;
}

std::vector<std::string> words_of(const std::string& markup) {
  std::istringstream text(plain(markup));
  return {std::istream_iterator<std::string>(text), {}};
}

/// Whether two thirds of the words of the longer prompt occur in the other one, too, in the same order.
bool alike(const std::string& a, const std::string& b) {
  const std::vector<std::string> x = words_of(a), y = words_of(b);
  std::vector<std::size_t> common(y.size() + 1, 0);  // the longest common subsequence with the words so far
  for (const std::string& word : x) {
    std::vector<std::size_t> longer = common;
    for (std::size_t j = 1; j <= y.size(); ++j)
      longer[j] = std::max({longer[j - 1], common[j], word == y[j - 1] ? common[j - 1] + 1 : 0});
    common = std::move(longer);
  }
  return 3 * common.back() >= 2 * std::max(x.size(), y.size());
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

const Value* named(const std::vector<Value>& values, const std::string& name) {
  const auto found = std::ranges::find(values, name, &Value::name);
  return found == values.end() ? nullptr : &*found;
}

/// Whether the question is given this value, under its own name or as it was before the step.
bool is_given(const Question& question, const Value& value) {
  return named(question.given, value.name) || named(question.given, before(value).name);
}

/// Whether the walk gives it this number wherever the walk mentions it.
bool is_constant(const Walk& walk, const Value& value) {
  return std::ranges::all_of(walk.steps, [&](const Step& step) {
    const Value* there = named(step.values, value.name);
    return !there || same_number(there->value, value.value);
  });
}

/// Returns the step's refused or untaken `lines` that were so before it already, or became so at the step before,
/// without the line that it asks about.
std::vector<int> known_lines(const std::vector<int>& lines, const std::vector<int>& before, int line_before, int line) {
  std::vector<int> known;
  std::ranges::copy_if(lines, std::back_inserter(known),
                       [&](int l) { return l != line && (l == line_before || std::ranges::count(before, l) > 0); });
  return known;
}

const std::string& answer(const Question& q) { return q.choices.at(static_cast<std::size_t>(q.answer)); }

}  // namespace

Value before(Value value) {
  value.name = tr("{value} before", {{"value", value.name}});
  return value;
}

std::vector<Value> known_values(const Walk& walk, int step) {
  const Step& asked = walk.steps[static_cast<std::size_t>(step)];
  std::vector<Value> known;
  if (step > 0)
    std::ranges::copy_if(asked.values, std::back_inserter(known), [&](const Value& value) {
      return named(walk.steps[static_cast<std::size_t>(step) - 1].values, value.name) &&
             !is_given(*asked.question, value) && is_constant(walk, value);
    });
  known.insert(known.end(), asked.question->given.begin(), asked.question->given.end());
  for (Value& value : known) value.fresh = false;
  return known;
}

Step asking_step(const Walk& walk, int step) {
  const Step& asked = walk.steps.at(static_cast<std::size_t>(step));
  Step shown;
  shown.slug = asked.slug;
  shown.question = asked.question;
  shown.view = asked.view;
  shown.scene = question_scene(walk, step);
  shown.scene.time.reset();  // bodies that run on would show the answer
  shown.scene.grid.reset();  // and so would all items, in other columns
  shown.values = known_values(walk, step);
  if (step == 0) return shown;
  const Step& before = walk.steps[static_cast<std::size_t>(step) - 1];
  shown.refused = known_lines(asked.refused, before.refused, before.line, asked.line);
  shown.untaken = known_lines(asked.untaken, before.untaken, -1, asked.line);
  shown.counters = before.counters;
  shown.counters.early_out = before.counters.early_out && asked.counters.early_out;
  if (before.verdict.kind == asked.verdict.kind && before.verdict.text == asked.verdict.text)
    shown.verdict = asked.verdict;
  return shown;
}

void ask_once(Walk& walk) {
  std::vector<const Question*> asked;
  for (Step& step : walk.steps) {
    if (!step.question) continue;
    const Question& q = *step.question;
    const bool again = std::ranges::any_of(asked, [&](const Question* earlier) {
      return answer(*earlier) == answer(q) && alike(earlier->prompt, q.prompt);
    });
    if (again)
      step.question.reset();
    else
      asked.push_back(&q);
  }
}

Scene opening_scene(const Step& first) {
  if (first.question->over) return *first.question->over;
  Scene scene = first.scene;
  scene.axis = asked_axis(scene.axis);
  std::vector<std::vector<Vec3>> left_out;
  std::erase_if(scene.items, [&](const Item& item) {
    const Role role = std::visit(Part{}, item).first;
    const bool found = tells(role) || role == Role::highlight;
    if (found) left_out.push_back(positions(item));
    return found;
  });
  std::erase_if(scene.items, [&](const Item& item) {
    return std::holds_alternative<Label>(item) && std::ranges::find(left_out, positions(item)) != left_out.end();
  });
  return scene;
}

Scene question_scene(const Walk& walk, int step) {
  const Step& asked = walk.steps.at(static_cast<std::size_t>(step));
  if (step == 0) return opening_scene(asked);
  const Scene& before = walk.steps.at(static_cast<std::size_t>(step) - 1).scene;
  const Scene& after = asked.scene;
  if (asked.question->over) return *asked.question->over;
  if (before.chart || after.chart || has_raster(after)) return before;
  return without_answer(after, before);
}

}  // namespace isect::viz
