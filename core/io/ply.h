// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a .ply file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/problems.h"
#include "core/io/source.h"

namespace confidel::io {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

struct PlyType {
  std::size_t width = 0;  ///< bytes; 0: no such type
  bool is_real = false;
  bool is_signed = false;
};

struct PlyProperty {
  std::string name;
  PlyType type;       ///< of the value, or of a list's values
  PlyType list_size;  ///< width 0: not a list
  bool is_list() const { return list_size.width > 0; }
};

struct PlyElement {
  std::string name;
  int count = 0;
  int line = 0;
  std::vector<PlyProperty> properties;
  /// Position of the property, or -1.
  int find(const std::string& property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;  ///< byte behind the line end_header
  int lines = 0;         ///< lines of the header
};

PlyHeader read_ply_header(const Source& source, Problems& problems);

}  // namespace confidel::io
