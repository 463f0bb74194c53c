// SPDX-License-Identifier: GPL-3.0-or-later
// The instance that a certificate describes, with its claims.
#pragma once

#include "proofs/certificate/reader.h"
#include "proofs/lemmas/instance.h"

namespace confidel {

struct ClaimedLemma {
  std::string id;
  long count = 0;
  int line = 0;
};

struct CertificateInstance {
  Instance instance;
  std::vector<ClaimedLemma> claims;  ///< besides `conforms`
  std::string refutes;               ///< the statement that the certificate refutes, or ""
};

/// Throws InputError where the text is no certificate, or where what lemmas take for granted does not hold (cells with collinear corners,
/// boundary edges that are no segments, points that coincide): such certificates are for confidel-check to reject.
CertificateInstance instance_of(const Certificate& certificate);

/// The first claimed statement that does not hold, or of what conforming consists of: L18 (no point in or on a cell's sphere, off the plane), L18b (ties),
/// L19 (the cells tile the facets), L22 (segments in no facet). "L18 fails at cell-3-point-7", or "". Exact; all points against all cells.
std::string objection_to(const CertificateInstance& given);

}  // namespace confidel
