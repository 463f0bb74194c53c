// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes for binary literals.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace confidel::test {

class BinaryFile {
 public:
  explicit BinaryFile(std::string begin, bool big_endian = false) : bytes_(std::move(begin)), big_endian_(big_endian) {}

  BinaryFile& integer(std::uint64_t value, int width) {
    for (int i = 0; i < width; ++i) {
      const int shift = 8 * (big_endian_ ? width - 1 - i : i);
      bytes_ += static_cast<char>(value >> shift & 0xFF);
    }
    return *this;
  }
  BinaryFile& real32(float value) { return integer(std::bit_cast<std::uint32_t>(value), 4); }
  BinaryFile& real64(double value) { return integer(std::bit_cast<std::uint64_t>(value), 8); }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  bool big_endian_;
};

}  // namespace confidel::test
