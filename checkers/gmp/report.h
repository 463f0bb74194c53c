// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rules.h"
#include "text.h"

struct Options {
    std::string certificate, complex;
    unsigned threads = 1;
    bool json = false, quiet = false;
};

struct Outcome {
    int exitCode = 70;
    std::string verdict;                       // VERIFIED, REJECTED, UNDECIDED, MALFORMED, UNREADABLE
    std::string why;                           // UNDECIDED
    std::string rule, object;                  // REJECTED
    std::uint64_t line = 0;
    const Malformed* malformed = nullptr;
    const Unreadable* unreadable = nullptr;
    std::vector<std::pair<const Rule*, std::uint64_t>> passed;
    double seconds = 0;
};

// Everything on standard output, and the `s` line.
void report(const Options&, const Check&, const Outcome&);
