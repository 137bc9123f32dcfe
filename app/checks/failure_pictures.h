#pragma once
// X.new.png and X.diff.png: files beside a baseline X.png that fails, until it no longer does; X.new.svg beside X.svg.

#include <filesystem>
#include <string>

#include "app/checks/baselines.h"

namespace isect::program {

bool is_failure_picture(const std::filesystem::path&);

/// Writes the failure's pictures beside its baseline and names them in it. If that can't be done, or would replace a
/// file that isect did not make for this folder, the failure gets a note instead.
void write_failure_pictures(Failure&, const std::string& folder);
/// Removes those files that isect made for this folder.
void remove_failure_pictures(const std::string& baseline, const std::string& folder);

}  // namespace isect::program
