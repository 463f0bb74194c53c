// SPDX-License-Identifier: Apache-2.0
#include "digest.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <stdexcept>

namespace {
constexpr std::size_t worthAThread = 1000000;  // bytes
constexpr std::size_t mostWaiting = 16;
}

// Without OpenSSL's configuration file and lists of algorithms: they take longer to read than a small certificate, and the file might put
// something else in SHA-256's place.
Sha256::Sha256(bool ownThread) : ownThread_(ownThread) {
    OPENSSL_init_crypto(OPENSSL_INIT_NO_LOAD_CONFIG | OPENSSL_INIT_NO_LOAD_CRYPTO_STRINGS | OPENSSL_INIT_NO_ADD_ALL_CIPHERS | OPENSSL_INIT_NO_ADD_ALL_DIGESTS,
                        nullptr);
    context_ = EVP_MD_CTX_new();
    if (context_ == nullptr || EVP_DigestInit_ex(context_, EVP_sha256(), nullptr) != 1)
        throw std::runtime_error("SHA-256 is not available");
}
Sha256::~Sha256() {
    endThread();
    EVP_MD_CTX_free(context_);
}

void Sha256::hash(const char* bytes, std::size_t size) {
    if (EVP_DigestUpdate(context_, bytes, size) != 1) failed_ = true;
}

void Sha256::add(const char* bytes, std::size_t size) {
    added_ += size;
    if (ownThread_ && added_ > worthAThread && !thread_.joinable()) thread_ = std::thread([this] { hashWaiting(); });
    if (!thread_.joinable()) return hash(bytes, size);
    std::vector<char> copy(bytes, bytes + size);
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < mostWaiting; });
    waiting_.push_back(std::move(copy));
    changed_.notify_one();
}

void Sha256::hashWaiting() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return !waiting_.empty() || ended_; });
        if (waiting_.empty()) return;
        const std::vector<char> next = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        changed_.notify_one();
        hash(next.data(), next.size());
        lock.lock();
    }
}

void Sha256::endThread() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard<std::mutex> guard(mutex_);
        ended_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

std::string Sha256::hexadecimal() {
    endThread();
    unsigned char bytes[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    if (failed_ || EVP_DigestFinal_ex(context_, bytes, &size) != 1 || size != 32) throw std::runtime_error("SHA-256 failed");
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
        text += "0123456789abcdef"[bytes[i] >> 4];
        text += "0123456789abcdef"[bytes[i] & 15];
    }
    return text;
}
