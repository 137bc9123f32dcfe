#pragma once
// What the best order of some tests costs, found by trying all orders.

#include <algorithm>
#include <cmath>

namespace isect::tests {

/// Returns the least of cost(order) over all orders; the one given is sorted.
template <class Order, class Cost>
double least_of_all_orders(Order order, const Cost& cost) {
  double least = INFINITY;
  do least = std::min<double>(least, cost(order));
  while (std::ranges::next_permutation(order).found);
  return least;
}

}  // namespace isect::tests
