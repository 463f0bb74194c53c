// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers from the bytes of a binary file, within bounds, independent of the machine's byte order.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace confidel::io {

class ByteCursor {
 public:
  ByteCursor(std::string_view bytes, std::size_t position, bool big_endian)
      : bytes_(bytes), position_(position), big_endian_(big_endian) {}

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }
  void skip(std::size_t count) { position_ += count; }

  /// The next 1, 2, 4 or 8 bytes as an unsigned integer; the caller has checked remaining().
  std::uint64_t integer(std::size_t width) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t at = big_endian_ ? i : width - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes_[position_ + at]);
    }
    position_ += width;
    return value;
  }
  double real32() { return std::bit_cast<float>(static_cast<std::uint32_t>(integer(4))); }
  double real64() { return std::bit_cast<double>(integer(8)); }

 private:
  std::string_view bytes_;
  std::size_t position_;
  bool big_endian_;
};

}  // namespace confidel::io
