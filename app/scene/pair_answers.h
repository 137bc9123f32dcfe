#pragma once
// The answers about pairs of a scene's objects, kept while both objects stay.

#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "app/scene/answered.h"

namespace isect::program::scene {

class PairAnswers {
 public:
  using Answer = std::shared_ptr<const Answered>;

  /// Says that object number `i` has other numbers.
  void forget(std::size_t i) {
    std::erase_if(known_, [i](const auto& one) { return one.first.first == i || one.first.second == i; });
  }
  Answer of(const Context& context, const PairAsked& asked) {
    Answer& answer = known_[{asked.a, asked.b}];
    if (answer) return answer;
    Answered made = answered(context, asked);
    made.json = {};  // no step needs it
    return answer = std::make_shared<const Answered>(std::move(made));
  }

 private:
  std::map<std::pair<std::size_t, std::size_t>, Answer> known_;
};

}  // namespace isect::program::scene
