// SPDX-License-Identifier: Apache-2.0
// Claims about lemmas, their parameters and evidence, as read (docs/lemma-claims.md).
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

using Whole = mpz_class;
using Rational = mpq_class;

// In the order of the table of claims.
enum class Lemma : std::uint8_t {
    hAngle, hBall, hOffset, hChord, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l18b, l19, l20, l21, l22, l23
};
constexpr std::array<std::string_view, 28> lemmaNames = {"H-angle", "H-ball", "H-offset", "H-chord", "L1",  "L2",  "L3",  "L4",   "L5",  "L6",
                                                         "L7",      "L8",     "L9",       "L10",     "L11", "L12", "L13", "L14",  "L15", "L16",
                                                         "L17",     "L18",    "L18b",     "L19",     "L20", "L21", "L22", "L23"};
inline std::string_view nameOf(Lemma lemma) { return lemmaNames[static_cast<std::size_t>(lemma)]; }

struct Claim {
    Lemma lemma;
    std::uint32_t count;  // as stated
    std::uint64_t line;
};

struct LengthParameter {
    std::uint64_t line;
    Rational value;
};
struct FactorParameter {
    std::uint64_t line;
    std::uint32_t value;
};
struct AngleParameter {
    std::uint64_t line;
    std::uint32_t factor;  // K
    Rational cosine;       // C
};
struct BallParameter {
    std::uint64_t line;
    std::uint32_t vertex;
    Rational radius;
};
struct RowParameter {
    std::uint64_t line;
    std::uint32_t segment;
    Rational offset, a[2], b[2];  // A and B at the first and the second vertex
};

struct Parameters {
    std::optional<LengthParameter> r, h, rMax;
    std::optional<AngleParameter> angle;
    std::optional<FactorParameter> beta, offset, chord;
    std::vector<BallParameter> balls;  // by vertex
    std::vector<RowParameter> rows;    // by segment
    bool local() const { return !balls.empty() || !rows.empty(); }
    const BallParameter* ball(std::uint32_t vertex) const;
    const RowParameter* row(std::uint32_t segment) const;
};

struct Insertion {  // c FACET a b c POINT
    std::uint64_t line;
    std::uint32_t facet, corner[3], point;
};

struct Refutation {
    std::uint64_t line;            // of `refutes`
    std::uint64_t evidenceLine;
    Lemma lemma;
    std::uint32_t cell, second;    // the second cell (L5), or the point
    std::uint32_t point;           // the second point (L18)
    Rational value, other;         // POWER, or both RATIONALs
};

struct Claims {
    std::vector<Claim> claims;
    std::optional<Refutation> refutation;  // then there is no `claim conforms`
    Parameters parameters;
    std::vector<Insertion> insertions;
    const Claim* find(Lemma lemma) const;
};
