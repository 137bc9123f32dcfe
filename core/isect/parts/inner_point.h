#pragma once
// A point inside a convex solid given by half-spaces (isect/half_spaces.h): a mean of some of its corners, which do not
// all lie on one face. Each is where three faces meet, p / w by Cramer's rule with w > 0, and is weighed by its w: the
// point is sum p / sum w, which need not be a point of doubles. Nothing is rounded.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <isect/half_spaces.h>

namespace isect {

/// A place in the sense of isect/parts/mesh_surface.h.
class InnerPoint {
 public:
  template <PolynomialScalar W>
  Components<W, 3> way_to(const Point<double, 3>& x) const {
    Components<W, 3> sum = {W(0), W(0), W(0)};
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const inequalities::Row<W> corner = weighed<W>(i);
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] = sum[k] + (corner[3] * W(x[static_cast<Eigen::Index>(k)]) - corner[k]);
    }
    return sum;
  }
  Point<double, 3> least() const { return Point<double, 3>::Constant(-std::numeric_limits<double>::infinity()); }

 private:
  friend std::optional<InnerPoint> inner_point(const HalfSpaces& solid);

  struct Corner {
    std::array<int, 3> faces;
    int side;  ///< the sign of their determinant
    inequalities::Row<Bounded<double>> quick;
  };

  explicit InnerPoint(const std::vector<half_spaces::Face>& faces) : faces_(faces) {}

  void add(const std::array<int, 3>& faces, int side) {
    corners_.push_back({faces, side, {}});
    corners_.back().quick = at_corner<Bounded<double>>(corners_.back());
  }

  /// p, then w.
  template <PolynomialScalar W>
  inequalities::Row<W> weighed(std::size_t i) const {
    if constexpr (std::is_same_v<W, Bounded<double>>)
      return corners_[i].quick;
    else
      return at_corner<W>(corners_[i]);
  }
  template <PolynomialScalar W>
  inequalities::Row<W> at_corner(const Corner& corner) const {
    const auto row = [&](std::size_t i) {
      return half_spaces::detail::row<W>(faces_[static_cast<std::size_t>(corner.faces[i])]);
    };
    const inequalities::Row<W> x = row(0), y = row(1), z = row(2);
    const Components<W, 3> p = inequalities::detail::corner(x, y, z);
    inequalities::Row<W> at = {p[0], p[1], p[2], inequalities::detail::determinant(x, y, z)};
    if (corner.side < 0)
      for (W& number : at) number = -number;
    return at;
  }

  std::vector<half_spaces::Face> faces_;
  std::vector<Corner> corners_;  ///< at most four: each leads out of the plane, line or point of those before it
};

/// Finds a point inside the solid; nothing where no corners span it: it has no interior, or is unbounded.
inline std::optional<InnerPoint> inner_point(const HalfSpaces& solid) {
  InnerPoint inner(solid.faces);
  const auto text = half_spaces::detail::text_of(solid.faces);
  const inequalities::detail::Rows rows(half_spaces::detail::count(solid.faces), text);
  std::vector<int> holding_all;
  for (int i = 0; i < rows.count(); ++i) holding_all.push_back(i);
  const auto take = [&](int i, int j, int k, int side) {
    const auto leaves = [&](int face) {
      if (face == i || face == j || face == k) return false;
      return sign_of<long_text>([&]<class W>() -> W {
               return inequalities::detail::value_at_corner(rows.template row<W>(face), rows.template row<W>(i),
                                                            rows.template row<W>(j), rows.template row<W>(k));
             }) != 0;
    };
    if (std::erase_if(holding_all, leaves) > 0) inner.add({i, j, k}, side);
    return !holding_all.empty();
  };
  inequalities::detail::each_corner(rows, take, NoTrace());
  return holding_all.empty() ? std::optional(std::move(inner)) : std::nullopt;
}

}  // namespace isect
