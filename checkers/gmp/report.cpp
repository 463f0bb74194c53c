// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <cmath>
#include <cstdio>

namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (byte < 0x20 || byte == 0x7f) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", byte);
            result += escape;
        } else {
            result += c;
        }
    }
    result += '"';
    return result;
}

std::string rounded(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string lastLine(const Outcome& outcome) {
    if (outcome.verdict == "VERIFIED") return "s VERIFIED";
    if (outcome.verdict == "UNDECIDED") return "s UNDECIDED " + outcome.why;
    if (outcome.verdict == "REJECTED")
        return "s REJECTED " + outcome.rule + " " + std::to_string(outcome.line) + " " + outcome.object;
    if (outcome.verdict == "REFUTED") return "s REFUTED " + outcome.rule + " " + outcome.object;
    return "";
}

bool reached(const Outcome& outcome, const char* rule) {
    for (const auto& [passed, count] : outcome.passed)
        if (std::string(passed->name) == rule) return true;
    return false;
}

void reportText(const Options& options, const Check& check, const Outcome& outcome) {
    const Certificate& c = check.certificate;
    if (!c.complexDigest.empty()) {
        std::printf("complex sha256 %s, %s\n", c.complexDigest.c_str(),
                    options.complex.empty() ? "not compared" : ("compared with " + options.complex).c_str());
        std::printf("dimension %d: %u vertices, %zu segments, %zu facets, %zu Steiner points, %zu cells, %zu rows, %zu subsegments\n", c.dimension,
                    c.vertexCount, c.segments.size(), c.facets.size(), c.steiner.size(), c.cells.size(), c.rows.size(), c.hanging.size());
    }
    for (const auto& [rule, count] : outcome.passed)
        std::printf("rule %-9s holds: %llu %s\n", rule->name, static_cast<unsigned long long>(count), rule->counted);
    if (reached(outcome, "carrier") && c.coplanar)
        std::puts("all points lie in one plane: the statement is about the planar Delaunay subdivisions");
    if (reached(outcome, "emptiness")) {
        if (check.smallest.exists())
            std::printf("smallest relative power off-plane %s: cell of line %llu, point %u\n", rounded(check.smallest.value).c_str(),
                        static_cast<unsigned long long>(check.smallest.cellLine), check.smallest.point);
        else
            std::puts("no point lies outside the plane of a cell");
    }
    for (const ClaimReport& claim : check.claims) {
        std::printf("claim %-7s %llu objects, %llu failures, ", std::string(nameOf(claim.lemma)).c_str(), static_cast<unsigned long long>(claim.objects),
                    static_cast<unsigned long long>(claim.failures));
        if (claim.hasSlack)
            std::printf("smallest slack %s: line %llu, %s\n", rounded(claim.slack).c_str(), static_cast<unsigned long long>(claim.line), claim.object.c_str());
        else std::puts("no slack");
    }
    std::printf("%.3f seconds, %u threads\n", outcome.seconds, options.threads);
}

void reportJson(const Options& options, const Check& check, const Outcome& outcome) {
    const Certificate& c = check.certificate;
    std::string text = "{\"verdict\":";
    text += quoted(outcome.verdict) + ",\"exit\":" + std::to_string(outcome.exitCode);
    text += ",\"certificate\":" + quoted(options.certificate);
    if (outcome.verdict == "REJECTED")
        text += ",\"rule\":" + quoted(outcome.rule) + ",\"line\":" + std::to_string(outcome.line) + ",\"object\":" + quoted(outcome.object);
    if (outcome.verdict == "REFUTED") text += ",\"rule\":" + quoted(outcome.rule) + ",\"object\":" + quoted(outcome.object);
    if (outcome.verdict == "UNDECIDED") text += ",\"why\":" + quoted(outcome.why);
    if (outcome.malformed != nullptr)
        text += ",\"error\":" + quoted(outcome.malformed->code) + ",\"file\":" + quoted(outcome.malformed->file) +
                ",\"line\":" + std::to_string(outcome.malformed->line) + ",\"column\":" + std::to_string(outcome.malformed->column) +
                ",\"message\":" + quoted(outcome.malformed->message);
    if (outcome.unreadable != nullptr)
        text += ",\"file\":" + quoted(outcome.unreadable->file) + ",\"message\":" + quoted(outcome.unreadable->reason);
    if (!c.complexDigest.empty()) {
        text += ",\"complex\":{\"sha256\":" + quoted(c.complexDigest) + ",\"compared\":" + (options.complex.empty() ? "false" : "true") + "}";
        text += ",\"dimension\":" + std::to_string(c.dimension);
        text += ",\"records\":{\"vertices\":" + std::to_string(c.vertexCount) + ",\"segments\":" + std::to_string(c.segments.size()) +
                ",\"facets\":" + std::to_string(c.facets.size()) + ",\"points\":" + std::to_string(c.steiner.size()) +
                ",\"cells\":" + std::to_string(c.cells.size()) + ",\"rows\":" + std::to_string(c.rows.size()) +
                ",\"hanging\":" + std::to_string(c.hanging.size()) + "}";
    }
    // What `confidel campaign cover-cells` puts together: of which certificate, and which of its cells.
    if (!c.digest.empty()) text += ",\"digest\":" + quoted(c.digest);
    if (check.firstCell < check.endCell)
        text += ",\"cells-checked\":[" + std::to_string(check.firstCell) + "," + std::to_string(check.endCell - 1) + "]";
    text += ",\"rules\":{";
    for (std::size_t i = 0; i < outcome.passed.size(); ++i) {
        if (i != 0) text += ',';
        text += quoted(outcome.passed[i].first->name);
        text += ':';
        text += std::to_string(outcome.passed[i].second);
    }
    text += "}";
    if (reached(outcome, "carrier")) text += std::string(",\"coplanar\":") + (c.coplanar ? "true" : "false");
    if (reached(outcome, "emptiness")) {
        text += ",\"smallest-relative-power\":";
        if (!check.smallest.exists() || !std::isfinite(check.smallest.value)) text += "null";
        else
            text += "{\"value\":" + rounded(check.smallest.value) + ",\"cell-line\":" + std::to_string(check.smallest.cellLine) +
                    ",\"point\":" + std::to_string(check.smallest.point) + "}";
    }
    text += ",\"claims\":[";
    for (std::size_t i = 0; i < check.claims.size(); ++i) {
        const ClaimReport& claim = check.claims[i];
        if (i != 0) text += ',';
        text += "{\"id\":" + quoted(std::string(nameOf(claim.lemma))) + ",\"objects\":" + std::to_string(claim.objects) +
                ",\"failures\":" + std::to_string(claim.failures);
        if (claim.hasSlack)
            text += ",\"slack\":" + rounded(claim.slack) + ",\"line\":" + std::to_string(claim.line) + ",\"object\":" + quoted(claim.object) + "}";
        else text += ",\"slack\":null,\"line\":null,\"object\":null}";
    }
    text += "]";
    char seconds[40];
    std::snprintf(seconds, sizeof seconds, "%.3f", outcome.seconds);
    text += std::string(",\"seconds\":") + seconds + ",\"threads\":" + std::to_string(options.threads) + "}";
    std::puts(text.c_str());
}

}  // namespace

void report(const Options& options, const Check& check, const Outcome& outcome) {
    if (options.json) reportJson(options, check, outcome);
    else if (!options.quiet && (outcome.exitCode <= 1 || outcome.exitCode == 3 || outcome.exitCode == 5)) reportText(options, check, outcome);
    const std::string line = lastLine(outcome);
    if (!line.empty()) std::fprintf(options.json ? stderr : stdout, "%s\n", line.c_str());
}
