#pragma once
// Errors in a command line, in our words: the option, what was given, what is allowed.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace isect::program {

/// Refuses what CLI11 would accept silently: "--out=" and "--out --step" have no value, "--json=yes" has one too many.
/// `arguments` begin with the subcommand's name. Throws viz::BadInput.
void check_values(const CLI::App&, const std::vector<std::string>& arguments);

/// Returns the message about what CLI11 refused.
std::string complaint(const CLI::App&, const CLI::ParseError&);

}  // namespace isect::program
