// SPDX-License-Identifier: Apache-2.0
#include "input.h"

#include "limits.h"

#include <fcntl.h>
#include <unistd.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace {
constexpr std::size_t firstChunk = std::size_t{1} << 14, chunk = std::size_t{1} << 18;  // for a look at the file; for decompressing it
constexpr int largestWindow = 27;  // 128 MiB, zstd's own default; larger windows are declined
}

ByteSource::ByteSource(const std::string& path) : path_(path) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) throw Unreadable{path, std::strerror(errno)};
    try {
        compressed_.resize(firstChunk);
        while (available_ < 4 && !fileDone_) fill();
        static constexpr unsigned char magic[4] = {0x28, 0xb5, 0x2f, 0xfd};
        isCompressed_ = available_ >= 4 && std::memcmp(compressed_.data(), magic, 4) == 0;
        if (!isCompressed_) return;
        compressed_.resize(chunk);
        context_ = ZSTD_createDCtx();
        if (context_ == nullptr) throw std::bad_alloc();
        int window = largestWindow;
        if (memoryLimit() != 0)
            while (window > 10 && (std::size_t{1} << window) > memoryLimit() / 2) --window;
        lowered_ = window < largestWindow;
        ZSTD_DCtx_setParameter(context_, ZSTD_d_windowLogMax, window);
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

ByteSource::~ByteSource() {
    if (context_ != nullptr) ZSTD_freeDCtx(context_);
    accountForeignMemory(contextBytes_, 0);
    ::close(descriptor_);
}

std::size_t ByteSource::readFile(char* target, std::size_t size) {
    for (;;) {
        const ssize_t got = ::read(descriptor_, target, size);
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EINTR) throw Unreadable{path_, std::strerror(errno)};
    }
}

void ByteSource::fill() {
    if (position_ == available_) position_ = available_ = 0;
    const std::size_t got = readFile(compressed_.data() + available_, compressed_.size() - available_);
    if (got == 0) fileDone_ = true;
    available_ += got;
}

std::size_t ByteSource::read(char* target, std::size_t size) {
    if (isCompressed_) return decompress(target, size);
    if (position_ < available_) {  // the bytes read for the look at the magic number
        const std::size_t part = std::min(size, available_ - position_);
        std::memcpy(target, compressed_.data() + position_, part);
        position_ += part;
        return part;
    }
    return readFile(target, size);
}

std::size_t ByteSource::decompress(char* target, std::size_t size) {
    if (!pendingError_.empty()) throw DamagedFrame{pendingError_};
    ZSTD_outBuffer output{target, size, 0};
    while (output.pos == 0) {
        if (position_ == available_ && !fileDone_) fill();
        if (frameDone_) {
            if (position_ < available_) throw DamagedFrame{"bytes after the zstd frame"};
            return 0;
        }
        ZSTD_inBuffer input{compressed_.data(), available_, position_};
        const std::size_t before = position_;
        const std::size_t result = ZSTD_decompressStream(context_, &output, &input);
        position_ = input.pos;
        const std::size_t bytes = ZSTD_sizeof_DCtx(context_);
        accountForeignMemory(contextBytes_, bytes);
        contextBytes_ = bytes;
        if (ZSTD_isError(result)) {
            if (ZSTD_getErrorCode(result) == ZSTD_error_frameParameter_windowTooLarge)
                throw Declined{lowered_ ? "memory-limit" : "too-large"};
            pendingError_ = ZSTD_getErrorName(result);
        } else if (result == 0) {
            frameDone_ = true;
        } else if (fileDone_ && output.pos == 0 && position_ == before) {
            pendingError_ = "the zstd frame ends early";
        }
        // What was decompressed before the damage is still text.
        if (!pendingError_.empty() && output.pos == 0) throw DamagedFrame{pendingError_};
    }
    return output.pos;
}
