#pragma once
// What emscripten's library lacks of C++20, as far as we use it: in Debian 12 (libc++ 13) algorithms of std::ranges,
// numbers as text, std::bit_cast; in Debian 13 (libc++ 19) text as numbers. Included before every file of the web
// build, and empty where the library has them.

#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <type_traits>

namespace std {

/// Decimal numbers only. The C library's own reading is exact, and its locale never changes here.
template <class T>
requires is_floating_point_v<T> from_chars_result from_chars(const char* first, const char* last, T& value) {
  const auto digits = [last](const char* at) {
    while (at != last && *at >= '0' && *at <= '9') ++at;
    return at;
  };
  const char* const begin = first != last && *first == '-' ? first + 1 : first;
  const char* end = digits(begin);
  ptrdiff_t count = end - begin;
  if (end != last && *end == '.') {
    const char* const fraction = digits(end + 1);
    count += fraction - (end + 1);
    if (count > 0) end = fraction;
  }
  if (count == 0) return {first, errc::invalid_argument};
  if (end != last && (*end == 'e' || *end == 'E')) {
    const char* exponent = end + 1;
    if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
    if (const char* const after = digits(exponent); after != exponent) end = after;
  }
  const string text(first, end);
  const T read = is_same_v<T, float> ? strtof(text.c_str(), nullptr) : static_cast<T>(strtod(text.c_str(), nullptr));
  const size_t mantissa = min(text.find_first_of("eE"), text.size());
  const bool is_zero = text.find_first_of("123456789") >= mantissa;
  if (!isfinite(read) || (read == 0 && !is_zero)) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc()};
}

}  // namespace std

#endif

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

template <class T>
unique_ptr<T> make_unique_for_overwrite(size_t n) {
  return unique_ptr<T>(new remove_extent_t<T>[n]);
}

/// How many digits the shortest decimal number takes that is read back as the same one.
inline int fewest_digits(double value) {
  int digits = 0, zeros = 0;
  for (const char letter : fmt::format("{}", abs(value))) {
    if (letter == 'e') break;
    if (letter == '0' || letter == '.')
      zeros += digits > 0 && letter == '0';
    else
      digits += zeros + 1, zeros = 0;
  }
  return max(digits, 1);
}

/// The fewest digits that are read back as the same number; fixed or with an exponent, whichever is shorter.
inline to_chars_result to_chars(char* first, char* last, double value) {
  char text[64];
  int length = snprintf(text, sizeof text, "%g", value);
  if (isfinite(value)) {
    const int digits = fewest_digits(value);
    length = snprintf(text, sizeof text, "%.*e", digits - 1, value);
    const int exponent = atoi(strchr(text, 'e') + 1), sign = value < 0 || (value == 0 && signbit(value)) ? 1 : 0;
    const int decimals = max(0, digits - 1 - exponent);
    const int fixed = sign + max(1, exponent + 1) + (decimals > 0 ? decimals + 1 : 0);
    if (fixed <= length) length = snprintf(text, sizeof text, "%.*f", decimals, value);
  }
  if (last - first < length) return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(length));
  return {first + length, errc()};
}

}  // namespace std

namespace std::ranges {

/// A predicate that looks through a projection, which may be a member.
template <class F, class P>
auto projected_call(F& f, P& p) {
  return [&f, &p](const auto& element) -> decltype(auto) { return std::invoke(f, std::invoke(p, element)); };
}
template <class F, class P>
auto projected_order(F& f, P& p) {
  return [&f, &p](const auto& a, const auto& b) -> decltype(auto) {
    return std::invoke(f, std::invoke(p, a), std::invoke(p, b));
  };
}
template <class T, class P>
auto projected_equal(const T& value, P& p) {
  return [&value, &p](const auto& element) { return std::invoke(p, element) == value; };
}

template <class R>
concept has_begin = requires(R& r) {
  std::begin(r);
};

#define ISECT_RANGES_CALL(name)                                         \
  template <has_begin R, class F, class P = identity>                   \
  constexpr auto name(R&& r, F f, P p = {}) {                           \
    return std::name(std::begin(r), std::end(r), projected_call(f, p)); \
  }                                                                     \
  template <class I, class F>                                           \
  requires(!has_begin<I>) constexpr auto name(I first, I last, F f) { return std::name(first, last, f); }
ISECT_RANGES_CALL(any_of)
ISECT_RANGES_CALL(all_of)
ISECT_RANGES_CALL(none_of)
ISECT_RANGES_CALL(find_if)
ISECT_RANGES_CALL(find_if_not)
ISECT_RANGES_CALL(count_if)
ISECT_RANGES_CALL(for_each)
ISECT_RANGES_CALL(stable_partition)
#undef ISECT_RANGES_CALL

#define ISECT_RANGES_ORDER(name)                                         \
  template <class R, class F = std::less<>, class P = identity>          \
  constexpr auto name(R&& r, F f = {}, P p = {}) {                       \
    return std::name(std::begin(r), std::end(r), projected_order(f, p)); \
  }
ISECT_RANGES_ORDER(sort)
ISECT_RANGES_ORDER(stable_sort)
ISECT_RANGES_ORDER(is_sorted)
ISECT_RANGES_ORDER(min_element)
ISECT_RANGES_ORDER(max_element)
#undef ISECT_RANGES_ORDER

template <class R, class T, class P = identity>
constexpr auto find(R&& r, const T& value, P p = {}) {
  return std::find_if(std::begin(r), std::end(r), projected_equal(value, p));
}
template <class R, class T, class P = identity>
constexpr auto count(R&& r, const T& value, P p = {}) {
  return std::count_if(std::begin(r), std::end(r), projected_equal(value, p));
}
template <class R, class F = std::equal_to<>>
constexpr auto adjacent_find(R&& r, F f = {}) {
  return std::adjacent_find(std::begin(r), std::end(r), f);
}
template <class R, class T, class F = std::less<>>
constexpr bool binary_search(R&& r, const T& value, F f = {}) {
  return std::binary_search(std::begin(r), std::end(r), value, f);
}
template <class R, class T>
constexpr void replace(R&& r, const T& from, const T& to) {
  std::replace(std::begin(r), std::end(r), from, to);
}
template <class R, class F, class T>
constexpr void replace_if(R&& r, F f, const T& to) {
  std::replace_if(std::begin(r), std::end(r), f, to);
}
template <class R>
constexpr void reverse(R&& r) {
  std::reverse(std::begin(r), std::end(r));
}
template <class In, class Out>
struct copied {
  In in;
  Out out;
};
template <class R, class Out>
constexpr auto copy(R&& r, Out out) {
  return copied<decltype(std::begin(r)), Out>{std::end(r), std::copy(std::begin(r), std::end(r), out)};
}
template <class R, class Out, class F>
constexpr void copy_if(R&& r, Out out, F f) {
  std::copy_if(std::begin(r), std::end(r), out, f);
}
template <class R, class Out>
constexpr void move(R&& r, Out out) {
  std::move(std::begin(r), std::end(r), out);
}
template <class R, class Out, class F>
constexpr void transform(R&& r, Out out, F f) {
  std::transform(std::begin(r), std::end(r), out, [&f](const auto& x) -> decltype(auto) { return std::invoke(f, x); });
}
template <class R, class S, class Out>
constexpr void merge(R&& r, S&& s, Out out) {
  std::merge(std::begin(r), std::end(r), std::begin(s), std::end(s), out);
}
template <class R, class S, class F = std::equal_to<>>
constexpr bool equal(R&& r, S&& s, F f = {}) {
  return std::equal(std::begin(r), std::end(r), std::begin(s), std::end(s), f);
}

}  // namespace std::ranges

#endif
