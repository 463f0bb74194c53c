// SPDX-License-Identifier: Apache-2.0
// Bytes of a file, decompressed when it is a zstd frame. Streaming: a fixed buffer, whatever the file announces.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

struct ZSTD_DCtx_s;

struct Unreadable { std::string file, reason; };
struct Declined { std::string why; };
struct DamagedFrame { std::string reason; };

class ByteSource {
public:
    explicit ByteSource(const std::string& path);
    ~ByteSource();
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    // Up to `size` bytes, 0 at the end. Throws Unreadable, Declined, DamagedFrame.
    std::size_t read(char* target, std::size_t size);

private:
    std::size_t readFile(char* target, std::size_t size);
    std::size_t decompress(char* target, std::size_t size);
    void fill();

    std::string path_;
    int descriptor_ = -1;
    std::vector<char> compressed_;
    std::size_t position_ = 0, available_ = 0;
    bool isCompressed_ = false, frameDone_ = false, fileDone_ = false, lowered_ = false;
    std::string pendingError_;
    ZSTD_DCtx_s* context_ = nullptr;
    std::size_t contextBytes_ = 0;
};
