#pragma once
// A number of which only is known whether it must be 0: the cheapest arithmetic that settles a sum of products when
// each has a factor 0, as in the many ties of shapes along the axes.
//
// It knows that of a leaf or a difference by looking, of a sum when both terms are 0, of a product when one factor is.
// x y - y x is 0 too, but not to it. Arguments must be finite: infinity times 0 is not 0.

#include <optional>

namespace isect {

class Nought {
 public:
  Nought() = default;
  Nought(double x) : holds_(x == 0) {}

  static Nought difference(double x, double y) { return Nought(x == y ? 0. : 1.); }

  friend Nought operator+(Nought a, Nought b) { return Nought(a.holds_ && b.holds_ ? 0. : 1.); }
  friend Nought operator-(Nought a, Nought b) { return a + b; }
  friend Nought operator*(Nought a, Nought b) { return Nought(a.holds_ || b.holds_ ? 0. : 1.); }
  friend Nought operator-(Nought a) { return a; }
  friend Nought abs(Nought a) { return a; }

  /// 0, or nothing where that is not known.
  std::optional<int> sign() const { return holds_ ? std::optional(0) : std::nullopt; }

 private:
  bool holds_ = true;
};

}  // namespace isect
