#pragma once
// The texts of a scene file that are shown: markup, with mathematics between dollars.

#include <string>

#include "app/scene/source.h"

namespace isect::program::scene {

/// Reads a text as markup; a lone dollar in it stays one. Throws viz::BadInput if it is no text, if LaTeX would refuse
/// its mathematics and, unless LaTeX alone sets it, if that is more than a line of letters can show.
std::string read_markup(const Source&, const Json&, const Path&);

/// Says whether LaTeX sets all that this run draws; not so at the start.
void set_by_tex_alone(bool);

}  // namespace isect::program::scene
