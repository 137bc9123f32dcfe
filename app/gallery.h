#pragma once
// The folder that figures go to: DIR/<lesson>/<preset>/<NN>-<slug>.<format>, the alt text beside, and one manifest.json
// that lists all figures there. Whatever isect did not make stays as it is.

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/piece.h"
#include "viz/formats.h"

namespace isect::program {

class Gallery {
 public:
  /// Throws viz::BadInput where the folder holds baselines, and viz::FileError where a manifest.json there is not
  /// isect's. Nothing is written yet.
  Gallery(std::string folder, const Program&);
  /// Throws viz::FileError where a file that this figure would replace is not isect's.
  void need_ours(const Piece&, const viz::Format&) const;

  /// The figure, its alt text, and its line for the manifest; returns where the figure is.
  std::string add(const Excerpt&, const Piece&, const std::string& format, const std::string& bytes,
                  nlohmann::ordered_json about);
  /// Takes away figures that isect made for this folder, of steps that the walk no longer has, with their alt texts.
  /// Returns how many.
  std::size_t remove_stale(const Excerpt&);
  /// Alt texts that someone has edited: neither written nor removed.
  const std::set<std::string>& left_alone() const { return left_alone_; }
  /// Merges what was added into the manifest, which may have grown meanwhile.
  void list();

 private:
  using Entries = std::map<std::string, nlohmann::ordered_json>;  ///< by file

  std::string path(const std::string& file) const;
  Entries read_manifest() const;
  bool is_ours(const std::string& file) const;
  /// Whether a step's alt text is absent, as it is now, or as the manifest says that isect wrote it.
  bool is_our_text(const std::string& stem, const std::string& now) const;

  std::string folder_;
  Entries listed_;  ///< before this run
  Entries added_;
  std::set<std::string> left_alone_;
};

}  // namespace isect::program
