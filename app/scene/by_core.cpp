// Two objects as any two shapes of the core.

#include <algorithm>

#include <isect/ask_any.h>

#include "app/query/results.h"
#include "app/scene/pairs.h"

namespace isect::program::scene {

namespace {

Answer decided(const std::optional<Answer>& answer) {
  if (!answer) throw NotDecided("no test is made for the two shapes");
  return *answer;
}

Answer asked_in_space(const AnyShape<double, 3>& a, const Shaped& b) { return decided(ask_any(a, b.shape<3>())); }

}  // namespace

Answer by_core(const Shaped& a, const Shaped& b) {
  return a.flat() ? ask_any(a.shape<2>(), b.shape<2>()) : asked_in_space(a.shape<3>(), b);
}

Answer by_core(const viz::Vec3& p, const Shaped& o) {
  return o.flat() ? ask_any(point_of<2>(p), o.shape<2>()) : asked_in_space(point_of<3>(p), o);
}

Answer by_core(const Ray<double, 3>& x, const Shaped& o) { return asked_in_space(x, o); }
Answer by_core(const Triangle<double, 3>& x, const Shaped& o) { return asked_in_space(x, o); }

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
