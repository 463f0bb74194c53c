// SPDX-License-Identifier: Apache-2.0
#include "limits.h"

#include <gmp.h>
#include <malloc.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<std::ptrdiff_t> used{0};  // since there is a limit; without one nothing is counted: millions of short numbers come and go
std::size_t limit = 0;
bool json = false;
std::atomic_flag ending = ATOMIC_FLAG_INIT;

void say(int descriptor, const char* text) {
    std::size_t left = std::strlen(text);
    while (left > 0) {
        const ssize_t written = ::write(descriptor, text, left);
        if (written <= 0) return;
        text += written;
        left -= static_cast<std::size_t>(written);
    }
}

// Only async-signal-safe calls: this also runs in the handler of SIGALRM.
[[noreturn]] void endUndecided(const char* why) {
    if (ending.test_and_set()) for (;;) ::pause();
    if (json) {
        say(1, "{\"verdict\":\"UNDECIDED\",\"why\":\"");
        say(1, why);
        say(1, "\"}\n");
    }
    const int last = json ? 2 : 1;
    say(last, "s UNDECIDED ");
    say(last, why);
    say(last, "\n");
    ::_exit(3);
}

[[noreturn]] void memoryExhausted() {
    if (limit != 0) endUndecided("memory-limit");
    if (ending.test_and_set()) for (;;) ::pause();
    say(2, "confidel-check: internal error: out of memory\n");
    ::_exit(70);
}

void count(std::size_t taken, std::size_t given) {
    const std::ptrdiff_t change = static_cast<std::ptrdiff_t>(taken) - static_cast<std::ptrdiff_t>(given);
    if (used.fetch_add(change, std::memory_order_relaxed) + change > static_cast<std::ptrdiff_t>(limit)) memoryExhausted();
}

void* allocate(std::size_t bytes) {
    if (limit != 0 && bytes > limit) memoryExhausted();
    void* memory = std::malloc(bytes == 0 ? 1 : bytes);
    if (memory == nullptr) memoryExhausted();
    if (limit != 0) count(malloc_usable_size(memory), 0);
    return memory;
}

void release(void* memory) {
    if (limit != 0) count(0, malloc_usable_size(memory));
    std::free(memory);
}

void* reallocate(void* memory, std::size_t, std::size_t bytes) {
    if (limit != 0 && bytes > limit) memoryExhausted();
    const std::size_t before = limit != 0 ? malloc_usable_size(memory) : 0;
    void* moved = std::realloc(memory, bytes);
    if (moved == nullptr) memoryExhausted();
    if (limit != 0) count(malloc_usable_size(moved), before);
    return moved;
}

void releaseSized(void* memory, std::size_t) { release(memory); }

void onAlarm(int) { endUndecided("time-limit"); }
void onInterrupt(int) { ::_exit(130); }

}  // namespace

void* operator new(std::size_t bytes) { return allocate(bytes); }
void* operator new[](std::size_t bytes) { return allocate(bytes); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

void installMemoryAccounting() { mp_set_memory_functions(allocate, reallocate, releaseSized); }
void setMemoryLimit(std::size_t bytes) { limit = bytes; }
std::size_t memoryLimit() { return limit; }
void announceJson(bool value) { json = value; }

void accountForeignMemory(std::size_t before, std::size_t after) {
    if (limit != 0) count(after, before);
}

void setTimeLimit(double seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
    if (timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0) timer.it_value.tv_usec = 1;
    ::signal(SIGALRM, onAlarm);
    ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void disarmTimeLimit() {
    const itimerval off{};
    ::setitimer(ITIMER_REAL, &off, nullptr);
    ::signal(SIGALRM, SIG_IGN);
}

void installSignalHandlers() {
    ::signal(SIGINT, onInterrupt);
    ::signal(SIGTERM, onInterrupt);
}
