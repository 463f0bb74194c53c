// SPDX-License-Identifier: GPL-3.0-or-later
// For programs that embed Confidel: conform this complex, check this certificate. examples/embed.cpp uses it.
#pragma once

#include <string>

#include "core/complex/build.h"
#include "core/io/read.h"
#include "core/placement/placement.h"
#include "proofs/certificate/checker_process.h"

namespace confidel {

struct ConformingRequest {
  std::string certificate;        ///< where to write it; .zst compresses
  std::string strategy = "lean";  ///< or "graded"
  long max_points = 3'000'000;    ///< 0: no limit
  int threads = 1;                ///< the result does not depend on it
};

struct ConformingResult {
  Placement placement;  ///< exact points, the complex's vertices first, in its working coordinates; cells
  std::string complex_sha256;
};

/// Places Steiner points on a valid complex (read_input, then build_complex) and writes the certificate. This is no verdict: that is the checker's.
/// Throws FileError, LimitReached, StrategyFailed; std::invalid_argument for an unknown strategy.
ConformingResult make_conforming(const Complex& complex, const ConformingRequest& request);

/// Has confidel-check (beside this program, or on PATH) check the certificate, and that it is about this complex: exit_code 0 and "s VERIFIED",
/// or what docs/certificate-format.md section 6 says. Throws FileError if it cannot be started.
CheckerRun check_certificate(const std::string& certificate, const Complex& complex);

}  // namespace confidel
