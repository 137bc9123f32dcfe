#pragma once
// The answers about pairs of a scene's objects, kept from one setting to the next.

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/scene/answered.h"

namespace isect::program::scene {

/// The answers about pairs, kept while their objects stay: of many objects only one is moved at a time.
class PairAnswers {
 public:
  using Answer = std::shared_ptr<const Answered>;

  /// Uses these numbers from now on.
  void move_to(const File& file, const viz::Parameters& parameters) {
    for (const Object& o : file.objects)
      if (!same(o, parameters))
        std::erase_if(known_, [&](const auto& one) {
          return &file.objects[one.first.first] == &o || &file.objects[one.first.second] == &o;
        });
    numbers_ = parameters;
  }
  Answer of(const Context& context, const PairAsked& asked) {
    Answer& answer = known_[{asked.a, asked.b}];
    if (answer) return answer;
    Answered made = answered(context, asked);
    made.json = {};  // no step needs it
    return answer = std::make_shared<const Answered>(std::move(made));
  }

 private:
  bool same(const Object& o, const viz::Parameters& parameters) const {
    const auto stays = [&](const std::string& field) {
      const auto was = numbers_.find(o.name + "." + field), is = parameters.find(o.name + "." + field);
      if (was == numbers_.end() || is == parameters.end()) return was == numbers_.end() && is == parameters.end();
      return was->second == is->second;
    };
    return std::ranges::all_of(o.fields, stays) && stays("at");
  }

  viz::Parameters numbers_;
  std::map<std::pair<std::size_t, std::size_t>, Answer> known_;
};

}  // namespace isect::program::scene
