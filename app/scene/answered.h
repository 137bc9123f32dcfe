#pragma once
// A question about a scene with its exact answer, ready to become a step, a row of the summary and JSON.

#include <map>
#include <string>
#include <vector>

#include "app/scene/file.h"
#include "app/scene/shapes.h"

namespace isect::program::scene {

/// A scene's objects with their current numbers.
struct Context {
  const File& file;
  NamedValues numbers;
  Room room;
  mutable std::map<std::size_t, Shaped> shapes = {};  ///< of the objects asked about so far

  const Object& object(std::size_t i) const { return file.objects[i]; }
  const Shaped& shaped(std::size_t i) const { return shapes.try_emplace(i, numbers, object(i)).first->second; }
  std::string name(std::size_t i) const;  ///< as markup
};

struct Answered {
  std::string slug;
  std::string title, caption;  ///< markup
  viz::Verdict verdict;
  std::string formula = {};
  std::vector<viz::Value> values = {};
  std::vector<std::size_t> lit = {};  ///< the objects that it is about; if two, the first and the second
  std::vector<viz::Item> items = {};  ///< drawn with them
  Json json = {};                     ///< for `isect scene --json`
};

/// Answer the question. Throw viz::BadInput if the core refuses the input, naming the objects.
Answered answered(const Context&, const PairAsked&);
Answered answered(const Context&, const FirstHitAsked&);
Answered answered(const Context&, const FitAsked&);
Answered answered(const Context&, const ClipAsked&);
Answered answered(const Context&, const HierarchyAsked&);
Answered answered(const Context&, const WalkAsked&);

/// Returns a name as a part of a file's name: small letters, digits and hyphens.
std::string slug_of(std::string text);

}  // namespace isect::program::scene
