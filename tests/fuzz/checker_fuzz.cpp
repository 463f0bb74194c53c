// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: the checker as a whole. Each text is checked as it is, and once more with the digest at its end put right, so that it gets
// past the reader to the rules.
#include "checkers/gmp/limits.h"
#include "checkers/gmp/report.h"

#include <cstdlib>
#include <sys/mman.h>
#include <unistd.h>

// Instead of limits.cpp, which replaces operator new: that is the sanitizer's here.
void installMemoryAccounting() {}
void setMemoryLimit(std::size_t) {}
std::size_t memoryLimit() { return 0; }
void announceJson(bool) {}
void accountForeignMemory(std::size_t, std::size_t) {}
void setTimeLimit(double) {}
void disarmTimeLimit() {}
void installSignalHandlers() {}

namespace {

void checkText(const std::string& text) {
    const int descriptor = ::memfd_create("certificate", 0);
    if (descriptor < 0 || ::write(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
    ::lseek(descriptor, 0, SEEK_SET);
    Options options;
    options.certificate = "/proc/self/fd/" + std::to_string(descriptor);
    Check check;
    check.threads = 1;
    Outcome outcome;
    try {
        readCertificate(check.certificate, options.certificate, options.complex, 2);
        decide(check, options, outcome);
    } catch (const Malformed& malformed) {
        if (malformed.code.empty() || malformed.line == 0) std::abort();
    } catch (const Declined&) {
    } catch (const Unreadable&) {
        std::abort();
    }
    ::close(descriptor);
}

// The last line, if it is `end ...`, with the digest of what stands before it.
std::string withDigest(const std::string& text) {
    const std::size_t line = text.rfind("\nend ");
    if (line == std::string::npos) return "";
    const std::size_t field = text.rfind(' ');
    if (field <= line + 4) return "";
    Sha256 digest(false);
    digest.add(text.data(), line + 1);
    return text.substr(0, field + 1) + digest.hexadecimal() + "\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    checkText(text);
    const std::string repaired = withDigest(text);
    if (!repaired.empty() && repaired != text) checkText(repaired);
    return 0;
}
