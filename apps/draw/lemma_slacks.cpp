// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/draw/lemma_slacks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "proofs/lemmas/certificate_instance.h"
#include "proofs/lemmas/lemma.h"
#include "proofs/lemmas/tally.h"

namespace confidel {
namespace {

const char* const by_cell[] = {"H-offset", "L1", "L2", "L3", "L4", "L5", "L7", "L20", "L23"};

std::vector<double> slacks_of(const Lemma& lemma, const Instance& instance, const Certificate& certificate) {
  std::vector<double> result(certificate.cells.size(), std::numeric_limits<double>::quiet_NaN());
  Tally tally(0, [&](double slack, int line) {
    const auto cell = std::lower_bound(certificate.cells.begin(), certificate.cells.end(), line, [](const CertificateCell& c, int l) { return c.line < l; });
    if (cell == certificate.cells.end() || cell->line != line) return;
    double& least = result[cell - certificate.cells.begin()];
    if (std::isnan(least) || slack < least) least = slack;
  });
  lemma.evaluate(instance, tally);
  // A box is named by the first of its two cells.
  for (std::size_t i = 1; i < result.size(); ++i)
    if (certificate.cells[i].box >= 0 && certificate.cells[i].box == certificate.cells[i - 1].box && std::isnan(result[i])) result[i] = result[i - 1];
  return result;
}

}  // namespace

std::vector<LemmaSlacks> lemma_slacks(const Certificate& certificate) {
  std::vector<LemmaSlacks> result;
  try {
    const CertificateInstance described = instance_of(certificate);
    for (const ClaimedLemma& claim : described.claims) {
      if (std::find(std::begin(by_cell), std::end(by_cell), claim.id) == std::end(by_cell)) continue;
      const Lemma& lemma = find_lemma(claim.id);
      if (lemma.needs_kinds && described.instance.wrong_kind >= 0) continue;
      LemmaSlacks slacks{claim.id, slacks_of(lemma, described.instance, certificate)};
      if (std::any_of(slacks.cells.begin(), slacks.cells.end(), [](double slack) { return !std::isnan(slack); })) result.push_back(std::move(slacks));
    }
  } catch (const InputError&) {
    return {};
  } catch (const MissingParameter&) {
    return {};
  }
  return result;
}

}  // namespace confidel
