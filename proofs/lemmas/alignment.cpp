// SPDX-License-Identifier: GPL-3.0-or-later
// L12 and L14: the protectors of one edge in its facets, by their offset vectors.
#include "proofs/lemmas/needs.h"
#include "proofs/lemmas/rational_geometry.h"
#include "proofs/lemmas/statements.h"
#include "proofs/lemmas/tally.h"

namespace confidel::statements {
namespace {

RationalVector offset_of(const Instance& instance, const PlacedRow& row, std::size_t protector) {
  return minus(instance.positions[row.protectors[protector].points.front()], instance.positions[row.points.front()]);
}

std::string pair_name(const PlacedRow& row, std::size_t i, std::size_t j) {
  return fmt::format("row-{}-facet-{}-facet-{}", row.segment, row.protectors[i].facet, row.protectors[j].facet);
}

}  // namespace

void alignment(const Instance& instance, Tally& tally) {
  for (std::size_t r = 0; r < instance.rows.size(); ++r) {
    const PlacedRow& row = instance.rows[r];
    for (std::size_t i = 0; i < row.protectors.size(); ++i)
      for (std::size_t j = 0; j < row.protectors.size(); ++j) {
        if (instance.coplanar(row.protectors[i].facet, row.protectors[j].facet)) continue;
        const RationalVector o = offset_of(instance, row, i), other = offset_of(instance, row, j);
        const mpq_class slack = dot(other, minus(other, o)) / squared(other);
        const int line = line_of(instance.lines.rows, static_cast<int>(r));
        if (slack <= 0) tally.fail(line, pair_name(row, i, j));
        tally.slack(slack, line, [&] { return pair_name(row, i, j); });
      }
  }
}

void sheet_separation(const Instance& instance, Tally& tally) {
  const mpq_class h = square(need(instance.parameters.spacing, "h"));
  for (std::size_t r = 0; r < instance.rows.size(); ++r) {
    const PlacedRow& row = instance.rows[r];
    for (std::size_t i = 0; i < row.protectors.size(); ++i)
      for (std::size_t j = i + 1; j < row.protectors.size(); ++j) {
        const mpq_class slack = 4 * squared(minus(offset_of(instance, row, i), offset_of(instance, row, j))) / (9 * h) - 1;
        const int line = line_of(instance.lines.rows, static_cast<int>(r));
        if (slack < 0) tally.fail(line, pair_name(row, i, j));
        tally.slack(slack, line, [&] { return pair_name(row, i, j); });
      }
  }
}

}  // namespace confidel::statements
