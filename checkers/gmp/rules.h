// SPDX-License-Identifier: Apache-2.0
// The rules of section 5, one function each. Each relies on the rules before it.
#pragma once

#include "certificate.h"

#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tuple>

struct Violation {
    std::uint64_t line;
    std::string object;
};

// The violation with the smallest line; of those on one line the first that was offered.
class Earliest {
public:
    void offer(std::uint64_t line, std::string object) {
        const std::lock_guard<std::mutex> guard(mutex_);
        if (line >= line_.load(std::memory_order_relaxed)) return;
        object_ = std::move(object);
        line_.store(line, std::memory_order_relaxed);
    }
    std::uint64_t line() const { return line_.load(std::memory_order_relaxed); }
    std::optional<Violation> result() const {
        if (line() == ~std::uint64_t{0}) return std::nullopt;
        return Violation{line(), object_};
    }

private:
    std::atomic<std::uint64_t> line_{~std::uint64_t{0}};
    std::string object_;
    std::mutex mutex_;
};

template <class... Parts>
std::string objectName(const Parts&... parts) {
    std::string name;
    const auto add = [&name](const auto& part) {
        if (!name.empty()) name += '-';
        if constexpr (std::is_convertible_v<decltype(part), std::string>) name += part;
        else name += std::to_string(part);
    };
    (add(parts), ...);
    return name;
}

// Calls work(begin, end) for consecutive pieces of [0, count), on several threads.
template <class Work>
void inParallel(std::size_t count, unsigned threads, std::size_t piece, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr error;
    std::mutex mutex;
    const auto run = [&] {
        try {
            auto worker = work();
            for (;;) {
                const std::size_t begin = next.fetch_add(piece);
                if (begin >= count) return;
                worker(begin, begin + piece < count ? begin + piece : count);
            }
        } catch (...) {
            next.store(count);
            const std::lock_guard<std::mutex> guard(mutex);
            if (!error) error = std::current_exception();
        }
    };
    std::vector<std::thread> pool;
    if (count > piece)
        for (unsigned i = 1; i < threads; ++i) pool.emplace_back(run);
    run();
    for (std::thread& thread : pool) thread.join();
    if (error) std::rethrow_exception(error);
}

// The smallest relative power off-plane: for the reader only, no verdict rests on it.
struct SmallestPower {
    static constexpr std::uint64_t noLine = std::numeric_limits<std::uint64_t>::max();
    double value = std::numeric_limits<double>::infinity();  // also of what is beyond doubles
    std::uint64_t cellLine = noLine;                         // as long as there is no point off-plane
    std::uint32_t point = none;
    bool exists() const { return cellLine != noLine; }
    bool betterThan(const SmallestPower& other) const { return std::tie(value, cellLine, point) < std::tie(other.value, other.cellLine, other.point); }
};

struct ClaimReport {
    Lemma lemma;
    std::uint64_t objects = 0, failures = 0;
    bool hasSlack = false;
    double slack = 0;
    std::uint64_t line = 0;
    std::string object;
    std::optional<Violation> violation;
};

class Index;
class FloatNormals;
class Shapes;

struct Check {
    Certificate certificate;
    unsigned threads = 1;
    bool exact = false;                         // no float filter (--exact)
    std::size_t firstCell = 0, endCell = 0;     // the cells that are asked for (--cells)
    std::shared_ptr<Shapes> shapes;             // found by rule `kinds`, if it applies
    std::shared_ptr<const Index> index;         // of all points, when it was needed
    std::shared_ptr<const FloatNormals> floatNormals;  // found by rule `complex`; none with --exact
    std::vector<ClaimReport> claims;
    SmallestPower smallest, smallestHanging;
    std::uint64_t tieCount = 0;                 // pairs of a cell and another point on its circle
    std::optional<Violation> tieViolation;      // found together with `emptiness`
};

struct Rule {
    const char* name;
    std::optional<Violation> (*function)(Check&);
    const char* counted;                        // what the rule goes through ...
    std::uint64_t (*count)(const Check&);       // ... and how many
};

std::optional<Violation> ruleHash(Check&);
std::optional<Violation> ruleComplex(Check&);
std::optional<Violation> ruleDistinct(Check&);
std::optional<Violation> ruleCarrier(Check&);
std::optional<Violation> ruleCell(Check&);
std::optional<Violation> ruleBox(Check&);
std::optional<Violation> ruleTiling(Check&);
std::optional<Violation> ruleEmptiness(Check&);
std::optional<Violation> ruleTie(Check&);
std::optional<Violation> ruleHanging(Check&);
std::optional<Violation> ruleRows(Check&);
