// SPDX-License-Identifier: Apache-2.0
// Every bit of certificates flipped: bit-flips FOLDER CERTIFICATE ...
// As it is, and with the digest put right. Each must be no certificate any more (2), undecided (3) or rejected (5), with and without the float
// filter; what is accepted, or of which both say different things, is written to FOLDER, for typed_test.py to judge.
#include "tests/checkers/in_process.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>

int main(int count, char** arguments) {
    if (count < 3) return 64;
    const std::string folder = arguments[1];
    std::map<std::string, long> tally;
    const auto judge = [&](const std::string& name, std::size_t bit, const char* kind, const std::string& text) {
        const Answer answer = answerTo(text, false), exact = answerTo(text, true);
        std::string verdict = "no certificate";
        if (answer == exact && answer.code == 5) verdict = "rejected";
        else if (answer != exact || (answer.code != 2 && answer.code != 3)) {
            verdict = answer == exact && answer.code == 0 ? "accepted" : "wrong";
            std::ofstream(folder + "/" + verdict + "-" + name + "-" + std::to_string(bit) + "-" + kind + ".cert", std::ios::binary) << text;
        }
        ++tally[std::string(kind) + " " + verdict];
    };
    for (int i = 2; i < count; ++i) {
        std::ifstream file(arguments[i], std::ios::binary);
        const std::string original{std::istreambuf_iterator<char>(file), {}};
        const std::string path = arguments[i], name = path.substr(path.rfind('/') + 1);
        for (std::size_t bit = 0; bit < 8 * original.size(); ++bit) {
            std::string text = original;
            text[bit / 8] = static_cast<char>(text[bit / 8] ^ 1 << bit % 8);
            judge(name, bit, "bit", text);
            const std::string repaired = withDigest(text);
            if (!repaired.empty() && repaired != original && repaired != text) judge(name, bit, "bit-with-digest", repaired);
        }
    }
    for (const auto& [what, times] : tally) std::printf("%ld %s\n", times, what.c_str());
    return 0;
}
