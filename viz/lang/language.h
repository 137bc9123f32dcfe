#pragma once
// The languages that texts are written in, and the one that is spoken now.

#include <string>
#include <vector>

namespace isect::viz {

struct Language {
  std::string code;  ///< as in `--lang de`, and in the names of files: "de"
  std::string name;  ///< as its speakers call it: "Deutsch"
};

/// Returns all languages, English first.
const std::vector<Language>& languages();
/// Finds a language by its code. Throws BadInput, which names those that are allowed, if there is none.
const Language& language_named(const std::string& code);

/// Returns the code of the language that this thread speaks: "en" unless a Speaking says otherwise.
const std::string& spoken();

/// Speaks a language until the end of the block, in this thread. An empty code is English.
class Speaking {
 public:
  explicit Speaking(const std::string& code);
  ~Speaking();
  Speaking(const Speaking&) = delete;
  Speaking& operator=(const Speaking&) = delete;

 private:
  const Language* before_;
};

}  // namespace isect::viz
