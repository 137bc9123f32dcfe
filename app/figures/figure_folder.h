#pragma once
// The folder for figures: DIR/<lesson>/<preset>/<NN>-<slug>.<format>, the alt text beside, and one manifest.json that
// lists all figures there. Files that isect did not make, or that someone has edited since, stay as they are.

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/figures/figure_info.h"
#include "viz/formats/formats.h"

namespace isect::program {

class FigureFolder {
 public:
  /// Throws viz::BadInput if the folder holds baselines, and viz::FileError if a manifest.json there is not isect's.
  /// Nothing is written yet.
  FigureFolder(std::string folder, const Program&);
  /// Lists what exists so far if an error ended the run.
  ~FigureFolder();
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;
  /// Throws viz::FileError if a file that this figure would replace is not isect's.
  void need_ours(const FigureInfo&, const viz::Format&) const;

  /// Writes the figure, the picture of its faces if it has one, its alt text, and its lines for the manifest; returns
  /// the line that says where the figure is. The figure and that picture appear together or not at all. If someone has
  /// edited one of them, all of that stays as it was, and no line is returned.
  std::string add(const Excerpt&, const FigureInfo&, const std::string& format, const FigureFile&,
                  nlohmann::ordered_json about);
  /// Does the same for a figure of several settings, which the manifest lists as its parts.
  std::string add(Excerpts, const FigureInfo&, const std::string& format, const FigureFile&,
                  nlohmann::ordered_json about);
  /// Writes a page that shows figures; returns the same.
  std::string add_page(const std::string& file, const std::string& text);
  /// Removes figures that isect made for this folder, of steps that the walk no longer has, with their alt texts.
  /// Returns how many.
  std::size_t remove_stale(const Excerpt&);
  /// Says on stderr which files someone has edited, so that they were neither written nor removed.
  void say_left_alone() const;
  /// Merges what was added into the manifest, which may have grown meanwhile.
  void list();

 private:
  using Entries = std::map<std::string, nlohmann::ordered_json>;  ///< by file
  struct Manifest {
    Entries figures, pages;
  };

  std::string path(const std::string& file) const;
  Manifest read_manifest() const;
  bool is_ours(const std::string& file) const;
  /// Whether a step's alt text is absent, equal to `now`, or as the manifest says that isect wrote it.
  bool is_our_text(const std::string& stem, const std::string& now) const;
  /// Whether a figure or page exists, is not empty, and is neither equal to `now` nor as the manifest says that isect
  /// wrote it. A file listed by an older isect has no digest there and counts as not edited.
  bool is_edited(const std::string& file, const Entries Manifest::*kind, const std::string& now) const;

  std::string folder_;
  Manifest listed_;  ///< what the manifest says
  Manifest added_;   ///< what it does not say yet
  std::set<std::string> left_alone_;
};

}  // namespace isect::program
