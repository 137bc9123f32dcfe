#pragma once
// The usual normals of k-DOPs, as integers.
//
//   2D   4: the axes          8: and the diagonals (1, +-1)
//   3D   6: the axes         14: and (1, +-1, +-1)         18: and (1, +-1, 0), ...         26: all of these
//
// k counts planes, two for each normal. The normals are not divided by their lengths: what touches on a grid has
// touching slabs (isect/kdop_kdop.h). Source: Klosowski, Held, Mitchell, Sowizral, Zikan, IEEE TVCG 4 (1998).

#include <stdexcept>
#include <string>
#include <vector>

#include <isect/shapes.h>

namespace isect {

/// The k / 2 normals of a k-DOP: the axes first, then those with two components, then with three; the first component
/// that is not 0 is 1. Throws std::invalid_argument for a k that is not in the table above.
template <class S, int N>
std::vector<Vector<S, N>> directions(int k) {
  static_assert(N == 2 || N == 3);
  const bool diagonals = N == 2 ? k == 8 : k == 18 || k == 26;  // with two components
  const bool corners = N == 3 && (k == 14 || k == 26);          // with three
  if (k != 2 * N && !diagonals && !corners)
    throw std::invalid_argument("directions: no set of " + std::to_string(k) + " planes in " + std::to_string(N) + "D");
  std::vector<Vector<S, N>> normals;
  for (int i = 0; i < N; ++i) normals.push_back(Vector<S, N>::Unit(i));
  for (int i = 0; i < N && diagonals; ++i)
    for (int j = i + 1; j < N; ++j)
      for (const S sign : {S(1), S(-1)}) normals.push_back(Vector<S, N>::Unit(i) + sign * Vector<S, N>::Unit(j));
  if constexpr (N == 3)
    for (int signs = 0; signs < 4 && corners; ++signs)
      normals.push_back({S(1), signs & 1 ? S(-1) : S(1), signs & 2 ? S(-1) : S(1)});
  return normals;
}

}  // namespace isect
