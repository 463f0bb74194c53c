// SPDX-License-Identifier: Apache-2.0
#include "text.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace {
constexpr std::size_t longestLine = 1048576;  // bytes before the LF
constexpr std::size_t mostDigits = 65536;
constexpr std::size_t firstChunk = std::size_t{1} << 14, largestChunk = std::size_t{1} << 18;

bool printable(char c) { return c >= 0x20 && c <= 0x7e; }
bool digit(char c) { return c >= '0' && c <= '9'; }
constexpr std::uint8_t noDigit = 255;
constexpr std::array<std::uint8_t, 256> hexadecimalValues = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(noDigit);
    for (std::uint8_t i = 0; i < 16; ++i) values[static_cast<std::uint8_t>("0123456789abcdef"[i])] = i;
    return values;
}();
std::uint8_t hexadecimalValue(char c) { return hexadecimalValues[static_cast<std::uint8_t>(c)]; }
}  // namespace

Text::Text(const std::string& path, bool threads) : path_(path), source_(path), threads_(threads), textDigest_(std::make_unique<Sha256>(threads)) {}

void Text::failAt(const char* where, const char* code, const std::string& message) const {
    const auto column = static_cast<std::uint64_t>(where - (buffer_.data() + lineStart_)) + 1;
    throw Malformed{path_, line_, column, code, message};
}
void Text::fail(const char* code, const std::string& message) const { failAt(cursor_, code, message); }

// Moves the unfinished line to the beginning and reads more bytes behind it; false at the end of the file.
bool Text::load() {
    flush(buffer_.data() + lineStart_);
    if (lineStart_ > 0) {
        std::memmove(buffer_.data(), buffer_.data() + lineStart_, filled_ - lineStart_);
        filled_ -= lineStart_;
        flushed_ -= lineStart_;
        lineStart_ = 0;
    }
    chunk_ = std::clamp(2 * chunk_, firstChunk, largestChunk);  // small for small files
    if (buffer_.size() < filled_ + chunk_) buffer_.resize(filled_ + chunk_);
    try {
        const std::size_t got = source_.read(buffer_.data() + filled_, chunk_);
        filled_ += got;
        return got != 0;
    } catch (const DamagedFrame& damage) {
        throw Malformed{path_, line_, filled_ + 1, "E-ZSTD", damage.reason};
    }
}

// After load().
void Text::truncated() {
    const char* first = buffer_.data();
    const char* last = buffer_.data() + filled_;
    const char* bad = std::find_if_not(first, last, printable);
    if (bad != last) failAt(bad, "E-SYNTAX", "a byte that is not printable ASCII");
    failAt(last, "E-TRUNCATED", first == last ? "the text ends early" : "the text ends within a line");
}

void Text::begin() {
    lineStart_ = started_ ? lineStop_ + 1 : 0;
    started_ = true;
    ++line_;
    std::size_t searched = 0;
    for (;;) {
        const std::size_t from = lineStart_ + searched;
        const void* found = from < filled_ ? std::memchr(buffer_.data() + from, '\n', filled_ - from) : nullptr;
        if (found != nullptr) {
            lineStop_ = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
            break;
        }
        searched = filled_ - lineStart_;
        if (searched > longestLine) break;
        if (!load()) truncated();
    }
    const char* first = buffer_.data() + lineStart_;
    if (searched > longestLine || lineStop_ - lineStart_ > longestLine) {
        const char* last = first + longestLine;
        const char* bad = std::find_if_not(first, last, printable);
        if (bad != last) failAt(bad, "E-SYNTAX", "a byte that is not printable ASCII");
        throw Declined{"too-large"};
    }
    cursor_ = first;
    stop_ = buffer_.data() + lineStop_;
}

void Text::expectEnd() {
    lineStart_ = lineStop_ + 1;
    ++line_;
    if (lineStart_ < filled_ || load()) failAt(buffer_.data() + lineStart_, "E-TRAILING", "text after the end");
}

void Text::badKeyword(std::string_view expected, std::initializer_list<std::string_view> miscounted) {
    const char* end = std::find(cursor_, stop_, ' ');
    const std::string_view found(cursor_, static_cast<std::size_t>(end - cursor_));
    for (const std::string_view other : miscounted)
        if (other == found || (other == "#" && !found.empty() && digit(found[0])))
            fail("E-COUNT", "fewer or more records than announced: expected " + std::string(expected));
    fail("E-SYNTAX", "expected " + std::string(expected));
}

void Text::begin(std::string_view keyword, std::initializer_list<std::string_view> miscounted) {
    begin();
    const auto length = static_cast<std::size_t>(stop_ - cursor_);
    if (length < keyword.size() || std::memcmp(cursor_, keyword.data(), keyword.size()) != 0 ||
        (length > keyword.size() && cursor_[keyword.size()] != ' '))
        badKeyword("`" + std::string(keyword) + "`", miscounted);
    cursor_ += keyword.size();
}

void Text::beginNumber(std::initializer_list<std::string_view> miscounted) {
    begin();
    if (cursor_ == stop_ || !digit(*cursor_)) badKeyword("a number", miscounted);
}

std::string_view Text::word() {
    const char* end = std::find(cursor_, stop_, ' ');
    const std::string_view field(cursor_, static_cast<std::size_t>(end - cursor_));
    for (const char& c : field)
        if (!printable(c)) failAt(&c, "E-SYNTAX", "a byte that is not printable ASCII");
    cursor_ = end;
    return field;
}

std::uint32_t Text::index() {
    const char* first = cursor_;
    std::uint64_t value = 0;
    bool large = false;
    while (cursor_ != stop_ && digit(*cursor_)) {
        value = value * 10 + static_cast<std::uint64_t>(*cursor_++ - '0');
        if (value >= (std::uint64_t{1} << 31)) large = true;
    }
    if (cursor_ == first || (cursor_ != stop_ && *cursor_ != ' ')) fail("E-SYNTAX", "expected a decimal number");
    if (*first == '0' && cursor_ - first > 1) failAt(first, "E-SYNTAX", "a leading zero");
    if (large) throw Declined{"too-large"};
    return static_cast<std::uint32_t>(value);
}

std::uint32_t Text::indexBelow(std::uint64_t bound, const char* what) {
    const char* first = cursor_;
    const std::uint32_t value = index();
    if (value >= bound) failAt(first, "E-RANGE", std::string("there is no such ") + what);
    return value;
}

void Text::integer(IntegerStore& store, char terminator) {
    const char* start = cursor_;
    const bool negative = cursor_ != stop_ && *cursor_ == '-';
    if (negative) ++cursor_;
    const char* first = cursor_;
    mp_limb_t last = 0;  // of the last 16 digits; the LF behind the line is no digit
    const char* end = first;
    for (std::uint8_t value = hexadecimalValue(*end); value != noDigit; value = hexadecimalValue(*++end)) last = last << 4 | value;
    cursor_ = end;
    if (cursor_ == first || (cursor_ != stop_ && *cursor_ != terminator))
        fail("E-SYNTAX", "expected an integer, hexadecimal in lower case");
    const auto digits = static_cast<std::size_t>(cursor_ - first);
    if (*first == '0' && digits > 1) failAt(first, "E-SYNTAX", "a leading zero");
    if (*first == '0' && negative) failAt(start, "E-SYNTAX", "-0 does not exist");
    if (digits > mostDigits) throw Declined{"too-large"};
    if (*first == '0') {
        store.append(nullptr, 0);
        return;
    }
    const std::size_t size = (digits + 15) / 16;
    if (limbs_.size() < size) limbs_.resize(size);
    limbs_[0] = last;
    for (std::size_t i = 1; i < size; ++i) {
        end -= 16;
        mp_limb_t limb = 0;
        for (const char* c = end - first > 16 ? end - 16 : first; c != end; ++c) limb = limb << 4 | hexadecimalValue(*c);
        limbs_[i] = limb;
    }
    store.append(limbs_.data(), negative ? -static_cast<int>(size) : static_cast<int>(size));
}

void Text::badSpace() {
    if (cursor_ == stop_) fail("E-SYNTAX", "a field is missing");
    ++cursor_;
    fail("E-SYNTAX", "a space without a field");
}

void Text::slash() {
    if (*cursor_ != '/') fail("E-SYNTAX", "expected `/`");  // nor is it the LF behind the line
    ++cursor_;
}

void Text::finish() {
    if (cursor_ != stop_) fail("E-SYNTAX", "text after the last field");
}

std::string_view Text::rest() {
    const std::string_view text(cursor_, static_cast<std::size_t>(stop_ - cursor_));
    for (const char* c = cursor_; c != stop_; ++c)
        if (!printable(*c) || (*c == ' ' && (c == cursor_ || c + 1 == stop_ || c[1] == ' ')))
            failAt(c, "E-SYNTAX", "not a printable character or a single space");
    cursor_ = stop_;
    return text;
}

void Text::flush(const char* upTo) {
    const char* from = buffer_.data() + flushed_;
    const auto size = static_cast<std::size_t>(upTo - from);
    if (textDigest_) textDigest_->add(from, size);
    if (complexDigest_) {
        complexDigest_->add(from, size);
        compare(from, size);
    }
    flushed_ += size;
}

std::string Text::digestBeforeThisLine() {
    flush(buffer_.data() + lineStart_);
    const std::string digest = textDigest_->hexadecimal();
    textDigest_.reset();
    return digest;
}

void Text::startComplex(const std::string& comparePath) {
    flush(buffer_.data() + lineStart_);
    complexDigest_ = std::make_unique<Sha256>(threads_);
    compareLine_ = line_;
    if (comparePath.empty()) return;
    otherPath_ = comparePath;
    other_ = std::make_unique<ByteSource>(comparePath);
}

std::string Text::endComplex() {
    flush(buffer_.data() + lineStop_ + 1);
    const std::string digest = complexDigest_->hexadecimal();
    complexDigest_.reset();
    if (other_ && differenceLine_ == 0) {  // the other file has to end here too
        char more = 0;
        try {
            if (other_->read(&more, sizeof more) != 0) differenceLine_ = line_;
        } catch (const DamagedFrame& damage) {
            throw Malformed{otherPath_, compareLine_ - 1, 1, "E-ZSTD", damage.reason};
        }
    }
    other_.reset();
    return digest;
}

void Text::compare(const char* bytes, std::size_t size) {
    if (!other_ || differenceLine_ != 0) return;
    otherBytes_.resize(std::min(size, largestChunk));
    while (size > 0) {
        std::size_t got = 0;
        try {
            got = other_->read(otherBytes_.data(), std::min(size, otherBytes_.size()));
        } catch (const DamagedFrame& damage) {
            throw Malformed{otherPath_, compareLine_ - 1, 1, "E-ZSTD", damage.reason};
        }
        if (got == 0) {
            differenceLine_ = compareLine_;
            return;
        }
        const std::string_view own(bytes, got), other(otherBytes_.data(), got);
        const auto place = std::mismatch(own.begin(), own.end(), other.begin()).first;
        compareLine_ += static_cast<std::uint64_t>(std::count(own.begin(), place, '\n'));
        if (place != own.end()) {
            differenceLine_ = compareLine_;
            return;
        }
        bytes += got;
        size -= got;
    }
}
