#pragma once
// What the targets draw from an input.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

/// Numbers from the input's bytes; zeros when it ends.
class Source {
 public:
  Source(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  int byte() { return size_ == 0 ? 0 : (--size_, *data_++); }
  int below(int n) { return byte() % n; }

  double number() {
    static constexpr std::array<double, 16> bases = {0,   1,   -1,  2,   -2,    3,      0.5,    0.1,
                                                     0.3, 0.7, -.1, 1e8, 1e300, 1e-300, 5e-324, 0x1p-1022};
    const int how = byte();
    if (how < 128) return bases[how % 16];
    if (how < 160) return std::nextafter(bases[how % 16], 0);
    if (how < 192) return std::nextafter(bases[how % 16], 10);
    if (how < 224) return byte() - 128;
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | static_cast<std::uint64_t>(byte());
    const double any = std::bit_cast<double>(bits);
    return std::isfinite(any) ? any : 0;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};
