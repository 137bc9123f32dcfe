#pragma once
// What a scene's lesson knows from one setting to the next: of many objects only one is moved at a time.

#include <algorithm>
#include <map>
#include <mutex>
#include <string>

#include "app/scene/object_pictures.h"
#include "app/scene/pair_answers.h"

namespace isect::program::scene {

class Known {
 public:
  PairAnswers pairs;
  ObjectPictures pictures;
  /// The verdicts for which the author of the scene wrote own words, by index of what is asked: those of the first
  /// walk.
  std::map<std::size_t, std::string> written_for = {};

  /// Uses these numbers from now on, and forgets what was known of objects that have others.
  void move_to(const File& file, const viz::Parameters& parameters) {
    for (std::size_t i = 0; i < file.objects.size(); ++i)
      if (!same(file.objects[i], parameters)) pairs.forget(i), pictures.forget(i);
    numbers_ = parameters;
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
};

/// It is shared by a lesson and its copies.
struct KnownScene {
  std::mutex busy;
  Known known = {};
};

}  // namespace isect::program::scene
