// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace confidel::io {

Source load(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw FileError(fmt::format("cannot read {}: it is a directory", path));
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw FileError(fmt::format("cannot open {}: {}", path, std::strerror(errno)));
  Source source{path, {}};
  char block[1 << 16];
  while (stream.read(block, sizeof block) || stream.gcount() > 0) {
    source.text.append(block, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw FileError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  return source;
}

std::string suffix(const std::string& path) {
  std::string result = std::filesystem::path(path).extension().string();
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

}  // namespace confidel::io
