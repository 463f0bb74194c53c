// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate's writer: docs/certificate-format.md section 3, docs/lemma-claims.md section 1.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/complex/complex.h"
#include "core/placement/placement.h"

namespace confidel {

struct CertificateSummary {
  std::uint64_t text_bytes = 0;  ///< uncompressed
  std::uint64_t file_bytes = 0;
  std::string complex_sha256;
};

/// KEY TEXT pairs without meaning: strategy, seed, options, tool.
using CertificateNotes = std::vector<std::pair<std::string, std::string>>;

/// Writes the certificate for the claim `conforms` and the placement's own claims, or for its refutation; compressed if the path ends in .zst. Written to the temporary name (in the
/// same folder) and renamed when complete: the path never holds half a certificate. Same arguments, same bytes.
/// Pre: claims are in the order of lemma-claims.md. Throws FileError.
CertificateSummary write_certificate(const std::string& path, const std::string& temporary, const Complex& complex, const Placement& placement,
                                     const CertificateNotes& notes);

}  // namespace confidel
