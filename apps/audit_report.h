// SPDX-License-Identifier: GPL-3.0-or-later
// An audit in words and as a document, with the numbers that the files use.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/audit/audit.h"
#include "core/complex/build.h"
#include "core/complex/input.h"

namespace confidel {

/// 1e-9 of the greatest extent: some hundred times the rounding errors of tools that compute in doubles.
double default_nearness(const Mesh& mesh);

class AuditReport {
 public:
  AuditReport(const Input& input, const BuiltComplex& built, const Mesh& mesh, const Audit& audit, double near)
      : input_(input), complex_(built.complex), report_(built.report), mesh_(mesh), audit_(audit), near_(near) {}

  std::string text() const;
  nlohmann::ordered_json json() const;
  /// The failing part that is deepest intruded, in words joined by '-'. Pre: something fails.
  std::string worst_object() const;

 private:
  std::string part_name(bool segment, int index) const;
  std::string piece_name(const std::array<int, 3>& piece) const;
  std::string witness(const Intrusion& intrusion) const;
  std::string failure(bool segment, int index, const AuditedPart& part) const;
  nlohmann::ordered_json part_json(bool segment, int index, const AuditedPart& part) const;
  nlohmann::ordered_json intrusion_json(const std::array<int, 3>& piece, const Intrusion& intrusion) const;

  const Input& input_;
  const Complex& complex_;
  const BuildReport& report_;
  const Mesh& mesh_;
  const Audit& audit_;
  double near_;
};

}  // namespace confidel
