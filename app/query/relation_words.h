#pragma once
// The names of relations in queries, scenes and the files of hard cases.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <isect/conventions.h>

namespace isect::query {

/// In the order of the enumeration: b_contains_a is a_inside_b.
inline constexpr std::array<std::string_view, 6> relation_words = {"disjoint",     "equal", "b_contains_a",
                                                                   "a_contains_b", "touch", "overlap"};

inline std::string name(Relation r) { return std::string(relation_words[static_cast<std::size_t>(r)]); }

}  // namespace isect::query
