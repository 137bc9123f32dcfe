#pragma once
// What a pure function returned lately. A drawing differs from the one before in few shapes; the rest is not done anew.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isect::viz {

/// All key that a result depends on, in a fixed order.
using MemoKey = std::vector<double>;

/// Keeps results by the key they depend on: those that were asked for last, whose keys have `most` numbers together,
/// and at most twice as many.
template <class Result>
class Memo {
 public:
  explicit Memo(std::size_t most) : most_(most) {}

  /// Returns the result kept for this key, or makes it. The reference holds until the next call.
  template <class Make>
  const Result& operator()(MemoKey key, const Make& make) {
    if (const auto kept = late_.find(key); kept != late_.end()) return kept->second;
    if (numbers_ >= most_) early_ = std::exchange(late_, {}), numbers_ = 0;
    numbers_ += key.size();
    if (auto node = early_.extract(key)) return late_.insert(std::move(node)).position->second;
    return late_.emplace(std::move(key), make()).first->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const MemoKey& key) const {
      std::uint64_t h = key.size();
      for (const double x : key) {
        h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
      }
      return static_cast<std::size_t>(h);
    }
  };
  using Results = std::unordered_map<MemoKey, Result, Hash>;

  std::size_t most_, numbers_ = 0;  ///< of the keys in late_
  Results late_ = {}, early_ = {};
};

}  // namespace isect::viz
