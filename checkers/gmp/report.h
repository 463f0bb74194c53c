// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rules.h"
#include "text.h"

struct Options {
    std::string certificate, complex;
    unsigned threads = 1;
    bool json = false, quiet = false, exact = false;
    std::string cells;  // as given by --cells
    std::uint64_t firstCell = 0, lastCell = 0;
};

struct Outcome {
    int exitCode = 70;
    std::string verdict;                       // VERIFIED, REFUTED, REJECTED, UNDECIDED, MALFORMED, UNREADABLE
    std::string why;                           // UNDECIDED
    std::string rule, object;                  // REJECTED, REFUTED
    std::uint64_t line = 0;
    const Malformed* malformed = nullptr;
    const Unreadable* unreadable = nullptr;
    std::vector<std::pair<const Rule*, std::uint64_t>> passed;
    double seconds = 0;
};

// All rules and claims, in order.
void decide(Check&, const Options&, Outcome&);
// Everything on standard output, and the `s` line.
void report(const Options&, const Check&, const Outcome&);
