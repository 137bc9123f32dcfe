#include "app/scene/questions.h"

#include <algorithm>
#include <iterator>

#include "app/query/relation_words.h"
#include "app/scene/pairs.h"
#include "app/scene/type_words.h"
#include "app/scene/types.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

using viz::Vec3;
using viz::Verdict;

Vec3 direction_of(const NamedValues& s, const Object& o) {
  if (const auto ray = ray_in_space(s, o)) return ray->direction;
  throw NotDecided(
      viz::tr("from one end of {a} to the other is no vector of floating-point numbers, so the test would be of "
              "another segment",
              {{"a", o.name}}));
}

void refuse_outline(const Object& o) {
  throw NotDecided(viz::tr("the outline of {a} has no area, crosses or touches itself", {{"a", o.name}}));
}

namespace {

const std::vector<Pair>& pairs() {
  static const std::vector<Pair> all = [] {
    std::vector<Pair> table;
    for (const auto& some :
         {pairs_of_queries(), pairs_of_sets(), pairs_in_plane(), pairs_of_solids(), pairs_of_polygons()})
      std::ranges::copy(some, std::back_inserter(table));
    return table;
  }();
  return all;
}

const Pair* pair_of(Type a, Type b, bool flat) {
  const auto found = std::ranges::find_if(pairs(), [&](const Pair& p) { return p.a == a && p.b == b && p.fits(flat); });
  return found == pairs().end() ? nullptr : &*found;
}

Told asked_in_order(const Shaped& a, const Shaped& b, const Pair& pair) {
  Told out;
  if (pair.kind) out.query = query_of(pair.kind, a, b);
  pair.ask(a, b, out);
  tell(a, b, out);
  return out;
}

/// Turns the answer about b and a into one about a and b.
Told turned_round(Told out, const Shaped& a, const Shaped& b) {
  if (const std::string other = both_names(b, a); out.verdict.text.starts_with(other))
    out.verdict.text.replace(0, other.size(), both_names(a, b));  // in the order of the question
  const std::optional<Relation> was = out.answer.relation;
  out.answer = reversed(out.answer);
  if (out.query.is_null() && was != out.answer.relation)  // a query's result is about its own fields
    out.result["relation"] = query::name(*out.answer.relation);
  return out;
}

Told not_decided(const Shaped& a, const Shaped& b, const std::string& why) {
  Told out;
  out.open = true;
  out.result = {{"not decided", why}};
  out.verdict = {Verdict::Kind::open,
                 viz::tr("{both}: not decided, as {why}", {{"both", both_names(a, b)}, {"why", viz::as_markup(why)}})};
  return out;
}

}  // namespace

bool is_decided(Type a, Type b, bool flat) { return pair_of(a, b, flat) || pair_of(b, a, flat); }

Told ask(const Shaped& a, const Shaped& b) {
  const Pair* pair = pair_of(a.type(), b.type(), a.flat());
  if (!pair) {
    if (pair_of(b.type(), a.type(), a.flat())) return turned_round(ask(b, a), a, b);
    return not_decided(a, b,
                       viz::tr("no test is made for {a} and {b}",
                               {{"a", article_and_type(a.type())}, {"b", article_and_type(b.type())}}));
  }
  try {
    return asked_in_order(a, b, *pair);
  } catch (const NotDecided& why) {
    return not_decided(a, b, why.what());
  }
}

}  // namespace isect::program::scene
