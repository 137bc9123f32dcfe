#pragma once
// The words and the rules that every test shares.
//
// Sets        All shapes are closed: a common point, even a single one, is an intersection.
// Exactness   Every verdict is the true one for the real numbers that the floating-point arguments denote.
//             There is no hidden epsilon; a tolerance is a named argument.
// Rays        r(t) = o + t d with t in a closed range, in units of |d|. A zero direction makes the ray a point.
// Empty       An interval, box or slab with lo > hi, a radius or half-length below 0, a cylinder or cone without axis,
//             a plane whose normal is 0: such a shape has no point, and is disjoint from everything.
// Thin sets   A segment, a triangle in space or a flat box has its interior within the line or plane that it spans, a
//             point is its own: a plate that pierces a solid overlaps it, one on its face touches it.
// NaN, inf    A shape with a coordinate that is NaN or infinite meets nothing, even where its numbers are only
//             compared. Only the range of a ray and an interval by itself may be infinite.
// Signs       -0 equals +0. Frame: right-handed, y up, radians, counter-clockwise seen from outside.

#if __cplusplus <= 201703L
#error "isect needs C++20: build with -std=c++20 or later"
#endif

#include <cfloat>

#if defined(__FAST_MATH__)
#error "isect needs IEEE arithmetic: build without -ffast-math"
#endif
// See core/CMakeLists.txt for the options that no macro shows: -ffp-contract=off, and -fno-tree-slp-vectorize with GCC.
static_assert(FLT_EVAL_METHOD == 0, "isect needs arithmetic in the type itself: build with -mfpmath=sse");

namespace isect {

/// How two sets lie; where several hold, the first.
enum class Relation {
  disjoint,    ///< no common point
  equal,       ///< the same set
  a_inside_b,  ///< A is a subset of B, inner tangency included
  b_inside_a,  ///< B is a subset of A, inner tangency included
  touching,    ///< common points, but none is interior to both
  overlapping  ///< some point is interior to both, and neither contains the other
};

/// The relation of B to A, from that of A to B.
constexpr Relation reversed(Relation r) {
  if (r == Relation::a_inside_b) return Relation::b_inside_a;
  return r == Relation::b_inside_a ? Relation::a_inside_b : r;
}

/// Where a point lies with respect to a set: in its interior, on its boundary, or outside.
enum class Location { in, on, out };

/// How a shape lies to a view volume. `crossing` is the rest: it may still be outside, near an edge of the volume.
enum class Culling { outside, inside, crossing };

// Whether code shall be small and quick to compile rather than fast: a build says so by ISECT_SMALL_CODE, or -Os. All
// answers are the same, bit for bit. Then nothing runs in plain doubles first, what doubles leave open is settled by
// isect/numbers/recorded.h, and the operations of numbers may stay calls.
#if defined(ISECT_SMALL_CODE) || defined(__OPTIMIZE_SIZE__)
inline constexpr bool small_code = true;
#define ISECT_INLINE inline
#else
inline constexpr bool small_code = false;
#define ISECT_INLINE [[gnu::always_inline]] inline
#endif

}  // namespace isect
