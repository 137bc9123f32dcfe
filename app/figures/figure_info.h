#pragma once
// One figure to be written: a step, or several steps together.

#include <string>
#include <utility>
#include <vector>

#include "app/shell/options.h"
#include "viz/formats/files.h"

namespace isect::program {

struct FigureInfo {
  std::string stem;        ///< its file, without the ending: "ray-sphere/two-roots/03-foot"
  std::vector<int> steps;  ///< from 0; of several settings those of one after the other
  std::string title;       ///< markup
  std::string caption;     ///< markup
  std::string imprint;     ///< its title inside the file, plain
  std::string alt;         ///< plain
  viz::Metadata metadata;
};

/// A figure's file; of a TikZ picture of a large mesh also the picture of its faces, which the file names.
struct FigureFile {
  FigureFile(std::string written, std::string picture = {})  // NOLINT: bytes are a file
      : bytes(std::move(written)), faces(std::move(picture)) {}
  std::string bytes, faces;  ///< no faces: the figure is one file
};
/// Returns the name of the file with the faces, without its ending: "ray-sphere/two-roots/03-foot-faces".
std::string faces_of(const std::string& stem);

FigureInfo info_of(const Excerpt&, int step);
/// Returns all chosen steps in one file, "strip-03-06": `kind` is its first word. Of several settings it names each;
/// see cases.h.
FigureInfo info_of(Excerpts, const std::string& kind);
/// Whether a figure shows several steps, or settings.
bool shows_several(const viz::Metadata&);
/// Returns the steps of a figure of several, as --step takes them; empty for a figure of one.
std::string steps_of(const viz::Metadata&);

}  // namespace isect::program
