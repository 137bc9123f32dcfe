#pragma once
// Where a point lies: in, on the boundary or out, in words.

#include <string>

#include <isect/conventions.h>
#include "lessons/shared/opinions.h"

namespace isect::lessons {

inline std::string verdict_text(Location l) {
  return l == Location::in ? "IN" : l == Location::on ? "ON the boundary" : "OUT";
}
inline viz::Verdict::Kind verdict_kind(Location l) {
  return l == Location::in   ? viz::Verdict::Kind::yes
         : l == Location::on ? viz::Verdict::Kind::on
                             : viz::Verdict::Kind::no;
}

/// "on its boundary": for alt texts, after "a point that lies".
inline std::string lies(Location l) {
  return l == Location::in ? "inside" : l == Location::on ? "on its boundary" : "outside";
}

/// Where a point lies to a closed polygon. A yes/no method cannot say "on the boundary": there "inside" is right, and
/// "outside" wrong. What is told of the method says so.
class LocationOpinions {
 public:
  explicit LocationOpinions(Location truth)
      : truth_(truth),
        all_(truth == Location::on   ? "on the boundary"
             : truth == Location::in ? "inside"
                                     : "outside") {}

  void add(std::string method, bool inside) {
    const bool on = truth_ == Location::on;
    const std::string said = inside ? "inside" : "outside";
    all_.add(std::move(method), on ? said + on_the_boundary(inside) : said, inside == (truth_ != Location::out));
  }

  void add(std::string method, std::string says, bool agrees) { all_.add(std::move(method), std::move(says), agrees); }

  std::vector<viz::Opinion> take() { return all_.take(); }

 private:
  static std::string on_the_boundary(bool inside) {
    return std::string(inside ? ", as" : ", though") + " the boundary belongs to the polygon (cannot answer ON)";
  }

  Location truth_;
  Opinions all_;
};

}  // namespace isect::lessons
