#pragma once
// A short name of the contents of a file or a text: equal bytes have the same one, different ones hardly ever.

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace isect::program {

/// Returns 16 hexadecimal digits, by FNV-1a. They show changes by accident or by hand, but none that somebody hides.
inline std::string digest(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return fmt::format("{:016x}", hash);
}

}  // namespace isect::program
