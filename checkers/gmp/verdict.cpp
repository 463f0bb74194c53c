// SPDX-License-Identifier: Apache-2.0
// In which order rules and claims are tested, and what the answer is.
#include "lemmas.h"
#include "report.h"

namespace {

std::uint64_t facets(const Check& k) { return k.certificate.facets.size(); }
std::uint64_t points(const Check& k) { return k.certificate.pointCount(); }
std::uint64_t cells(const Check& k) { return k.certificate.cells.size(); }

const Rule hash{"hash", ruleHash, "digest", [](const Check&) -> std::uint64_t { return 1; }};
const Rule complex{"complex", ruleComplex, "facets", facets};
const Rule distinct{"distinct", ruleDistinct, "points", points};
const Rule carrier{"carrier", ruleCarrier, "Steiner points", [](const Check& k) -> std::uint64_t { return k.certificate.steiner.size(); }};
const Rule cell{"cell", ruleCell, "cells", cells};
const Rule box{"box", ruleBox, "boxes", [](const Check& k) -> std::uint64_t { return k.certificate.boxCount; }};
const Rule kinds{"kinds", ruleKinds, "cells", cells};
const Rule tiling{"tiling", ruleTiling, "facets", facets};
const Rule emptiness{"emptiness", ruleEmptiness, "pairs of a cell and a point", [](const Check& k) -> std::uint64_t { return (k.endCell - k.firstCell) * points(k); }};
const Rule tie{"tie", ruleTie, "further points on circles", [](const Check& k) -> std::uint64_t { return k.tieCount; }};
const Rule hanging{"hanging", ruleHanging, "subsegments", [](const Check& k) -> std::uint64_t { return k.certificate.hanging.size(); }};
const Rule rows{"rows", ruleRows, "rows", [](const Check& k) -> std::uint64_t { return k.certificate.rows.size(); }};

bool needsKinds(const Claims& claims) {
    if (claims.refutation) return true;
    return std::any_of(claims.claims.begin(), claims.claims.end(), [](const Claim& claim) {
        const Lemma l = claim.lemma;
        return (l >= Lemma::l1 && l <= Lemma::l17) || l == Lemma::l20 || l == Lemma::l23 || l == Lemma::hBall || l == Lemma::hOffset;
    });
}

class Verdict {
public:
    Verdict(Check& check, const Options& options, Outcome& outcome) : check_(check), options_(options), outcome_(outcome) {}

    void find() {
        const Claims& claims = check_.certificate.claims;
        if (!all({&hash, &complex, &distinct, &carrier, &cell, &box})) return;
        if (needsKinds(claims) && !all({&kinds})) return;
        if (claims.refutation) return refutation();
        if (!rule(tiling, Lemma::l19)) return;
        if (!claims.claims.empty() && !(all({&rows}) && lemmas())) return;
        if (!rule(emptiness, Lemma::l18) || !rule(tie, Lemma::l18b) || !rule(hanging, Lemma::l22)) return;
        if (claims.claims.empty() && !all({&rows})) return;
        accept(0, "VERIFIED");
    }

private:
    bool reject(const std::string& name, const Violation& violation) {
        outcome_.exitCode = 5;
        outcome_.verdict = "REJECTED";
        outcome_.rule = name;
        outcome_.line = violation.line;
        outcome_.object = violation.object;
        return false;
    }
    void accept(int code, const char* verdict) {
        const bool some = !options_.cells.empty();
        outcome_.exitCode = some ? 3 : code;
        outcome_.verdict = some ? "UNDECIDED" : verdict;
        outcome_.why = "cells-" + options_.cells;
    }
    bool all(std::initializer_list<const Rule*> list) {
        for (const Rule* rule : list) {
            if (const auto violation = rule->function(check_)) return reject(rule->name, *violation);
            outcome_.passed.emplace_back(rule, rule->count(check_));
        }
        return true;
    }
    // A rule that a claim may stand for.
    bool rule(const Rule& rule, Lemma lemma) {
        const Claim* claim = check_.certificate.claims.find(lemma);
        if (claim == nullptr) return all({&rule});
        const std::string name(nameOf(lemma));
        if (const auto violation = testCount(check_, *claim)) return reject(name, *violation);
        const auto violation = rule.function(check_);
        reportRule(check_, *claim, violation);
        if (violation) return reject(name, *violation);
        outcome_.passed.emplace_back(&rule, rule.count(check_));
        return true;
    }
    bool lemmas() {
        std::string name;
        const auto violation = testClaims(check_, name);
        return !violation || reject(name, *violation);
    }
    void refutation() {
        if (!lemmas()) return;
        const std::string name(nameOf(check_.certificate.claims.refutation->lemma));
        std::string object;
        if (const auto violation = testRefutation(check_, object)) {
            reject(name, *violation);
            return;
        }
        outcome_.rule = name;
        outcome_.object = object;
        accept(1, "REFUTED");
    }

    Check& check_;
    const Options& options_;
    Outcome& outcome_;
};

}  // namespace

void decide(Check& check, const Options& options, Outcome& outcome) {
    const std::size_t count = check.certificate.cells.size();
    check.endCell = count;
    if (!options.cells.empty()) {
        check.firstCell = std::min<std::uint64_t>(options.firstCell, count);
        check.endCell = std::min<std::uint64_t>(options.lastCell + 1, count);
    }
    Verdict(check, options, outcome).find();
    std::stable_sort(check.claims.begin(), check.claims.end(), [](const ClaimReport& a, const ClaimReport& b) { return a.lemma < b.lemma; });
}
