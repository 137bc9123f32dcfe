// The file that compiles isect/ask.h: any two shapes.

#include <algorithm>

#include <isect/ask.h>

#include "app/query/results.h"
#include "app/scene/pairs.h"

namespace isect::program::scene {

namespace {

Answer decided(const std::optional<Answer>& answer) {
  if (!answer) throw NotDecided("no test is made for the two shapes");
  return *answer;
}

}  // namespace

Answer by_core(const Shaped& a, const Shaped& b) {
  return decided(a.flat() ? isect::ask(a.shape<2>(), b.shape<2>()) : isect::ask(a.shape<3>(), b.shape<3>()));
}

Answer by_core(const viz::Vec3& p, const Shaped& o) {
  return o.flat() ? isect::ask(point_of<2>(p), o.shape<2>()) : isect::ask(point_of<3>(p), o.shape<3>());
}

Answer by_core(const Ray<double, 3>& x, const Shaped& o) { return decided(isect::ask(x, o.shape<3>())); }
Answer by_core(const Triangle<double, 3>& x, const Shaped& o) { return decided(isect::ask(x, o.shape<3>())); }

void give(Relation r, Told& out) {
  out.answer = answer(r);
  out.result = {{"relation", query::name(r)}};
}

void relate(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result =
      out.answer.relation ? Json{{"relation", query::name(*out.answer.relation)}} : Json{{"meet", out.answer.meet}};
}

void locate(const Shaped& a, const Shaped& b, Told& out) {
  out.answer = by_core(a, b);
  out.result = query::located(*out.answer.location);
}

void tell_first(const std::optional<double>& t, Told& out) {
  out.answer.meet = t.has_value(), out.answer.t = t;
  out.result = {{"hit", out.answer.meet}};
  if (t) out.result["t"] = query::number(*t);
}

void tell_part(const std::optional<Interval<double>>& part, Told& out) {
  out.answer = answer(part);
  out.result = part ? query::stretch(part) : Json{{"hit", false}};
}

bool lies_on(const viz::Vec3& p, const Shaped& o) {
  if (o.type() == Type::cloud) return std::ranges::find(o.points(), p) != o.points().end();
  return by_core(p, o).meet;
}

}  // namespace isect::program::scene
