// SPDX-License-Identifier: Apache-2.0
// Runs mutants of the checker, linked into this program, on test certificates: driver CASES LARGEST-NUMBER < NUMBERS
// CASES has lines `exit code TAB expected answer TAB argument TAB argument ...`, the first argument a certificate. For each number (which mutant
// is in force; -1: none, or the one compiled in), a line `number TAB the first certificate with another answer`, or `number TAB` alone.
// Each mutant runs in a process of its own, with limits of time and memory, forked from this one: starting programs would take most of the time.
#include "mutant.h"

#include <openssl/evp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <list>
#include <sstream>
#include <string>
#include <vector>

int checkerMain(int count, char** arguments);

namespace {

constexpr int caseSeconds = 3, waitingSeconds = 180;
constexpr rlim_t allSeconds = 60, bytes = rlim_t{1} << 31;

struct Case {
    int code;
    std::string expected;
    std::vector<std::string> arguments;
};

std::string contents(int descriptor) {
    std::string text(static_cast<std::size_t>(std::max<off_t>(0, ::lseek(descriptor, 0, SEEK_END))), '\0');
    if (::pread(descriptor, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) return "?";
    return text;
}

std::string lastLine(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

// The first line, without the name of the file.
std::string messageOf(const std::string& text, const std::string& file) {
    return text.compare(0, file.size(), file) == 0 ? text.substr(file.size(), text.find('\n') - file.size()) : "no error line";
}

// As in MANIFEST.tsv: `CODE LINE`, of `FILE:LINE:COLUMN: error[CODE]: ...`; for a damaged frame the code alone.
std::string errorOf(const std::string& text, const std::string& file) {
    const std::size_t code = text.find("error[");
    if (code == std::string::npos || text.compare(0, file.size() + 1, file + ":") != 0) return "no error line";
    const std::string name = text.substr(code + 6, text.find(']', code) - code - 6);
    return name == "E-ZSTD" ? name : name + " " + text.substr(file.size() + 1, text.find(':', file.size() + 1) - file.size() - 1);
}

// Of a report what is the same each time: the counts of the rules, the smallest relative power, the claims.
std::string reportOf(const std::string& text) {
    const std::size_t begin = text.find("\"rules\":"), end = text.rfind(",\"seconds\"");
    return begin == std::string::npos || end == std::string::npos || end < begin ? "no report" : text.substr(begin, end - begin);
}

class Runner {
public:
    // The certificate to which the mutant gives another answer, or what else happened; "" if all answers are as expected.
    std::string noticedBy(std::list<Case>& cases, int number) {
        *place_ = 0;
        const pid_t child = ::fork();
        if (child == 0) inChild(cases, number);
        int status = 0;
        // Threads that wait for each other use no time of a processor: the limits of the child would not end it.
        const auto start = std::chrono::steady_clock::now();
        for (pid_t ended = 0; ended == 0; ended = ::waitpid(child, &status, WNOHANG)) {
            if (std::chrono::steady_clock::now() - start > std::chrono::seconds(waitingSeconds)) ::kill(child, SIGKILL);
            ::usleep(2000);
        }
        if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGVTALRM || WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) return "does not end";
        const int code = WIFSIGNALED(status) ? -1 : WEXITSTATUS(status);
        if (code == alike) return "";
        if (code == 99) return "does not compile";
        if (static_cast<std::size_t>(*place_) >= cases.size()) return "crashes";
        const auto test = std::next(cases.begin(), *place_);
        cases.splice(cases.begin(), cases, test);  // what noticed one mutant notices the next ones of that file
        return test->arguments[0];
    }

private:
    static constexpr int alike = 98, different = 97;

    [[noreturn]] void inChild(const std::list<Case>& cases, int number) {
        const rlimit time{allSeconds, allSeconds + 1}, memory{bytes, bytes}, core{0, 0};
        ::setrlimit(RLIMIT_CPU, &time);
        ::setrlimit(RLIMIT_AS, &memory);
        ::setrlimit(RLIMIT_CORE, &core);
        ::dup2(out_, 1);
        ::dup2(error_, 2);
        mutant::active = number;
        for (const Case& test : cases) {
            if (!asExpected(test)) ::_exit(different);
            ++*place_;
        }
        ::_exit(alike);
    }

    bool asExpected(const Case& test) {
        for (const int descriptor : {out_, error_})
            if (::ftruncate(descriptor, 0) != 0 || ::lseek(descriptor, 0, SEEK_SET) != 0) std::abort();
        itimerval timer{};
        timer.it_value.tv_sec = caseSeconds;  // of its own time: others may keep the processor busy
        ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
        std::vector<char*> arguments{const_cast<char*>("confidel-check")};
        for (const std::string& argument : test.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
        arguments.push_back(nullptr);
        const int code = checkerMain(static_cast<int>(arguments.size()) - 1, arguments.data());
        std::fflush(nullptr);
        const bool json = std::find(test.arguments.begin(), test.arguments.end(), "--json") != test.arguments.end();
        const std::string error = contents(error_), &file = test.arguments[0];
        const std::string answer = code == 2 ? (json ? messageOf(error, file) : errorOf(error, file)) : json ? reportOf(contents(out_)) : lastLine(contents(out_));
        return code == test.code && answer == test.expected;
    }

    int out_ = ::memfd_create("out", 0), error_ = ::memfd_create("error", 0);
    int* place_ = static_cast<int*>(::mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
};

}  // namespace

int main(int count, char** arguments) {
    // With a number in the environment: the checker itself, for scripts that start it.
    if (const char* number = std::getenv("CONFIDEL_MUTANT")) {
        mutant::active = std::atoi(number);
        return checkerMain(count, arguments);
    }
    if (count != 2) return 2;
    std::list<Case> cases;
    std::ifstream file(arguments[1]);
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        Case test;
        std::string code;
        std::getline(fields, code, '\t');
        std::getline(fields, test.expected, '\t');
        for (std::string argument; std::getline(fields, argument, '\t');) test.arguments.push_back(argument);
        test.code = std::atoi(code.c_str());
        cases.push_back(test);
    }
    // What OpenSSL does at its first digest is done here, not in each child again.
    unsigned char digest[EVP_MAX_MD_SIZE];
    EVP_Digest("", 0, digest, nullptr, EVP_sha256(), nullptr);
    Runner runner;
    for (int number; std::cin >> number;) {
        const std::string by = runner.noticedBy(cases, number);
        std::printf("%d\t%s\n", number, by.c_str());
        std::fflush(stdout);
    }
}
