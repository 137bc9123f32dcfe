#pragma once
// The folder that figures go to: DIR/<lesson>/<preset>/<NN>-<slug>.<format>, the alt text beside, and one manifest.json
// that lists all figures there. Whatever isect did not make stays as it is.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lessons/program/options.h"

namespace isect::program {

class Gallery {
 public:
  /// Throws viz::BadInput where the folder holds baselines, and viz::FileError where a manifest.json, or a file where one
  /// of these figures goes, is not isect's. Nothing is written yet.
  Gallery(std::string folder, const Program&, const std::vector<Excerpt>&,
          const std::vector<std::string>& formats);

  /// The figure, its alt text, and its line for the manifest; returns where the figure is.
  std::string add(const Excerpt&, int step, const std::string& format, const std::string& bytes,
                  nlohmann::ordered_json about);
  /// Takes away figures that isect made for this folder, of steps that the walk no longer has, with their alt texts.
  /// Returns how many.
  std::size_t remove_stale(const Excerpt&);
  /// Merges what was added into the manifest, which may have grown meanwhile.
  void list();

 private:
  using Entries = std::map<std::string, nlohmann::ordered_json>;  ///< by file

  std::string path(const std::string& file) const;
  Entries read_manifest() const;
  bool is_ours(const std::string& file) const;

  std::string folder_;
  Entries listed_;  ///< before this run
  Entries added_;
};

}  // namespace isect::program
