#pragma once
// Several settings in one figure, or at one scale: what they are called, and what a figure keeps of them.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/excerpt.h"
#include "viz/formats/files.h"

namespace isect::program {

/// The most settings that are drawn at one scale: their figures carry all of them.
inline constexpr std::size_t most_cases = 100;

/// Returns what each setting is called beside the others, as markup: its preset's title, "two roots", its scene's, or
/// its file's name; with what tells it from others of that title, and of several lessons with the lesson's.
std::vector<std::string> case_titles(Excerpts);

/// Returns what stands below each chosen step, as markup: of one setting the step's title; of several that of the case,
/// with the step's where a case shows several. With `captions` each is followed by the step's caption.
std::vector<std::string> part_captions(Excerpts, bool captions);

/// Returns the steps of a setting as a part of a name, from 1: "03-06" if they follow each other, "03+05" otherwise.
std::string numbers_of(const std::vector<int>& steps);
/// Returns the folder and name of a figure of several settings, without its ending: "ray-sphere/strip-tangent+miss-03".
/// `kind` is the first word of the name.
std::string stem_of(Excerpts, const std::string& kind);

/// Writes the settings, with their chosen steps, into the metadata of a figure; `own`: the one that it shows at their
/// scale, or none if it shows all. Throws viz::BadInput if they are too many, or too much for a file's metadata.
void keep_cases(viz::Metadata&, Excerpts, std::optional<std::size_t> own = {});

/// What keep_cases has written.
struct CasesInFigure {
  std::vector<viz::Metadata> cases;     ///< of each setting, as a figure of it alone would carry it; or none
  std::optional<std::size_t> own = {};  ///< less than their number
};
/// Throws viz::BadInput if that is not what isect writes.
CasesInFigure cases_of(const viz::Metadata&);
/// Whether a figure shows several settings.
bool shows_cases(const viz::Metadata&);

}  // namespace isect::program
