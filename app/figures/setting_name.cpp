#include "app/figures/setting_name.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/figures/digest.h"

namespace isect::program {

namespace {

/// Whether every file system and shell takes the character as it is.
bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("+-.,=_").find(c) != std::string_view::npos;
}

}  // namespace

std::string name_of_change(const viz::Parameters& from, const viz::Parameters& to) {
  std::string exact;
  for (const auto& [name, value] : to)
    if (const auto before = from.find(name); before == from.end() || before->second != value)
      exact += "+" + name + "=" + viz::to_text(value);
  return plain_name(exact);
}

std::string plain_name(const std::string& exact) {
  constexpr std::size_t most = 80;
  if (exact.size() <= most && std::ranges::all_of(exact, is_plain)) return exact;
  std::string name = exact.substr(0, most - 17);
  std::ranges::replace_if(
      name, [](char c) { return !is_plain(c); }, '_');
  return fmt::format("{}~{}", name, digest(exact));
}

}  // namespace isect::program
