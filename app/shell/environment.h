#pragma once
// What a machine must have before anything can be drawn on it, checked before work begins.

#include <string>

#include "app/program.h"

namespace isect::program {

/// Throws viz::NoFonts if there are no fonts, and viz::NoBackend if the system grants too little to draw. If the fonts
/// are not those for which figures are made, prints one line on stderr.
void need_environment(const Program&);

/// Draws a small figure with this back end, as `check` draws. Throws viz::NoBackend, or worse.
void draw_on_trial(const Program&, const std::string& backend);
/// Does so in a child process, so that a crash there is reported: returns why it failed; empty if it did not.
std::string trial(const std::string& backend);

}  // namespace isect::program
