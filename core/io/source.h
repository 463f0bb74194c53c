// SPDX-License-Identifier: GPL-3.0-or-later
// Files as bytes, and one reader per format.
#pragma once

#include <string>

#include "core/complex/input.h"

namespace confidel::io {

struct Source {
  std::string file;  ///< for messages, and to find a companion beside it
  std::string text;  ///< all bytes
};

/// Throws FileError.
Source load(const std::string& path);

/// Lower-case suffix with its dot, or "".
std::string suffix(const std::string& path);

Input read_poly(const Source& source);
Input read_smesh(const Source& source);
Input read_off(const Source& source);
Input read_obj(const Source& source);
Input read_edg(const Source& source);
Input read_stl(const Source& source);
Input read_ply(const Source& source);
Input read_medit(const Source& source);

}  // namespace confidel::io
