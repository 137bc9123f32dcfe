#pragma once
// X.new.png and X.diff.png: files beside a baseline X.png that fails, until it no longer does.

#include <filesystem>
#include <string>

#include "app/checks/baselines.h"

namespace isect::program {

bool is_leftover(const std::filesystem::path&);

/// Writes the failure's pictures beside its baseline and names them in it. If that can't be done, or would replace a
/// file that isect did not make for this folder, the failure gets a note instead.
void write_leftovers(Failure&, const std::string& folder);
/// Removes those files that isect made for this folder.
void remove_leftovers(const std::string& baseline, const std::string& folder);

}  // namespace isect::program
