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

std::atomic<std::size_t> used{0};
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

void add(std::size_t bytes) {
    const std::size_t now = used.fetch_add(bytes, std::memory_order_relaxed) + bytes;
    if (limit != 0 && now > limit) memoryExhausted();
}

void* allocate(std::size_t bytes) {
    if (limit != 0 && bytes > limit) memoryExhausted();
    void* memory = std::malloc(bytes == 0 ? 1 : bytes);
    if (memory == nullptr) memoryExhausted();
    add(malloc_usable_size(memory));
    return memory;
}

void release(void* memory) {
    if (memory == nullptr) return;
    used.fetch_sub(malloc_usable_size(memory), std::memory_order_relaxed);
    std::free(memory);
}

void* reallocate(void* memory, std::size_t, std::size_t bytes) {
    if (limit != 0 && bytes > limit) memoryExhausted();
    used.fetch_sub(malloc_usable_size(memory), std::memory_order_relaxed);
    void* moved = std::realloc(memory, bytes == 0 ? 1 : bytes);
    if (moved == nullptr) memoryExhausted();
    add(malloc_usable_size(moved));
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
    used.fetch_sub(before, std::memory_order_relaxed);
    add(after);
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
