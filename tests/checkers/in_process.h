// SPDX-License-Identifier: Apache-2.0
// The checker as a function of a text, for what checks millions of texts.
#pragma once

#include "checkers/gmp/report.h"

#include <cstdlib>
#include <sys/mman.h>
#include <unistd.h>

// The exit code, and what is said besides it. Ends the program where the checker breaks its own rules.
struct Answer {
    int code = 70;
    std::string said;
    bool operator==(const Answer&) const = default;
};

inline Answer answerTo(const std::string& text, bool exact) {
    const int descriptor = ::memfd_create("certificate", 0);
    if (descriptor < 0 || ::write(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
    ::lseek(descriptor, 0, SEEK_SET);
    Options options;
    options.certificate = "/proc/self/fd/" + std::to_string(descriptor);
    Check check;
    check.exact = exact;
    Answer answer;
    try {
        readCertificate(check.certificate, options.certificate, options.complex, check.threads);
        Outcome outcome;
        decide(check, options, outcome);
        answer = {outcome.exitCode, outcome.verdict + " " + outcome.rule + " " + std::to_string(outcome.line) + " " + outcome.object + outcome.why};
    } catch (const Malformed& malformed) {
        if (malformed.code.empty() || malformed.line == 0) std::abort();
        answer = {2, malformed.code + " " + std::to_string(malformed.line) + " " + std::to_string(malformed.column)};
    } catch (const Declined& declined) {
        answer = {3, declined.why};
    } catch (const Unreadable&) {
        std::abort();
    }
    ::close(descriptor);
    return answer;
}

// The text with a digest at its end that is right; empty if there is no such line.
inline std::string withDigest(const std::string& text) {
    const std::size_t line = text.rfind("\nend ");
    if (line == std::string::npos) return "";
    const std::size_t field = text.rfind(' ');
    if (field <= line + 4) return "";
    Sha256 digest(false);
    digest.add(text.data(), line + 1);
    return text.substr(0, field + 1) + digest.hexadecimal() + "\n";
}
