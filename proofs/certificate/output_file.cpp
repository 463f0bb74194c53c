// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/output_file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>
#include <zstd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "core/complex/input.h"

namespace confidel {
namespace {

bool ends_with(const std::string& text, std::string_view suffix) {
  return text.size() >= suffix.size() && std::string_view(text).substr(text.size() - suffix.size()) == suffix;
}

}  // namespace

struct OutputFile::Implementation {
  std::string path, temporary;
  int file = -1;
  bool committed = false;
  std::uint64_t text_bytes = 0, file_bytes = 0;
  std::string pending;
  EVP_MD_CTX* hash = nullptr;
  ZSTD_CCtx* compressor = nullptr;
  std::vector<char> compressed;

  [[noreturn]] void fail(const char* what) const { throw FileError(path + ": " + what + ": " + std::strerror(errno)); }

  void put(const char* data, std::size_t size) {
    while (size > 0) {
      const ssize_t written = ::write(file, data, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("cannot write");
      data += written;
      size -= static_cast<std::size_t>(written);
      file_bytes += static_cast<std::uint64_t>(written);
    }
  }

  void flush(bool last) {
    EVP_DigestUpdate(hash, pending.data(), pending.size());
    if (compressor == nullptr) {
      put(pending.data(), pending.size());
    } else {
      ZSTD_inBuffer input{pending.data(), pending.size(), 0};
      for (;;) {
        ZSTD_outBuffer output{compressed.data(), compressed.size(), 0};
        const std::size_t rest = ZSTD_compressStream2(compressor, &output, &input, last ? ZSTD_e_end : ZSTD_e_continue);
        if (ZSTD_isError(rest)) throw FileError(path + ": " + ZSTD_getErrorName(rest));
        put(compressed.data(), output.pos);
        if (last ? rest == 0 : input.pos == input.size) break;
      }
    }
    pending.clear();
  }
};

OutputFile::OutputFile(const std::string& path, const std::string& temporary) : implementation_(std::make_unique<Implementation>()) {
  auto& self = *implementation_;
  self.path = path;
  self.temporary = temporary;
  self.file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (self.file < 0) self.fail("cannot create a file here");
  self.hash = EVP_MD_CTX_new();
  EVP_DigestInit_ex(self.hash, EVP_sha256(), nullptr);
  if (ends_with(path, ".zst")) {
    self.compressor = ZSTD_createCCtx();
    self.compressed.resize(ZSTD_CStreamOutSize());
  }
}

OutputFile::~OutputFile() {
  auto& self = *implementation_;
  if (self.file >= 0) ::close(self.file);
  if (!self.committed && self.file >= 0) ::unlink(self.temporary.c_str());
  EVP_MD_CTX_free(self.hash);
  ZSTD_freeCCtx(self.compressor);
}

void OutputFile::write(std::string_view text) {
  auto& self = *implementation_;
  self.pending += text;
  self.text_bytes += text.size();
  if (self.pending.size() >= (1U << 20)) self.flush(false);
}

std::string OutputFile::digest() {
  auto& self = *implementation_;
  self.flush(false);
  EVP_MD_CTX* copy = EVP_MD_CTX_new();
  EVP_MD_CTX_copy_ex(copy, self.hash);
  unsigned char bytes[32];
  EVP_DigestFinal_ex(copy, bytes, nullptr);
  EVP_MD_CTX_free(copy);
  static const char digits[] = "0123456789abcdef";
  std::string result;
  for (unsigned char byte : bytes) {
    result += digits[byte >> 4];
    result += digits[byte & 15];
  }
  return result;
}

std::uint64_t OutputFile::text_bytes() const { return implementation_->text_bytes; }

std::uint64_t OutputFile::commit() {
  auto& self = *implementation_;
  self.flush(true);
  if (::fsync(self.file) != 0 && errno != EINVAL) self.fail("cannot write");
  if (::rename(self.temporary.c_str(), self.path.c_str()) != 0) self.fail("cannot rename the finished file");
  self.committed = true;
  return self.file_bytes;
}

}  // namespace confidel
