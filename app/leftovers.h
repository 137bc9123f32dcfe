#pragma once
// X.new.png and X.diff.png: what a baseline X.png that fails gets beside it, until it fails no more.

#include <filesystem>
#include <string>

#include "app/baselines.h"

namespace isect::program {

bool is_leftover(const std::filesystem::path&);

/// Writes the failure's pictures beside its baseline and names them in it. Where that can't be done, or would replace a
/// file that isect did not make for this folder, the failure gets a note instead.
void write_leftovers(Failure&, const std::string& folder);
/// Removes those that isect made for this folder.
void remove_leftovers(const std::string& baseline, const std::string& folder);

}  // namespace isect::program
