// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all, optionally compressed, hashed while it is written.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace confidel {

class OutputFile {
 public:
  /// Opens the temporary file, in the folder of path. Compresses if path ends in .zst. Throws FileError.
  OutputFile(const std::string& path, const std::string& temporary);
  /// Removes the temporary file unless commit was called.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  /// SHA-256 of everything written so far (before compression), lower-case hexadecimal.
  std::string digest();
  std::uint64_t text_bytes() const;
  /// Flushes, syncs and renames; returns the size of the file.
  std::uint64_t commit();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace confidel
