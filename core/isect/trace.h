#pragma once
// What an algorithm reports while it runs, and how to listen.
//
// Most algorithms take a last parameter `Trace&& trace = {}` and call it with typed events that copy values they
// have computed anyway. The default listener does nothing and costs nothing: the machine code equals that
// of the text with its trace lines deleted (tests/core/zero_cost_trace.cmake compares the two).

#include <type_traits>
#include <variant>
#include <vector>

#include <isect/conventions.h>

namespace isect {

/// Listens to nothing.
struct NoTrace {
  template <class Event>
  constexpr void operator()(const Event&) const {}
};

/// Keeps every event in order. `Event` is the header's own std::variant, such as ray_sphere::Event.
template <class Event>
struct Record {
  std::vector<Event> events;

  template <class E>
  void operator()(const E& event) {
    events.emplace_back(event);
  }
};

/// Whether anyone listens: where an event's values cost something to make, `if constexpr (heard<Trace>)`
/// guards it.
template <class Trace>
inline constexpr bool heard = !std::is_base_of_v<NoTrace, std::remove_cvref_t<Trace>>;

/// The arithmetic in use could not decide; the same text runs again in a finer one. Later events are rounded
/// to S.
struct Fallback {};

}  // namespace isect
