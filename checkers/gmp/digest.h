// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

struct evp_md_ctx_st;

// SHA-256, incremental.
class Sha256 {
public:
    // With `ownThread`, what comes after the first bytes is hashed in a thread of its own.
    explicit Sha256(bool ownThread);
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;
    void add(const char* bytes, std::size_t size);
    std::string hexadecimal();  // once, at the end

private:
    void hash(const char* bytes, std::size_t size);
    void hashWaiting();
    void endThread();

    evp_md_ctx_st* context_ = nullptr;
    bool failed_ = false;
    const bool ownThread_;
    std::size_t added_ = 0;
    std::thread thread_;
    std::mutex mutex_;  // for what follows
    std::condition_variable changed_;
    std::deque<std::vector<char>> waiting_;
    bool ended_ = false;
};
