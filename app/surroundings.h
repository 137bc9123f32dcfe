#pragma once
// What a machine must have before anything can be drawn on it, told before work begins.

#include <string>

#include "app/program.h"

namespace isect::program {

/// Throws viz::NoFonts where there are no fonts, and viz::NoBackend where the system grants too little to draw. Other
/// fonts than the ones figures are made for: one line on stderr.
void need_surroundings(const Program&);

/// A small figure, drawn by this back end as `check` draws. Throws viz::NoBackend, or worse.
void draw_on_trial(const Program&, const std::string& backend);
/// The same in a child process, so that what crashes there is told: why it failed; empty where it did not.
std::string trial(const std::string& backend);

}  // namespace isect::program
