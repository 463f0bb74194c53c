// SPDX-License-Identifier: Apache-2.0
// confidel-check: checks a certificate for a conforming Delaunay triangulation.
#include "filter.h"
#include "limits.h"
#include "report.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace {

constexpr const char* usageText =
    "usage: confidel-check CERT [--complex FILE] [--threads N] [--json] [--time-limit SECONDS]\n"
    "                      [--memory-limit BYTES|512M|4G] [--cells I-J] [--exact] [--quiet] [--help] [--version]\n"
    "\n"
    "Checks a certificate (plain or zstd) for a conforming Delaunay triangulation.\n"
    "  --complex FILE        the complex has to be this one, byte for byte\n"
    "  --threads N           number of threads, by default one per processor\n"
    "  --json                one JSON document on standard output, the verdict on standard error\n"
    "  --time-limit SECONDS  then UNDECIDED\n"
    "  --memory-limit BYTES  then UNDECIDED; suffixes K, M, G are powers of 1024\n"
    "  --cells I-J           tests what ranges over cells for these only; then UNDECIDED\n"
    "  --exact               integers only: without the float filter (docs/trust.md); the same answer, later\n"
    "  --quiet               only the verdict\n"
    "Exit codes: 0 verified, 1 refuted, 2 no certificate or bad usage, 3 undecided, 4 unreadable,\n"
    "5 rejected, 70 internal error, 130 interrupted.\n";

constexpr std::size_t fewForThreads = 2000;

struct Usage { std::string message; };

std::uint64_t parseNumber(const std::string& option, const std::string& text) {
    if (text.empty() || text.size() > 18) throw Usage{option + " needs a number"};
    std::uint64_t value = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') throw Usage{option + " needs a number"};
        value = value * 10 + static_cast<std::uint64_t>(c - '0');
    }
    return value;
}

std::size_t parseBytes(const std::string& option, std::string text) {
    int shift = 0;
    if (!text.empty()) {
        const std::size_t suffix = std::string("KMG").find(text.back());
        if (suffix != std::string::npos) {
            shift = 10 * (static_cast<int>(suffix) + 1);
            text.pop_back();
        }
    }
    const std::uint64_t value = parseNumber(option, text);
    if (value == 0 || value > (std::uint64_t{1} << 62) >> shift) throw Usage{option + " is out of range"};
    return value << shift;
}

double parseSeconds(const std::string& option, const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || text.find_first_not_of("0123456789.") != std::string::npos || !std::isfinite(value) || value > 1e9)
        throw Usage{option + " needs a number of seconds"};
    return value;
}

// The limits take effect here, so that they hold for everything that follows.
Options parse(int count, char** arguments) {
    Options options;
    options.threads = std::max(1u, std::thread::hardware_concurrency());
    bool named = false;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        const auto next = [&]() -> std::string {
            if (++i >= count) throw Usage{argument + " needs a value"};
            return arguments[i];
        };
        if (argument == "--json") options.json = true;
        else if (argument == "--exact") options.exact = true;
        else if (argument == "--quiet") options.quiet = true;
        else if (argument == "--complex") {
            options.complex = next();
            if (options.complex.empty()) throw Usage{"--complex needs a file"};
        }
        else if (argument == "--threads") {
            const std::uint64_t threads = parseNumber(argument, next());
            if (threads < 1 || threads > 1024) throw Usage{"--threads is from 1 to 1024"};
            options.threads = static_cast<unsigned>(threads);
        }
        else if (argument == "--cells") {
            const std::string range = next();
            const std::size_t dash = std::min(range.find('-'), range.size() - (range.empty() ? 0 : 1));
            options.cells = range;
            options.firstCell = parseNumber(argument, range.substr(0, dash));
            options.lastCell = parseNumber(argument, range.empty() ? range : range.substr(dash + 1));
            if (options.firstCell > options.lastCell) throw Usage{"--cells needs the smaller number first"};
            if (range != std::to_string(options.firstCell) + "-" + std::to_string(options.lastCell)) throw Usage{"--cells needs I-J"};
        }
        else if (argument == "--time-limit") setTimeLimit(parseSeconds(argument, next()));
        else if (argument == "--memory-limit") setMemoryLimit(parseBytes(argument, next()));
        else if (argument.size() > 1 && argument[0] == '-') throw Usage{"unknown option " + argument};
        else if (named) throw Usage{"more than one certificate"};
        else {
            options.certificate = argument;
            named = true;
        }
    }
    if (!named) throw Usage{"no certificate given"};
    return options;
}

int run(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    Check check;
    check.threads = options.threads;
    check.exact = options.exact || !setRoundingToNearest();
    Outcome outcome;
    Malformed malformed;
    Unreadable unreadable;
    try {
        readCertificate(check.certificate, options.certificate, options.complex, check.threads);
        // A thread takes longer to start than a small certificate to check.
        if (check.certificate.cells.size() + check.certificate.hanging.size() < fewForThreads) check.threads = 1;
        decide(check, options, outcome);
    } catch (const Malformed& error) {
        malformed = error;
        outcome.exitCode = 2;
        outcome.verdict = "MALFORMED";
        outcome.malformed = &malformed;
    } catch (const Declined& declined) {
        outcome.exitCode = 3;
        outcome.verdict = "UNDECIDED";
        outcome.why = declined.why;
    } catch (const Unreadable& error) {
        unreadable = error;
        outcome.exitCode = 4;
        outcome.verdict = "UNREADABLE";
        outcome.unreadable = &unreadable;
    }
    disarmTimeLimit();
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report(options, check, outcome);
    if (outcome.malformed != nullptr)
        std::fprintf(stderr, "%s:%llu:%llu: error[%s]: %s\n", malformed.file.c_str(), static_cast<unsigned long long>(malformed.line),
                     static_cast<unsigned long long>(malformed.column), malformed.code.c_str(), malformed.message.c_str());
    if (outcome.unreadable != nullptr) std::fprintf(stderr, "%s: cannot be read: %s\n", unreadable.file.c_str(), unreadable.reason.c_str());
    // A verdict that did not reach its reader is none.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        std::fprintf(stderr, "confidel-check: internal error: standard output cannot be written\n");
        return 70;
    }
    return outcome.exitCode;
}

}  // namespace

int main(int count, char** arguments) {
    installMemoryAccounting();
    installSignalHandlers();
    int code = 70;
    try {
        for (int i = 1; i < count; ++i) {
            const std::string argument = arguments[i];
            if (argument == "--help") return std::fputs(usageText, stdout) < 0 ? 70 : 0;
            if (argument == "--version") return std::puts("confidel-check 1.0.0, certificates of version 1") < 0 ? 70 : 0;
            if (argument == "--json") announceJson(true);
        }
        code = run(parse(count, arguments));
    } catch (const Usage& usage) {
        std::fprintf(stderr, "confidel-check: error[E-USAGE]: %s\n%s", usage.message.c_str(), usageText);
        code = 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "confidel-check: internal error: %s\n", error.what());
    } catch (...) {
        std::fprintf(stderr, "confidel-check: internal error\n");
    }
    // Freeing millions of small pieces one by one would only cost time.
    std::fflush(nullptr);
    std::_Exit(code);
}
