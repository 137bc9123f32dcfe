#pragma once
// Events of the core as JSON: {"event": "Decision", "a": 1, ...}. A new event needs one line at the end of this file,
// or of the only handler file that uses it: its name and its members' in order.

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <isect/methods/point_polygon.h>
#include <isect/parts/point_segment.h>
#include <isect/point_polygon.h>
#include <isect/trace.h>
#include "app/query/reply.h"

namespace isect::query {

/// A text as a template argument.
template <std::size_t Size>
struct Text {
  char text[Size];
  constexpr Text(const char (&given)[Size]) { std::copy_n(given, Size, text); }
};

/// The name of a type, and those of its members, separated by spaces.
template <Text Name, Text Members = "">
struct Named {
  static constexpr std::string_view name = Name.text, members = Members.text;
  static constexpr int count =
      members.empty() ? 0 : 1 + static_cast<int>(std::count(members.begin(), members.end(), ' '));
};

/// Specialised for every event and every aggregate inside one.
template <class E>
struct EventNames;

/// The names of an enumeration's values in order, as `of`.
template <class E>
struct Names;

template <class E>
Json event(const E&);

namespace detail {

inline Json value(bool x) { return x; }
inline Json value(Location x) { return name(x); }
inline Json value(Relation x) { return name(x); }
template <class S>
requires(std::is_arithmetic_v<S> || std::is_enum_v<S>) Json value(S x) {
  if constexpr (std::is_floating_point_v<S>)
    return number(x);
  else if constexpr (requires { Names<S>::of; })
    return Names<S>::of[static_cast<int>(x)];
  else
    return static_cast<int>(x);
}
template <class S, int N>
Json value(const Vector<S, N>& v) {
  return numbers<S, N>(v);
}
template <class S>
Json value(const Interval<S>& x) {
  return {number(x.lo), number(x.hi)};
}
template <class S, int N>
Json value(const Aabb<S, N>& box) {
  return {{"lo", numbers<S, N>(box.lo)}, {"hi", numbers<S, N>(box.hi)}};
}
template <class X, std::size_t N>
Json value(const std::array<X, N>& list) {
  Json all = Json::array();
  for (const X& x : list) all.push_back(value(x));
  return all;
}
template <class X>
Json value(const std::optional<X>& x) {
  return x ? value(*x) : Json(nullptr);
}
template <class E>
requires requires { EventNames<E>::name; }
Json value(const E& inner) {
  Json object = event(inner);
  object.erase("event");
  return object;
}

/// Returns the members by position; a wrong count of names does not compile.
template <class E>
std::vector<Json> members(const E& e) {
  constexpr int count = EventNames<E>::count;
  static_assert(count <= 6);
  if constexpr (count == 0) {
    static_assert(std::is_empty_v<E>);
    return {};
  } else if constexpr (count == 1) {
    const auto& [a] = e;
    return {value(a)};
  } else if constexpr (count == 2) {
    const auto& [a, b] = e;
    return {value(a), value(b)};
  } else if constexpr (count == 3) {
    const auto& [a, b, c] = e;
    return {value(a), value(b), value(c)};
  } else if constexpr (count == 4) {
    const auto& [a, b, c, d] = e;
    return {value(a), value(b), value(c), value(d)};
  } else if constexpr (count == 5) {
    const auto& [a, b, c, d, f] = e;
    return {value(a), value(b), value(c), value(d), value(f)};
  } else {
    const auto& [a, b, c, d, f, g] = e;
    return {value(a), value(b), value(c), value(d), value(f), value(g)};
  }
}

}  // namespace detail

/// Returns an object of an event's name and its values, under the names of its members.
inline Json event(std::string_view name, std::string_view members, std::vector<Json> values) {
  Json object = {{"event", name}};
  for (Json& value : values) {
    const std::size_t end = std::min(members.find(' '), members.size());
    object[std::string(members.substr(0, end))] = std::move(value);
    members.remove_prefix(std::min(end + 1, members.size()));
  }
  return object;
}

template <class E>
Json event(const E& e) {
  return event(EventNames<E>::name, EventNames<E>::members, detail::members(e));
}

/// Writes the events as they come, if they are wanted. An ignoring listener would mean compiling each call twice.
struct EventWriter {
  Job& job;

  template <class E>
  void operator()(const E& e) const {
    if (job.traced) tell(job, e);
  }

 private:
  template <class E>
  [[gnu::noinline, gnu::cold]] static void tell(Job& job,
                                                const E& e) {  // one copy, not one for every place that reports it
    job.tell(event(e));
  }
};

/// Runs call(trace). `Event` is the test's own variant of possible events.
template <class Event, class Call>
auto run(Job& job, const Call& call) {
  return call(EventWriter{job});
}

template <>
struct EventNames<Fallback> : Named<"Fallback"> {};

template <>
struct EventNames<point_polygon::Edge> : Named<"Edge", "ring index passage turn"> {};
template <>
struct EventNames<point_polygon::Straddles> : Named<"Straddles", "index holds"> {};
template <class S>
struct EventNames<point_polygon::CrossesAt<S>> : Named<"CrossesAt", "index x holds"> {};
template <class S>
struct EventNames<point_polygon::LeftBy<S>> : Named<"LeftBy", "index area2"> {};
template <>
struct Names<point_polygon::Passage> {
  static constexpr const char* of[] = {"above", "below", "horizontal", "crossed_left", "crossed_right", "on"};
};
template <>
struct Names<point_segment::Nearest> {
  static constexpr const char* of[] = {"p", "q", "between"};
};

}  // namespace isect::query
