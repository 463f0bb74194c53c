// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: the checker as a whole. Each text is checked as it is, and once more with the digest at its end put right, so that it gets
// past the reader to the rules.
#include "checkers/gmp/limits.h"
#include "tests/checkers/in_process.h"

// Instead of limits.cpp, which replaces operator new: that is the sanitizer's here.
void installMemoryAccounting() {}
void setMemoryLimit(std::size_t) {}
std::size_t memoryLimit() { return 0; }
void announceJson(bool) {}
void accountForeignMemory(std::size_t, std::size_t) {}
void setTimeLimit(double) {}
void disarmTimeLimit() {}
void installSignalHandlers() {}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    answerTo(text, false);
    const std::string repaired = withDigest(text);
    if (!repaired.empty() && repaired != text) answerTo(repaired, false);
    return 0;
}
