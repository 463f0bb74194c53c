// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/api/confidel.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "core/features/features.h"
#include "core/placement/graded.h"
#include "core/placement/lean.h"
#include "proofs/certificate/writer.h"

namespace confidel {
namespace {

class Silent : public Progress {
  void at(const char*, long) override {}
  bool stop_requested(long) override { return false; }
  void estimated(double) override {}
};

struct TemporaryFile {
  explicit TemporaryFile(std::string path) : name(std::move(path)) {}
  ~TemporaryFile() { std::remove(name.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string name;
};

}  // namespace

ConformingResult make_conforming(const Complex& complex, const ConformingRequest& request) {
  const Features features = compute_features(complex);
  Limits limits;
  limits.max_points = request.max_points;
  limits.threads = request.threads;
  Silent progress;
  ConformingResult result;
  if (request.strategy == "lean") result.placement = place_lean(complex, features, limits, progress);
  else if (request.strategy == "graded") result.placement = place_graded(complex, features, limits, progress);
  else throw std::invalid_argument("there is no strategy " + request.strategy);
  result.complex_sha256 = write_certificate(request.certificate, request.certificate + ".partial", complex, result.placement, {{"strategy", request.strategy}}).complex_sha256;
  return result;
}

CheckerRun check_certificate(const std::string& certificate, const Complex& complex) {
  const TemporaryFile canonical(certificate + ".plc.partial");
  std::ofstream stream(canonical.name, std::ios::binary);
  stream << canonical_text(complex);
  stream.close();
  if (!stream) throw FileError(canonical.name + ": cannot be written");
  return run_checker({certificate, canonical.name, 1, 0, 0, {}});
}

}  // namespace confidel
