// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers from one 64-bit seed, the same on every machine: the generator is the one that the standard specifies bit by bit,
// and the ways from its words to integers and dyadic numbers are these.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace confidel::campaigns {

class Random {
 public:
  explicit Random(std::uint64_t seed) : words_(seed) {}

  std::uint64_t word() { return words_(); }

  /// Every integer of [low, high] with the same probability: words beyond the last full cycle are thrown away.
  int integer(int low, int high) {
    const std::uint64_t count = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low) + 1;
    const std::uint64_t excess = (UINT64_MAX % count + 1) % count;
    std::uint64_t value = word();
    while (value > UINT64_MAX - excess) value = word();
    return static_cast<int>(low + static_cast<std::int64_t>(value % count));
  }
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(integer(0, static_cast<int>(count) - 1)); }
  bool one_in(int n) { return integer(1, n) == 1; }

  /// A multiple of 2^(1-bits) in [-1, 1); bits from 1 to 53.
  double real(int bits = 53) { return std::ldexp(static_cast<double>(word() >> (64 - bits)), 1 - bits) - 1; }
  /// The same in [low, high), as doubles round it.
  double between(double low, double high) { return low + (high - low) * 0.5 * (real() + 1); }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[index(i)]);
  }
  template <class T>
  const T& choose(const std::vector<T>& items) { return items[index(items.size())]; }

 private:
  std::mt19937_64 words_;
};

}  // namespace confidel::campaigns
