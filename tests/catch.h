#pragma once
// Catch2's headers, 2.x or 3.x, in one place.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>

#include <string>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

namespace isect::test {
#ifdef CATCH_ALL_HPP_INCLUDED
/// Matches a text that has this part; Catch2 2.x has it under this name.
inline auto Contains(const std::string& part) { return Catch::Matchers::ContainsSubstring(part); }
#else
using Catch::Matchers::Contains;
#endif
}  // namespace isect::test
