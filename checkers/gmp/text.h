// SPDX-License-Identifier: Apache-2.0
// Strict streaming reader of lines and fields (section 1 of the format).
#pragma once

#include "digest.h"
#include "input.h"
#include "points.h"

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

struct Malformed {
    std::string file;
    std::uint64_t line, column;
    std::string code, message;
};

class Text {
public:
    Text(const std::string& path, bool threads);  // threads: the digests may have some of their own

    // Lines.
    std::uint64_t line() const { return line_; }
    void begin();                       // the next line; E-TRUNCATED when there is none
    void expectEnd();                   // E-TRAILING when there is one
    // Begins a line whose first field is `keyword`. A first field among `miscounted` means that
    // records are missing or too many ("#" stands for a decimal digit).
    void begin(std::string_view keyword, std::initializer_list<std::string_view> miscounted = {});
    // Begins a line that starts with a number.
    void beginNumber(std::initializer_list<std::string_view> miscounted);

    // Fields, each behind a space.
    std::string_view word();
    std::uint32_t index();
    std::uint32_t indexBelow(std::uint64_t bound, const char* what);
    void integer(IntegerStore& store, char terminator = ' ');
    void space() {
        // Every field ends at a space or at the end of the line; the LF behind it is no space.
        if (*cursor_ != ' ' || cursor_ + 1 == stop_ || cursor_[1] == ' ') badSpace();
        ++cursor_;
    }
    void slash();
    bool atEnd() const { return cursor_ == stop_; }
    void finish();
    std::string_view rest();            // text of single spaces and printable characters, up to the end
    const char* mark() const { return cursor_; }
    const char* lineStart() const { return buffer_.data() + lineStart_; }
    void rewind(const char* to) { cursor_ = to; }  // to a mark on the same line
    [[noreturn]] void fail(const char* code, const std::string& message) const;
    [[noreturn]] void failAt(const char* where, const char* code, const std::string& message) const;

    // Digests. The text digest covers all lines before the current one.
    std::string digestBeforeThisLine();
    void startComplex(const std::string& comparePath);  // from the current line on
    std::string endComplex();                           // up to and including the current line
    std::uint64_t firstDifference() const { return differenceLine_; }  // 0: none

private:
    [[noreturn]] void badSpace();
    bool load();
    void flush(const char* upTo);
    void compare(const char* bytes, std::size_t size);
    void badKeyword(std::string_view expected, std::initializer_list<std::string_view> miscounted);
    [[noreturn]] void truncated();

    std::string path_;
    ByteSource source_;
    std::vector<char> buffer_;
    std::size_t lineStart_ = 0, lineStop_ = 0, filled_ = 0, flushed_ = 0, chunk_ = 0;
    bool started_ = false;
    const char* cursor_ = nullptr;
    const char* stop_ = nullptr;
    std::uint64_t line_ = 0;

    const bool threads_;
    std::unique_ptr<Sha256> textDigest_;  // until its value was asked for
    std::unique_ptr<Sha256> complexDigest_;
    std::unique_ptr<ByteSource> other_;
    std::string otherPath_;
    std::vector<char> otherBytes_;
    std::uint64_t compareLine_ = 0, differenceLine_ = 0;
    std::vector<mp_limb_t> limbs_;
};
