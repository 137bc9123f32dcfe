#pragma once
// A short name of what a file or a text holds: the same bytes have the same one, others hardly ever.

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace isect::program {

/// 16 hexadecimal digits, by FNV-1a. Tells changes made by accident or by hand, not by somebody who wants to hide them.
inline std::string digest(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return fmt::format("{:016x}", hash);
}

}  // namespace isect::program
