#pragma once
// What a text needs again and again, found once in each arithmetic that asks for it: a normal, a point by numerator and
// denominator. Where steps are recorded it is found anew, as it is no number yet.

#include <new>
#include <tuple>
#include <type_traits>

#include <isect/numbers/predicate.h>

namespace isect {

/// How a text gets at what is kept in W between its runs: by reference, or anew.
template <class W, class Kept>
using kept_t = std::conditional_t<std::is_same_v<W, Recorded>, Kept, const Kept&>;

namespace detail {
/// Like std::optional, which would fill its memory with zeros first: an Exact takes 1,700 bytes.
template <class T>
class Found {
 public:
  Found() {}
  Found(const Found&) {}  // a copy finds anew
  ~Found() {
    if (known_) value_.~T();
  }

  template <class Find>
  ISECT_INLINE const T& once(const Find& find) {
    if (!known_) new (&value_) T(find());
    known_ = true;
    return value_;
  }

 private:
  bool known_ = false;
  union {
    T value_;
  };
};
}  // namespace detail

template <template <class> class Value>
class FoundOnce {
 public:
  /// What find() returned when it was first asked for in W.
  template <Filtered W, class Find>
  ISECT_INLINE kept_t<W, Value<W>> in(const Find& find) const {
    if constexpr (std::is_same_v<W, Recorded>)
      return find();
    else
      return std::get<Found<W>>(found_).once(find);
  }

 private:
  template <class W>
  using Found = detail::Found<Value<W>>;
  mutable std::tuple<Found<Bounded<double>>, Found<Grid>, Found<CompensatedBy<false>>, Found<CompensatedBy<true>>,
                     Found<ThreefoldBy<false>>, Found<ThreefoldBy<true>>, Found<Bounded<DoubleDouble>>,
                     Found<ShortExact>, Found<MediumExact>, Found<Exact>>
      found_;
};

}  // namespace isect
