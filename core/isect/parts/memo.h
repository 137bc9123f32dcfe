#pragma once
// Values that a text needs again and again, such as a normal, or a point by numerator and denominator: each is found
// once in each arithmetic that asks for it. Where steps are recorded it is found anew, as it is no number yet.

#include <memory>
#include <new>
#include <tuple>
#include <type_traits>

#include <isect/numbers/predicate.h>

namespace isect {

/// The type by which a text gets what is kept in W between its runs: by reference, or anew.
template <class W, class Kept>
using kept_t = std::conditional_t<std::is_same_v<W, Recorded>, Kept, const Kept&>;

namespace detail {
/// Memory for a T. A std::optional<T> would be filled with zeros first, and an Exact takes 1,700 bytes.
template <class T>
union Slot {
  T value;

  Slot() {}
  ~Slot() {}
};

/// Holds a Value<W> for each W in which it was found.
template <template <class> class Value, class... W>
class MemoSlots {
 public:
  MemoSlots() = default;
  MemoSlots(const MemoSlots&) {}  // a copy finds anew
  MemoSlots& operator=(const MemoSlots&) = delete;
  ~MemoSlots() { (forget<W>(), ...); }

  template <class V, class Find>
  ISECT_INLINE const Value<V>& once(const Find& find) {
    Value<V>& value = std::get<Slot<Value<V>>>(slots_).value;
    if ((known_ & bit<V>) == 0) new (&value) Value<V>(find());
    known_ |= bit<V>;
    return value;
  }

 private:
  template <class V>
  static constexpr unsigned bit = [] {
    unsigned mine = 0, next = 1;
    ((mine |= std::is_same_v<V, W> ? next : 0, next <<= 1), ...);
    return mine;
  }();
  template <class V>
  void forget() {
    if constexpr (!std::is_trivially_destructible_v<Value<V>>)
      if ((known_ & bit<V>) != 0) std::destroy_at(&std::get<Slot<Value<V>>>(slots_).value);
  }

  unsigned known_ = 0;
  std::tuple<Slot<Value<W>>...> slots_;
};
}  // namespace detail

template <template <class> class Value>
class Memo {
 public:
  /// Returns what find() returned when it was first called in W.
  template <PolynomialScalar W, class Find>
  ISECT_INLINE kept_t<W, Value<W>> in(const Find& find) const {
    if constexpr (std::is_same_v<W, Recorded>)
      return find();
    else
      return found_.template once<W>(find);
  }

 private:
  mutable detail::MemoSlots<Value, Bounded<double>, Grid, CompensatedBy<false>, CompensatedBy<true>, TripleDouble,
                            Bounded<DoubleDouble>, ShortExact, MediumExact, Exact>
      found_;
};

}  // namespace isect
